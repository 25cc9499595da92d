function varargout = contact_get_motion(varargin)
% CONTACT_GET_MOTION  [approach, creep] = rollcon.contact_get_motion(contact)
%
% Returns approach, creepages and spin, given or found for prescribed forces.
%
%   contact (contact)
% Results:
%   approach: length
%   creep: longitudinal, lateral (dimensionless), spin (1/length)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('contact_get_motion', varargin{:});
end
