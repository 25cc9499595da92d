function varargout = wheelrail_set_conformal(varargin)
% WHEELRAIL_SET_CONFORMAL  rollcon.wheelrail_set_conformal(wheelrail, on)
%
% Lays the frame of each patch on the profiles, with normals that turn across it, instead of in one
% plane: for worn profiles and flange roots, where normals turn by more than a few degrees within a
% patch. Its compliance is that of half-spaces on the frame unrolled (docs/theory.md, section 11), its
% operators are made anew at every position, so that a step takes tens of milliseconds, and
% derivatives of the totals are differences of solves. Creep-force tables are not used: statistic
% by_table of a patch is 0.
%
%   wheelrail (wheelrail)
%   on (int32): 1: along the profiles; 0: in a plane, the standard
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('wheelrail_set_conformal', varargin{:});
end
