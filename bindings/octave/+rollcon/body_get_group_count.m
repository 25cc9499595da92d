function varargout = body_get_group_count(varargin)
% BODY_GET_GROUP_COUNT  n = rollcon.body_get_group_count(body)
%
% Returns how many groups of the mesh's file name something of the body; 0 for a mesh that was not
% read, and for a body that was saved and loaded.
%
%   body (body)
% Results:
%   n: groups
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_group_count', varargin{:});
end
