function varargout = body_copy(varargin)
% BODY_COPY  copy = rollcon.body_copy(body)
%
% Makes another body that was given the same and is not prepared, from one that is or is not. Changed
% in its loads and prescribed displacements alone, and prepared, it takes the equations of the first,
% and their factors: so several load cases of one body cost one assembly and factorisation. (Finite
% elements factorise once more, with nothing condensed, for all cases after the first, unless option
% keep_factors is 0; boundary elements are assembled again for each, since loads have integrals of
% their own.)
%
%   body (body)
% Results:
%   copy: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_copy', varargin{:});
end
