!> Bodies: settings, preparation and results, added to what the caller gives (module rollcon_body_inputs).
module rollcon_body
  use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t
  use rollcon_c
  use rollcon_support
  use rollcon_body_inputs
  implicit none
  private
  public :: rc_body

  type, extends(rc_body_inputs) :: rc_body
  contains
    procedure, private :: set_option_int32
    procedure, private :: set_option_int64
    procedure, private :: set_option_real
    generic :: set => set_option_int32, set_option_int64, set_option_real
    procedure, private :: get_option_int32
    procedure, private :: get_option_int64
    procedure, private :: get_option_real
    generic :: get => get_option_int32, get_option_int64, get_option_real
    procedure :: prepare
    procedure :: save => save_to
    procedure :: get_kind
    procedure :: get_size
    procedure :: get_displacements
    procedure :: get_reaction
    procedure :: get_stat
  end type

contains

  !> Settings by name; rc_body_option_info lists them.
  subroutine set_option_int32(self, name, value, stat, errmsg)
    class(rc_body), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_int(self%handle(), c_text(name), int(value, rc_long)), self%owner(), 'rc_body%set', stat, errmsg)
  end subroutine

  subroutine set_option_int64(self, name, value, stat, errmsg)
    class(rc_body), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_int(self%handle(), c_text(name), value), self%owner(), 'rc_body%set', stat, errmsg)
  end subroutine

  subroutine set_option_real(self, name, value, stat, errmsg)
    class(rc_body), intent(inout) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_real(self%handle(), c_text(name), value), self%owner(), 'rc_body%set', stat, errmsg)
  end subroutine

  subroutine get_option_int32(self, name, value, stat, errmsg)
    class(rc_body), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: wide
    wide = 0
    call finish(rollcon_body_get_int(self%handle(), c_text(name), wide), self%owner(), 'rc_body%get', stat, errmsg)
    value = int(wide, c_int32_t)
  end subroutine

  subroutine get_option_int64(self, name, value, stat, errmsg)
    class(rc_body), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_body_get_int(self%handle(), c_text(name), value), self%owner(), 'rc_body%get', stat, errmsg)
  end subroutine

  subroutine get_option_real(self, name, value, stat, errmsg)
    class(rc_body), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_body_get_real(self%handle(), c_text(name), value), self%owner(), 'rc_body%get', stat, errmsg)
  end subroutine

  !> Checks that the body is complete, assembles and factorises its equations and freezes it; a solve does it if nobody did.
  subroutine prepare(self, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_prepare(self%handle()), self%owner(), 'rc_body%prepare', stat, errmsg)
  end subroutine

  !> Writes the body, prepared if it was not, to a file; `load` makes a prepared body of it.
  subroutine save_to(self, path, stat, errmsg)
    class(rc_body), intent(inout) :: self
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_save(self%handle(), c_text(path)), self%owner(), 'rc_body%save', stat, errmsg)
  end subroutine

  subroutine get_kind(self, kind, stat, errmsg)
    class(rc_body), intent(in) :: self
    integer(rc_int), intent(out) :: kind
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    kind = 0
    call finish(rollcon_body_get_kind(self%handle(), kind), self%owner(), 'rc_body%get_kind', stat, errmsg)
  end subroutine

  !> Nodes and elements of the mesh.
  subroutine get_size(self, nodes, elements, stat, errmsg)
    class(rc_body), intent(in) :: self
    integer, intent(out) :: nodes
    integer, intent(out), optional :: elements
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: n, m
    n = 0
    m = 0
    call finish(rollcon_body_get_size(self%handle(), n, m), self%owner(), 'rc_body%get_size', stat, errmsg)
    nodes = int(n)
    if (present(elements)) elements = int(m)
  end subroutine

  !> Displacements u(3,n) of a prepared body under its own loads and given displacements, no contact acting.
  subroutine get_displacements(self, u, stat, errmsg)
    class(rc_body), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    integer(rc_long) :: n, m
    n = 0
    m = 0
    status = rollcon_body_get_size(self%handle(), n, m)
    allocate (u(3, n))
    u = 0
    if (status == ROLLCON_OK) status = rollcon_body_get_displacements(self%handle(), n, u)
    call finish(status, self%owner(), 'rc_body%get_displacements', stat, errmsg)
  end subroutine

  !> Force of the supports on a prepared body and its moment about the origin, no contact acting.
  subroutine get_reaction(self, force, moment, stat, errmsg)
    class(rc_body), intent(in) :: self
    real(rc_real), intent(out) :: force(3), moment(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    force = 0
    moment = 0
    call finish(rollcon_body_get_reaction(self%handle(), force, moment), self%owner(), 'rc_body%get_reaction', stat, errmsg)
  end subroutine

  !> Counters and timings of a prepared body by name; rc_body_stat_name lists them.
  subroutine get_stat(self, name, value, stat, errmsg)
    class(rc_body), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_body_get_stat(self%handle(), c_text(name), value), self%owner(), 'rc_body%get_stat', stat, errmsg)
  end subroutine

end module rollcon_body
