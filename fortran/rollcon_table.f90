!> Provides what the generated type rc_table_plain, a creep-force table, does not have.
module rollcon_table
  use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_null_funptr, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_contact
  use rollcon_context
  use rollcon_table_plain
  implicit none
  private
  public :: rc_table

  type, extends(rc_table_plain) :: rc_table
  contains
    procedure :: load
    procedure :: standard
    procedure, private :: take
    procedure :: set_progress
    procedure :: get_samples
    procedure :: evaluate
    procedure :: evaluate_contact
  end type

contains

  !> Loads the table of a file that rc_table%save wrote.
  subroutine load(self, context, path, stat, errmsg)
    class(rc_table), intent(inout) :: self
    type(rc_context), intent(in) :: context
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    call self%free()
    p = c_null_ptr
    status = rollcon_table_load(context%handle(), c_text(path), p)
    if (status == ROLLCON_OK) call self%take(p)
    call finish(status, context%handle(), 'rc_table%load', stat, errmsg)
  end subroutine

  !> Makes the table that comes with the library.
  subroutine standard(self, context, stat, errmsg)
    class(rc_table), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    call self%free()
    p = c_null_ptr
    status = rollcon_table_standard(context%handle(), p)
    if (status == ROLLCON_OK) call self%take(p)
    call finish(status, context%handle(), 'rc_table%standard', stat, errmsg)
  end subroutine

  !> Takes a reference that was the caller's.
  subroutine take(self, p)
    class(rc_table), intent(inout) :: self
    type(c_ptr), intent(in) :: p
    integer :: kept
    call self%from_id(int(rollcon_id_of(p)), kept)
    call rollcon_table_release(p)
  end subroutine

  !> Sets `progress`, a bind(C) module procedure that is called about ten times a second; absent: no calls. A result
  !> other than 0 cancels.
  subroutine set_progress(self, progress, user, stat, errmsg)
    class(rc_table), intent(inout) :: self
    procedure(rollcon_progress_fn), optional :: progress
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_funptr) :: f
    type(c_ptr) :: u
    f = c_null_funptr
    u = c_null_ptr
    if (present(progress)) f = c_funloc(progress)
    if (present(user)) u = user
    call finish(rollcon_table_set_progress(self%handle(), f, u), self%handle(), 'rc_table%set_progress', stat, errmsg)
  end subroutine

  !> Returns all samples; NaN where one is not solved yet.
  subroutine get_samples(self, samples, stat, errmsg)
    class(rc_table), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: samples(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: needed
    integer(rc_int) :: status
    real(rc_real) :: none(1)
    needed = 0
    status = rollcon_table_get_samples(self%handle(), 0_rc_long, none, needed)
    allocate (samples(needed))
    if (status == ROLLCON_OK .and. needed > 0) &
      status = rollcon_table_get_samples(self%handle(), needed, samples, needed)
    call finish(status, self%handle(), 'rc_table%get_samples', stat, errmsg)
  end subroutine

  !> Returns forces and moments results(3, n) of inputs(9, n) and, if wanted, derivatives(9, 3, n) of each result by
  !> each input.
  subroutine evaluate(self, inputs, results, derivatives, stat, errmsg)
    class(rc_table), intent(in) :: self
    real(rc_real), intent(in), contiguous :: inputs(:, :)
    real(rc_real), intent(out), contiguous :: results(:, :)
    real(rc_real), intent(out), contiguous, optional :: derivatives(:, :, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    integer(rc_long) :: n
    n = size(inputs, 2, rc_long)
    if (size(inputs, 1) /= 9 .or. size(results, 1) /= 3 .or. size(results, 2) /= n) then
      status = rollcon_report(self%handle(), ROLLCON_ERR_ARGUMENT, &
        c_text('rc_table%evaluate: inputs must be (9, n) and results (3, n)'))
    else if (.not. present(derivatives)) then
      status = rollcon_table_evaluate(self%handle(), n, inputs, results)
    else if (size(derivatives, 1) /= 9 .or. size(derivatives, 2) /= 3 .or. size(derivatives, 3) /= n) then
      status = rollcon_report(self%handle(), ROLLCON_ERR_ARGUMENT, &
        c_text('rc_table%evaluate: derivatives must be (9, 3, n)'))
    else
      status = rollcon_table_evaluate_derivatives(self%handle(), n, inputs, results, derivatives)
    end if
    call finish(status, self%handle(), 'rc_table%evaluate', stat, errmsg)
  end subroutine

  !> Returns forces along t1 and t2 and moment about n, results(3), of a solved contact, by the Hertzian contact that
  !> stands for it. If friction is absent, it is the contact's own.
  subroutine evaluate_contact(self, contact, results, friction, stat, errmsg)
    class(rc_table), intent(in) :: self
    type(rc_contact), intent(in) :: contact
    real(rc_real), intent(out) :: results(3)
    real(rc_real), intent(in), optional :: friction
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: mu
    mu = -1
    if (present(friction)) mu = friction
    call finish(rollcon_table_evaluate_contact(self%handle(), contact%handle(), mu, results), self%handle(), &
      'rc_table%evaluate_contact', stat, errmsg)
  end subroutine

end module rollcon_table
