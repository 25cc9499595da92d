!> The first half of a contact: its life and everything that the caller gives. rc_contact (module rollcon_contact) adds
!> the solve and its results; programs use that type. A variable is one reference to the object, as for `rc_context`.
!>
!> Vectors are xyz by columns: x(3,n); node numbers count from 1. Every call takes `stat` (absent: a failure prints its
!> message and stops; positive values are results with a caveat) and `errmsg` (set on failure, cut or padded).
module rollcon_scene
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int32_t, c_int64_t, c_null_char, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_context
  use rollcon_body
  implicit none
  private
  public :: rc_scene

  type :: rc_scene
    private
    type(c_ptr) :: p = c_null_ptr
    type(c_ptr) :: context = c_null_ptr  ! a reference of its own, for the texts of failures
  contains
    procedure :: create
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
    procedure :: owner
    procedure :: set_frame_nodes
    procedure :: set_frame_nodes_by_component
    procedure, private :: add_frame_elements_int32
    procedure, private :: add_frame_elements_int64
    generic :: add_frame_elements => add_frame_elements_int32, add_frame_elements_int64
    procedure :: frame_from_body
    procedure :: set_pose
    procedure :: set_axes
    procedure :: set_gap
    procedure :: set_gap_quadratic
    procedure :: set_rolling
    procedure :: set_creep
    procedure :: set_creep_field
    procedure :: prescribe
    procedure :: set_friction
    procedure :: set_friction_field
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

  subroutine create(self, context, body1, body2, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    type(rc_context), intent(in) :: context
    type(rc_body), intent(in) :: body1, body2
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    type(c_ptr) :: ctx
    call self%free()
    ctx = context%handle()
    status = rollcon_contact_create(ctx, body1%handle(), body2%handle(), self%p)
    if (status /= ROLLCON_OK) then
      self%p = c_null_ptr
    else if (rollcon_context_retain(ctx) == ROLLCON_OK) then
      self%context = ctx
    end if
    call finish(status, ctx, 'rc_contact%create', stat, errmsg)
  end subroutine

  !> Gives the reference back; no harm if there is none.
  impure elemental subroutine release(self)
    class(rc_scene), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_contact_release(self%p)
    if (c_associated(self%context)) call rollcon_context_release(self%context)
    self%p = c_null_ptr
    self%context = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_scene), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_scene), intent(inout) :: self
    class(rc_scene), intent(in) :: other
    type(c_ptr) :: p, context
    p = other%p
    context = other%context
    if (c_associated(p)) then
      if (rollcon_contact_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    if (c_associated(context)) then
      if (rollcon_context_retain(context) /= ROLLCON_OK) context = c_null_ptr
    end if
    call self%free()
    self%p = p
    self%context = context
  end subroutine

  !> Adds a reference to the contact that `id` names; texts of failures come from `context`.
  subroutine from_id(self, context, id, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p, ctx
    integer(rc_int) :: status
    p = rollcon_contact_from_id(int(id, rc_int))
    ctx = context%handle()
    status = rollcon_contact_retain(p)
    call self%free()
    if (status == ROLLCON_OK) then
      self%p = p
      if (c_associated(ctx)) then
        if (rollcon_context_retain(ctx) == ROLLCON_OK) self%context = ctx
      end if
    end if
    call finish(status, c_null_ptr, 'rc_contact%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_scene), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_scene), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> The C handle of the context that holds the texts of failures.
  function owner(self) result(context)
    class(rc_scene), intent(in) :: self
    type(c_ptr) :: context
    context = self%context
  end function

  !> Nodes of the frame, x(3,n).
  subroutine set_frame_nodes(self, x, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(x, 1) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_contact%set_frame_nodes', stat, errmsg, 'the first extent of x must be 3')
      return
    end if
    call finish(rollcon_contact_set_frame_nodes(self%p, size(x, 2, rc_long), x, 3_rc_long, 1_rc_long), self%context, &
      'rc_contact%set_frame_nodes', stat, errmsg)
  end subroutine

  !> Nodes of the frame, x(n,3).
  subroutine set_frame_nodes_by_component(self, x, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: n
    if (size(x, 2) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_contact%set_frame_nodes_by_component', stat, errmsg, &
        'the second extent of x must be 3')
      return
    end if
    n = size(x, 1, rc_long)
    call finish(rollcon_contact_set_frame_nodes(self%p, n, x, 1_rc_long, n), self%context, &
      'rc_contact%set_frame_nodes_by_component', stat, errmsg)
  end subroutine

  !> Elements of one type (ROLLCON_TRI3, ...): nodes(nodes per element, n), numbered from 1. Tag: 1 if
  !> absent.
  subroutine add_frame_elements_int32(self, type, nodes, tag, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    integer(rc_int), intent(in) :: type
    integer(c_int32_t), intent(in), contiguous :: nodes(:, :)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: t
    t = 1
    if (present(tag)) t = int(tag, rc_int)
    if (nodes_of(type) /= 0 .and. size(nodes, 1) /= nodes_of(type)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_contact%add_frame_elements', stat, errmsg, &
        'the first extent of nodes must be the number of nodes of one element')
      return
    end if
    call finish(rollcon_contact_add_frame_elements(self%p, type, size(nodes, 2, rc_long), nodes, 1_rc_int, t), &
      self%context, 'rc_contact%add_frame_elements', stat, errmsg)
  end subroutine

  subroutine add_frame_elements_int64(self, type, nodes, tag, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    integer(rc_int), intent(in) :: type
    integer(c_int64_t), intent(in) :: nodes(:, :)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%add_frame_elements_int32(type, narrow_ids(nodes), tag, stat, errmsg)
  end subroutine

  !> The faces of body 1 or 2 that carry a tag become the frame.
  subroutine frame_from_body(self, which, tag, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    integer, intent(in) :: which, tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_frame_from_body(self%p, int(which, rc_int), int(tag, rc_int)), self%context, &
      'rc_contact%frame_from_body', stat, errmsg)
  end subroutine

  !> Where body 1 or 2 stands: x = matmul(rotation, x_body) + translation.
  subroutine set_pose(self, which, rotation, translation, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    integer, intent(in) :: which
    real(rc_real), intent(in) :: rotation(3, 3), translation(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    ! C wants it by rows
    call finish(rollcon_contact_set_pose(self%p, int(which, rc_int), transpose(rotation), translation), self%context, &
      'rc_contact%set_pose', stat, errmsg)
  end subroutine

  !> Origin of the local axes, rolling direction and outward normal of body 1.
  subroutine set_axes(self, origin, rolling, normal, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in) :: origin(3), rolling(3), normal(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_axes(self%p, origin, rolling, normal), self%context, 'rc_contact%set_axes', stat, errmsg)
  end subroutine

  !> Gap of the undeformed bodies at each node.
  subroutine set_gap(self, gap, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: gap(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_gap(self%p, size(gap, kind=rc_long), gap), self%context, &
      'rc_contact%set_gap', stat, errmsg)
  end subroutine

  !> Gap a x**2 + b y**2 + c x y in the local axes.
  subroutine set_gap_quadratic(self, a, b, c, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in) :: a, b, c
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_gap_quadratic(self%p, a, b, c), self%context, &
      'rc_contact%set_gap_quadratic', stat, errmsg)
  end subroutine

  !> Rolling speed > 0.
  subroutine set_rolling(self, speed, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in) :: speed
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_rolling(self%p, speed), self%context, 'rc_contact%set_rolling', stat, errmsg)
  end subroutine

  !> Creepages and spin of body 1 relative to body 2: the same as three calls of prescribe by motion.
  subroutine set_creep(self, longitudinal, lateral, spin, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in) :: longitudinal, lateral, spin
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_creep(self%p, longitudinal, lateral, spin), self%context, &
      'rc_contact%set_creep', stat, errmsg)
  end subroutine

  !> Rigid slip velocity at each node, slip(2,n), added to creepages and spin; n = 0 removes it.
  subroutine set_creep_field(self, slip, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: slip(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(slip, 1) /= 2) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_contact%set_creep_field', stat, errmsg, &
        'the first extent of slip must be 2')
      return
    end if
    call finish(rollcon_contact_set_creep_field(self%p, size(slip, 2, rc_long), slip), self%context, &
      'rc_contact%set_creep_field', stat, errmsg)
  end subroutine

  !> One direction (ROLLCON_LONGITUDINAL, ...) by force or by motion (ROLLCON_BY_FORCE, ROLLCON_BY_MOTION).
  subroutine prescribe(self, direction, how, value, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    integer(rc_int), intent(in) :: direction, how
    real(rc_real), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_prescribe(self%p, direction, how, value), self%context, 'rc_contact%prescribe', stat, errmsg)
  end subroutine

  !> Friction law and its parameters: 'coulomb', [mu].
  subroutine set_friction(self, law, parameters, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    character(len=*), intent(in) :: law
    real(rc_real), intent(in), contiguous :: parameters(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_friction(self%p, c_text(law), size(parameters, kind=rc_int), parameters), self%context, &
      'rc_contact%set_friction', stat, errmsg)
  end subroutine

  !> Coefficient of friction at each node; no entries: remove the field.
  subroutine set_friction_field(self, mu, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: mu(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_friction_field(self%p, size(mu, kind=rc_long), mu), self%context, &
      'rc_contact%set_friction_field', stat, errmsg)
  end subroutine

  !> Solver settings by name; rc_option_info lists them.
  subroutine set_option_int32(self, name, value, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_int(self%p, c_text(name), int(value, rc_long)), self%context, &
      'rc_contact%set', stat, errmsg)
  end subroutine

  subroutine set_option_int64(self, name, value, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_int(self%p, c_text(name), value), self%context, 'rc_contact%set', stat, errmsg)
  end subroutine

  subroutine set_option_real(self, name, value, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_real(self%p, c_text(name), value), self%context, 'rc_contact%set', stat, errmsg)
  end subroutine

  subroutine set_option_text(self, name, value, stat, errmsg)
    class(rc_scene), intent(inout) :: self
    character(len=*), intent(in) :: name
    character(len=*), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_set_str(self%p, c_text(name), c_text(value)), self%context, 'rc_contact%set', stat, errmsg)
  end subroutine

  subroutine get_option_int32(self, name, value, stat, errmsg)
    class(rc_scene), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: wide
    wide = 0
    call finish(rollcon_contact_get_int(self%p, c_text(name), wide), self%context, 'rc_contact%get', stat, errmsg)
    value = int(wide, c_int32_t)
  end subroutine

  subroutine get_option_int64(self, name, value, stat, errmsg)
    class(rc_scene), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_contact_get_int(self%p, c_text(name), value), self%context, 'rc_contact%get', stat, errmsg)
  end subroutine

  subroutine get_option_real(self, name, value, stat, errmsg)
    class(rc_scene), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_contact_get_real(self%p, c_text(name), value), self%context, 'rc_contact%get', stat, errmsg)
  end subroutine

  subroutine get_option_text(self, name, value, stat, errmsg)
    class(rc_scene), intent(in) :: self
    character(len=*), intent(in) :: name
    character(len=:), allocatable, intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable :: buffer(:)
    integer(rc_long) :: needed
    integer(rc_int) :: status
    allocate (buffer(usual_text))
    buffer(1) = c_null_char
    needed = 0
    status = rollcon_contact_get_str(self%p, c_text(name), usual_text, buffer, needed)
    value = f_text(buffer)
    call finish(status, self%context, 'rc_contact%get', stat, errmsg)
  end subroutine

end module rollcon_scene
