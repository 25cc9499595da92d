function varargout = contact_past_get(varargin)
% CONTACT_PAST_GET  past = rollcon.contact_past_get(contact)
%
% Returns what the next step starts from, as numbers: a header with a version, time, tractions, a
% checksum. They serve another run, or another contact of such bodies on the same frame.
%
%   contact (contact)
% Results:
%   past: [] only with capacity 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_past_get', varargin{:});
end
