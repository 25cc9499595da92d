function varargout = context_check(varargin)
% CONTEXT_CHECK  status = rollcon.context_check(context)
%
% Returns the first failure since the latch was set, whose text becomes the last error; without one
% the first status > 0 (a solve that did not converge, ...); without either, or with the latch off,
% OK. Any negative status may be returned.
%
%   context (context)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('context_check', varargin{:});
end
