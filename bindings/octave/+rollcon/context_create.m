function varargout = context_create(varargin)
% CONTEXT_CREATE  context = rollcon.context_create()
%
% Makes a context.
% Results:
%   context: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('context_create', varargin{:});
end
