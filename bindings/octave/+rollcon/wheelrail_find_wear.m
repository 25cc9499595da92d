function varargout = wheelrail_find_wear(varargin)
% WHEELRAIL_FIND_WEAR  [wheel, rail, volumes, status] = rollcon.wheelrail_find_wear(wheelrail,
%     n_cases, positions, velocities, weights, law, parameters, points)
%
% Finds the wear of wheel and rail by a spectrum of positions: solves them like
% rollcon.wheelrail_solve_many, and adds the depths that a pass of each wears off either body
% (rollcon.contact_get_wear) times its weight. A pass is one revolution of the wheel, or one wheel
% over the rail. Depths are normal to the profiles, at points at equal arc lengths from end to end
% (rollcon.body_get_profile_point); depth times the points' lengths of the profile adds up to the
% volume. Patches of a wheel count with their weights. Positions without a solution wear nothing, and
% are reported the way rollcon.wheelrail_solve_many reports them. ERR_STATE: something is missing, or
% forces come from a table (rollcon.wheelrail_set_table), which knows of no slip.
%
%   wheelrail (wheelrail)
%   n_cases (int64): 1 to 100000
%   positions(n_cases,6) (real): those of rollcon.wheelrail_set_position
%   velocities(n_cases,6) (real): those of rollcon.wheelrail_set_velocity
%   weights(n_cases) (real, may be left out): >= 0; []: each 1/n_cases
%   law (text): that of rollcon.contact_get_wear
%   parameters(n) (real): of the law
%   points (int64): 2 to 1000000, times n_cases at most 2e7
% Results:
%   wheel: depth per pass, length; []: not wanted
%   rail: depth per pass, length; []: not wanted
%   volumes: per length rolled, of wheel and rail, length^2; []: not wanted
%   status: what rollcon.wheelrail_solve would return for each
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_find_wear', varargin{:});
end
