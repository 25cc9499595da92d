function varargout = stat_info(varargin)
% STAT_INFO  [name, doc, inside] = rollcon.stat_info(kind, i)
%
% Returns a row of the table of statistics. Some count work inside the library: they help to
% understand a solve, and another version may count otherwise or leave them out.
%
%   kind (int32, name or number: kind of object): OF_...
%   i (row): 0 to rollcon.stat_count - 1
% Results:
%   name: its name; 32 bytes are enough for every name
%   doc: what it means
%   inside: 1: counts work inside the library, which is promised to nobody; 0: stays
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('stat_info', varargin{:});
end
