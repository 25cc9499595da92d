function varargout = table_load(varargin)
% TABLE_LOAD  table = rollcon.table_load(context, path)
%
% Makes a table from a file of rollcon.table_save. ERR_IO: the file cannot be read, is none of these,
% truncated or changed; ERR_UNSUPPORTED: it is of another ABI number, format or byte order.
%
%   context (context)
%   path (name of a file): name of the file
% Results:
%   table: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_load', varargin{:});
end
