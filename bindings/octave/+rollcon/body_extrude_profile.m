function varargout = body_extrude_profile(varargin)
% BODY_EXTRUDE_PROFILE  rollcon.body_extrude_profile(body, origin, along, z_axis)
%
% Makes the profile, moved along a straight line without end, the surface of the body: x of the
% profile points along `along`, z along z_axis, y along z_axis x along.
%
%   body (body): with a profile (else ERR_STATE)
%   origin(3) (real): where the profile's point (0, 0) lies, length
%   along(3) (real): direction, of any length but 0
%   z_axis(3) (real): direction, not parallel to along; what is normal to it counts
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_extrude_profile', varargin{:});
end
