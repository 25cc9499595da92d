function varargout = wheelrail_get_derivative(varargin)
% WHEELRAIL_GET_DERIVATIVE  [force, moment, z] = rollcon.wheelrail_get_derivative(wheelrail, entry)
%
% Returns the derivatives of the totals of the last solve by one entry of its position or velocity:
% those of what rollcon.wheelrail_get_resultant gives in the track, and derivatives of the wheelset's
% z. Where the height was found from a vertical force, that force stays and z follows; entry 2 has
% none then. They are those of Newton's systems at the solutions of the patches, whose axes and strips
% move; with a creep-force table and on conformal frames, central differences of solves. The first
% call finds all twelve and keeps them until the next solve. ERR_STATE: no solution, or one that did
% not converge. ERR_SINGULAR: a patch begins or ends here.
%
%   wheelrail (wheelrail)
%   entry (int32): 0 to 5: of the position (rollcon.wheelrail_set_position); 6 to 11: of the velocity
% Results:
%   force: derivative of the force on the wheel
%   moment: derivative of its moment about the wheelset's centre, which moves along
%   z: of the wheelset's z
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_derivative', varargin{:});
end
