function varargout = body_get_int(varargin)
% BODY_GET_INT  value = rollcon.body_get_int(body, name)
%
% Returns the value of an integer option.
%
%   body (body)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_int', varargin{:});
end
