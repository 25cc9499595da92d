function varargout = contact_set_gap_grid(varargin)
% CONTACT_SET_GAP_GRID  rollcon.contact_set_gap_grid(contact, nx, x_least, x_greatest, y_least,
%     y_greatest, gap)
%
% Sets the gap of the undeformed bodies at approach 0 by its values on a regular grid in the axes (t1,
% t2): between the points it is bicubic, with continuous slopes. Values that are +infinity say that a
% body is not there: the contact ends at the cells beside them, and there only
% (rollcon.contact_frame_automatic); the grid's own rim is no such edge. Replaces a gap array or a
% quadratic gap. A frame must lie within the cells that have a gap.
%
%   contact (contact)
%   nx (int32): points along t1 of each line, 2 or more
%   x_least (real): x of the first point of a line, length
%   x_greatest (real): x of the last point, length
%   y_least (real): y of the first line, length
%   y_greatest (real): y of the last line, length
%   gap(n) (real): line by line, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_gap_grid', varargin{:});
end
