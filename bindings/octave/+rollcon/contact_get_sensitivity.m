function varargout = contact_get_sensitivity(varargin)
% CONTACT_GET_SENSITIVITY  [force, moment, approach, creep] = rollcon.contact_get_sensitivity(contact,
%     parameter)
%
% Returns the derivatives of what rollcon.contact_get_resultant (local axes) and
% rollcon.contact_get_motion give, by one parameter. A direction stands for the value last solved with
% there: creepage, spin or approach where the motion was prescribed; force, spin moment or compressive
% load where the force was; motions that were found then change with it. FRICTION stands for a factor,
% now 1, on every friction coefficient: for d/dmu of a uniform mu divide by mu. They are those of
% Newton's system at the solution, the state of every node held: at most one factorisation for all
% parameters (one more for NORMAL where pressures stand alone) and one right side each; kept until the
% next solve. After NO_CONTACT only a prescribed motion's derivative by itself is not 0. ERR_STATE: no
% solution, one that did not converge, or the parameter is a tangential force or spin moment without
% friction. ERR_SINGULAR: a load at the limit of friction. ERR_UNSUPPORTED: friction follows the whole
% solution (of temperature, with a memory, of a layer that flows).
%
%   contact (contact)
%   parameter (int32, name or number: direction or parameter): LONGITUDINAL, LATERAL, NORMAL, SPIN,
%   FRICTION, TILT_1 or TILT_2
% Results:
%   force: derivative of the force on body 1, local axes
%   moment: derivative of its moment about the origin, local axes
%   approach: derivative of the approach
%   creep: derivatives of longitudinal and lateral creepage and spin
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_sensitivity', varargin{:});
end
