function varargout = wheelrail_set_friction(varargin)
% WHEELRAIL_SET_FRICTION  rollcon.wheelrail_set_friction(wheelrail, law, parameters)
%
% Sets the law of friction. "coulomb": mu. "by_angle": coefficients by the inclination of the rail's
% surface, linear between points and constant beyond them: lubricated gauge faces under dry heads. The
% inclination is atan dz/dy of a right rail with y to the right and z down, its cant included, its
% deviation not: negative on the gauge face; left rails are mirrored, so that one table serves both.
%
%   wheelrail (wheelrail)
%   law (text): coulomb or by_angle
%   parameters(n) (real): mu; angle1, mu1, angle2, mu2, ... with ascending angles, radian. Coefficients
%   0 to 10
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_friction', varargin{:});
end
