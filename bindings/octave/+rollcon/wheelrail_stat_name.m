function varargout = wheelrail_stat_name(varargin)
% WHEELRAIL_STAT_NAME  text = rollcon.wheelrail_stat_name(i)
%
% Returns the name of a statistic of a wheel on its rail.
%
%   i (row): 0 to rollcon.wheelrail_stat_count() - 1
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_stat_name', varargin{:});
end
