function varargout = contact_get_wear(varargin)
% CONTACT_GET_WEAR  [depth, volume] = rollcon.contact_get_wear(contact, law, parameters, points, y)
%
% Returns the depth that one pass of the contact wears off, along t2: the integral of the law's rate
% along the rolling direction, at the friction, pressure and slip of the last solve; after a step in
% time, what that step takes off. Material is given to the points by the functions that are 1 at a
% point and linear to its neighbours: the sum of depth times the point's length of y is the volume
% exactly. A body that comes by once per revolution has this depth per revolution, and the same law
% may be asked for each body with its own coefficients. Half-spaces and rigid bodies in steady
% rolling, with all of the contact on the frame, lose what the balance of work says (statistic
% friction_power_balance), which misses nothing on coarse frames; others what slip at nodes takes
% (friction_power). Laws: "archard": rate = i p |s|/V; with i1, i2 and an angle p |(i1 s1, i2 s2)|/V,
% in axes turned by the angle from t1 towards t2. "t_gamma": pairs (e, r) of energy density e = |t
% s|/V, ascending, and rate r (depth per length rolled), linear between, from (0, 0), and beyond the
% last pair. ERR_ARGUMENT: y does not cover the nodes in contact.
%
%   contact (contact)
%   law (text): archard or t_gamma
%   parameters(n) (real): i; i1, i2, angle (length^2/force, radian); e, r, e, r, ... (force/length^2,
%   dimensionless)
%   points (int64): 2 to 1000000
%   y(points) (real): places along t2, ascending, length
% Results:
%   depth: per pass, length; []: not wanted
%   volume: per length rolled, length^2; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_wear', varargin{:});
end
