function varargout = contact_set_friction_across(varargin)
% CONTACT_SET_FRICTION_ACROSS  rollcon.contact_set_friction_across(contact, points)
%
% Sets friction coefficients along t2, linear between points and constant beyond them, for frames of
% any maker: they replace the (greatest) coefficient of rollcon.contact_set_friction, where
% rollcon.contact_set_friction_field gives none.
%
%   contact (contact)
%   points(n,2) (real, may be left out): y along t2 from the origin of the axes, ascending, length, and
%   mu >= 0; [] only with n = 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_friction_across', varargin{:});
end
