function varargout = contact_write_body(varargin)
% CONTACT_WRITE_BODY  rollcon.contact_write_body(contact, which, path)
%
% Writes the elements of a body of finite or boundary elements with displacements, smoothed stresses
% (xx, yy, zz, xy, yz, xz, in ParaView's order) and von Mises's stress at the nodes, under the
% tractions of the last solve and the body's own loads, as a VTU file for ParaView and meshio. The
% call is otherwise like rollcon.contact_get_fields_at.
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
%   path (name of a file): name of the file; an existing one is replaced
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_write_body', varargin{:});
end
