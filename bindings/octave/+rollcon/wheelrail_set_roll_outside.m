function varargout = wheelrail_set_roll_outside(varargin)
% WHEELRAIL_SET_ROLL_OUTSIDE  rollcon.wheelrail_set_roll_outside(wheelrail, on)
%
% Says in which order positions turn a wheelset. A point of it is pitched about its axle; then it is
% either yawed about z and rolled about x, which is CONTACT's order, or rolled and then yawed, which
% is that of a new handle. Rates of roll and yaw are those of these angles. It counts from the next
% solve, also for positions that were set before. Both orders agree without roll or without yaw.
%
%   wheelrail (wheelrail)
%   on (int32): 1: the roll outside the yaw; 0: the yaw outside the roll, the standard
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_roll_outside', varargin{:});
end
