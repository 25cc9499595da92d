function varargout = option_info(varargin)
% OPTION_INFO  [name, doc, type, low, high, standard] = rollcon.option_info(kind, i)
%
% Returns a row of the table of options. For text options low, high and standard are 0, and the
% meaning ends with the values allowed.
%
%   kind (int32, name or number: kind of object): OF_...
%   i (row): 0 to rollcon.option_count - 1
% Results:
%   name: its name; 32 bytes are enough for every name
%   doc: what it means
%   type: TYPE_...
%   low: least value allowed
%   high: greatest value allowed
%   standard: value of a new object
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('option_info', varargin{:});
end
