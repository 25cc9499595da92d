function varargout = stat_count(varargin)
% STAT_COUNT  value = rollcon.stat_count(kind)
%
% Returns the number of statistics of a kind of object; 0 for kinds without statistics and for unknown
% numbers.
%
%   kind (int32, name or number: kind of object): OF_...
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('stat_count', varargin{:});
end
