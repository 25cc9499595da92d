function varargout = context_set_threads(varargin)
% CONTEXT_SET_THREADS  rollcon.context_set_threads(context, n)
%
% Sets the most threads that each solve, each preparation of a body and each list of cases, positions
% or samples in this context may use. Many parts use fewer: the BLAS has one thread on frames of less
% than 2000 nodes and where operators are not dense, sparse factorisations have one and that of the
% BLAS, each case of a list has one, and inside a parallel region of the caller everything has one.
%
%   context (context)
%   n (int32): 0 to 4096; 0 (standard): as many as OpenMP would use
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('context_set_threads', varargin{:});
end
