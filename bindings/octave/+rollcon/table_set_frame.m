function varargout = table_set_frame(varargin)
% TABLE_SET_FRAME  rollcon.table_set_frame(table, along, across)
%
% Sets the coarser of the two frames of strips on which samples of circles are solved; those of longer
% ellipses have more cells along their length and fewer across. Call it before the first sample (else
% ERR_STATE).
%
%   table (table)
%   along (int32): elements along each strip, 6 to 100; the finer frame has twice as many
%   across (int32): strips, 4 to 100; the finer frame has twice as many
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_set_frame', varargin{:});
end
