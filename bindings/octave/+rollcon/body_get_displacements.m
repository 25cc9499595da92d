function varargout = body_get_displacements(varargin)
% BODY_GET_DISPLACEMENTS  u = rollcon.body_get_displacements(body)
%
% Returns the displacement of every node under the body's own loads and given displacements; zero when
% there are none, and for rigid bodies.
%
%   body (body)
% Results:
%   u: displacement x y z, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_displacements', varargin{:});
end
