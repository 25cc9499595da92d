function varargout = wheelrail_get_int(varargin)
% WHEELRAIL_GET_INT  value = rollcon.wheelrail_get_int(wheelrail, name)
%
% Returns the value of an integer option.
%
%   wheelrail (wheelrail)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_int', varargin{:});
end
