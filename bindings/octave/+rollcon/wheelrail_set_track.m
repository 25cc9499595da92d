function varargout = wheelrail_set_track(varargin)
% WHEELRAIL_SET_TRACK  rollcon.wheelrail_set_track(wheelrail, gauge, gauge_height, cant)
%
% Says where the rails lie: each is canted, its top is at z = 0, and its gauge side is half the gauge
% from the middle of the track.
%
%   wheelrail (wheelrail)
%   gauge (real): > 0, length
%   gauge_height (real): below the top of the rails, where the gauge is measured; length; 0 places the
%   rail by its profile's origin: half the gauge from the middle, z = 0
%   cant (real): of each rail towards the middle of the track, radian, -0.5 to 0.5; 0 if the profile is
%   canted already
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_track', varargin{:});
end
