function varargout = contact_reset(varargin)
% CONTACT_RESET  rollcon.contact_reset(contact)
%
% Forgets the solution, the warm start, the iteration log and what was before a time step (bodies are
% at rest); keeps the scene and all that was computed for the frame.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_reset', varargin{:});
end
