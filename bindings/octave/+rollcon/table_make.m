function varargout = table_make(varargin)
% TABLE_MAKE  rollcon.table_make(table, part, parts)
%
% Solves the samples of a part of the table that are not there yet, over the context's threads; with
% the last sample the table is made. Results depend neither on the number of threads nor on the parts.
% Several processes make a part each, one of them then adds the samples of the others.
%
%   table (table)
%   part (int32): 0 to parts - 1
%   parts (int32): 1 or more; 1: the whole table
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_make', varargin{:});
end
