function varargout = table_request_cancel(varargin)
% TABLE_REQUEST_CANCEL  rollcon.table_request_cancel(table)
%
% Asks a running rollcon.table_make to stop: it returns CANCELLED within a few solves. What was solved
% stays, and the next call goes on.
%
%   table (table)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_request_cancel', varargin{:});
end
