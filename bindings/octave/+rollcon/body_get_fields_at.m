function varargout = body_get_fields_at(varargin)
% BODY_GET_FIELDS_AT  [displacement, stress] = rollcon.body_get_fields_at(body, nodes, u, xyz)
%
% Returns displacements and stresses at any points inside a body: for finite elements the smoothed
% ones of nodes, interpolated by the elements' shape functions, for boundary elements by Somigliana's
% identities, as near to the surface as wanted, and on it. The call is otherwise like
% rollcon.body_get_node_stresses. ERR_ARGUMENT also: a point is outside (a millionth of the element's
% size beyond its faces is still inside).
%
%   body (body)
%   nodes (int64): as many as the body has
%   u(nodes,3) (real, may be left out): displacements of the nodes; []: those of
%   rollcon.body_get_displacements
%   xyz(n,3) (real): in the body's axes, length
% Results:
%   displacement: x y z, length; []: not wanted
%   stress: s11, s22, s33, s12, s13, s23, force/length^2; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_fields_at', varargin{:});
end
