function varargout = table_evaluate_derivatives(varargin)
% TABLE_EVALUATE_DERIVATIVES  [results, derivatives] = rollcon.table_evaluate_derivatives(table,
%     inputs)
%
% The same with derivatives, which are continuous, by all inputs.
%
%   table (table)
%   inputs(n,9) (real): as rollcon.table_evaluate takes them
% Results:
%   results: likewise
%   derivatives: of each result by each input
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_evaluate_derivatives', varargin{:});
end
