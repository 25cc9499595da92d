function varargout = contact_get_body_fields_at(varargin)
% CONTACT_GET_BODY_FIELDS_AT  [displacement, stress] = rollcon.contact_get_body_fields_at(contact,
%     which, xyz)
%
% Returns displacements and stresses at any points inside a body of finite or boundary elements under
% the tractions of the last solve and the body's own loads, in the body's axes; tension is positive.
% Those of finite elements are what rollcon.body_get_fields_at gives for
% rollcon.contact_get_body_displacements. Those of boundary elements follow from Somigliana's
% identities, as near to the surface as wanted, and on it: errors there are those of the solution, and
% largest where tractions jump. ERR_UNSUPPORTED: another kind of body (for half-spaces see
% rollcon.contact_get_stresses_at); ERR_ARGUMENT: a point is outside, and by how much of a surface of
% boundary elements (a millionth of the element's size beyond its faces is still inside).
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
%   xyz(n,3) (real): in the body's axes, length
% Results:
%   displacement: x y z, length; []: not wanted
%   stress: s11, s22, s33, s12, s13, s23, force/length^2; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_body_fields_at', varargin{:});
end
