function varargout = stat_name(varargin)
% STAT_NAME  text = rollcon.stat_name(i)
%
% Returns the name of a statistic.
%
%   i (row): 0 to rollcon.stat_count() - 1
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('stat_name', varargin{:});
end
