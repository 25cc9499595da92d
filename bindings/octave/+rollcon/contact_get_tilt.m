function varargout = contact_get_tilt(varargin)
% CONTACT_GET_TILT  tilt = rollcon.contact_get_tilt(contact)
%
% Returns rotations of body 1 against body 2 about t1 and t2, given or found for prescribed moments
% (rollcon.contact_prescribe).
%
%   contact (contact)
% Results:
%   tilt: radian
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_tilt', varargin{:});
end
