function varargout = wheelrail_get_resultant(varargin)
% WHEELRAIL_GET_RESULTANT  [force, moment] = rollcon.wheelrail_get_resultant(wheelrail, axes)
%
% Returns the force of all patches on the wheel and its moment about the wheelset's centre.
%
%   wheelrail (wheelrail)
%   axes (int32, name or number: axes of the track, may be left out): IN_TRACK or IN_WHEELSET
% Results:
%   force: force
%   moment: force x length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_resultant', varargin{:});
end
