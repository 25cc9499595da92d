function varargout = table_set_bodies(varargin)
% TABLE_SET_BODIES  rollcon.table_set_bodies(table, youngs, poissons, frictions)
%
% Makes it a table of two bodies whose elastic constants differ, one of which may be rigid: wheel on
% rail of another metal, rubber on steel. Forces of such bodies depend on friction by itself: the
% table has coefficients of friction, is linear in the logarithm of two and cubic in that of more, and
% has none beyond. rollcon.table_evaluate then takes as shear and poisson the mean values of the
% bodies (rollcon.contact_get_equivalent_ellipse), and creepages without the strain under the
% pressure. Each coefficient of friction takes as long as two to three Poisson's ratios of like
% bodies. Bodies whose (1 - 2 nu)/(2 G) are the same make a table of like bodies. Call it before the
% first sample (else ERR_STATE).
%
%   table (table)
%   youngs(2) (real): Young's moduli of bodies 1 and 2, in any unit; 0: rigid, not both
%   poissons(2) (real): -1 to 0.5; ignored for a rigid body
%   frictions(n) (real): coefficients of friction, ascending, above 0 to 10
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('table_set_bodies', varargin{:});
end
