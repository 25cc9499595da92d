function varargout = body_option_info(varargin)
% BODY_OPTION_INFO  [name, type, low, high, standard] = rollcon.body_option_info(i)
%
% Returns a row of the table of options of bodies.
%
%   i (row): 0 to rollcon.body_option_count() - 1
% Results:
%   name: NUL-terminated; [] only with capacity 0
%   type: TYPE_...
%   low: least value allowed
%   high: greatest value allowed
%   standard: value of a new body
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('body_option_info', varargin{:});
end
