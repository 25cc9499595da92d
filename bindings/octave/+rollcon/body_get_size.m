function varargout = body_get_size(varargin)
% BODY_GET_SIZE  [nodes, elements] = rollcon.body_get_size(body)
%
% Returns the nodes and elements given so far; 0 for bodies without a mesh. It works before
% rollcon.body_prepare.
%
%   body (body)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_size', varargin{:});
end
