function varargout = body_get_reaction(varargin)
% BODY_GET_REACTION  [force, moment] = rollcon.body_get_reaction(body)
%
% Returns the resultant of the forces that the supports exert on the body under its own loads and
% given displacements, and its moment about the origin of the body's axes. It balances the loads up to
% the error of the discretisation: a measure of it.
%
%   body (body)
% Results:
%   force: force
%   moment: force x length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_get_reaction', varargin{:});
end
