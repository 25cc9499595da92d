function varargout = contact_set_friction(varargin)
% CONTACT_SET_FRICTION  rollcon.contact_set_friction(contact, law, parameters)
%
% Sets the law of friction for the whole frame. "coulomb": mu. "orthotropic": mu1 and mu2 along axes
% that are turned by an angle (radian) from t1 towards t2 (on curved frames those of each node), slip
% normal to the ellipse of the tractions; "orthotropic_collinear": the same ellipse, slip against the
% traction. "linear", "rational", "exponential": friction that falls with the slip speed s, muk + mu1
% f(s/s1) and, with 5 parameters, + mu2 f(s/s2), each half as great or less at its speed: f(x) =
% max(0, 1 - x/2), 1/(1 + x) (of the second term 1/(1 + x^2)), or 2^-x. "temperature": linear in the
% surface temperature between points T1, mu1, T2, mu2, ... with ascending temperatures, constant
% beyond them (needs rollcon.contact_set_heat; steady rolling, no sensitivities). Where friction falls
% several solutions may exist then: a solve from nothing begins with the friction of rest, a warm one
% continues the last solution, the plan says which; FIELD_FRICTION gives the coefficient at the node's
% slip. Where rollcon.contact_set_friction_field gives coefficients, each is the greatest of its node
% (at rest) and the law keeps its ratios. The published procedures (rollcon.contact_set_procedure)
% take "coulomb" alone (ERR_UNSUPPORTED at the solve).
%
%   contact (contact)
%   law (text): a name of a law
%   parameters(n) (real): mu; mu1, mu2, angle; muk, mu1, s1, mu2, s2; T1, mu1, T2, mu2, ... Coefficients
%   >= 0, of an ellipse at most 1000 times apart; speeds > 0, length/time
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_friction', varargin{:});
end
