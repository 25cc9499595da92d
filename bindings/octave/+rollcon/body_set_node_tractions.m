function varargout = body_set_node_tractions(varargin)
% BODY_SET_NODE_TRACTIONS  rollcon.body_set_node_tractions(body, tag, nodes, along, tractions)
%
% Prescribes tractions at nodes of the faces with a tag, interpolated by the faces' shape functions,
% zero at nodes not named; replaces what an earlier call gave for the tag, and adds to its traction
% and pressure. With a direction, `along`, the three components act along its part in the surface,
% across (the outward normal times that), and along the outward normal. At rollcon.body_prepare,
% ERR_MESH: a node is on no face with the tag, or the direction is normal to one.
%
%   body (body)
%   tag (int32): of some face (else ERR_ARGUMENT)
%   nodes(n) (int32): node ids; ERR_MESH if out of range
%   along(3) (real, may be left out): direction of the first component; [] or 0 0 0: components along x
%   y z
%   tractions(n,3) (real): force/length^2, -1e100 to 1e100
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_node_tractions', varargin{:});
end
