function varargout = body_set_int(varargin)
% BODY_SET_INT  rollcon.body_set_int(body, name, value)
%
% Sets an integer option.
%
%   body (body): not prepared (ERR_STATE)
%   name (text)
%   value (int64)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_int', varargin{:});
end
