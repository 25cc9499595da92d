function varargout = body_set_real(varargin)
% BODY_SET_REAL  rollcon.body_set_real(body, name, value)
%
% Sets a real option.
%
%   body (body): not prepared (ERR_STATE)
%   name (text)
%   value (real)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_real', varargin{:});
end
