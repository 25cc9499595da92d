function varargout = body_set_pressure(varargin)
% BODY_SET_PRESSURE  rollcon.body_set_pressure(body, tag, pressure)
%
% Prescribes a pressure on the faces with a tag, against their outward normals; replaces an earlier
% one and adds to a traction on the same tag.
%
%   body (body)
%   tag (int32): of some face (else ERR_ARGUMENT)
%   pressure (real): force/length^2, -1e100 to 1e100; > 0 compresses
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_pressure', varargin{:});
end
