function varargout = body_get_profile_length(varargin)
% BODY_GET_PROFILE_LENGTH  length = rollcon.body_get_profile_length(body)
%
% Returns the arc length of the profile. It works before rollcon.body_prepare.
%
%   body (body): with a profile (else ERR_STATE)
% Results:
%   length: length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_profile_length', varargin{:});
end
