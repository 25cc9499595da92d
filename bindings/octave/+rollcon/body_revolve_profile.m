function varargout = body_revolve_profile(varargin)
% BODY_REVOLVE_PROFILE  rollcon.body_revolve_profile(body, origin, axis, radius)
%
% Makes the profile, turned about an axis, the surface of the body: its points lie at y along the axis
% and at radius + z away from it. An axis of the opposite direction mirrors it in y.
%
%   body (body): with a profile (else ERR_STATE)
%   origin(3) (real): point of the axis at which y is 0, length
%   axis(3) (real): direction of y, of any length but 0
%   radius (real): radius at z = 0, length; radius + z >= 0 all along the profile
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_revolve_profile', varargin{:});
end
