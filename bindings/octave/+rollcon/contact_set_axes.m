function varargout = contact_set_axes(varargin)
% CONTACT_SET_AXES  rollcon.contact_set_axes(contact, origin, rolling, normal)
%
% Sets the axes: n along `normal`, t1 along the projection of `rolling` on the tangent plane, t2 = n x
% t1. Vectors need not have unit length. Creepages, spin and moments belong to the origin.
%
%   contact (contact)
%   origin(3) (real): length
%   rolling(3) (real): rolling direction, not parallel to normal
%   normal(3) (real): outward normal of body 1
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_axes', varargin{:});
end
