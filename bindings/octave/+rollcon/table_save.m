function varargout = table_save(varargin)
% TABLE_SAVE  rollcon.table_save(table, path)
%
% Writes the table to a file, whole or not at all; an older one is replaced. ERR_STATE: the table is
% not made yet.
%
%   table (table)
%   path (name of a file): name of the file
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_save', varargin{:});
end
