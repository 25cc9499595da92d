function varargout = wheelrail_get_patch_axes(varargin)
% WHEELRAIL_GET_PATCH_AXES  [origin, axes] = rollcon.wheelrail_get_patch_axes(wheelrail, patch)
%
% Returns origin and axes of the contact of a patch (rollcon.wheelrail_get_contact) in the track: a
% node at (x, y, z) of the contact is at origin + x t1 + y t2 + z n. The axes of a left wheel are a
% mirror image: a left-handed triple.
%
%   wheelrail (wheelrail)
%   patch (row): 0 to rollcon.wheelrail_get_patch_count - 1
% Results:
%   origin: the middle of its overlap; x counts from the wheelset's, as in the statistic, length
%   axes: unit vectors t1 (the rolling direction), t2 (across), n (into the rail)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_patch_axes', varargin{:});
end
