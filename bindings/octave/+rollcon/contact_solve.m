function varargout = contact_solve(varargin)
% CONTACT_SOLVE  status = rollcon.contact_solve(contact)
%
% Solves the steady rolling contact: tractions, slip, and whatever motion was prescribed by force.
% Starts from the last solution unless the option "warm_start" is 0. After NOT_CONVERGED and CANCELLED
% the best iterate can be read. COARSE says that no node in contact has all its neighbours in contact
% (with friction: fewer than 5 have); the solution is that of the frame, not of the bodies. Log and
% plan tell more. A failed solve does not change the scene but discards the last solution. Bodies that
% are not prepared are prepared first and may fail the way rollcon.body_prepare does (ERR_MESH,
% ERR_SINGULAR); the text names the body. Creepages (whose slip, times speed or stiffness, would come
% to 1e305) and approaches (to pressures of 1e150) that double precision cannot calculate with are
% ERR_ARGUMENT; the text names a node and what is allowed. Nodes that are never to touch may have any
% gap, with the monolithic system (rollcon.contact_set_procedure) up to that limit.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_solve', varargin{:});
end
