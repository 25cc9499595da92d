function varargout = context_set_latch(varargin)
% CONTEXT_SET_LATCH  rollcon.context_set_latch(context, on)
%
% Turns the latch on or off, for programs that check once, at the end. While the latch is on, the
% first call that fails on the context or on what was made from it is remembered, and every later one
% does nothing and returns the same status, with the same last error. Release, retain,
% rollcon.contact_request_cancel, rollcon.body_get_kind and the calls of this latch work on. Outputs
% of calls that do nothing keep the values that they had, handles to be made are []. Calls that have
% no live handle belong to no context.
%
%   context (context)
%   on (int32, may be left out): 1: on, 0: off (standard); either forgets what was remembered
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('context_set_latch', varargin{:});
end
