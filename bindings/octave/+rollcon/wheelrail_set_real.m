function varargout = wheelrail_set_real(varargin)
% WHEELRAIL_SET_REAL  rollcon.wheelrail_set_real(wheelrail, name, value)
%
% Sets a real option.
%
%   wheelrail (wheelrail)
%   name (text)
%   value (real)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_real', varargin{:});
end
