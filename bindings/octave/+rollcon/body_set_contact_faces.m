function varargout = body_set_contact_faces(varargin)
% BODY_SET_CONTACT_FACES  rollcon.body_set_contact_faces(body, tags)
%
% Says which faces may come into contact: gaps are computed and frames laid on them. The standard is
% all faces that are neither held nor loaded.
%
%   body (body)
%   tags(n) (int32, may be left out): each of some face (else ERR_ARGUMENT); [] only with n = 0
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_set_contact_faces', varargin{:});
end
