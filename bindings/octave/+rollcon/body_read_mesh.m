function varargout = body_read_mesh(varargin)
% BODY_READ_MESH  rollcon.body_read_mesh(body, path, part)
%
% Takes nodes, elements and names from a file, in place of the whole former mesh: a file of Gmsh if
% the name ends in .msh (versions 2 to 2.2 and 4.1, text or binary), of Abaqus or CalculiX if it ends
% in .inp. Linear and quadratic tetrahedra, wedges and hexahedra for finite-element bodies, with the
% surface elements that have a name; triangles and quadrilaterals for all others. Orders of nodes are
% changed to those of rollcon; hexahedra of 27 nodes and wedges of 18 lose those inside their faces.
% Nodes that no element has are left out, the others keep the order of the file. Groups are Gmsh's
% physical groups (nameless ones: "surface 2", ...), Abaqus's sets and surfaces. An element's tag is
% its (first) physical group in Gmsh, else 0: rollcon.body_tag_group. ERR_IO names the file, the line
% (in binary files the byte) and what is wrong there; ERR_MESH: no element that the body could take.
% Shapes are checked by rollcon.body_prepare.
%
%   body (body): with a mesh, not prepared (else ERR_STATE)
%   path (name of a file): name of the file, which ends in .msh or .inp
%   part (text, may be left out): name of a group (in any case): only its elements; "": those of the
%   whole file
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_read_mesh', varargin{:});
end
