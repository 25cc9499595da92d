!> Provides the context, owner of log sink, thread budget and the text of the last failure.
!>
!> A variable of this type is one reference to the object: assignment adds a reference, `free` and the end of the
!> variable's life give it back. Every call takes `stat` (absent: a failure prints its message and stops) and `errmsg`.
module rollcon_context
  use, intrinsic :: iso_c_binding, only: c_associated, c_funloc, c_funptr, c_null_funptr, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  implicit none
  private
  public :: rc_context

  type :: rc_context
    private
    type(c_ptr) :: p = c_null_ptr
  contains
    procedure :: create
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
    procedure :: set_log
    procedure :: set_threads
    procedure :: set_communicator
    procedure :: set_latch
    procedure :: check
    procedure, private :: assign
    generic :: assignment(=) => assign
    final :: finalize
  end type

contains

  subroutine create(self, stat, errmsg)
    class(rc_context), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%free()
    call finish(rollcon_context_create(ROLLCON_HEADER_ABI, self%p), c_null_ptr, 'rc_context%create', stat, errmsg)
  end subroutine

  !> Gives the reference back; no harm if there is none.
  impure elemental subroutine release(self)
    class(rc_context), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_context_release(self%p)
    self%p = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_context), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_context), intent(inout) :: self
    class(rc_context), intent(in) :: other
    type(c_ptr) :: p
    p = other%p
    if (c_associated(p)) then
      if (rollcon_context_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    call self%free()
    self%p = p
  end subroutine

  !> Adds a reference to the context that `id` names, as counted by the FORTRAN 77 layer.
  subroutine from_id(self, id, stat, errmsg)
    class(rc_context), intent(inout) :: self
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    p = rollcon_context_from_id(int(id, rc_int))
    status = rollcon_context_retain(p)
    call self%free()
    if (status == ROLLCON_OK) self%p = p
    call finish(status, c_null_ptr, 'rc_context%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_context), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> Returns the C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_context), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> Sends messages up to `level` to `sink`, a bind(C) module procedure; absent: to nobody.
  subroutine set_log(self, level, sink, user, stat, errmsg)
    class(rc_context), intent(inout) :: self
    integer(rc_int), intent(in) :: level
    procedure(rollcon_log_fn), optional :: sink
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_funptr) :: f
    type(c_ptr) :: u
    f = c_null_funptr
    u = c_null_ptr
    if (present(sink)) f = c_funloc(sink)
    if (present(user)) u = user
    call finish(rollcon_context_set_log(self%p, level, f, u), self%p, 'rc_context%set_log', stat, errmsg)
  end subroutine

  !> Sets the threads per solve; 0 leaves the number to OpenMP.
  subroutine set_threads(self, n, stat, errmsg)
    class(rc_context), intent(inout) :: self
    integer, intent(in) :: n
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_context_set_threads(self%p, int(n, rc_int)), self%p, 'rc_context%set_threads', stat, errmsg)
  end subroutine

  !> Lets the ranks of an MPI communicator share work: all of them make the same calls with the same data.
  subroutine set_communicator(self, communicator, stat, errmsg)
    class(rc_context), intent(inout) :: self
    integer, intent(in) :: communicator
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_context_set_communicator(self%p, int(communicator, rc_int)), self%p, &
      'rc_context%set_communicator', stat, errmsg)
  end subroutine

  !> Sets the latch. 1: the first failure from here on is remembered, and later calls on this context, its bodies and
  !> contacts do nothing and return it; 0: off. Either forgets what was remembered.
  subroutine set_latch(self, on, stat, errmsg)
    class(rc_context), intent(inout) :: self
    integer, intent(in) :: on
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_context_set_latch(self%p, int(on, rc_int)), self%p, 'rc_context%set_latch', stat, errmsg)
  end subroutine

  !> Returns the first failure since the latch was set, or the first status > 0, or 0.
  subroutine check(self, stat, errmsg)
    class(rc_context), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_context_check(self%p), self%p, 'rc_context%check', stat, errmsg)
  end subroutine

end module rollcon_context
