function varargout = wheelrail_find_contact_points(varargin)
% WHEELRAIL_FIND_CONTACT_POINTS  points = rollcon.wheelrail_find_contact_points(left, right, shift,
%     columns)
%
% Finds where both wheels of a wheelset touch over its lateral shift, without yaw: the roll follows
% from contact on both sides. Columns of points are z and roll of the wheelset and radius_difference,
% the rolling radius on the right less that on the left; of the left wheel left_y and left_z of the
% contact in the track, left_angle, left_wheel_y on the wheel's profile, left_radius; of the right
% wheel right_y, ...
%
%   left (wheelrail): made with LEFT
%   right (wheelrail): made with RIGHT
%   shift(n) (real): y of the wheelset's centre, length; such that both wheels find their rails
%   columns (text): names separated by blanks, each a number of a row
% Results:
%   points: a row for each shift, the columns side by side; what is behind a shift that fails is not
%   written
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_find_contact_points', varargin{:});
end
