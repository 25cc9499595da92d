function varargout = body_set_nodes(varargin)
% BODY_SET_NODES  rollcon.body_set_nodes(body, x)
%
% Sets the nodes and forgets elements, supports, loads and contact faces. Component j of node i is x[i
% * node_stride + j * component_stride]: packed x[n][3] has strides 3 and 1, Fortran's X(n,3) 1 and n.
%
%   body (body)
%   x(n,3) (real): coordinates, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_nodes', varargin{:});
end
