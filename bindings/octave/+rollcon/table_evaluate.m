function varargout = table_evaluate(varargin)
% TABLE_EVALUATE  results = rollcon.table_evaluate(table, inputs)
%
% Returns forces and spin moments on body 1 of n contacts, by the signs of
% rollcon.contact_get_resultant. |F| is never above friction times load. Nothing is allocated. Inputs
% are those of a Hertzian contact: shear modulus, Poisson's ratio, coefficient of friction, semi-axes
% along and across the rolling direction, load, creepages along and across it, spin. The first entry
% that the table does not have is ERR_ARGUMENT (ERR_NONFINITE) and ends the call; results before it
% are there. ERR_STATE: the table is not made yet.
%
%   table (table)
%   inputs(n,9) (real): shear > 0, force/length^2; poisson, within the table; friction 0 to 10; a and b
%   > 0, length; load >= 0, force; longitudinal and lateral creepage; spin, 1/length
% Results:
%   results: force along t1 and t2; moment about n, force length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('table_evaluate', varargin{:});
end
