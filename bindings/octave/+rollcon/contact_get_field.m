function varargout = contact_get_field(varargin)
% CONTACT_GET_FIELD  v = rollcon.contact_get_field(contact, field, axes)
%
% Returns a nodal field: n_values = nodes x values per node, node after node. ERR_NONFINITE: a value
% is beyond the range of double precision.
%
%   contact (contact)
%   field (int32, name or number: field): FIELD_...
%   axes (int32, name or number: axes): LOCAL or GLOBAL
% Results:
%   v: values; [] only with capacity 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_field', varargin{:});
end
