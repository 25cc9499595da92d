function varargout = contact_set_layer_yield(varargin)
% CONTACT_SET_LAYER_YIELD  rollcon.contact_set_layer_yield(contact, stress, hardening)
%
% Lets the layer between the bodies (rollcon.contact_set_layer, which may be stiff: flexibility 0)
% flow along the surface under a traction of stress + hardening times the flow since the surfaces came
% into contact. Where that is less than friction it bounds the traction, and what friction would call
% slip is flow. It works with the laws "coulomb", "temperature", and those that fall with a memory;
% others end with ERR_UNSUPPORTED at the solve. The flow is found by solves with given coefficients,
% as with rollcon.contact_set_friction_memory: for steady rolling only, without sensitivities.
%
%   contact (contact)
%   stress (real): >= 0, force/length^2; 0: never flows
%   hardening (real): force/length^3; negative: softening
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_layer_yield', varargin{:});
end
