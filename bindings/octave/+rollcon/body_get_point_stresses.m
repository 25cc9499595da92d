function varargout = body_get_point_stresses(varargin)
% BODY_GET_POINT_STRESSES  [stress, xyz] = rollcon.body_get_point_stresses(body, nodes, u)
%
% Returns stresses at the integration points of all finite elements, element by element, with which
% the elements themselves balance loads, and the points' places. The call is otherwise like
% rollcon.body_get_node_stresses.
%
%   body (body)
%   nodes (int64): as many as the body has
%   u(nodes,3) (real, may be left out): displacements of the nodes; []: those of
%   rollcon.body_get_displacements
% Results:
%   stress: s11, s22, s33, s12, s13, s23, force/length^2; []: not wanted
%   xyz: places in the body's axes, length; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_point_stresses', varargin{:});
end
