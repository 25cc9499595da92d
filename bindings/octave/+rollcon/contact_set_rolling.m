function varargout = contact_set_rolling(varargin)
% CONTACT_SET_ROLLING  rollcon.contact_set_rolling(contact, speed)
%
% Sets the speed V at which the contact travels over both surfaces along +t1 (omega R for a wheel).
% Forgets the velocity of the contact (rollcon.contact_set_velocity).
%
%   contact (contact)
%   speed (real): V > 0, length/time
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_rolling', varargin{:});
end
