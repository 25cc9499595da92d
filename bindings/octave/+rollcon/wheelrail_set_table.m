function varargout = wheelrail_set_table(varargin)
% WHEELRAIL_SET_TABLE  rollcon.wheelrail_set_table(wheelrail, table)
%
% Looks forces along the surfaces and spin moments up in a creep-force table from now on, for the
% equivalent ellipse of each patch (rollcon.contact_get_equivalent_ellipse), which is solved without
% friction: its contact then has pressures alone. A patch that the table does not have (ratio of its
% axes, Poisson's ratio, or no single ellipse) is solved in full; statistic by_table of the patch is
% 0. The wheel keeps the table; [] solves all patches in full again. ERR_STATE: the table is not made
% yet.
%
%   wheelrail (wheelrail)
%   table (table): []: no table
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_table', varargin{:});
end
