function varargout = wheelrail_create(varargin)
% WHEELRAIL_CREATE  wheelrail = rollcon.wheelrail_create(context, wheel, rail, side)
%
% Makes a wheel on its rail. The profile of the wheel has y from the tread's datum, the flange at
% lesser y, and z down (like "s1002"); that of the rail is upright, with its gauge side at lesser y
% and z down. Both are the same on both sides of the track: what is on the left is the mirror image.
% Where the profiles lie in their bodies (rollcon.body_extrude_profile, rollcon.body_revolve_profile)
% does not matter, and the bodies stay free for other uses. A profile or elastic constants that the
% bodies are given later count from the next solve. At least one body must be elastic. The standard is
% rails without deviation, height prescribed by motion, accuracy 0.01; everything else must be set
% before a solve.
%
%   context (context)
%   wheel (body): a half-space or rigid, with a profile (else ERR_STATE)
%   rail (body): a half-space or rigid, with a profile (else ERR_STATE); may be of another context
%   side (int32, name or number: side): LEFT or RIGHT
% Results:
%   wheelrail: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_create', varargin{:});
end
