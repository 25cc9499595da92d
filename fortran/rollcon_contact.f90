!> A pair of bodies in rolling contact: the solve and its results, on top of what rc_scene takes from the caller.
!>
!> A variable of this type is one reference to the object, as for `rc_context`. Vectors are xyz by columns: t(3,n). Every
!> call takes `stat` (absent: a failure prints its message and stops; positive values are results with a caveat) and
!> `errmsg` (set on failure, cut or padded).
module rollcon_contact
  use, intrinsic :: iso_c_binding, only: c_char, c_funloc, c_funptr, c_loc, c_null_char, c_null_funptr, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_scene
  implicit none
  private
  public :: rc_contact

  type, extends(rc_scene) :: rc_contact
  contains
    procedure :: set_progress
    procedure :: request_cancel
    procedure :: solve
    procedure :: solve_many
    procedure :: reset
    procedure :: get_size
    procedure :: get_tractions
    procedure, private :: get_field_vectors
    procedure, private :: get_field_scalars
    generic :: get_field => get_field_vectors, get_field_scalars
    procedure :: get_status
    procedure :: get_resultant
    procedure :: get_motion
    procedure :: get_sensitivity
    procedure :: get_displacements_at
    procedure :: get_stat
    procedure :: get_history
    procedure :: get_error_function
    procedure :: get_plan
    procedure :: write_vtu
  end type

contains

  !> `progress`, a bind(C) module procedure, is called in every iteration; absent: no calls. It reads the event with
  !> rc_event_int and rc_event_real; a result other than 0 cancels the solve.
  subroutine set_progress(self, progress, user, stat, errmsg)
    class(rc_contact), intent(inout) :: self
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
    call finish(rollcon_contact_set_progress(self%handle(), f, u), self%owner(), 'rc_contact%set_progress', stat, errmsg)
  end subroutine

  !> Makes the running solve return ROLLCON_CANCELLED; from any thread.
  subroutine request_cancel(self, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_request_cancel(self%handle()), self%owner(), 'rc_contact%request_cancel', stat, errmsg)
  end subroutine

  !> Solves; starts from the last solution if there is one.
  subroutine solve(self, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_solve(self%handle()), self%owner(), 'rc_contact%solve', stat, errmsg)
  end subroutine

  !> Solves the scene for many load cases on the threads of the context. values(p,i) replaces in case i what is prescribed
  !> in the direction parameters(p) (ROLLCON_LONGITUDINAL, ...), or is a factor on the friction coefficients
  !> (ROLLCON_FRICTION). Only the results that are present are computed: status(n), force(3,n), moment(3,n), approach(n),
  !> creep(3,n), derivatives(10,size(parameters),n) of force, moment, approach and creep, statistics(m,n) of the m `names`
  !> (separated by blanks), tractions(3,nodes,n); NaN where a case has none.
  subroutine solve_many(self, parameters, values, status, force, moment, approach, creep, derivatives, names, statistics, &
      tractions, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    integer(rc_int), intent(in), contiguous :: parameters(:)
    real(rc_real), intent(in), contiguous :: values(:, :)
    integer(rc_int), allocatable, target, intent(out), optional :: status(:)
    real(rc_real), allocatable, target, intent(out), optional :: force(:, :), moment(:, :), approach(:), creep(:, :)
    real(rc_real), allocatable, target, intent(out), optional :: derivatives(:, :, :), statistics(:, :), tractions(:, :, :)
    character(len=*), intent(in), optional :: names
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: a(8)
    integer(rc_long) :: n, nodes, elements
    integer(rc_int) :: rc
    n = size(values, 2, rc_long)
    if (size(values, 1) /= size(parameters)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%owner(), 'rc_contact%solve_many', stat, errmsg, &
        'the first extent of values must be the number of parameters')
      return
    end if
    if (present(statistics) .neqv. present(names)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%owner(), 'rc_contact%solve_many', stat, errmsg, &
        'names and statistics must come together')
      return
    end if
    nodes = 0
    elements = 0
    rc = ROLLCON_OK
    if (present(tractions)) rc = rollcon_contact_get_size(self%handle(), nodes, elements)
    a = c_null_ptr
    if (present(status)) then
      allocate (status(n))
      status = 0
      if (n > 0) a(1) = c_loc(status(1))
    end if
    call matrix(force, 3_rc_long, n, a(2))
    call matrix(moment, 3_rc_long, n, a(3))
    if (present(approach)) then
      allocate (approach(n))
      approach = 0
      if (n > 0) a(4) = c_loc(approach(1))
    end if
    call matrix(creep, 3_rc_long, n, a(5))
    call cube(derivatives, 10_rc_long, size(parameters, kind=rc_long), n, a(6))
    if (present(names)) call matrix(statistics, words(names), n, a(7))
    call cube(tractions, 3_rc_long, nodes, n, a(8))
    if (rc == ROLLCON_OK) then
      if (present(names) .and. n > 0) then
        rc = rollcon_contact_solve_many(self%handle(), size(parameters, kind=rc_int), parameters, n, values, c_text(names), &
          nodes, a(1), a(2), a(3), a(4), a(5), a(6), a(7), a(8))
      else
        rc = rollcon_contact_solve_many(self%handle(), size(parameters, kind=rc_int), parameters, n, values, c_text(''), &
          nodes, a(1), a(2), a(3), a(4), a(5), a(6), a(7), a(8))
      end if
    end if
    call finish(rc, self%owner(), 'rc_contact%solve_many', stat, errmsg)
  end subroutine

  !> Zeros, and where they are, if the array is wanted.
  subroutine matrix(array, rows, columns, address)
    real(rc_real), allocatable, target, intent(inout), optional :: array(:, :)
    integer(rc_long), intent(in) :: rows, columns
    type(c_ptr), intent(inout) :: address
    if (.not. present(array)) return
    allocate (array(rows, columns))
    array = 0
    if (size(array, kind=rc_long) > 0) address = c_loc(array(1, 1))
  end subroutine

  subroutine cube(array, rows, columns, layers, address)
    real(rc_real), allocatable, target, intent(inout), optional :: array(:, :, :)
    integer(rc_long), intent(in) :: rows, columns, layers
    type(c_ptr), intent(inout) :: address
    if (.not. present(array)) return
    allocate (array(rows, columns, layers))
    array = 0
    if (size(array, kind=rc_long) > 0) address = c_loc(array(1, 1, 1))
  end subroutine

  !> Number of words, separated by blanks.
  pure integer(rc_long) function words(text)
    character(len=*), intent(in) :: text
    logical :: inside
    integer :: i
    words = 0
    inside = .false.
    do i = 1, len(text)
      if (text(i:i) /= ' ' .and. .not. inside) words = words + 1
      inside = text(i:i) /= ' '
    end do
  end function

  !> Forgets the last solution; keeps the scene.
  subroutine reset(self, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_reset(self%handle()), self%owner(), 'rc_contact%reset', stat, errmsg)
  end subroutine

  !> Nodes and elements of the frame.
  subroutine get_size(self, nodes, elements, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer, intent(out) :: nodes
    integer, intent(out), optional :: elements
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: n, m
    n = 0
    m = 0
    call finish(rollcon_contact_get_size(self%handle(), n, m), self%owner(), 'rc_contact%get_size', stat, errmsg)
    nodes = int(n)
    if (present(elements)) elements = int(m)
  end subroutine

  !> Tractions on body 1, t(3,n), in local axes if `axes` is absent.
  subroutine get_tractions(self, t, axes, stat, errmsg)
    class(rc_contact), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: t(:, :)
    integer(rc_int), intent(in), optional :: axes
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    integer(rc_long) :: n, m
    n = 0
    m = 0
    status = rollcon_contact_get_size(self%handle(), n, m)
    allocate (t(3, n))
    t = 0
    if (status == ROLLCON_OK) status = rollcon_contact_get_tractions(self%handle(), axes_or_local(axes), n, t)
    call finish(status, self%owner(), 'rc_contact%get_tractions', stat, errmsg)
  end subroutine

  !> Values of a field (ROLLCON_FIELD_POINT, ...) at the nodes: v(components,n), or v(n) for scalar fields.
  subroutine get_field_vectors(self, field, v, axes, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: field
    real(rc_real), allocatable, intent(out) :: v(:, :)
    integer(rc_int), intent(in), optional :: axes
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real), allocatable :: flat(:)
    integer(rc_long) :: n
    integer(rc_int) :: status
    call read_field(self, field, axes_or_local(axes), flat, n, status)
    v = reshape(flat, [size(flat, kind=rc_long)/max(n, 1_rc_long), n])
    call finish(status, self%owner(), 'rc_contact%get_field', stat, errmsg)
  end subroutine

  subroutine get_field_scalars(self, field, v, axes, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: field
    real(rc_real), allocatable, intent(out) :: v(:)
    integer(rc_int), intent(in), optional :: axes
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: n
    integer(rc_int) :: status
    call read_field(self, field, axes_or_local(axes), v, n, status)
    call finish(status, self%owner(), 'rc_contact%get_field', stat, errmsg)
  end subroutine

  !> ROLLCON_OPEN, ROLLCON_STICK, ROLLCON_SLIP or ROLLCON_EXCLUDED at each node.
  subroutine get_status(self, status, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), allocatable, intent(out) :: status(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: s
    integer(rc_long) :: n, m
    n = 0
    m = 0
    s = rollcon_contact_get_size(self%handle(), n, m)
    allocate (status(n))
    status = 0
    if (s == ROLLCON_OK) s = rollcon_contact_get_status(self%handle(), n, status)
    call finish(s, self%owner(), 'rc_contact%get_status', stat, errmsg)
  end subroutine

  !> Force and moment on body 1 about the axes' origin, in local axes if `axes` is absent.
  subroutine get_resultant(self, force, moment, axes, stat, errmsg)
    class(rc_contact), intent(in) :: self
    real(rc_real), intent(out) :: force(3), moment(3)
    integer(rc_int), intent(in), optional :: axes
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    force = 0
    moment = 0
    call finish(rollcon_contact_get_resultant(self%handle(), axes_or_local(axes), force, moment), self%owner(), &
      'rc_contact%get_resultant', stat, errmsg)
  end subroutine

  !> Approach, and creepages and spin in creep(3): given or found.
  subroutine get_motion(self, approach, creep, stat, errmsg)
    class(rc_contact), intent(in) :: self
    real(rc_real), intent(out) :: approach, creep(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    approach = 0
    creep = 0
    call finish(rollcon_contact_get_motion(self%handle(), approach, creep), self%owner(), 'rc_contact%get_motion', stat, errmsg)
  end subroutine

  !> Derivatives of local force and moment, approach and creepages by the value prescribed in a direction
  !> (ROLLCON_LONGITUDINAL, ...), or by a factor on every friction coefficient (ROLLCON_FRICTION).
  subroutine get_sensitivity(self, parameter, force, moment, approach, creep, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: parameter
    real(rc_real), intent(out) :: force(3), moment(3), approach, creep(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    force = 0
    moment = 0
    approach = 0
    creep = 0
    call finish(rollcon_contact_get_sensitivity(self%handle(), parameter, force, moment, approach, creep), self%owner(), &
      'rc_contact%get_sensitivity', stat, errmsg)
  end subroutine

  !> Displacements u(3,n) of body 1 or 2 at points xy(2,n) of the contact surface, in local axes.
  subroutine get_displacements_at(self, body, xy, u, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer, intent(in) :: body
    real(rc_real), intent(in), contiguous :: xy(:, :)
    real(rc_real), allocatable, intent(out) :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(xy, 1) /= 2) then
      call finish(ROLLCON_ERR_ARGUMENT, self%owner(), 'rc_contact%get_displacements_at', stat, errmsg, &
        'the first extent of xy must be 2')
      return
    end if
    allocate (u(3, size(xy, 2)))
    u = 0
    call finish(rollcon_contact_get_displacements_at(self%handle(), int(body, rc_int), size(xy, 2, rc_long), xy, u), self%owner(), &
      'rc_contact%get_displacements_at', stat, errmsg)
  end subroutine

  !> Counters and timings by name; rc_stat_name lists them.
  subroutine get_stat(self, name, value, stat, errmsg)
    class(rc_contact), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_contact_get_stat(self%handle(), c_text(name), value), self%owner(), 'rc_contact%get_stat', stat, errmsg)
  end subroutine

  !> rows(8,n): phase, iteration, normal residual, tangential residual, step length, nodes in contact, nodes in slip, seconds.
  subroutine get_history(self, rows, stat, errmsg)
    class(rc_contact), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: rows(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long), parameter :: usual_rows = 128
    integer(rc_long) :: n
    integer(rc_int) :: status
    n = 0
    allocate (rows(8, usual_rows))
    status = rollcon_contact_get_history(self%handle(), usual_rows, rows, n)
    if (status == ROLLCON_ERR_CAPACITY) then
      deallocate (rows)
      allocate (rows(8, n))
      status = rollcon_contact_get_history(self%handle(), size(rows, 2, rc_long), rows, n)
    end if
    if (status /= ROLLCON_OK) n = 0
    rows = rows(:, 1:n)
    call finish(status, self%owner(), 'rc_contact%get_history', stat, errmsg)
  end subroutine

  !> Error function of every row of get_history, and the seconds since the solve began.
  subroutine get_error_function(self, psi, seconds, stat, errmsg)
    class(rc_contact), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: psi(:)
    real(rc_real), allocatable, intent(out), optional :: seconds(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long), parameter :: usual_rows = 128
    real(rc_real), allocatable :: when(:)
    integer(rc_long) :: n
    integer(rc_int) :: status
    n = 0
    allocate (psi(usual_rows), when(usual_rows))
    status = rollcon_contact_get_error_function(self%handle(), usual_rows, psi, when, n)
    if (status == ROLLCON_ERR_CAPACITY) then
      deallocate (psi, when)
      allocate (psi(n), when(n))
      status = rollcon_contact_get_error_function(self%handle(), size(psi, 1, rc_long), psi, when, n)
    end if
    if (status /= ROLLCON_OK) n = 0
    psi = psi(1:n)
    if (present(seconds)) seconds = when(1:n)
    call finish(status, self%owner(), 'rc_contact%get_error_function', stat, errmsg)
  end subroutine

  !> What the solver left out for this scene, and why.
  subroutine get_plan(self, text, stat, errmsg)
    class(rc_contact), intent(in) :: self
    character(len=:), allocatable, intent(out) :: text
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable :: buffer(:)
    integer(rc_long) :: needed
    integer(rc_int) :: status
    allocate (buffer(usual_text))
    buffer(1) = c_null_char
    needed = 0
    status = rollcon_contact_get_plan(self%handle(), usual_text, buffer, needed)
    if (status == ROLLCON_ERR_CAPACITY) then
      deallocate (buffer)
      allocate (buffer(needed))
      status = rollcon_contact_get_plan(self%handle(), size(buffer, kind=rc_long), buffer, needed)
    end if
    text = f_text(buffer)
    call finish(status, self%owner(), 'rc_contact%get_plan', stat, errmsg)
  end subroutine

  !> Frame and results as a VTU file.
  subroutine write_vtu(self, path, stat, errmsg)
    class(rc_contact), intent(in) :: self
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_write(self%handle(), c_text(path)), self%owner(), 'rc_contact%write_vtu', stat, errmsg)
  end subroutine

  pure integer(rc_int) function axes_or_local(axes)
    integer(rc_int), intent(in), optional :: axes
    axes_or_local = ROLLCON_LOCAL
    if (present(axes)) axes_or_local = axes
  end function

  !> All values of a field one after the other, and the number of nodes n.
  subroutine read_field(self, field, axes, flat, n, status)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: field, axes
    real(rc_real), allocatable, intent(out) :: flat(:)
    integer(rc_long), intent(out) :: n
    integer(rc_int), intent(out) :: status
    integer(rc_long) :: m, values
    n = 0
    m = 0
    values = 0
    status = rollcon_contact_get_size(self%handle(), n, m)
    allocate (flat(3*n))
    if (status == ROLLCON_OK) status = rollcon_contact_get_field(self%handle(), field, axes, 3*n, flat, values)
    if (status < 0) values = 0
    flat = flat(1:values)
  end subroutine

end module rollcon_contact
