function varargout = body_set_springs(varargin)
% BODY_SET_SPRINGS  rollcon.body_set_springs(body, tag, stiffness)
%
% Puts the faces with a tag on springs: a rail on its pad, a wheel on the rubber of its tyre. Their
% traction is minus the stiffness times the displacement. Springs hold a body as supports do; faces on
% springs are no contact faces unless rollcon.body_set_contact_faces names them.
% rollcon.body_get_reaction has what held nodes take, without springs.
%
%   body (body): of finite elements, or a section (else ERR_UNSUPPORTED)
%   tag (int32): of some face (else ERR_ARGUMENT)
%   stiffness(3) (real): along x, y and z, force/length^3, 0 to 1e100
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_springs', varargin{:});
end
