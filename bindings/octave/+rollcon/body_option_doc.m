function varargout = body_option_doc(varargin)
% BODY_OPTION_DOC  text = rollcon.body_option_doc(i)
%
% Returns what an option of bodies means.
%
%   i (row): 0 to rollcon.body_option_count() - 1
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_option_doc', varargin{:});
end
