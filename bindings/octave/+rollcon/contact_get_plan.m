function varargout = contact_get_plan(varargin)
% CONTACT_GET_PLAN  text = rollcon.contact_get_plan(contact)
%
% Returns how the last solve was done (sizes, schemes, linear solver and why), as text for people.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_plan', varargin{:});
end
