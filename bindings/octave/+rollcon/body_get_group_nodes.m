function varargout = body_get_group_nodes(varargin)
% BODY_GET_GROUP_NODES  nodes = rollcon.body_get_group_nodes(body, group)
%
% Returns the nodes of all that a group has, ascending, for rollcon.body_set_support and
% rollcon.body_tag_faces_of_nodes.
%
%   body (body)
%   group (text): name, in any case; ERR_ARGUMENT lists those that there are
% Results:
%   nodes: node ids; [] only with capacity 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_group_nodes', varargin{:});
end
