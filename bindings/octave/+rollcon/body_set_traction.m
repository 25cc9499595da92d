function varargout = body_set_traction(varargin)
% BODY_SET_TRACTION  rollcon.body_set_traction(body, tag, traction)
%
% Prescribes the traction on the faces with a tag; replaces an earlier one. A pressure on the same tag
% is added to it. Faces without load or support are free.
%
%   body (body)
%   tag (int32): of some face (else ERR_ARGUMENT)
%   traction(3) (real): force/length^2 along x y z, -1e100 to 1e100
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_traction', varargin{:});
end
