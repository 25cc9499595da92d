function varargout = table_set_poissons(varargin)
% TABLE_SET_POISSONS  rollcon.table_set_poissons(table, poissons)
%
% Sets the Poisson's ratios of the table; it is linear between them, and has none beyond. Before the
% first sample (else ERR_STATE).
%
%   table (table)
%   poissons(n) (real): ascending, -1 to 0.5
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_set_poissons', varargin{:});
end
