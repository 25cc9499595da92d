function varargout = wheelrail_set_wheelset(varargin)
% WHEELRAIL_SET_WHEELSET  rollcon.wheelrail_set_wheelset(wheelrail, back_to_back, flange_back, radius)
%
% Sets the dimensions of the wheelset.
%
%   wheelrail (wheelrail)
%   back_to_back (real): distance between the backs of the flanges, > 0, length
%   flange_back (real): y of the flange's back in the profile of the wheel, length
%   radius (real): radius at the profile's z = 0, > 0, length; radius + z > 0 all along the profile
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_wheelset', varargin{:});
end
