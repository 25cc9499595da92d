function varargout = contact_repeat_step(varargin)
% CONTACT_REPEAT_STEP  rollcon.contact_repeat_step(contact)
%
% Lets the next solve start from where the last step did, as if that had not been, for a host that
% tries loads or motions again before it goes on. It works once after each step.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_repeat_step', varargin{:});
end
