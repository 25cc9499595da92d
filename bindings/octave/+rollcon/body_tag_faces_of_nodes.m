function varargout = body_tag_faces_of_nodes(varargin)
% BODY_TAG_FACES_OF_NODES  rollcon.body_tag_faces_of_nodes(body, nodes, tag)
%
% Gives a tag to the faces all of whose nodes are given, midside nodes too: boundary faces of finite
% elements (later calls win over earlier ones), or surface elements added so far. rollcon.body_prepare
% refuses loads and contact faces whose tag is then on no face (ERR_MESH).
%
%   body (body): with elements
%   nodes(n) (int32): node ids; ERR_MESH if out of range
%   tag (int32): names these faces in loads, contact faces and rollcon.contact_frame_from_body
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_tag_faces_of_nodes', varargin{:});
end
