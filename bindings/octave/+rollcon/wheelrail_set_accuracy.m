function varargout = wheelrail_set_accuracy(varargin)
% WHEELRAIL_SET_ACCURACY  rollcon.wheelrail_set_accuracy(wheelrail, accuracy)
%
% Sets how accurate forces are to be: the frames of the patches are as fine as that takes.
%
%   wheelrail (wheelrail)
%   accuracy (real): error of tangential forces over the limit of friction: 0.005 to 1, standard 0.01
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_accuracy', varargin{:});
end
