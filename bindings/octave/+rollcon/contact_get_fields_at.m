function varargout = contact_get_fields_at(varargin)
% CONTACT_GET_FIELDS_AT  [u, stress] = rollcon.contact_get_fields_at(contact, which, xyz, in_axes)
%
% Returns displacements and stresses at any points inside a body, or on its surface, under the
% tractions of the last solve and the body's own loads. Tension is positive. Half-spaces: tractions
% (rollcon.contact_get_tractions) are interpolated by the frame's shape functions; body 1 fills n <= 0
% and body 2 n >= 0, on the surface n = 0 results are the limits from inside; every stress is within
% the option stress_accuracy times the largest traction of the exact integrals. Where tractions jump
% (at the rim of a frame that ends under load) stresses along the surface grow like a logarithm and
% are given for a depth of 1e-8 of the smallest element. On a curved frame the local components of
% tractions act on the plane of the axes, which they do in the solve, too. Finite elements: what
% rollcon.body_get_fields_at gives for rollcon.contact_get_body_displacements. Boundary elements:
% Somigliana's identities, as near to the surface as wanted, and on it; errors there are those of the
% solution, and largest where tractions jump. ERR_UNSUPPORTED: a rigid body; ERR_ARGUMENT: a point is
% outside, and by how much of a surface of boundary elements (a millionth of the element's size beyond
% its faces is still inside).
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
%   xyz(n,3) (real): in these axes, length
%   in_axes (int32, name or number: axes of points): IN_CONTACT or IN_BODY: of points and results
% Results:
%   u: displacement, length; []: not wanted
%   stress: s11, s22, s33, s12, s13, s23, force/length^2; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_fields_at', varargin{:});
end
