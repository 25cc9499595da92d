function varargout = contact_get_str(varargin)
% CONTACT_GET_STR  text = rollcon.contact_get_str(contact, name)
%
% Returns the value of a text option.
%
%   contact (contact)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_str', varargin{:});
end
