function varargout = contact_write(varargin)
% CONTACT_WRITE  rollcon.contact_write(contact, path)
%
% Writes frame and fields, in global axes, as a VTU file for ParaView and meshio. A field beyond the
% range of double precision is ERR_NONFINITE; nothing is written.
%
%   contact (contact)
%   path (name of a file): name of the file; an existing one is replaced
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_write', varargin{:});
end
