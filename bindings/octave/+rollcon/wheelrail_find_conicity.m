function varargout = wheelrail_find_conicity(varargin)
% WHEELRAIL_FIND_CONICITY  [conicity, wavelength] = rollcon.wheelrail_find_conicity(left, right,
%     amplitude)
%
% Finds the equivalent conicities of EN 15302: those of cones whose free wheelset has the same
% wavelength at the same amplitude of its kinematic motion, from the rolling-radius difference by
% integration of y'' = -difference / (e r). Shifts count at the height of the rails.
%
%   left (wheelrail): made with LEFT
%   right (wheelrail): made with RIGHT
%   amplitude(n) (real): half the distance of the turning points, > 0, length; such that the wheelset
%   comes back
% Results:
%   conicity: tan gamma_e
%   wavelength: of the motion, length: with the distance e of the points of contact and the rolling
%   radius r where the wheelset runs straight on
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_find_conicity', varargin{:});
end
