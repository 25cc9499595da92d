function varargout = body_save(varargin)
% BODY_SAVE  rollcon.body_save(body, path)
%
% Writes the body, prepared if it was not, to a file: all that was given, the factors, and the
% responses to frames that it has cached (option cache_bytes). The file appears whole or not at all;
% an older one is replaced. Poses belong to contacts and are not written. Every library of the same
% ABI number and format reads it, on any machine of the same byte order with IEEE numbers.
%
%   body (body)
%   path (name of a file): name of the file
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('body_save', varargin{:});
end
