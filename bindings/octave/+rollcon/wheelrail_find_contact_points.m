function varargout = wheelrail_find_contact_points(varargin)
% WHEELRAIL_FIND_CONTACT_POINTS  points = rollcon.wheelrail_find_contact_points(left, right, shift)
%
% Finds where both wheels of a wheelset touch over its lateral shift, without yaw: the roll follows
% from contact on both sides. Each row of points has z and roll of the wheelset and its rolling-radius
% difference, the radius on the right less that on the left; then of the left wheel y and z of the
% contact in the track, its angle, y on the wheel's profile, and the rolling radius; then the same of
% the right wheel.
%
%   left (wheelrail): made with LEFT
%   right (wheelrail): made with RIGHT
%   shift(n) (real): y of the wheelset's centre, length; such that both wheels find their rails
% Results:
%   points: a row for each shift; what is behind a shift that fails is not written
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_find_contact_points', varargin{:});
end
