function varargout = wheelrail_forget_table(varargin)
% WHEELRAIL_FORGET_TABLE  rollcon.wheelrail_forget_table(wheelrail)
%
% Solves all patches in full again, like a new handle.
%
%   wheelrail (wheelrail)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_forget_table', varargin{:});
end
