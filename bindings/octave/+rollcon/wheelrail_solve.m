function varargout = wheelrail_solve(varargin)
% WHEELRAIL_SOLVE  status = rollcon.wheelrail_solve(wheelrail)
%
% Finds the patches and solves each as a steady rolling contact, from the last solution where there is
% one. The status is the worst of the patches' in the order that holds for all calls. RIM_CONTACT: a
% patch ends at the end of a profile, or is not within its frame; NO_CONTACT: the wheel is lifted; the
% log has the numbers. ERR_STATE names the call that is missing. ERR_ARGUMENT: with this z wheel and
% rail overlap by more than a tenth of the wheel's radius. ERR_LOAD: with this y no height brings the
% wheel on the rail, or no overlap up to a tenth of the radius carries the vertical force. ERR_MESH: a
% conformal patch (option conformal) turns by more than 60 degrees to a side.
%
%   wheelrail (wheelrail)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_solve', varargin{:});
end
