function varargout = table_evaluate_derivatives(varargin)
% TABLE_EVALUATE_DERIVATIVES  [results, derivatives] = rollcon.table_evaluate_derivatives(table,
%     inputs)
%
% Does what rollcon.table_evaluate does, and returns derivatives by all inputs, which are continuous.
%
%   table (table)
%   inputs(n,9) (real): those of rollcon.table_evaluate
% Results:
%   results: those of rollcon.table_evaluate
%   derivatives: derivative of each result by each input
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_evaluate_derivatives', varargin{:});
end
