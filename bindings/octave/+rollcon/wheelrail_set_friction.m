function varargout = wheelrail_set_friction(varargin)
% WHEELRAIL_SET_FRICTION  rollcon.wheelrail_set_friction(wheelrail, mu)
%
% Sets the coefficient of Coulomb's friction. It is not needed where
% rollcon.wheelrail_set_friction_by_angle gives it.
%
%   wheelrail (wheelrail)
%   mu (real): 0 to 10
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_friction', varargin{:});
end
