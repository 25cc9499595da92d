function varargout = contact_set_velocity(varargin)
% CONTACT_SET_VELOCITY  rollcon.contact_set_velocity(contact, which, velocity, angular_velocity,
%     point)
%
% Says how a body or the contact itself moves: its point at x has the velocity v + omega x (x -
% point). Creepages and spin then follow from the velocities of both bodies;
% rollcon.contact_get_motion returns them after a solve. Where bodies have profiles or meshes the
% relative velocity is taken between their surfaces, node by node: rolling radius and spin vary over
% the contact. The speed V follows from the velocity of the contact, less the mean of both bodies';
% where that is not given it is the one set by rollcon.contact_set_rolling; one of the two is needed.
% A body whose velocity is not given is at rest. What was set last counts: rollcon.contact_set_creep
% forgets all velocities, rollcon.contact_prescribe replaces one creepage or the spin and leaves the
% rest of the slip.
%
%   contact (contact)
%   which (int32, name or number: body of a contact or moving contact): BODY1, BODY2 or CONTACT_ITSELF
%   velocity(3) (real): velocity of its point at `point`, length/time
%   angular_velocity(3) (real): 1/time
%   point(3) (real): in space, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_velocity', varargin{:});
end
