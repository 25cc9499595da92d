function varargout = contact_set_friction_memory(varargin)
% CONTACT_SET_FRICTION_MEMORY  rollcon.contact_set_friction_memory(contact, length, least_speed)
%
% Gives friction that falls with the slip speed a memory: for a particle of the surface d mu/dt =
% -max(s, s0)/dc (mu - mu_s(s)), where mu_s is what the law without memory says; where surfaces come
% into contact mu is that at rest. Coefficients then follow the whole solution and are found by solves
% with given ones (statistics friction_rounds and friction_change). The memory holds for whatever law
% is set, if it falls, else the solve ends with ERR_STATE. It is for steady rolling only (steps in
% time: ERR_UNSUPPORTED from the solve), and there are no sensitivities (ERR_UNSUPPORTED).
%
%   contact (contact)
%   length (real): dc, length of slip, >= 0; 0: no memory
%   least_speed (real): s0 >= 0, slip speed, length/time
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_friction_memory', varargin{:});
end
