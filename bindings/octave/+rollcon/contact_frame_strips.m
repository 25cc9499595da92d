function varargout = contact_frame_strips(varargin)
% CONTACT_FRAME_STRIPS  rollcon.contact_frame_strips(contact, along, lines)
%
% Makes strips along the rolling direction the frame: what the contact covers of lines at ascending y.
% Each has along + 1 nodes from end to end, close together near the ends, where tractions grow like
% the square root of the distance. Nodes come line by line. Replaces the frame just as
% rollcon.contact_frame_rectangle does. Nodes on the outline carry no traction (EXCLUDED): bodies that
% overlap there are reported as RIM_CONTACT.
%
%   contact (contact)
%   along (int32): elements along each strip, 2 to 10000
%   lines(n,3) (real): y of each line, ascending, and the least and greatest x that the contact covers
%   of it, the first less than the second (equal on the first and the last line, if it is a point),
%   length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_strips', varargin{:});
end
