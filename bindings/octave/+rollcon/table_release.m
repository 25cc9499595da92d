function varargout = table_release(varargin)
% TABLE_RELEASE  rollcon.table_release(table)
%
% Drops a reference; the handle is dead after the last one. [] and dead handles are ignored.
%
%   table (table)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_release', varargin{:});
end
