function varargout = contact_set_creep_field(varargin)
% CONTACT_SET_CREEP_FIELD  rollcon.contact_set_creep_field(contact, slip)
%
% Adds a rigid slip velocity given node by node to that of creepages and spin. On a curved frame its
% components are along the local axes of each node.
%
%   contact (contact)
%   slip(n,2) (real, may be left out): velocity along t1 and t2, length/time; [] only with n = 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_creep_field', varargin{:});
end
