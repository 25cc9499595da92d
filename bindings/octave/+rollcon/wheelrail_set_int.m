function varargout = wheelrail_set_int(varargin)
% WHEELRAIL_SET_INT  rollcon.wheelrail_set_int(wheelrail, name, value)
%
% Sets an integer option.
%
%   wheelrail (wheelrail)
%   name (text)
%   value (int64)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_int', varargin{:});
end
