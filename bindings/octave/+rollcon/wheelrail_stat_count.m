function varargout = wheelrail_stat_count(varargin)
% WHEELRAIL_STAT_COUNT  value = rollcon.wheelrail_stat_count()
%
% Returns the number of statistics of a wheel on its rail.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_stat_count', varargin{:});
end
