function varargout = body_set_viscoelastic(varargin)
% BODY_SET_VISCOELASTIC  rollcon.body_set_viscoelastic(body, tag, ratios, times)
%
% Lets the material of a half-space relax: Young's modulus at a time t after a strain is E (1 - sum of
% ratio (1 - exp(-t / time))), E that of rollcon.body_set_elastic, with a Poisson's ratio that does
% not change. Such bodies roll steadily, at the speed of rollcon.contact_set_rolling: time steps,
% conformal contacts, wear, tables and wheels on rails end with ERR_UNSUPPORTED. What rolling costs is
% the statistic rolling_resistance.
%
%   body (body): a half-space, not prepared (ERR_STATE)
%   tag (int32, may be left out): half-spaces, of one material, ignore it
%   ratios(n) (real): part of E that each term loses, 0 <= ratio < 1; less than 1 - 1e-6 in all
%   times(n) (real): relaxation time of each term, > 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_viscoelastic', varargin{:});
end
