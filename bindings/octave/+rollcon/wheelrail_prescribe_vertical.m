function varargout = wheelrail_prescribe_vertical(varargin)
% WHEELRAIL_PRESCRIBE_VERTICAL  rollcon.wheelrail_prescribe_vertical(wheelrail, how, force)
%
% Prescribes the height of the wheelset by motion, from its position (standard), or by the vertical
% force; z is then found by the solve.
%
%   wheelrail (wheelrail)
%   how (int32, name or number: how): BY_MOTION or BY_FORCE
%   force (real, may be left out): force of this wheel on its rail, along z of the track, >= 0; ignored
%   by motion
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_prescribe_vertical', varargin{:});
end
