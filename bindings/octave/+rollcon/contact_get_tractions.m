function varargout = contact_get_tractions(varargin)
% CONTACT_GET_TRACTIONS  t = rollcon.contact_get_tractions(contact, axes)
%
% Returns tractions on body 1 at the nodes; the normal component is <= 0 in compression. Normals
% follow a surface across the rolling direction only: along it all have the inclination at the origin
% of the axes. At a distance x from there, on a radius R, they are off the surface's own by x/R:
% pressures by half its square (0.02 % at x/R = 0.02, 0.5 % at 0.1), and the part p x/R of a pressure
% along the surface is no traction.
%
%   contact (contact)
%   axes (int32, name or number: axes): LOCAL or GLOBAL
% Results:
%   t: force/length^2
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_tractions', varargin{:});
end
