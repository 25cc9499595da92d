function varargout = contact_set_pose(varargin)
% CONTACT_SET_POSE  rollcon.contact_set_pose(contact, which, rotation, translation)
%
% Says where a body with a mesh stands: x = rotation x_body + translation, at approach 0. Standard:
% identity and zero. Half-spaces ignore it: their surface is the frame's.
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
%   rotation(3,3) (real): by rows; orthonormal with determinant +1 to 1e-6 (else ERR_ARGUMENT), then
%   made exactly so
%   translation(3) (real): length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_pose', varargin{:});
end
