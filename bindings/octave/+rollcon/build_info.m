function varargout = build_info(varargin)
% BUILD_INFO  text = rollcon.build_info()
%
% Returns the licences that this build carries and how it was built, as one line of text.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('build_info', varargin{:});
end
