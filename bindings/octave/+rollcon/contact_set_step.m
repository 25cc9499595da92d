function varargout = contact_set_step(varargin)
% CONTACT_SET_STEP  rollcon.contact_set_step(contact, kind, dt)
%
% Makes every solve from now on a step in time of length dt; STEADY makes it a steady state again.
% ROLLING_STEP: the contact rolls on by V dt, creepages and spin mean what they mean in steady
% rolling. SHIFT_STEP: no rolling; what is prescribed as creepages is the shift of body 1 against body
% 2 in this step (longitudinal and lateral, length) and its turn (spin, radians), and so it is in what
% rollcon.contact_get_motion returns; velocities and creep fields count by dt. Loads, motions,
% approach, friction and gap may change from step to step. The first step starts from the steady state
% solved last, or from rest where there is none (rollcon.contact_reset); a step that fails does not
% change the one before. A frame that follows its contact takes the past along (half-spaces and rigid
% bodies; meshed bodies: ERR_STATE from the solve).
%
%   contact (contact)
%   kind (int32, name or number: step): STEADY, ROLLING_STEP or SHIFT_STEP
%   dt (real, may be left out): > 0, time; ignored if the kind is STEADY
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_step', varargin{:});
end
