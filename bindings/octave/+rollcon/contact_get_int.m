function varargout = contact_get_int(varargin)
% CONTACT_GET_INT  value = rollcon.contact_get_int(contact, name)
%
% Returns the value of an integer option.
%
%   contact (contact)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_int', varargin{:});
end
