function varargout = table_set_ratios(varargin)
% TABLE_SET_RATIOS  rollcon.table_set_ratios(table, intervals, least, greatest)
%
% Sets which ratios a / b of semi-axes the table has. Call it before the first sample (else
% ERR_STATE).
%
%   table (table)
%   intervals (int32): intervals of the logarithm of the ratio, 4 to 100
%   least (real): 0.01 or more
%   greatest (real): more than the least, at most 100
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_set_ratios', varargin{:});
end
