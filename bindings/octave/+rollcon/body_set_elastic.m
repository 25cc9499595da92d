function varargout = body_set_elastic(varargin)
% BODY_SET_ELASTIC  rollcon.body_set_elastic(body, tag, young, poisson)
%
% Sets an isotropic linear elastic material.
%
%   body (body): not rigid, not prepared (ERR_STATE)
%   tag (int32, may be left out): finite elements: tag of the volume elements that get the material;
%   half-spaces and boundary-element bodies, of one material, ignore it
%   young (real): Young's modulus E > 0, force/length^2
%   poisson (real): Poisson's ratio, -1 < nu <= 0.5; finite elements take up to 0.4999999, TET4 and
%   WEDGE6 up to 0.45 (ERR_UNSUPPORTED from rollcon.body_prepare)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_elastic', varargin{:});
end
