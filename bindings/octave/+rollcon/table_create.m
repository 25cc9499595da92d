function varargout = table_create(varargin)
% TABLE_CREATE  table = rollcon.table_create(context)
%
% Makes a table without samples. The standard is semi-axes' ratios a / b 1/25 to 25 in 12 intervals,
% 18 magnitudes, 16 angles, 16 directions, the frames of rollcon.table_set_frame(12, 10), Poisson's
% ratios 0.28 and 0.3.
%
%   context (context)
% Results:
%   table: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_create', varargin{:});
end
