function varargout = contact_set_gap(varargin)
% CONTACT_SET_GAP  rollcon.contact_set_gap(contact, gap)
%
% Sets the gap of the undeformed bodies at approach 0, node by node; replaces a quadratic gap. Where a
% body has a mesh or a profile and no gap is given, it is measured along the frame's normals between
% the surfaces; a body without either is then the plane through the origin of the axes. These normals
% are level along the rolling direction (rollcon.contact_get_tractions): a gap along the surface's own
% would be longer by half the square of the angle between them.
%
%   contact (contact)
%   gap(n) (real): length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_gap', varargin{:});
end
