function varargout = body_set_rotation(varargin)
% BODY_SET_ROTATION  rollcon.body_set_rotation(body, tag, density, origin, rate)
%
% Prescribes the centrifugal forces of a steady rotation on the finite elements with a tag, added to
% rollcon.body_set_body_force; replaces an earlier one. The stiffness is that of the body at rest.
%
%   body (body)
%   tag (int32): of volume elements
%   density (real): mass/length^3, 0 to 1e100
%   origin(3) (real): on the axis of rotation, length
%   rate(3) (real): along the axis, radian/time
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_rotation', varargin{:});
end
