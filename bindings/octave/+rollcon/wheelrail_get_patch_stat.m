function varargout = wheelrail_get_patch_stat(varargin)
% WHEELRAIL_GET_PATCH_STAT  value = rollcon.wheelrail_get_patch_stat(wheelrail, patch, name)
%
% Returns one number about a patch: position, angle, rolling radius, creepages, forces, status. Names:
% rollcon.stat_info; meanings: docs/wheelrail.md.
%
%   wheelrail (wheelrail)
%   patch (row): 0 to rollcon.wheelrail_get_patch_count - 1
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_patch_stat', varargin{:});
end
