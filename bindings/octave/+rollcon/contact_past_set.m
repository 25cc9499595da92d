function varargout = contact_past_set(varargin)
% CONTACT_PAST_SET  rollcon.contact_past_set(contact, past)
%
% Lets the next step start from what rollcon.contact_past_get gave. Prepares bodies and frame where
% nothing was solved yet. Numbers of another frame, or that were changed, are refused and do not
% change the past; results of the last solve are gone.
%
%   contact (contact)
%   past(n) (real): what rollcon.contact_past_get gave
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_past_set', varargin{:});
end
