function varargout = table_get_samples(varargin)
% TABLE_GET_SAMPLES  samples = rollcon.table_get_samples(table)
%
% Returns all samples; NaN where one is not solved yet. There are none in a table that was loaded, or
% before rollcon.table_make.
%
%   table (table)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_get_samples', varargin{:});
end
