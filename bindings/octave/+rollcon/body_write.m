function varargout = body_write(varargin)
% BODY_WRITE  rollcon.body_write(body, path, nodes, u)
%
% Writes the elements of a body of finite or boundary elements with displacements, smoothed stresses
% (xx, yy, zz, xy, yz, xz, in ParaView's order) and von Mises's stress at the nodes as a VTU file for
% ParaView and meshio. The call is otherwise like rollcon.body_get_node_stresses.
%
%   body (body)
%   path (name of a file): name of the file; an existing one is replaced
%   nodes (int64): as many as the body has
%   u(nodes,3) (real, may be left out): displacements of the nodes; []: those of
%   rollcon.body_get_displacements
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_write', varargin{:});
end
