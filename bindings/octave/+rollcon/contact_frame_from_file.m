function varargout = contact_frame_from_file(varargin)
% CONTACT_FRAME_FROM_FILE  rollcon.contact_frame_from_file(contact, path, part)
%
% Makes the surface elements of a mesh file the frame; replaces frame and all that was given for its
% nodes. The files are those of rollcon.body_read_mesh. Tags of elements are Gmsh's physical groups,
% else 0.
%
%   contact (contact)
%   path (name of a file): name of the file, which ends in .msh or .inp
%   part (text, may be left out): name of a group (in any case): only its elements; "": those of the
%   whole file
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_from_file', varargin{:});
end
