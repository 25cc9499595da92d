function varargout = contact_solve_many(varargin)
% CONTACT_SOLVE_MANY  [results, status] = rollcon.contact_solve_many(contact, parameters, values,
%     columns)
%
% Solves the scene for many load cases, each with some of what is prescribed replaced, on the threads
% of the context. What is replaced and what is wanted is said by names, the columns of two tables with
% a row for each case. A direction stands for the value prescribed there, as motion or as force
% (rollcon.contact_prescribe); friction for a factor on the friction coefficients that are set at the
% nodes (1: no change). Results do not depend on the order of the cases nor on the number of threads:
% the library orders them itself, solves equal ones once and starts warm along chains of neighbours
% (unless the option "warm_start" is 0). A case that fails has its negative status and NaN for results
% and does not affect the others; texts go to the log as warnings. The status returned is the worst in
% the order that holds for all calls; CANCELLED says that some cases were not solved. A negative one
% means that no case was solved. All results are in local axes. The scene does not change, and the
% last solution stays unless something was set since. Where no frame was given each case is solved on
% frames of its own (rollcon.contact_frame_automatic), steadily: then tractions are no column, and
% friction is a parameter of Coulomb's law alone. The progress callback receives the iterations of the
% calling thread, and of PHASE_CASES. The procedures of the paper use one thread.
%
%   contact (contact)
%   parameters (text): columns of values, separated by blanks, each once, of: longitudinal, lateral,
%   normal, spin, friction, tilt_1, tilt_2; []: none
%   values(n_cases,parameters) (real): a normal load, and a factor on friction, are >= 0; [] only
%   without cases or parameters
%   columns (text): columns of results, separated by blanks, of: force (3 numbers, on body 1), moment
%   (3, about the origin of the axes), approach, creep (3: longitudinal, lateral, spin), tilt (2),
%   derivatives (10 for each parameter: by its value, of force, moment, approach and creep, see
%   rollcon.contact_get_sensitivity; NaN where there are none, such as by friction at 0), tractions (3
%   for each node of the frame, on body 1), and the statistics iterations, fallbacks, residual_normal,
%   residual_tangential, nodes_contact, contact_area, max_pressure, friction_power,
%   friction_power_balance; []: none
% Results:
%   results: a row for each case, the columns side by side; what is beyond them is not written; [] only
%   with capacity 0
%   status: what rollcon.contact_solve would return for each
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_solve_many', varargin{:});
end
