function varargout = contact_get_node_states(varargin)
% CONTACT_GET_NODE_STATES  status = rollcon.contact_get_node_states(contact)
%
% Returns the state of each node: OPEN, STICK, SLIP or EXCLUDED.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_node_states', varargin{:});
end
