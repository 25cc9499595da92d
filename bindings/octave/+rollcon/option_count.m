function varargout = option_count(varargin)
% OPTION_COUNT  value = rollcon.option_count(kind)
%
% Returns the number of options of a kind of object; 0 for kinds without options and for unknown
% numbers.
%
%   kind (int32, name or number: kind of object): OF_...
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('option_count', varargin{:});
end
