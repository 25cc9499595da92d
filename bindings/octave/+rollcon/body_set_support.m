function varargout = body_set_support(varargin)
% BODY_SET_SUPPORT  rollcon.body_set_support(body, nodes, dof_mask, values)
%
% Holds displacement components of nodes, at zero or at given values. The call adds to what is held
% already; a component held twice takes the last value. A face is held where all its nodes are. A
% contact moves what is held rigidly with approach and creepage; values deform the body on top of
% that.
%
%   body (body)
%   nodes(n) (int32): node ids; ERR_MESH if out of range
%   dof_mask (int32, name or number: dof): sum of DOF_X, DOF_Y, DOF_Z: the components held, 1 to 7
%   values(n,3) (real, may be left out): displacements x y z, length, -1e100 to 1e100; components
%   outside of dof_mask are ignored; []: zero
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_support', varargin{:});
end
