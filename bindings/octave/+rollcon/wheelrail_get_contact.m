function varargout = wheelrail_get_contact(varargin)
% WHEELRAIL_GET_CONTACT  contact = rollcon.wheelrail_get_contact(wheelrail, patch)
%
% Returns the contact of a patch: body 1 is the wheel, body 2 the rail, and all its results are in the
% axes contact of the patch, t1 along the rolling direction. It is there to be read: calls that change
% a contact are ERR_STATE, except rollcon.contact_set_progress and rollcon.contact_request_cancel. The
% next solve of the wheel on its rail changes it. Its solution at nodes is made by this call, and by
% each solve while the contact is held. Both are one object to threads: while either is in use, so is
% the other.
%
%   wheelrail (wheelrail)
%   patch (row): 0 to rollcon.wheelrail_get_patch_count - 1
% Results:
%   contact: of the patch
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_contact', varargin{:});
end
