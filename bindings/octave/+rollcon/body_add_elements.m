function varargout = body_add_elements(varargin)
% BODY_ADD_ELEMENTS  rollcon.body_add_elements(body, type, connectivity, tag)
%
% Adds elements of one type; types may be mixed by several calls. Surface elements: corners run
% counter-clockwise seen from outside the body, so that normals point outwards. Finite-element bodies
% take volume elements, whose outer faces are their surface, and surface elements too, which only give
% their tag to the boundary face with the same nodes. Shapes, orientation and closedness are checked
% by rollcon.body_prepare (ERR_MESH there).
%
%   body (body)
%   type (int32, name or number: element type): TRI3, TRI6, QUAD4, QUAD8 or QUAD9; finite elements: also
%   TET4, TET10, WEDGE6, WEDGE15, HEX8, HEX20
%   connectivity(n,nodes) (int32): node ids
%   tag (int32): surface elements: names these faces in loads, contact faces and
%   rollcon.contact_frame_from_body; tractions may jump where tags meet. Volume elements: names their
%   material
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_add_elements', varargin{:});
end
