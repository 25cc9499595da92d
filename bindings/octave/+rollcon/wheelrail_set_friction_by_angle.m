function varargout = wheelrail_set_friction_by_angle(varargin)
% WHEELRAIL_SET_FRICTION_BY_ANGLE  rollcon.wheelrail_set_friction_by_angle(wheelrail, points)
%
% Sets coefficients by the inclination of the rail's surface, linear between points and constant
% beyond them, in place of that of rollcon.wheelrail_set_friction: lubricated gauge faces under dry
% heads. The inclination is atan dz/dy of a right rail with y to the right and z down, its cant
% included, its deviation not: negative on the gauge face; left rails are mirrored, so that one table
% serves both.
%
%   wheelrail (wheelrail)
%   points(n,2) (real, may be left out): inclination, radian, ascending, and mu, 0 to 10; [] only with n
%   = 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_friction_by_angle', varargin{:});
end
