function varargout = contact_get_fatigue_index(varargin)
% CONTACT_GET_FATIGUE_INDEX  index = rollcon.contact_get_fatigue_index(contact, shear_yield)
%
% Returns the index of surface-initiated rolling contact fatigue, FI = sqrt(F1^2 + F2^2)/Fn - 2 A k/(3
% Fn), with the area A in contact (statistic contact_area; pi a b for an ellipse) and the yield stress
% k in shear; positive where fatigue is to be expected. ERR_STATE: no solution, or no normal force.
% The wear number T-gamma, force times creepage, is the statistic t_gamma.
%
%   contact (contact)
%   shear_yield (real): k, force/length^2, above 0
% Results:
%   index: dimensionless
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_fatigue_index', varargin{:});
end
