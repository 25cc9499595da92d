function varargout = contact_frame_rectangle(varargin)
% CONTACT_FRAME_RECTANGLE  rollcon.contact_frame_rectangle(contact, type, nx, ny, x_least, x_greatest,
%     y_least, y_greatest)
%
% Makes a rectangle in the present plane of the axes the frame: nx by ny elements of one size.
% Replaces nodes and elements of the frame and forgets the gap array and the creep and friction
% fields. Nodes come line by line along t1, from the least y. Linear quadrilaterals make a regular
% frame, which half-spaces solve by fast Fourier transforms.
%
%   contact (contact)
%   type (int32, name or number: element type): TRI3, TRI6, QUAD4, QUAD8 or QUAD9
%   nx (int32): elements along t1, 1 to 30000
%   ny (int32): elements along t2, 1 to 30000
%   x_least (real): along t1 from the origin of the axes, length
%   x_greatest (real): > x_least
%   y_least (real): along t2 from the origin of the axes, length
%   y_greatest (real): > y_least
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_rectangle', varargin{:});
end
