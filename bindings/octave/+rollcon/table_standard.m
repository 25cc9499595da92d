function varargout = table_standard(varargin)
% TABLE_STANDARD  table = rollcon.table_standard(context)
%
% Makes the table that comes with the library: steel on steel, Poisson's ratios 0.28 to 0.3, ratios of
% semi-axes 1/25 to 25. Its file steel.rct is looked for in the folder that the environment variable
% DATA names, in share/rollcon above the library, and where the library was to be installed (else
% ERR_IO).
%
%   context (context)
% Results:
%   table: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_standard', varargin{:});
end
