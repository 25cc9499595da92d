function varargout = body_tag_faces(varargin)
% BODY_TAG_FACES  rollcon.body_tag_faces(body, elements, faces, tag)
%
% Gives a tag to boundary faces of finite elements, by element and face. Boundary faces that no call
% names have tag 0; later calls win. Faces inside the body are found by rollcon.body_prepare (ERR_MESH
% there).
%
%   body (body): of finite elements (else ERR_STATE)
%   elements(n) (int32): volume elements, in the order in which they were added over all calls
%   faces(n) (int32): face of each, in the order of TET4, ...: see the element types
%   tag (int32): names these faces in loads, contact faces and rollcon.contact_frame_from_body
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_tag_faces', varargin{:});
end
