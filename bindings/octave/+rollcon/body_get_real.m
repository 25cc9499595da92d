function varargout = body_get_real(varargin)
% BODY_GET_REAL  value = rollcon.body_get_real(body, name)
%
% Returns the value of a real option.
%
%   body (body)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_real', varargin{:});
end
