function varargout = wheelrail_get_profile_point(varargin)
% WHEELRAIL_GET_PROFILE_POINT  point = rollcon.wheelrail_get_profile_point(wheelrail, which, share)
%
% Returns where a point of the wheel's or the rail's profile stood in the last solve, in the track,
% for pictures. The wheel's profile is that in the plane of its axle, below it.
%
%   wheelrail (wheelrail)
%   which (int32, name or number: profile of a wheel on its rail): WHEEL or RAIL
%   share (real): fraction of the length of that body's profile, 0 to 1, from the end where y is less
% Results:
%   point: y and z, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_profile_point', varargin{:});
end
