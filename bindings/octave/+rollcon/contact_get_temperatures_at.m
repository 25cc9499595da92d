function varargout = contact_get_temperatures_at(varargin)
% CONTACT_GET_TEMPERATURES_AT  temperature = rollcon.contact_get_temperatures_at(contact, xy)
%
% Returns temperatures of the surfaces of both bodies at any points of the plane of the axes by the
% frictional heat of the last solve, steady rolling, and what the bodies have far away
% (rollcon.contact_set_heat): before the contact, in it, where both have the same, and behind it. Heat
% is carried along the rolling direction and spreads into the depth alone, which holds where the speed
% times half the length of the contact is well above the diffusivity (conductivity over heat
% capacity). Frictional power varies linearly between nodes. ERR_STATE: no solution, no heat given, or
% a step in time.
%
%   contact (contact)
%   xy(n,2) (real): positions along t1 and t2 from the origin, length
% Results:
%   temperature: temperatures of bodies 1 and 2
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_temperatures_at', varargin{:});
end
