function varargout = body_create(varargin)
% BODY_CREATE  body = rollcon.body_create(context, kind)
%
% Makes a body.
%
%   context (context)
%   kind (int32, name or number: body kind): BODY_...
% Results:
%   body: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_create', varargin{:});
end
