function varargout = body_tag_group(varargin)
% BODY_TAG_GROUP  rollcon.body_tag_group(body, group, tag)
%
% Gives a tag to what the mesh's file has in a group: to volume elements (their material), to surface
% elements and faces (loads, contact faces). A group of nodes alone names the faces all of whose nodes
% it has. Later calls win.
%
%   body (body): with a mesh that was read, not prepared (else ERR_STATE)
%   group (text): name, in any case; ERR_ARGUMENT lists those that there are
%   tag (int32): that of rollcon.body_add_elements
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_tag_group', varargin{:});
end
