function varargout = contact_set_procedure(varargin)
% CONTACT_SET_PROCEDURE  rollcon.contact_set_procedure(contact, procedure)
%
% Chooses one of the published solution procedures in place of the library's own iteration, by options
% and values: "system=monolithic jacobian=reduced"; what is not named has its standard value, and ""
% is the library's own. rollcon.option_info lists them (OF_PROCEDURE). Combinations that make no sense
% are ERR_OPTION when a solve begins, builds without the procedures ERR_UNSUPPORTED.
%
%   contact (contact)
%   procedure (text): option=value, separated by blanks
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_set_procedure', varargin{:});
end
