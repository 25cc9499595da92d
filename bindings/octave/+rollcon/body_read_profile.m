function varargout = body_read_profile(varargin)
% BODY_READ_PROFILE  rollcon.body_read_profile(body, path, unit, mirror, filter_length)
%
% Sets a profile through the points of a file, just as rollcon.body_set_profile does: a file of
% Simpack if the name ends in .prr or .prw (its keys are obeyed except for smoothing), of Miniprof if
% it ends in .ban, .whl or .mpt, else columns, y and z (docs/profiles.md). Simpack's and Miniprof's
% numbers are millimetres. ERR_IO names the line of a file that cannot be read, ERR_ARGUMENT that of a
% point at which the path turns back. z goes where the file says: mirror it where the file counts
% upwards.
%
%   body (body): a half-space or rigid, without a mesh (else ERR_STATE)
%   path (name of a file): name of the file
%   unit (real): factor on its numbers: length of a millimetre, > 0
%   mirror (int32, may be left out): 0: no; 1: in y, 2: in z, 3: in both
%   filter_length (real, may be left out): that of rollcon.body_set_profile, length
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_read_profile', varargin{:});
end
