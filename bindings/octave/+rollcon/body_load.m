function varargout = body_load(varargin)
% BODY_LOAD  body = rollcon.body_load(context, path)
%
% Makes a prepared body from a file of rollcon.body_save: nothing is assembled or factorised, and
% solves give the same tractions as with the body that was saved. Statistics count what is done from
% here on. A body equal to one of this context uses its factors, just as after rollcon.body_prepare.
% ERR_IO: the file cannot be read, is none of these, truncated or changed; ERR_UNSUPPORTED: it is of
% another ABI number, format or byte order, or of a kind that this build does not have. The text names
% the file and what is wrong, where.
%
%   context (context)
%   path (name of a file): name of the file
% Results:
%   body: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_load', varargin{:});
end
