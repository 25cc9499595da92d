function varargout = contact_set_real(varargin)
% CONTACT_SET_REAL  rollcon.contact_set_real(contact, name, value)
%
% Sets a real option.
%
%   contact (contact)
%   name (text)
%   value (real)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_real', varargin{:});
end
