function varargout = contact_request_cancel(varargin)
% CONTACT_REQUEST_CANCEL  rollcon.contact_request_cancel(contact)
%
% Asks a running solve to stop (an atomic store): at its next iteration, or, while bodies and
% operators are prepared, within moments; only a sparse factorisation runs to its end. The solve
% returns CANCELLED; the contact stays usable. What was cancelled during its preparation has no
% results, and the next solve prepares it anew.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_request_cancel', varargin{:});
end
