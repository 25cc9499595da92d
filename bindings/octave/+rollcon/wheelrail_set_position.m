function varargout = wheelrail_set_position(varargin)
% WHEELRAIL_SET_POSITION  rollcon.wheelrail_set_position(wheelrail, position)
%
% Sets the position of the wheelset. z = 0 is where the tread's datum of a centred wheelset is at the
% height of the rails' top; z is not used where a vertical force is prescribed (statistic "z" is what
% was found), except as the start of the search.
%
%   wheelrail (wheelrail)
%   position(6) (real): of the wheelset's centre: x, y, z, length; roll, yaw and pitch, radian; roll and
%   yaw -0.5 to 0.5
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_position', varargin{:});
end
