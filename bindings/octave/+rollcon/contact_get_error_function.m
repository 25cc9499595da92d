function varargout = contact_get_error_function(varargin)
% CONTACT_GET_ERROR_FUNCTION  [psi, seconds] = rollcon.contact_get_error_function(contact)
%
% Returns the convergence of the last solve: the error function of every row of
% rollcon.contact_get_history, and when it was evaluated. The error function is half the sum of the
% squared residuals of the contact laws over all nodes, each over the largest pressure or tangential
% traction of the iterate, and of the squared relative errors of the loads, times the nodes in
% contact. No rows before a solve.
%
%   contact (contact)
% Results:
%   psi: error function, dimensionless; []: not wanted
%   seconds: since the solve began; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_error_function', varargin{:});
end
