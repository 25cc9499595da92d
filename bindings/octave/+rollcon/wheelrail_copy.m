function varargout = wheelrail_copy(varargin)
% WHEELRAIL_COPY  copy = rollcon.wheelrail_copy(wheelrail)
%
% Makes another wheel on its rail with the same bodies, inputs and last solution, and no snapshots:
% both go on alike to the last bit.
%
%   wheelrail (wheelrail)
% Results:
%   copy: new handle
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_copy', varargin{:});
end
