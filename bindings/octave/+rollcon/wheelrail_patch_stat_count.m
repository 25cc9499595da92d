function varargout = wheelrail_patch_stat_count(varargin)
% WHEELRAIL_PATCH_STAT_COUNT  value = rollcon.wheelrail_patch_stat_count()
%
% Returns the number of statistics of a patch.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_patch_stat_count', varargin{:});
end
