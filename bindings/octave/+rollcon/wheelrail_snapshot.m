function varargout = wheelrail_snapshot(varargin)
% WHEELRAIL_SNAPSHOT  rollcon.wheelrail_snapshot(wheelrail, place)
%
% Takes a snapshot of what is set and of the last solution, kept at a place within the wheel, for
% rollcon.wheelrail_rollback, because integrators step back. Nothing is allocated where as much was
% kept before.
%
%   wheelrail (wheelrail)
%   place (int32): 0 to 15
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_snapshot', varargin{:});
end
