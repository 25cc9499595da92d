function varargout = body_get_group_name(varargin)
% BODY_GET_GROUP_NAME  text = rollcon.body_get_group_name(body, i)
%
% Returns the name of a group in the file's spelling.
%
%   body (body)
%   i (row): 0 to rollcon.body_get_group_count - 1
% Results:
%   text: the name
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_group_name', varargin{:});
end
