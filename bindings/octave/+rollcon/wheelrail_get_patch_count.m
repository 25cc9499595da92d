function varargout = wheelrail_get_patch_count(varargin)
% WHEELRAIL_GET_PATCH_COUNT  patches = rollcon.wheelrail_get_patch_count(wheelrail)
%
% Returns the number of patches, from 0.
%
%   wheelrail (wheelrail)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_patch_count', varargin{:});
end
