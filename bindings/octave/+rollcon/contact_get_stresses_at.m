function varargout = contact_get_stresses_at(varargin)
% CONTACT_GET_STRESSES_AT  [stress, u] = rollcon.contact_get_stresses_at(contact, which, xyz)
%
% Returns stresses and elastic displacements at any points inside a body, or on its surface, under the
% tractions of the last solve (those of rollcon.contact_get_tractions, interpolated by the frame's
% shape functions). The body must be an elastic half-space. Points and results are in the contact's
% axes: body 1 fills n <= 0 and body 2 n >= 0, on its surface n = 0 results are the limits from
% inside. Tension is positive. Every stress is within the option stress_accuracy times the largest
% traction of the exact integrals. Where tractions jump (at the rim of a frame that ends under load)
% stresses along the surface grow like a logarithm and are given for a depth of 1e-8 of the smallest
% element. On a curved frame the local components of tractions act on the plane of the axes, which
% they do in the solve, too. ERR_UNSUPPORTED: another kind of body; ERR_ARGUMENT: a point outside of
% the body.
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
%   xyz(n,3) (real): positions along t1, t2 and n from the origin, length
% Results:
%   stress: s11, s22, snn, s12, s1n, s2n, force/length^2; []: not wanted
%   u: displacement (t1, t2, n), length; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_stresses_at', varargin{:});
end
