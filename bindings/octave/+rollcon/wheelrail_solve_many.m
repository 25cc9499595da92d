function varargout = wheelrail_solve_many(varargin)
% WHEELRAIL_SOLVE_MANY  [totals, status] = rollcon.wheelrail_solve_many(wheelrail, positions,
%     velocities, columns)
%
% Solves many positions on the threads of the context, each by itself from nothing, as after
% rollcon.wheelrail_reset, with what else is set: results do not depend on the other positions, their
% order, or the number of threads, to the last bit. Columns of totals are force_x, force_y, force_z,
% moment_x, moment_y, moment_z on the wheel in the track (rollcon.wheelrail_get_resultant), z,
% vertical_force, friction_power. A position that fails has its negative status and NaN and does not
% affect the others; texts go to the log as warnings. The status returned is the worst in the order
% that holds for all calls; CANCELLED says that some were not solved. The wheel and its last solution
% do not change.
%
%   wheelrail (wheelrail)
%   positions(n,6) (real, may be left out): those of rollcon.wheelrail_set_position; [] only with n = 0
%   velocities(n,6) (real, may be left out): those of rollcon.wheelrail_set_velocity; [] only with n = 0
%   columns (text): names separated by blanks, each a number of a row
% Results:
%   totals: a row for each position, the columns side by side; [] only with n = 0
%   status: what rollcon.wheelrail_solve would return for each
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_solve_many', varargin{:});
end
