function varargout = table_set_resolution(varargin)
% TABLE_SET_RESOLUTION  rollcon.table_set_resolution(table, magnitudes, angles, directions)
%
% Sets how fine the table is in the creepages. Call it before the first sample (else ERR_STATE).
%
%   table (table)
%   magnitudes (int32): intervals from none to vast creepages, 4 to 100
%   angles (int32): intervals from pure spin to none, 4 to 100
%   directions (int32): directions of the translational creepage in half a turn, even, 4 to 32
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_set_resolution', varargin{:});
end
