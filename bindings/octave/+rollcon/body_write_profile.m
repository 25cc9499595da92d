function varargout = body_write_profile(varargin)
% BODY_WRITE_PROFILE  rollcon.body_write_profile(body, path, unit)
%
% Writes points of the profile to a file: of Simpack if the name ends in .prr or .prw, else two
% columns. A profile through points is the same when read again, one in closed form within 1e-9 of its
% size where its curvature is continuous. The file appears whole or not at all.
%
%   body (body): with a profile (else ERR_STATE)
%   path (name of a file): name of the file
%   unit (real): divides its numbers: length of a millimetre, > 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_write_profile', varargin{:});
end
