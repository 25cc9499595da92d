function varargout = wheelrail_rollback(varargin)
% WHEELRAIL_ROLLBACK  rollcon.wheelrail_rollback(wheelrail, place)
%
% Goes back to a snapshot: inputs, results, and later solves are as if nothing had been done since, to
% the last bit. ERR_STATE: there is no snapshot at this place, or track or wheelset have been set
% since. The snapshot stays. Contacts of patches that were new since then are no longer those of this
% wheel.
%
%   wheelrail (wheelrail)
%   place (int32): 0 to 15
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_rollback', varargin{:});
end
