function varargout = context_release(varargin)
% CONTEXT_RELEASE  rollcon.context_release(context)
%
% Drops a reference; the handle is dead after the last one. Bodies and contacts made from the context
% keep what they need of it. [] and dead handles are ignored.
%
%   context (context)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('context_release', varargin{:});
end
