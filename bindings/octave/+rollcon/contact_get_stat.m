function varargout = contact_get_stat(varargin)
% CONTACT_GET_STAT  value = rollcon.contact_get_stat(contact, name)
%
% Returns one number about the last solve: residuals, error estimates, iterations, areas, power,
% seconds, bytes. Names: rollcon.stat_info; meanings: docs/theory.md, section 8. An error estimate is
% computed when one of its numbers is asked for, at about the price of a solve.
%
%   contact (contact)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_stat', varargin{:});
end
