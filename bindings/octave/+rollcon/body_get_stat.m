function varargout = body_get_stat(varargin)
% BODY_GET_STAT  value = rollcon.body_get_stat(body, name)
%
% Returns one number about a prepared body: unknowns, assemblies, factorisations, condition, seconds,
% bytes; 0 for bodies without equations. Names: rollcon.stat_info. Counts are those of the equations,
% which equal bodies of a context have in common: "shared" is 1 for a body for which nothing was
% assembled because an equal one was prepared before, "loaded" for one from a file.
%
%   body (body)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_stat', varargin{:});
end
