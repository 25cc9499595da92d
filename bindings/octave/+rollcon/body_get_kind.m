function varargout = body_get_kind(varargin)
% BODY_GET_KIND  kind = rollcon.body_get_kind(body)
%
% Returns the model given to rollcon.body_create.
%
%   body (body)
% Results:
%   kind: BODY_...
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_kind', varargin{:});
end
