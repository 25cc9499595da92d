function varargout = wheelrail_set_velocity(varargin)
% WHEELRAIL_SET_VELOCITY  rollcon.wheelrail_set_velocity(wheelrail, velocity)
%
% Sets the velocity of the wheelset.
%
%   wheelrail (wheelrail)
%   velocity(6) (real): rates of the position, length/time and 1/time; the forward speed, the first, is
%   not 0; the pitch rate of a wheel that rolls forward is negative
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_velocity', varargin{:});
end
