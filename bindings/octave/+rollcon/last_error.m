function varargout = last_error(varargin)
% LAST_ERROR  text = rollcon.last_error()
%
% Returns the text of the last call that failed in this thread: name of the function, offending entry,
% allowed range. It is empty before the first failure. Every negative status leaves its text, also
% that of a dead handle; successes do not change the last text. It is valid until the next failure in
% this thread; texts beyond 2047 bytes are cut.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('last_error', varargin{:});
end
