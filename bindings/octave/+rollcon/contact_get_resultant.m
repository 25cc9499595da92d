function varargout = contact_get_resultant(varargin)
% CONTACT_GET_RESULTANT  [force, moment] = rollcon.contact_get_resultant(contact, axes)
%
% Returns the resultant force on body 1 and its moment about the origin of the axes.
%
%   contact (contact)
%   axes (int32, name or number: axes, may be left out): LOCAL or GLOBAL
% Results:
%   force: force
%   moment: force x length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_resultant', varargin{:});
end
