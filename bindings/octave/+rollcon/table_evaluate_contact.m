function varargout = table_evaluate_contact(varargin)
% TABLE_EVALUATE_CONTACT  results = rollcon.table_evaluate_contact(table, contact, friction)
%
% Returns tangential forces and spin moment on body 1 of a solved contact, from the Hertzian contact
% that stands for it (rollcon.contact_get_equivalent_ellipse): friction of a contact that was solved
% without, at the price of its pressures. The moment is about the contact's origin. ERR_ARGUMENT: the
% table does not have this ellipse, Poisson's ratio, friction, or pair of bodies; asked about unlike
% bodies, a table of like ones adds the mean strain under the pressure to the longitudinal creepage.
% ERR_STATE, ERR_UNSUPPORTED: for the reasons of rollcon.contact_get_equivalent_ellipse, or the table
% is not made yet.
%
%   table (table)
%   contact (contact)
%   friction (real): coefficient, 0 to 10; -1: the contact's own, mean over its pressure
% Results:
%   results: force along t1 and t2; moment about n, force length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_evaluate_contact', varargin{:});
end
