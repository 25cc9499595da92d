function varargout = has_feature(varargin)
% HAS_FEATURE  value = rollcon.has_feature(name)
%
% Returns 1 if this build has the feature, 0 if not or if the name is unknown or [].
%
%   name (text): one of the features listed in the reference
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('has_feature', varargin{:});
end
