function varargout = wheelrail_get_stat(varargin)
% WHEELRAIL_GET_STAT  value = rollcon.wheelrail_get_stat(wheelrail, name)
%
% Returns one number about the last solve: height, vertical force, frictional power, counts. Names:
% rollcon.stat_info; meanings: docs/wheelrail.md.
%
%   wheelrail (wheelrail)
%   name (text)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('wheelrail_get_stat', varargin{:});
end
