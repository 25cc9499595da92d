function varargout = version(varargin)
% VERSION  value = rollcon.version()
%
% Returns the version of the library: 10000 major + 100 minor + patch.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('version', varargin{:});
end
