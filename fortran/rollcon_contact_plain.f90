! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.

!> The life of a contact and its plain procedures. rc_contact (module rollcon_contact) adds the others; programs use
!> that type. A variable is one reference to the object: assignment adds a reference, `free` and the end of the
!> variable's life drop it.
module rollcon_contact_plain
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int32_t, c_int64_t, c_null_char, &
    c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_context
  use rollcon_body
  implicit none
  private
  public :: rc_contact_plain

  type :: rc_contact_plain
    private
    type(c_ptr) :: p = c_null_ptr
  contains
    procedure :: create
    procedure :: frame_from_file => contact_frame_from_file
    procedure :: frame_from_body => contact_frame_from_body
    procedure :: frame_rectangle => contact_frame_rectangle
    procedure :: frame_ellipse => contact_frame_ellipse
    procedure :: frame_strips => contact_frame_strips
    procedure :: frame_automatic => contact_frame_automatic
    procedure :: set_pose => contact_set_pose
    procedure :: set_axes => contact_set_axes
    procedure :: set_gap => contact_set_gap
    procedure :: set_gap_quadratic => contact_set_gap_quadratic
    procedure :: set_gap_grid => contact_set_gap_grid
    procedure :: set_rolling => contact_set_rolling
    procedure :: set_creep => contact_set_creep
    procedure :: set_step => contact_set_step
    procedure :: set_velocity => contact_set_velocity
    procedure :: set_creep_field => contact_set_creep_field
    procedure :: prescribe => contact_prescribe
    procedure :: set_friction => contact_set_friction
    procedure :: set_friction_memory => contact_set_friction_memory
    procedure :: set_layer => contact_set_layer
    procedure :: set_friction_across => contact_set_friction_across
    procedure :: set_heat => contact_set_heat
    procedure :: set_friction_field => contact_set_friction_field
    procedure :: set_procedure => contact_set_procedure
    procedure :: request_cancel => contact_request_cancel
    procedure :: solve => contact_solve
    procedure :: repeat_step => contact_repeat_step
    procedure :: past_set => contact_past_set
    procedure :: reset => contact_reset
    procedure :: get_size => contact_get_size
    procedure :: get_resultant => contact_get_resultant
    procedure :: get_motion => contact_get_motion
    procedure :: get_tilt => contact_get_tilt
    procedure :: get_sensitivity => contact_get_sensitivity
    procedure :: find_stress => contact_find_stress
    procedure :: write_loads => contact_write_loads
    procedure :: get_fatigue_index => contact_get_fatigue_index
    procedure :: get_equivalent_ellipse => contact_get_equivalent_ellipse
    procedure :: get_stat => contact_get_stat
    procedure :: get_plan => contact_get_plan
    procedure :: write_vtu => contact_write
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
    procedure, private :: set_option_int32
    procedure, private :: set_option_int64
    procedure, private :: set_option_real
    procedure, private :: set_option_text
    generic :: set => set_option_int32, set_option_int64, set_option_real, set_option_text
    procedure, private :: get_option_int32
    procedure, private :: get_option_int64
    procedure, private :: get_option_real
    procedure, private :: get_option_text
    generic :: get => get_option_int32, get_option_int64, get_option_real, get_option_text
    procedure, private :: assign
    generic :: assignment(=) => assign
    final :: finalize
  end type

contains

  !> A new contact; a failure leaves none.
  subroutine create(self, context, body1, body2, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    type(rc_context), intent(in) :: context
    type(rc_body), intent(in) :: body1
    type(rc_body), intent(in) :: body2
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    call self%free()
    status = rollcon_contact_create(context%handle(), body1%handle(), body2%handle(), self%p)
    if (status /= ROLLCON_OK) self%p = c_null_ptr
    call finish(status, context%handle(), 'rc_contact%create', stat, errmsg)
  end subroutine

  !> Gives the reference back; the object lives on while another variable or the library uses it.
  impure elemental subroutine release(self)
    class(rc_contact_plain), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_contact_release(self%p)
    self%p = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_contact_plain), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_contact_plain), intent(inout) :: self
    class(rc_contact_plain), intent(in) :: other
    type(c_ptr) :: p
    p = other%p
    if (c_associated(p)) then
      if (rollcon_contact_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    call self%free()
    self%p = p
  end subroutine

  !> Adds a reference to the contact that `id` names (as the FORTRAN 77 layer counts them).
  subroutine from_id(self, id, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    p = rollcon_contact_from_id(int(id, rc_int))
    status = rollcon_contact_retain(p)
    call self%free()
    if (status == ROLLCON_OK) self%p = p
    call finish(status, c_null_ptr, 'rc_contact%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_contact_plain), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_contact_plain), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_int32(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_int(self%p, c_text(name), int(value, rc_long)), self%p, &
      'rc_contact%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_int64(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_int(self%p, c_text(name), value), self%p, &
      'rc_contact%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_real(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_real(self%p, c_text(name), value), self%p, &
      'rc_contact%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_text(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    character(len=*), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_str(self%p, c_text(name), c_text(value)), self%p, &
      'rc_contact%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_int32(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: wide
    wide = 0
    call finish(rollcon_contact_get_int(self%p, c_text(name), wide), self%p, &
      'rc_contact%get', stat, errmsg)
    value = int(wide, c_int32_t)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_int64(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_contact_get_int(self%p, c_text(name), value), self%p, &
      'rc_contact%get', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_real(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_contact_get_real(self%p, c_text(name), value), self%p, &
      'rc_contact%get', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_text(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    character(len=:), allocatable, intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable :: buffer(:)
    integer(rc_long) :: needed
    integer(rc_int) :: status
    allocate (buffer(1))
    needed = 0
    status = rollcon_contact_get_str(self%p, c_text(name), 0_rc_long, buffer, needed)
    deallocate (buffer)
    allocate (buffer(max(needed, 1_rc_long)))
    buffer(1) = c_null_char
    if (status == ROLLCON_OK) &
      status = rollcon_contact_get_str(self%p, c_text(name), size(buffer, kind=rc_long), buffer, needed)
    value = f_text(buffer)
    call finish(status, self%p, &
      'rc_contact%get', stat, errmsg)
  end subroutine

  !> Makes the surface elements of a mesh file the frame; replaces frame and all that was given for its nodes. The files
  !> are those of rollcon_body_read_mesh. Tags of elements are Gmsh's physical groups, else 0.
  subroutine contact_frame_from_file(self, path, part, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    character(len=*), intent(in) :: path
    character(len=*), intent(in) :: part
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_frame_from_file(self%p, c_text(path), c_text(part)), self%p, &
      'rc_contact%frame_from_file', stat, errmsg)
  end subroutine

  !> Makes the faces of a body that carry a tag the frame: replaces nodes and elements of the frame and forgets the gap
  !> array and the creep and friction fields. Its nodes are those of the faces, in the order of their ids in the body,
  !> and follow the body's pose. For finite-element bodies with tri6 among these faces (tet10, the ends of wedge15) they
  !> are the corners alone, and the frame's elements linear: rollcon_contact_get_size tells how many. Faces of body 2
  !> are turned over, so that the frame's normals point out of body 1.
  subroutine contact_frame_from_body(self, which, tag, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: which
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_frame_from_body(self%p, which, int(tag, rc_int)), self%p, 'rc_contact%frame_from_body', &
      stat, errmsg)
  end subroutine

  !> Makes a rectangle in the present plane of the axes the frame: nx by ny elements of one size. Replaces nodes and
  !> elements of the frame and forgets the gap array and the creep and friction fields. Nodes come line by line along
  !> t1, from the least y. Linear quadrilaterals make a regular frame, which half-spaces solve by fast Fourier
  !> transforms.
  subroutine contact_frame_rectangle(self, type, nx, ny, x_least, x_greatest, y_least, y_greatest, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: type
    integer, intent(in) :: nx
    integer, intent(in) :: ny
    real(rc_real), intent(in) :: x_least
    real(rc_real), intent(in) :: x_greatest
    real(rc_real), intent(in) :: y_least
    real(rc_real), intent(in) :: y_greatest
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish( &
      rollcon_contact_frame_rectangle(self%p, type, int(nx, rc_int), int(ny, rc_int), x_least, x_greatest, y_least, y_greatest), &
      self%p, 'rc_contact%frame_rectangle', stat, errmsg)
  end subroutine

  !> Makes an ellipse in the present plane of the axes the frame: strips along the rolling direction, like those of
  !> rollcon_contact_frame_strips, on lines that lie closer towards the sides. It is meant to be the contact itself.
  subroutine contact_frame_ellipse(self, along, across, a, b, angle, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(in) :: along
    integer, intent(in) :: across
    real(rc_real), intent(in) :: a
    real(rc_real), intent(in) :: b
    real(rc_real), intent(in), optional :: angle
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: angle_or_standard
    angle_or_standard = 0
    if (present(angle)) angle_or_standard = angle
    call finish( &
      rollcon_contact_frame_ellipse(self%p, int(along, rc_int), int(across, rc_int), a, b, angle_or_standard), self%p, &
      'rc_contact%frame_ellipse', stat, errmsg)
  end subroutine

  !> Makes strips along the rolling direction the frame: what the contact covers of lines at ascending y. Each has along
  !> + 1 nodes from end to end, close together near the ends, where tractions grow like the square root of the distance.
  !> Nodes come line by line. Replaces the frame just as rollcon_contact_frame_rectangle does. Nodes on the outline
  !> carry no traction (ROLLCON_EXCLUDED): bodies that overlap there are reported as ROLLCON_RIM_CONTACT.
  subroutine contact_frame_strips(self, along, lines, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(in) :: along
    real(rc_real), intent(in), contiguous :: lines(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(lines, 1) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%p, 'rc_contact%frame_strips', stat, errmsg, &
      'the first extent of lines must be 3')
      return
    end if
    call finish(rollcon_contact_frame_strips(self%p, int(along, rc_int), size(lines, 2, rc_long), lines), self%p, &
      'rc_contact%frame_strips', stat, errmsg)
  end subroutine

  !> Leaves the frame to the library, which is the state of a new contact: solves then find the contact from the gap (of
  !> the bodies' meshes and profiles, rollcon_contact_set_gap_quadratic, rollcon_contact_set_gap_grid) and from load or
  !> approach, and lay strips on it whose ends are found with the pressures, finer ones until the option frame_accuracy
  !> is met or ROLLCON_INACCURATE says that it was not. Friction forces, spin moment and creepages under Coulomb's law,
  !> and their sensitivities, are extrapolated from two counts of strips. Where strips do not fit, two frames are fitted
  !> to the edge of each patch, and forces, moment, approach, creepages, their sensitivities and the statistics
  !> contact_area and error_estimate are extrapolated from both. Nodes and fields are those of the finest frame, which
  !> the next solve may replace. The error is that of the frame: what a body's own mesh adds is not counted.
  subroutine contact_frame_automatic(self, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_frame_automatic(self%p), self%p, 'rc_contact%frame_automatic', stat, errmsg)
  end subroutine

  !> Says where a body with a mesh stands: x = rotation x_body + translation, at approach 0. Standard: identity and
  !> zero. Half-spaces ignore it: their surface is the frame's.
  subroutine contact_set_pose(self, which, rotation, translation, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), intent(in) :: rotation(3, 3)
    real(rc_real), intent(in) :: translation(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_pose(self%p, which, transpose(rotation), translation), self%p, &
      'rc_contact%set_pose', stat, errmsg)
  end subroutine

  !> Sets the axes: n along `normal`, t1 along the projection of `rolling` on the tangent plane, t2 = n x t1. Vectors
  !> need not have unit length. Creepages, spin and moments belong to the origin.
  subroutine contact_set_axes(self, origin, rolling, normal, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in) :: origin(3)
    real(rc_real), intent(in) :: rolling(3)
    real(rc_real), intent(in) :: normal(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_axes(self%p, origin, rolling, normal), self%p, 'rc_contact%set_axes', stat, errmsg)
  end subroutine

  !> Sets the gap of the undeformed bodies at approach 0, node by node; replaces a quadratic gap. Where a body has a
  !> mesh or a profile and no gap is given, it is measured along the frame's normals between the surfaces; a body
  !> without either is then the plane through the origin of the axes. These normals are level along the rolling
  !> direction (rollcon_contact_get_tractions): a gap along the surface's own would be longer by half the square of the
  !> angle between them.
  subroutine contact_set_gap(self, gap, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: gap(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_gap(self%p, size(gap, 1, rc_long), gap), self%p, 'rc_contact%set_gap', stat, errmsg)
  end subroutine

  !> Sets the gap of the undeformed bodies at approach 0 to h = a x^2 + b y^2 + c x y in the axes (t1, t2); replaces a
  !> gap array.
  subroutine contact_set_gap_quadratic(self, a, b, c, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in) :: a
    real(rc_real), intent(in) :: b
    real(rc_real), intent(in) :: c
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_gap_quadratic(self%p, a, b, c), self%p, 'rc_contact%set_gap_quadratic', stat, &
      errmsg)
  end subroutine

  !> Sets the gap of the undeformed bodies at approach 0 by its values on a regular grid in the axes (t1, t2): between
  !> the points it is bicubic, with continuous slopes. Values that are +infinity say that a body is not there: the
  !> contact ends at the cells beside them, and there only (rollcon_contact_frame_automatic); the grid's own rim is no
  !> such edge. Replaces a gap array or a quadratic gap. A frame must lie within the cells that have a gap.
  subroutine contact_set_gap_grid(self, nx, x_least, x_greatest, y_least, y_greatest, gap, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(in) :: nx
    real(rc_real), intent(in) :: x_least
    real(rc_real), intent(in) :: x_greatest
    real(rc_real), intent(in) :: y_least
    real(rc_real), intent(in) :: y_greatest
    real(rc_real), intent(in), contiguous :: gap(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish( &
      rollcon_contact_set_gap_grid(self%p, int(nx, rc_int), x_least, x_greatest, y_least, y_greatest, size(gap, 1, rc_long), gap), &
      self%p, 'rc_contact%set_gap_grid', stat, errmsg)
  end subroutine

  !> Sets the speed V at which the contact travels over both surfaces along +t1 (omega R for a wheel). Forgets the
  !> velocity of the contact (rollcon_contact_set_velocity).
  subroutine contact_set_rolling(self, speed, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in) :: speed
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_rolling(self%p, speed), self%p, 'rc_contact%set_rolling', stat, errmsg)
  end subroutine

  !> Prescribes creepages and spin by motion: rigid slip c = V (longitudinal - spin y, lateral + spin x) of body 1
  !> relative to body 2. The call stands for three calls of rollcon_contact_prescribe, and forgets the velocities of
  !> rollcon_contact_set_velocity.
  subroutine contact_set_creep(self, longitudinal, lateral, spin, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in) :: longitudinal
    real(rc_real), intent(in) :: lateral
    real(rc_real), intent(in) :: spin
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_creep(self%p, longitudinal, lateral, spin), self%p, 'rc_contact%set_creep', stat, &
      errmsg)
  end subroutine

  !> Makes every solve from now on a step in time of length dt; ROLLCON_STEADY makes it a steady state again.
  !> ROLLCON_ROLLING_STEP: the contact rolls on by V dt, creepages and spin mean what they mean in steady rolling.
  !> ROLLCON_SHIFT_STEP: no rolling; what is prescribed as creepages is the shift of body 1 against body 2 in this step
  !> (longitudinal and lateral, length) and its turn (spin, radians), and so it is in what rollcon_contact_get_motion
  !> returns; velocities and creep fields count by dt. Loads, motions, approach, friction and gap may change from step
  !> to step. The first step starts from the steady state solved last, or from rest where there is none
  !> (rollcon_contact_reset); a step that fails does not change the one before. A frame that follows its contact takes
  !> the past along (half-spaces and rigid bodies; meshed bodies: ROLLCON_ERR_STATE from the solve).
  subroutine contact_set_step(self, kind, dt, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: kind
    real(rc_real), intent(in) :: dt
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_step(self%p, kind, dt), self%p, 'rc_contact%set_step', stat, errmsg)
  end subroutine

  !> Says how a body or the contact itself moves: its point at x has the velocity v + omega x (x - point). Creepages and
  !> spin then follow from the velocities of both bodies; rollcon_contact_get_motion returns them after a solve. Where
  !> bodies have profiles or meshes the relative velocity is taken between their surfaces, node by node: rolling radius
  !> and spin vary over the contact. The speed V follows from the velocity of the contact, less the mean of both
  !> bodies'; where that is not given it is the one set by rollcon_contact_set_rolling; one of the two is needed. A body
  !> whose velocity is not given is at rest. What was set last counts: rollcon_contact_set_creep forgets all velocities,
  !> rollcon_contact_prescribe replaces one creepage or the spin and leaves the rest of the slip.
  subroutine contact_set_velocity(self, which, velocity, angular_velocity, point, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), intent(in) :: velocity(3)
    real(rc_real), intent(in) :: angular_velocity(3)
    real(rc_real), intent(in) :: point(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_velocity(self%p, which, velocity, angular_velocity, point), self%p, &
      'rc_contact%set_velocity', stat, errmsg)
  end subroutine

  !> Adds a rigid slip velocity given node by node to that of creepages and spin. On a curved frame its components are
  !> along the local axes of each node.
  subroutine contact_set_creep_field(self, slip, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: slip(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(slip, 1) /= 2) then
      call finish(ROLLCON_ERR_ARGUMENT, self%p, 'rc_contact%set_creep_field', stat, errmsg, &
      'the first extent of slip must be 2')
      return
    end if
    call finish(rollcon_contact_set_creep_field(self%p, size(slip, 2, rc_long), slip), self%p, &
      'rc_contact%set_creep_field', stat, errmsg)
  end subroutine

  !> Prescribes one direction by motion or by force; the other quantity is found by the solve. Forces act on body 1. A
  !> tilt turns body 1 against body 2 about t1 or t2 through the origin: at (x, y) of a flat frame it takes (tilt 1) y -
  !> (tilt 2) x from the gap. Its moment is that of the contact's tractions on body 1 about the same axis: a load F that
  !> presses body 1 at (x, y) asks for the moments -F y (tilt 1) and F x (tilt 2). The standard is all by motion, 0.
  subroutine contact_prescribe(self, direction, how, value, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: direction
    integer(rc_int), intent(in) :: how
    real(rc_real), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_prescribe(self%p, direction, how, value), self%p, 'rc_contact%prescribe', stat, errmsg)
  end subroutine

  !> Sets the law of friction for the whole frame. "coulomb": mu. "orthotropic": mu1 and mu2 along axes that are turned
  !> by an angle (radian) from t1 towards t2 (on curved frames those of each node), slip normal to the ellipse of the
  !> tractions; "orthotropic_collinear": the same ellipse, slip against the traction. "linear", "rational",
  !> "exponential": friction that falls with the slip speed s, muk + mu1 f(s/s1) and, with 5 parameters, + mu2 f(s/s2),
  !> each half as great or less at its speed: f(x) = max(0, 1 - x/2), 1/(1 + x) (of the second term 1/(1 + x^2)), or
  !> 2^-x. "temperature": linear in the surface temperature between points T1, mu1, T2, mu2, ... with ascending
  !> temperatures, constant beyond them (needs rollcon_contact_set_heat; steady rolling, no sensitivities). Where
  !> friction falls several solutions may exist then: a solve from nothing begins with the friction of rest, a warm one
  !> continues the last solution, the plan says which; ROLLCON_FIELD_FRICTION gives the coefficient at the node's slip.
  !> Where rollcon_contact_set_friction_field gives coefficients, each is the greatest of its node (at rest) and the law
  !> keeps its ratios. The published procedures (rollcon_contact_set_procedure) take "coulomb" alone
  !> (ROLLCON_ERR_UNSUPPORTED at the solve).
  subroutine contact_set_friction(self, law, parameters, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    character(len=*), intent(in) :: law
    real(rc_real), intent(in), contiguous :: parameters(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_friction(self%p, c_text(law), size(parameters, 1, rc_int), parameters), self%p, &
      'rc_contact%set_friction', stat, errmsg)
  end subroutine

  !> Gives friction that falls with the slip speed a memory: for a particle of the surface d mu/dt = -max(s, s0)/dc (mu
  !> - mu_s(s)), where mu_s is what the law without memory says; where surfaces come into contact mu is that at rest.
  !> Coefficients then follow the whole solution and are found by solves with given ones (statistics friction_rounds and
  !> friction_change). The memory holds for whatever law is set, if it falls, else the solve ends with
  !> ROLLCON_ERR_STATE. It is for steady rolling only (steps in time: ROLLCON_ERR_UNSUPPORTED from the solve), and there
  !> are no sensitivities (ROLLCON_ERR_UNSUPPORTED).
  subroutine contact_set_friction_memory(self, length, least_speed, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in) :: length
    real(rc_real), intent(in) :: least_speed
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_friction_memory(self%p, length, least_speed), self%p, &
      'rc_contact%set_friction_memory', stat, errmsg)
  end subroutine

  !> Puts a thin layer between the bodies that gives way along the surface in proportion to the tangential traction at
  !> each point, in series with both: thickness over shear modulus. The displacements of the bodies do not contain it,
  !> slip does. The monolithic system (rollcon_contact_set_procedure) does not take it (ROLLCON_ERR_UNSUPPORTED at the
  !> solve). With a yield stress the layer, which may be stiff (flexibility 0), flows along the surface under a traction
  !> of stress + hardening times the flow since the surfaces came into contact. Where that is less than friction it
  !> bounds the traction, and what friction would call slip is flow. It flows with the laws "coulomb", "temperature",
  !> and those that fall with a memory; others end with ROLLCON_ERR_UNSUPPORTED at the solve. The flow is found by
  !> solves with given coefficients, as with rollcon_contact_set_friction_memory: for steady rolling only, without
  !> sensitivities.
  subroutine contact_set_layer(self, flexibility, stress, hardening, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in) :: flexibility
    real(rc_real), intent(in), optional :: stress
    real(rc_real), intent(in), optional :: hardening
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: stress_or_standard
    real(rc_real) :: hardening_or_standard
    stress_or_standard = 0
    if (present(stress)) stress_or_standard = stress
    hardening_or_standard = 0
    if (present(hardening)) hardening_or_standard = hardening
    call finish(rollcon_contact_set_layer(self%p, flexibility, stress_or_standard, hardening_or_standard), self%p, &
      'rc_contact%set_layer', stat, errmsg)
  end subroutine

  !> Sets friction coefficients along t2, linear between points and constant beyond them, for frames of any maker: they
  !> replace the (greatest) coefficient of rollcon_contact_set_friction, where rollcon_contact_set_friction_field gives
  !> none.
  subroutine contact_set_friction_across(self, points, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: points(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(points, 1) /= 2) then
      call finish(ROLLCON_ERR_ARGUMENT, self%p, 'rc_contact%set_friction_across', stat, errmsg, &
      'the first extent of points must be 2')
      return
    end if
    call finish(rollcon_contact_set_friction_across(self%p, size(points, 2, rc_long), points), self%p, &
      'rc_contact%set_friction_across', stat, errmsg)
  end subroutine

  !> Says what a body does with heat, for the surface temperatures of a solution (rollcon_contact_get_temperatures_at,
  !> ROLLCON_FIELD_TEMPERATURE) and for friction that depends on them. The call is needed for both bodies; one of them
  !> may take up no heat.
  subroutine contact_set_heat(self, which, conductivity, heat_capacity, temperature, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), intent(in) :: conductivity
    real(rc_real), intent(in) :: heat_capacity
    real(rc_real), intent(in) :: temperature
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_heat(self%p, which, conductivity, heat_capacity, temperature), self%p, &
      'rc_contact%set_heat', stat, errmsg)
  end subroutine

  !> Sets the friction coefficient node by node, in place of that of rollcon_contact_set_friction.
  subroutine contact_set_friction_field(self, mu, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: mu(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_friction_field(self%p, size(mu, 1, rc_long), mu), self%p, &
      'rc_contact%set_friction_field', stat, errmsg)
  end subroutine

  !> Chooses one of the published solution procedures in place of the library's own iteration, by options and values:
  !> "system=monolithic jacobian=reduced"; what is not named has its standard value, and "" is the library's own.
  !> rollcon_option_info lists them (ROLLCON_OF_PROCEDURE). Combinations that make no sense are ROLLCON_ERR_OPTION when
  !> a solve begins, builds without the procedures ROLLCON_ERR_UNSUPPORTED.
  subroutine contact_set_procedure(self, procedure, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    character(len=*), intent(in) :: procedure
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_procedure(self%p, c_text(procedure)), self%p, 'rc_contact%set_procedure', stat, &
      errmsg)
  end subroutine

  !> Asks a running solve to stop (an atomic store): at its next iteration, or, while bodies and operators are prepared,
  !> within moments; only a sparse factorisation runs to its end. The solve returns ROLLCON_CANCELLED; the contact stays
  !> usable. What was cancelled during its preparation has no results, and the next solve prepares it anew.
  subroutine contact_request_cancel(self, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_request_cancel(self%p), self%p, 'rc_contact%request_cancel', stat, errmsg)
  end subroutine

  !> Solves the steady rolling contact: tractions, slip, and whatever motion was prescribed by force. Starts from the
  !> last solution unless the option "warm_start" is 0. After ROLLCON_NOT_CONVERGED and ROLLCON_CANCELLED the best
  !> iterate can be read. ROLLCON_COARSE says that no node in contact has all its neighbours in contact (with friction:
  !> fewer than 5 have); the solution is that of the frame, not of the bodies. Log and plan tell more. A failed solve
  !> does not change the scene but discards the last solution. Bodies that are not prepared are prepared first and may
  !> fail the way rollcon_body_prepare does (ROLLCON_ERR_MESH, ROLLCON_ERR_SINGULAR); the text names the body. Creepages
  !> (whose slip, times speed or stiffness, would come to 1e305) and approaches (to pressures of 1e150) that double
  !> precision cannot calculate with are ROLLCON_ERR_ARGUMENT; the text names a node and what is allowed. Nodes that are
  !> never to touch may have any gap, with the monolithic system (rollcon_contact_set_procedure) up to that limit.
  subroutine contact_solve(self, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_solve(self%p), self%p, 'rc_contact%solve', stat, errmsg)
  end subroutine

  !> Lets the next solve start from where the last step did, as if that had not been, for a host that tries loads or
  !> motions again before it goes on. It works once after each step.
  subroutine contact_repeat_step(self, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_repeat_step(self%p), self%p, 'rc_contact%repeat_step', stat, errmsg)
  end subroutine

  !> Lets the next step start from what rollcon_contact_past_get gave. Prepares bodies and frame where nothing was
  !> solved yet. Numbers of another frame, or that were changed, are refused and do not change the past; results of the
  !> last solve are gone.
  subroutine contact_past_set(self, past, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: past(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_past_set(self%p, size(past, 1, rc_long), past), self%p, 'rc_contact%past_set', stat, &
      errmsg)
  end subroutine

  !> Forgets the solution, the warm start, the iteration log and what was before a time step (bodies are at rest); keeps
  !> the scene and all that was computed for the frame.
  subroutine contact_reset(self, stat, errmsg)
    class(rc_contact_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_reset(self%p), self%p, 'rc_contact%reset', stat, errmsg)
  end subroutine

  !> Returns the nodes and elements of the frame. It works before a solve.
  subroutine contact_get_size(self, nodes, elements, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    integer, intent(out) :: nodes
    integer, intent(out), optional :: elements
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: nodes_c
    integer(rc_long) :: elements_c
    nodes_c = 0
    elements_c = 0
    call finish(rollcon_contact_get_size(self%p, nodes_c, elements_c), self%p, 'rc_contact%get_size', stat, errmsg)
    nodes = int(nodes_c)
    if (present(elements)) elements = int(elements_c)
  end subroutine

  !> Returns the resultant force on body 1 and its moment about the origin of the axes.
  subroutine contact_get_resultant(self, force, moment, axes, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    real(rc_real), intent(out) :: force(3)
    real(rc_real), intent(out) :: moment(3)
    integer(rc_int), intent(in), optional :: axes
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: axes_or_standard
    axes_or_standard = ROLLCON_LOCAL
    if (present(axes)) axes_or_standard = axes
    force = 0
    moment = 0
    call finish(rollcon_contact_get_resultant(self%p, axes_or_standard, force, moment), self%p, &
      'rc_contact%get_resultant', stat, errmsg)
  end subroutine

  !> Returns approach, creepages and spin, given or found for prescribed forces.
  subroutine contact_get_motion(self, approach, creep, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    real(rc_real), intent(out) :: approach
    real(rc_real), intent(out) :: creep(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    approach = 0
    creep = 0
    call finish(rollcon_contact_get_motion(self%p, approach, creep), self%p, 'rc_contact%get_motion', stat, errmsg)
  end subroutine

  !> Returns rotations of body 1 against body 2 about t1 and t2, given or found for prescribed moments
  !> (rollcon_contact_prescribe).
  subroutine contact_get_tilt(self, tilt, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    real(rc_real), intent(out) :: tilt(2)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    tilt = 0
    call finish(rollcon_contact_get_tilt(self%p, tilt), self%p, 'rc_contact%get_tilt', stat, errmsg)
  end subroutine

  !> Returns the derivatives of what rollcon_contact_get_resultant (local axes) and rollcon_contact_get_motion give, by
  !> one parameter. A direction stands for the value last solved with there: creepage, spin or approach where the motion
  !> was prescribed; force, spin moment or compressive load where the force was; motions that were found then change
  !> with it. FRICTION stands for a factor, now 1, on every friction coefficient: for d/dmu of a uniform mu divide by
  !> mu. They are those of Newton's system at the solution, the state of every node held: at most one factorisation for
  !> all parameters (one more for NORMAL where pressures stand alone) and one right side each; kept until the next
  !> solve. After ROLLCON_NO_CONTACT only a prescribed motion's derivative by itself is not 0. ROLLCON_ERR_STATE: no
  !> solution, one that did not converge, or the parameter is a tangential force or spin moment without friction.
  !> ROLLCON_ERR_SINGULAR: a load at the limit of friction. ROLLCON_ERR_UNSUPPORTED: friction follows the whole solution
  !> (of temperature, with a memory, of a layer that flows).
  subroutine contact_get_sensitivity(self, parameter, force, moment, approach, creep, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    integer(rc_int), intent(in) :: parameter
    real(rc_real), intent(out) :: force(3)
    real(rc_real), intent(out) :: moment(3)
    real(rc_real), intent(out) :: approach
    real(rc_real), intent(out) :: creep(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    force = 0
    moment = 0
    approach = 0
    creep = 0
    call finish(rollcon_contact_get_sensitivity(self%p, parameter, force, moment, approach, creep), self%p, &
      'rc_contact%get_sensitivity', stat, errmsg)
  end subroutine

  !> Searches a half-space under the last solve for the largest value of a measure of stress, and says where it is.
  !> "von_mises", "shear" (half the difference of the extreme principal stresses) and "orthogonal_shear" (|s13|) take no
  !> parameters. Measures of the history of a particle that passes through the contact along t1: "dang_van" and
  !> "crossland" take the weight a of the hydrostatic stress h, and are max(shear of the deviator less the centre of its
  !> least ball + a h) and radius of the least ball/sqrt(2) + a max h. "lundberg_palmgren" takes exponents c and h and a
  !> least depth: value is the integral of amplitude(s13)^c/depth^h over t2 and depth, which times the length of the
  !> track is the volume integral of a bearing's life; place is that of the largest amplitude. Values are those of the
  !> solution's tractions: at a sharp end they depend on the frame. ROLLCON_ERR_OPTION: no such measure;
  !> ROLLCON_ERR_STATE: no solution, or no contact; ROLLCON_ERR_UNSUPPORTED: no half-space, or a conformal contact.
  subroutine contact_find_stress(self, which, measure, parameters, value, place, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    integer(rc_int), intent(in) :: which
    character(len=*), intent(in) :: measure
    real(rc_real), intent(in), contiguous :: parameters(:)
    real(rc_real), intent(out) :: value
    real(rc_real), intent(out) :: place(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    place = 0
    call finish( &
      rollcon_contact_find_stress(self%p, which, c_text(measure), size(parameters, 1, rc_int), parameters, value, place), &
      self%p, 'rc_contact%find_stress', stat, errmsg)
  end subroutine

  !> Writes what the contact does to a body with a mesh as forces on the body's own nodes, in its axes: the integrals of
  !> the last solve's tractions times the nodes' shape functions. A name that ends in .inp gets *CLOAD cards of Abaqus
  !> and CalculiX, of components that are not zero; one that ends in .mtx a MatrixMarket vector of x, y, z of each node
  !> in the order of the body. Nodes have the numbers of the file that the mesh was read from; of arrays the first is 1.
  !> The sums of force and moment are those of the contact (rollcon_contact_get_resultant; the second body takes the
  !> opposite): a frame and curved faces under it are not one surface, and what is missing is spread linearly over the
  !> loaded nodes. The file tells the resultant about the origin of the body's axes, and by how much that moved the
  !> forces. Forces of the body's own loads and supports are not among them. ROLLCON_ERR_UNSUPPORTED: a body without a
  !> mesh, or a build without finite elements.
  subroutine contact_write_loads(self, which, path, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    integer(rc_int), intent(in) :: which
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_write_loads(self%p, which, c_text(path)), self%p, 'rc_contact%write_loads', stat, &
      errmsg)
  end subroutine

  !> Returns the railways' index of surface-initiated rolling contact fatigue of wheels, after Ekberg, Kabo and
  !> Andersson (bearings: rollcon_contact_find_stress), FI = sqrt(F1^2 + F2^2)/Fn - 2 A k/(3 Fn), with the area A in
  !> contact (statistic contact_area; pi a b for an ellipse) and the yield stress k in shear; positive where fatigue is
  !> to be expected. ROLLCON_ERR_STATE: no solution, or no normal force. The wear number T-gamma, force times creepage,
  !> is the statistic t_gamma.
  subroutine contact_get_fatigue_index(self, shear_yield, index, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    real(rc_real), intent(in) :: shear_yield
    real(rc_real), intent(out) :: index
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    index = 0
    call finish(rollcon_contact_get_fatigue_index(self%p, shear_yield, index), self%p, 'rc_contact%get_fatigue_index', &
      stat, errmsg)
  end subroutine

  !> Returns the Hertzian contact that stands for this one, in the form of inputs of rollcon_table_evaluate. The ellipse
  !> has the area in contact (statistic contact_area) and, along over across, the second moments of the pressures. Load,
  !> creepages and spin are those of the solution, the latter by least squares weighted with pressure about its centre;
  !> the solution needs no friction. Friction is the mean over the pressure, for falling laws at the speed of the rigid
  !> slip; inputs[2] may be replaced. Elastic constants: mean values of 1/G and nu/G; where pressure strains one body
  !> more than the other, the longitudinal creepage has the mean difference of these strains on top. A moment about the
  !> contact's origin has center[0] F2 - center[1] F1 more than one about the centre. ROLLCON_ERR_STATE: no solution, no
  !> load, several patches far apart, or a shift; ROLLCON_ERR_UNSUPPORTED: a body has a mesh, a layer is between the
  !> bodies, or friction depends on the direction.
  subroutine contact_get_equivalent_ellipse(self, inputs, center, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    real(rc_real), intent(out) :: inputs(9)
    real(rc_real), intent(out) :: center(2)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    inputs = 0
    center = 0
    call finish(rollcon_contact_get_equivalent_ellipse(self%p, inputs, center), self%p, &
      'rc_contact%get_equivalent_ellipse', stat, errmsg)
  end subroutine

  !> Returns one number about the last solve: residuals, error estimates, iterations, areas, power, seconds, bytes.
  !> Names: rollcon_stat_info; meanings: docs/theory.md, section 8. An error estimate is computed when one of its
  !> numbers is asked for, at about the price of a solve.
  subroutine contact_get_stat(self, name, value, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_contact_get_stat(self%p, c_text(name), value), self%p, 'rc_contact%get_stat', stat, errmsg)
  end subroutine

  !> Returns how the last solve was done (sizes, schemes, linear solver and why), as text for people.
  subroutine contact_get_plan(self, text, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    character(len=:), allocatable, intent(out) :: text
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable :: buffer(:)
    integer(rc_long) :: needed
    integer(rc_int) :: status
    allocate (buffer(1))
    needed = 0
    status = rollcon_contact_get_plan(self%p, 0_rc_long, buffer, needed)
    deallocate (buffer)
    allocate (buffer(max(needed, 1_rc_long)))
    buffer(1) = c_null_char
    if (status == ROLLCON_OK) status = rollcon_contact_get_plan(self%p, size(buffer, kind=rc_long), buffer, needed)
    text = f_text(buffer)
    call finish(status, self%p, 'rc_contact%get_plan', stat, errmsg)
  end subroutine

  !> Writes frame and fields, in global axes, as a VTU file for ParaView and meshio. A field beyond the range of double
  !> precision is ROLLCON_ERR_NONFINITE; nothing is written.
  subroutine contact_write(self, path, stat, errmsg)
    class(rc_contact_plain), intent(in) :: self
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_write(self%p, c_text(path)), self%p, 'rc_contact%write_vtu', stat, errmsg)
  end subroutine

end module rollcon_contact_plain
