function varargout = status_string(varargin)
% STATUS_STRING  text = rollcon.status_string(status)
%
% Returns one line of text for a status; "unknown status" for other numbers.
%
%   status (int32): any number
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('status_string', varargin{:});
end
