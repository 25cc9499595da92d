function varargout = contact_create(varargin)
% CONTACT_CREATE  contact = rollcon.contact_create(context, body1, body2)
%
% Makes a contact of two bodies. The standard scene has axes (x, y, z) at the origin, speed 1,
% approach, creepages and spin 0, all by motion, bodies in the pose of their own axes. Without a frame
% the library makes one (rollcon.contact_frame_automatic). Friction has no standard, the gap only if a
% body has a mesh or a profile: solving without them is ERR_STATE. At least one of the bodies must be
% elastic.
%
%   context (context)
%   body1 (body): tractions are those on this body; n points out of it
%   body2 (body): may be of another context, and the same as body1
% Results:
%   contact: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_create', varargin{:});
end
