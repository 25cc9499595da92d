function varargout = body_option_count(varargin)
% BODY_OPTION_COUNT  value = rollcon.body_option_count()
%
% Returns the number of options of bodies.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_option_count', varargin{:});
end
