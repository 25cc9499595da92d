function varargout = contact_frame_from_body(varargin)
% CONTACT_FRAME_FROM_BODY  rollcon.contact_frame_from_body(contact, which, tag)
%
% Makes the faces of a body that carry a tag the frame: replaces nodes and elements of the frame and
% forgets the gap array and the creep and friction fields. Its nodes are those of the faces, in the
% order of their ids in the body, and follow the body's pose. For finite-element bodies with tri6
% among these faces (tet10, the ends of wedge15) they are the corners alone, and the frame's elements
% linear: rollcon.contact_get_size tells how many. Faces of body 2 are turned over, so that the
% frame's normals point out of body 1.
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2, prepared or not
%   tag (int32): of some element of it (else ERR_ARGUMENT)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_from_body', varargin{:});
end
