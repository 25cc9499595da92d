function varargout = contact_get_history(varargin)
% CONTACT_GET_HISTORY  rows = rollcon.contact_get_history(contact, columns)
%
% Returns the iterations of the last solve, one row each, with the columns asked for: phase,
% iteration, residual_normal, residual_tangential, step (its length), nodes_contact, nodes_slip,
% seconds (since the solve began), error_function: half the sum of the squared residuals of the
% contact laws over all nodes, each over the largest pressure or tangential traction of the iterate,
% and of the squared relative errors of the loads, times the nodes in contact. No rows before a solve.
%
%   contact (contact)
%   columns (text): names separated by blanks, each a number of a row
% Results:
%   rows: the columns side by side; [] only with capacity 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_history', varargin{:});
end
