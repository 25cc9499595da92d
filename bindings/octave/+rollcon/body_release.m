function varargout = body_release(varargin)
% BODY_RELEASE  rollcon.body_release(body)
%
% Drops a reference; the handle is dead after the last one. Contacts keep their bodies alive. [] and
% dead handles are ignored.
%
%   body (body)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_release', varargin{:});
end
