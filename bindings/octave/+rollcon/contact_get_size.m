function varargout = contact_get_size(varargin)
% CONTACT_GET_SIZE  [nodes, elements] = rollcon.contact_get_size(contact)
%
% Returns the nodes and elements of the frame. It works before a solve.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_size', varargin{:});
end
