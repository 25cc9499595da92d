function varargout = contact_frame_add_elements(varargin)
% CONTACT_FRAME_ADD_ELEMENTS  rollcon.contact_frame_add_elements(contact, type, connectivity, tag)
%
% Adds elements of one type to the frame. Types may be mixed by several calls. Shapes are checked by
% the solve (ERR_MESH there).
%
%   contact (contact)
%   type (int32, name or number: element type): TRI3, TRI6, QUAD4, QUAD8 or QUAD9
%   connectivity(n,nodes) (int32): node ids
%   tag (int32): free label of these elements, written to files
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_add_elements', varargin{:});
end
