function varargout = contact_release(varargin)
% CONTACT_RELEASE  rollcon.contact_release(contact)
%
% Drops a reference; the handle is dead after the last one. [] and dead handles are ignored.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_release', varargin{:});
end
