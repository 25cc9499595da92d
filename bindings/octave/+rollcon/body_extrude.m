function varargout = body_extrude(varargin)
% BODY_EXTRUDE  rollcon.body_extrude(body, origin, direction, period)
%
% Draws the plane mesh of a section along a line: a rail, a raceway strip. Its nodes lie in the plane
% at right angles to the line through the origin. Supports, tractions and given displacements are the
% same all along; what a contact does repeats after the period, which is long enough when the answer
% does not depend on it. The surface reaches as far to both sides of the section as that is wide:
% bring the contact there.
%
%   body (body): a section, not prepared (else ERR_STATE)
%   origin(3) (real): a point in the section's plane, length
%   direction(3) (real): of the line, of any length but 0
%   period (real): length after which all repeats, > 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_extrude', varargin{:});
end
