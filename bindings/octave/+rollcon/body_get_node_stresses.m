function varargout = body_get_node_stresses(varargin)
% BODY_GET_NODE_STRESSES  stress = rollcon.body_get_node_stresses(body, nodes, u)
%
% Returns smoothed stresses at all nodes of a body of finite elements under given displacements of its
% nodes, or of finite or boundary elements under its own loads. Each element's stresses are taken as
% the nearest function that is linear in the element (in a hexahedron: in each direction), and
% averaged at its nodes by volume, also across materials. Stresses of boundary elements follow from
% tractions and displacements along the surface, averaged by area, over edges as well. Tension is
% positive; axes of the body. ERR_UNSUPPORTED: another kind of body, or u for boundary elements;
% ERR_ARGUMENT: another number of nodes, or stresses overflow.
%
%   body (body)
%   nodes (int64): as many as the body has
%   u(nodes,3) (real, may be left out): those of rollcon.contact_get_body_displacements, length; []:
%   those of rollcon.body_get_displacements
% Results:
%   stress: s11, s22, s33, s12, s13, s23, force/length^2
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_node_stresses', varargin{:});
end
