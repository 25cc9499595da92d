function varargout = contact_frame_nodes(varargin)
% CONTACT_FRAME_NODES  rollcon.contact_frame_nodes(contact, x)
%
% Sets the nodes of the frame and forgets its elements, the gap array and the creep and friction
% fields. Component j of node i is x[i * node_stride + j * component_stride]: packed x[n][3] has
% strides 3 and 1, Fortran's X(n,3) 1 and n.
%
%   contact (contact)
%   x(n,3) (real): coordinates, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_nodes', varargin{:});
end
