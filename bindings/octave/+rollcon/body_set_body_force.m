function varargout = body_set_body_force(varargin)
% BODY_SET_BODY_FORCE  rollcon.body_set_body_force(body, tag, force)
%
% Prescribes a force per volume, such as weight, on the finite elements with a tag; replaces an
% earlier one. ERR_STATE: a body without volume elements, and at rollcon.body_prepare a tag that no
% element has.
%
%   body (body)
%   tag (int32): of volume elements
%   force(3) (real): force/length^3 along x y z: density times acceleration; -1e100 to 1e100
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_body_force', varargin{:});
end
