!> Bodies. A variable of this type is one reference to the object, as for `rc_context`.
module rollcon_body
  use, intrinsic :: iso_c_binding, only: c_associated, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_context
  implicit none
  private
  public :: rc_body

  type :: rc_body
    private
    type(c_ptr) :: p = c_null_ptr
    type(c_ptr) :: context = c_null_ptr  ! a reference of its own, for the texts of failures
  contains
    procedure :: create
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
    procedure :: set_elastic
    procedure :: prepare
    procedure :: get_kind
    procedure, private :: assign
    generic :: assignment(=) => assign
    final :: finalize
  end type

contains

  !> kind: ROLLCON_BODY_HALFSPACE, ROLLCON_BODY_RIGID, ...
  subroutine create(self, context, kind, stat, errmsg)
    class(rc_body), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer(rc_int), intent(in) :: kind
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    type(c_ptr) :: ctx
    call self%free()
    ctx = context%handle()
    status = rollcon_body_create(ctx, kind, self%p)
    if (status /= ROLLCON_OK) then
      self%p = c_null_ptr
    else if (rollcon_context_retain(ctx) == ROLLCON_OK) then
      self%context = ctx
    end if
    call finish(status, ctx, 'rc_body%create', stat, errmsg)
  end subroutine

  !> Gives the reference back; the object lives on while a contact or another variable uses it.
  impure elemental subroutine release(self)
    class(rc_body), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_body_release(self%p)
    if (c_associated(self%context)) call rollcon_context_release(self%context)
    self%p = c_null_ptr
    self%context = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_body), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_body), intent(inout) :: self
    class(rc_body), intent(in) :: other
    type(c_ptr) :: p, context
    p = other%p
    context = other%context
    if (c_associated(p)) then
      if (rollcon_body_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    if (c_associated(context)) then
      if (rollcon_context_retain(context) /= ROLLCON_OK) context = c_null_ptr
    end if
    call self%free()
    self%p = p
    self%context = context
  end subroutine

  !> Adds a reference to the body that `id` names; texts of failures come from `context`.
  subroutine from_id(self, context, id, stat, errmsg)
    class(rc_body), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p, ctx
    integer(rc_int) :: status
    p = rollcon_body_from_id(int(id, rc_int))
    ctx = context%handle()
    status = rollcon_body_retain(p)
    call self%free()
    if (status == ROLLCON_OK) then
      self%p = p
      if (c_associated(ctx)) then
        if (rollcon_context_retain(ctx) == ROLLCON_OK) self%context = ctx
      end if
    end if
    call finish(status, c_null_ptr, 'rc_body%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_body), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_body), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> Young's modulus > 0 and Poisson's ratio in (-1, 0.5] of the elements with `tag` (0, all of a half-space, if absent).
  subroutine set_elastic(self, young, poisson, tag, stat, errmsg)
    class(rc_body), intent(inout) :: self
    real(rc_real), intent(in) :: young, poisson
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: t
    t = 0
    if (present(tag)) t = int(tag, rc_int)
    call finish(rollcon_body_set_elastic(self%p, t, young, poisson), self%context, 'rc_body%set_elastic', stat, errmsg)
  end subroutine

  !> Checks that the body is complete and freezes it; a solve does it if nobody did.
  subroutine prepare(self, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_prepare(self%p), self%context, 'rc_body%prepare', stat, errmsg)
  end subroutine

  subroutine get_kind(self, kind, stat, errmsg)
    class(rc_body), intent(in) :: self
    integer(rc_int), intent(out) :: kind
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    kind = 0
    call finish(rollcon_body_get_kind(self%p, kind), self%context, 'rc_body%get_kind', stat, errmsg)
  end subroutine

end module rollcon_body
