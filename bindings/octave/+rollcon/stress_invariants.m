function varargout = stress_invariants(varargin)
% STRESS_INVARIANTS  [principal, von_mises, shear] = rollcon.stress_invariants(stress)
%
% Returns principal stresses, von Mises's stress and the largest shear stress of n stresses, which may
% come from rollcon.contact_get_fields_at or elsewhere. Principal stresses are exact to rounding,
% relative to the largest of the three.
%
%   stress(n,6) (real): s11, s22, s33, s12, s13, s23, tension positive
% Results:
%   principal: the largest first; []: not wanted
%   von_mises: sqrt(3/2) times the norm of the deviator; []: not wanted
%   shear: half the difference of the first and the last principal stress; []: not wanted
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('stress_invariants', varargin{:});
end
