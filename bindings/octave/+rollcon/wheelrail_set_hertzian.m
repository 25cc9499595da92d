function varargout = wheelrail_set_hertzian(varargin)
% WHEELRAIL_SET_HERTZIAN  rollcon.wheelrail_set_hertzian(wheelrail, on)
%
% Takes Hertz's pressures on an ellipse that each patch's overlap gives, and solves for none, with a
% creep-force table (rollcon.wheelrail_set_table; without one nothing changes). A step takes tens of
% microseconds instead of about a millisecond; docs/wheelrail.md has the errors. Patches have their
% statistics; their contacts have no solution (ERR_STATE from calls that ask for one). A patch that
% the table does not have is solved in full; statistic hertzian of the patch is 0.
%
%   wheelrail (wheelrail)
%   on (int32): 1: ellipses of the overlaps; 0: pressures are solved for, the standard
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_hertzian', varargin{:});
end
