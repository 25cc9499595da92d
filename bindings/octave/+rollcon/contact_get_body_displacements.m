function varargout = contact_get_body_displacements(varargin)
% CONTACT_GET_BODY_DISPLACEMENTS  u = rollcon.contact_get_body_displacements(contact, which)
%
% Returns displacements of all nodes of a body of finite or boundary elements under the tractions of
% the last solve and the body's own loads, in the body's axes. Under a frame of its own finer than the
% body's faces these are the tractions that the elements feel (docs/theory.md, section 10). The first
% call for a body factorises its stiffness once more, with nothing condensed; contacts and solves
% after that use the factors (unless its option keep_factors is 0); boundary elements have theirs.
% ERR_UNSUPPORTED: another kind of body.
%
%   contact (contact)
%   which (int32, name or number: body of a contact): BODY1 or BODY2
% Results:
%   u: displacement x y z of each node, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_body_displacements', varargin{:});
end
