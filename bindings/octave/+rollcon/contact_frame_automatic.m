function varargout = contact_frame_automatic(varargin)
% CONTACT_FRAME_AUTOMATIC  rollcon.contact_frame_automatic(contact)
%
% Leaves the frame to the library, which is the state of a new contact: solves then find the contact
% from the gap (of the bodies' meshes and profiles, rollcon.contact_set_gap_quadratic,
% rollcon.contact_set_gap_grid) and from load or approach, and lay strips on it whose ends are found
% with the pressures, finer ones until the option frame_accuracy is met or INACCURATE says that it was
% not. Where strips do not fit, two frames are fitted to the edge of each patch, and forces, moment,
% approach, creepages, their sensitivities and the statistics contact_area and error_estimate are
% extrapolated from both. Nodes and fields are those of the finest frame, which the next solve may
% replace. The error is that of the frame: what a body's own mesh adds is not counted.
%
%   contact (contact)
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
rollcon_mex('contact_frame_automatic', varargin{:});
end
