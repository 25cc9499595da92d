function varargout = body_set_profile_shape(varargin)
% BODY_SET_PROFILE_SHAPE  rollcon.body_set_profile_shape(body, shape, parameters)
%
% Sets a profile in closed form: "line" half_width, slope; "arc" radius, half_width: the circle
% through (0, 0) about z = -radius, up to half of it; "arcs" y, z and angle of the start, then length
% and curvature (0: a line; positive: from y to z) of each arc, each going on in the direction in
% which the one before ends; "s1002" unit: the wheel, in lengths of which `unit` is a millimetre, the
% middle of the tread at (0, 0), z down, the flange at y < 0; "60e1" unit: the head of the rail,
% upright, its top at (0, 0), z down. The former profile and its place are forgotten.
%
%   body (body): a half-space or rigid, without a mesh (else ERR_STATE)
%   shape (text): line, arc, arcs, s1002 or 60e1
%   parameters(n) (real): of the shape, in its order; radian, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_profile_shape', varargin{:});
end
