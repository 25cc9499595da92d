function varargout = option_doc(varargin)
% OPTION_DOC  text = rollcon.option_doc(i)
%
% Returns what an option means, for text options also the values allowed.
%
%   i (row): 0 to rollcon.option_count() - 1
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('option_doc', varargin{:});
end
