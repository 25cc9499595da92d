function varargout = stat_count(varargin)
% STAT_COUNT  value = rollcon.stat_count()
%
% Returns the number of statistics.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('stat_count', varargin{:});
end
