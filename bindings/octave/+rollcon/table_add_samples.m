function varargout = table_add_samples(varargin)
% TABLE_ADD_SAMPLES  rollcon.table_add_samples(table, samples)
%
% Adds the samples that another table of the same settings has (rollcon.table_get_samples); NaN adds
% none. With the last sample the table is made.
%
%   table (table)
%   samples(n) (real)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_add_samples', varargin{:});
end
