function varargout = wheelrail_release(varargin)
% WHEELRAIL_RELEASE  rollcon.wheelrail_release(wheelrail)
%
% Drops a reference; the handle is dead after the last one. Contacts of its patches live on. [] and
% dead handles are ignored.
%
%   wheelrail (wheelrail)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_release', varargin{:});
end
