function varargout = contact_set_heat(varargin)
% CONTACT_SET_HEAT  rollcon.contact_set_heat(contact, which, conductivity, heat_capacity, temperature)
%
% Says what a body does with heat, for the surface temperatures of a solution
% (rollcon.contact_get_temperatures_at, FIELD_TEMPERATURE) and for friction that depends on them. The
% call is needed for both bodies; one of them may take up no heat.
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
%   conductivity (real): >= 0, power/(length temperature)
%   heat_capacity (real): >= 0, energy/(volume temperature): density times specific heat
%   temperature (real): temperature far from the contact
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_heat', varargin{:});
end
