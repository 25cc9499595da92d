function varargout = wheelrail_reset(varargin)
% WHEELRAIL_RESET  rollcon.wheelrail_reset(wheelrail)
%
% Forgets the solution and the warm starts; keeps what was set and all that was computed for the
% frames.
%
%   wheelrail (wheelrail)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_reset', varargin{:});
end
