function varargout = wear_profile(varargin)
% WEAR_PROFILE  [worn, taken] = rollcon.wear_profile(points, yz, rate, side, distance, most_depth,
%     smoothing)
%
% Moves points of a profile into their body by what wears off over a distance: along the normal, by
% the rate smoothed, of as much of the distance as wears no point deeper than most_depth. Smoothing
% keeps the volume: waves as long as `smoothing` keep one half, and nothing gets below the least rate
% or above the greatest.
%
%   points (int64): 2 to 1000000
%   yz(points,2) (real): in the order of the profile, length
%   rate(points) (real): depth per distance, >= 0
%   side (int32, name or number: inside of a profile): BODY_BELOW or BODY_ABOVE
%   distance (real): >= 0
%   most_depth (real): > 0, length
%   smoothing (real): length of waves, >= 0; 0: none
% Results:
%   worn: may be yz
%   taken: part of the distance that was taken; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wear_profile', varargin{:});
end
