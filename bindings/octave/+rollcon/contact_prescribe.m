function varargout = contact_prescribe(varargin)
% CONTACT_PRESCRIBE  rollcon.contact_prescribe(contact, direction, how, value)
%
% Prescribes one direction by motion or by force; the other quantity is found by the solve. Forces act
% on body 1. Standard: all by motion, 0.
%
%   contact (contact)
%   direction (int32, name or number: direction): LONGITUDINAL, LATERAL, NORMAL or SPIN
%   how (int32, name or number: how): BY_MOTION or BY_FORCE
%   value (real): motion: creepage, spin (1/length), approach (length); force: force, spin moment about
%   the origin, and for NORMAL the compressive load >= 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_prescribe', varargin{:});
end
