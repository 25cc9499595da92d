function varargout = wheelrail_request_cancel(varargin)
% WHEELRAIL_REQUEST_CANCEL  rollcon.wheelrail_request_cancel(wheelrail)
%
% Asks a running rollcon.wheelrail_solve or rollcon.wheelrail_solve_many to stop (an atomic store)
% before its next patch, height or position. It returns CANCELLED; the wheel stays usable.
%
%   wheelrail (wheelrail)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_request_cancel', varargin{:});
end
