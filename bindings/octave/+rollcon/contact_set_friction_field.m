function varargout = contact_set_friction_field(varargin)
% CONTACT_SET_FRICTION_FIELD  rollcon.contact_set_friction_field(contact, mu)
%
% Sets the friction coefficient node by node, in place of that of rollcon.contact_set_friction.
%
%   contact (contact)
%   mu(n) (real, may be left out): >= 0; [] only with n = 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_friction_field', varargin{:});
end
