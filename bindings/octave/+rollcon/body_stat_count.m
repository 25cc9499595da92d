function varargout = body_stat_count(varargin)
% BODY_STAT_COUNT  value = rollcon.body_stat_count()
%
% Returns the number of statistics of bodies.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_stat_count', varargin{:});
end
