function varargout = contact_frame_ellipse(varargin)
% CONTACT_FRAME_ELLIPSE  rollcon.contact_frame_ellipse(contact, along, across, a, b, angle)
%
% Makes an ellipse in the present plane of the axes the frame: strips along the rolling direction,
% like those of rollcon.contact_frame_strips, on lines that lie closer towards the sides. It is meant
% to be the contact itself.
%
%   contact (contact)
%   along (int32): elements along each strip, 2 to 10000
%   across (int32): strips, 2 to 10000
%   a (real): semi-axis at `angle` from t1, length, > 0
%   b (real): the other semi-axis, length, > 0
%   angle (real, may be left out): radian, from t1 towards t2
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_ellipse', varargin{:});
end
