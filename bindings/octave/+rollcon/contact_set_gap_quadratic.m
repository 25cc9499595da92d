function varargout = contact_set_gap_quadratic(varargin)
% CONTACT_SET_GAP_QUADRATIC  rollcon.contact_set_gap_quadratic(contact, a, b, c)
%
% Sets the gap of the undeformed bodies at approach 0 to h = a x^2 + b y^2 + c x y in the axes (t1,
% t2); replaces a gap array.
%
%   contact (contact)
%   a (real): 1/length; 1/(2 R) for a sphere
%   b (real): 1/length
%   c (real, may be left out): 1/length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_gap_quadratic', varargin{:});
end
