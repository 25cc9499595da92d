function varargout = wheelrail_get_real(varargin)
% WHEELRAIL_GET_REAL  value = rollcon.wheelrail_get_real(wheelrail, name)
%
% Returns the value of a real option.
%
%   wheelrail (wheelrail)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_real', varargin{:});
end
