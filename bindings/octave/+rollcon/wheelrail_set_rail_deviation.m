function varargout = wheelrail_set_rail_deviation(varargin)
% WHEELRAIL_SET_RAIL_DEVIATION  rollcon.wheelrail_set_rail_deviation(wheelrail, deviation, rate)
%
% Sets the deviation of the rail from its place in the track and how it changes: irregularities, and
% rails that give way. The standard is 0.
%
%   wheelrail (wheelrail)
%   deviation(3) (real): along y and z, length; roll, radian, about the point where the gauge is
%   measured, at the height of the rails' top, -0.5 to 0.5
%   rate(3) (real): rates of these, length/time and 1/time
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_rail_deviation', varargin{:});
end
