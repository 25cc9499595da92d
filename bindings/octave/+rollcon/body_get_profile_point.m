function varargout = body_get_profile_point(varargin)
% BODY_GET_PROFILE_POINT  [point, tangent, curvature] = rollcon.body_get_profile_point(body, s)
%
% Returns point, tangent and curvature of the profile at an arc length, counted from the end where y
% is less. It works before rollcon.body_prepare.
%
%   body (body): with a profile (else ERR_STATE)
%   s (real): 0 to rollcon.body_get_profile_length, length
% Results:
%   point: y and z, length
%   tangent: y and z of the unit vector in the direction of greater arc length
%   curvature: 1/length, positive where the curve turns from y to z
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_profile_point', varargin{:});
end
