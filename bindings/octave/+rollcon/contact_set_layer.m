function varargout = contact_set_layer(varargin)
% CONTACT_SET_LAYER  rollcon.contact_set_layer(contact, flexibility)
%
% Puts a thin elastic layer between the bodies that gives way along the surface in proportion to the
% tangential traction at each point, in series with both: thickness over shear modulus. The
% displacements of the bodies do not contain it, slip does. The monolithic system
% (rollcon.contact_set_procedure) does not take it (ERR_UNSUPPORTED at the solve).
%
%   contact (contact)
%   flexibility (real): thickness over shear modulus, length^3/force, >= 0; 0: no layer
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_layer', varargin{:});
end
