function varargout = table_set_poissons(varargin)
% TABLE_SET_POISSONS  rollcon.table_set_poissons(table, poissons)
%
% Makes it a table of bodies of equal elastic constants, which a new one is, and sets its Poisson's
% ratios; it is linear between two, cubic between more, and has none beyond. Call it before the first
% sample (else ERR_STATE).
%
%   table (table)
%   poissons(n) (real): ascending, -1 to 0.5
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_set_poissons', varargin{:});
end
