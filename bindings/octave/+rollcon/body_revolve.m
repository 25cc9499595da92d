function varargout = body_revolve(varargin)
% BODY_REVOLVE  rollcon.body_revolve(body, origin, axis)
%
% Makes the plane mesh of a section a body of revolution: a wheel, a ring, a roller. Its nodes lie in
% a half plane that ends at the axis. Supports, tractions and given displacements count along x, y and
% z where the section lies, and turn with it: all of them are the same all the way round. Once
% prepared, the body has the nodes and faces of the surface that its contact edges sweep.
%
%   body (body): a section, not prepared (else ERR_STATE)
%   origin(3) (real): point of the axis, length
%   axis(3) (real): direction, of any length but 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_revolve', varargin{:});
end
