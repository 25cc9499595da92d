function varargout = body_set_profile(varargin)
% BODY_SET_PROFILE  rollcon.body_set_profile(body, points, filter_length)
%
% Sets a profile through points, in either order: a cubic spline in arc length with two derivatives
% continuous, broken at kinks (turns of 30 degrees and more, three times as much as beside them).
% Points nearer to each other than a thousandth of the usual distance are dropped, and where the path
% goes back and forth again the two points are replaced by their mean. The former profile and its
% place are forgotten. ERR_ARGUMENT names the point at which the path turns back.
%
%   body (body): a half-space or rigid, without a mesh (else ERR_STATE)
%   points(n,2) (real): y and z of each, length
%   filter_length (real, may be left out): 0: through the points; else they are smoothed before: waves
%   of this length to one half, shorter ones to nothing, longer ones stay; at most the length of the
%   profile
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_profile', varargin{:});
end
