function varargout = contact_set_int(varargin)
% CONTACT_SET_INT  rollcon.contact_set_int(contact, name, value)
%
% Sets an integer option.
%
%   contact (contact)
%   name (text)
%   value (int64)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_int', varargin{:});
end
