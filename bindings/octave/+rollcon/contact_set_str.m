function varargout = contact_set_str(varargin)
% CONTACT_SET_STR  rollcon.contact_set_str(contact, name, value)
%
% Sets a text option.
%
%   contact (contact)
%   name (text)
%   value (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_str', varargin{:});
end
