function varargout = contact_set_layer(varargin)
% CONTACT_SET_LAYER  rollcon.contact_set_layer(contact, flexibility, stress, hardening)
%
% Puts a thin layer between the bodies that gives way along the surface in proportion to the
% tangential traction at each point, in series with both: thickness over shear modulus. The
% displacements of the bodies do not contain it, slip does. The monolithic system
% (rollcon.contact_set_procedure) does not take it (ERR_UNSUPPORTED at the solve). With a yield stress
% the layer, which may be stiff (flexibility 0), flows along the surface under a traction of stress +
% hardening times the flow since the surfaces came into contact. Where that is less than friction it
% bounds the traction, and what friction would call slip is flow. It flows with the laws "coulomb",
% "temperature", and those that fall with a memory; others end with ERR_UNSUPPORTED at the solve. The
% flow is found by solves with given coefficients, as with rollcon.contact_set_friction_memory: for
% steady rolling only, without sensitivities.
%
%   contact (contact)
%   flexibility (real): thickness over shear modulus, length^3/force, >= 0
%   stress (real, may be left out): >= 0, force/length^2; 0: never flows, and with flexibility 0 there
%   is no layer
%   hardening (real, may be left out): force/length^3; negative: softening
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_layer', varargin{:});
end
