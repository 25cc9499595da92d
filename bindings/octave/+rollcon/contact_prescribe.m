function varargout = contact_prescribe(varargin)
% CONTACT_PRESCRIBE  rollcon.contact_prescribe(contact, direction, how, value)
%
% Prescribes one direction by motion or by force; the other quantity is found by the solve. Forces act
% on body 1. A tilt turns body 1 against body 2 about t1 or t2 through the origin: at (x, y) of a flat
% frame it takes (tilt 1) y - (tilt 2) x from the gap. Its moment is that of the contact's tractions
% on body 1 about the same axis: a load F that presses body 1 at (x, y) asks for the moments -F y
% (tilt 1) and F x (tilt 2). The standard is all by motion, 0.
%
%   contact (contact)
%   direction (int32, name or number: direction): LONGITUDINAL, LATERAL, NORMAL, SPIN, TILT_1 or TILT_2
%   how (int32, name or number: how): BY_MOTION or BY_FORCE
%   value (real): motion: creepage, spin (1/length), approach (length), tilt (radian, small); force:
%   force, moment about the axis through the origin, and for NORMAL the compressive load >= 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_prescribe', varargin{:});
end
