function varargout = contact_get_equivalent_ellipse(varargin)
% CONTACT_GET_EQUIVALENT_ELLIPSE  [inputs, center] = rollcon.contact_get_equivalent_ellipse(contact)
%
% Returns the Hertzian contact that stands for this one, in the form of inputs of
% rollcon.table_evaluate. The ellipse has the area in contact (statistic contact_area) and, along over
% across, the second moments of the pressures. Load, creepages and spin are those of the solution, the
% latter by least squares weighted with pressure about its centre; the solution needs no friction.
% Friction is the mean over the pressure, for falling laws at the speed of the rigid slip; inputs[2]
% may be replaced. Elastic constants: mean values of 1/G and nu/G; where pressure strains one body
% more than the other, the longitudinal creepage has the mean difference of these strains on top. A
% moment about the contact's origin has center[0] F2 - center[1] F1 more than one about the centre.
% ERR_STATE: no solution, no load, several patches far apart, or a shift; ERR_UNSUPPORTED: a body has
% a mesh, a layer is between the bodies, or friction depends on the direction.
%
%   contact (contact)
% Results:
%   inputs: shear modulus, Poisson's ratio, friction, semi-axes along and across the rolling direction,
%   load, longitudinal and lateral creepage, spin
%   center: along t1 and t2
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_equivalent_ellipse', varargin{:});
end
