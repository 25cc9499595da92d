function varargout = context_set_threads(varargin)
% CONTEXT_SET_THREADS  rollcon.context_set_threads(context, n)
%
% Sets the number of threads that each solve, and each preparation of a body, in this context may use.
%
%   context (context)
%   n (int32): 0 to 4096; 0 (standard): OpenMP decides
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('context_set_threads', varargin{:});
end
