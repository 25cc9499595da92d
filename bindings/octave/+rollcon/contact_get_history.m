function varargout = contact_get_history(varargin)
% CONTACT_GET_HISTORY  rows = rollcon.contact_get_history(contact)
%
% Returns the iterations of the last solve, one row each: phase, iteration, normal residual,
% tangential residual, step length, nodes in contact, nodes in slip, seconds. No rows before a solve.
%
%   contact (contact)
% Results:
%   rows: [] only with capacity 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_history', varargin{:});
end
