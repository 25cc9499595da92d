function varargout = contact_set_creep(varargin)
% CONTACT_SET_CREEP  rollcon.contact_set_creep(contact, longitudinal, lateral, spin)
%
% Prescribes creepages and spin by motion: rigid slip c = V (longitudinal - spin y, lateral + spin x)
% of body 1 relative to body 2. The call stands for three calls of rollcon.contact_prescribe, and
% forgets the velocities of rollcon.contact_set_velocity.
%
%   contact (contact)
%   longitudinal (real, may be left out): creepage along t1, dimensionless
%   lateral (real, may be left out): creepage along t2, dimensionless
%   spin (real, may be left out): 1/length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_creep', varargin{:});
end
