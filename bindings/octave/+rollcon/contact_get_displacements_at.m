function varargout = contact_get_displacements_at(varargin)
% CONTACT_GET_DISPLACEMENTS_AT  u = rollcon.contact_get_displacements_at(contact, which, xy)
%
% Returns the elastic displacement of a body at any points of the contact surface, on the frame or off
% it, in local axes (of the point, if curved).
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
%   xy(n,2) (real): positions along t1 and t2 from the origin, length
% Results:
%   u: displacement (t1, t2, n), length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_displacements_at', varargin{:});
end
