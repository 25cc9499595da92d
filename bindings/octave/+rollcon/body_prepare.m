function varargout = body_prepare(varargin)
% BODY_PREPARE  rollcon.body_prepare(body)
%
% Checks that the body is complete and its mesh and supports sound, assembles and factorises its
% equations, and freezes it. The call is optional: the first solve does it. Calling it again does
% nothing. (Finite elements with many contact faces and no loads of their own are factorised when a
% frame tells which part of the faces takes part.) ERR_MESH names the offending elements or nodes:
% double nodes, degenerate or repeated elements, neighbours of opposite orientation, and for elastic
% bodies open edges, normals that point inwards, more than one outer shell; for finite elements turned
% elements, faces that meet without matching, parts that share no face, tagged faces that are not on
% the boundary. A body equal to one that is prepared in the same context (mesh, tags, material,
% supports, loads, contact faces, options) uses its equations: nothing is assembled again.
% ERR_SINGULAR: the supports leave the body free to move, and the text says how; hold it (three nodes
% not on a line, or a hub), since what is held is also what approach and creepage move.
%
%   body (body)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_prepare', varargin{:});
end
