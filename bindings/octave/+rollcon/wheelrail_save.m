function varargout = wheelrail_save(varargin)
% WHEELRAIL_SAVE  rollcon.wheelrail_save(wheelrail, place)
%
% Saves what is set and the last solution at a place within the wheel, for rollcon.wheelrail_restore,
% because integrators step back. Nothing is allocated where as much was saved before.
%
%   wheelrail (wheelrail)
%   place (int32): 0 to 15
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_save', varargin{:});
end
