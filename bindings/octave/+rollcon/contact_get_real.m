function varargout = contact_get_real(varargin)
% CONTACT_GET_REAL  value = rollcon.contact_get_real(contact, name)
%
% Returns the value of a real option.
%
%   contact (contact)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_real', varargin{:});
end
