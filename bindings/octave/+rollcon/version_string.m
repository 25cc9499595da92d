function varargout = version_string(varargin)
% VERSION_STRING  text = rollcon.version_string()
%
% Returns the version as text, "major.minor.patch".
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('version_string', varargin{:});
end
