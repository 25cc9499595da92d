!> Provides what the generated type rc_contact_plain, a pair of bodies in rolling contact, does not have.
!>
!> Vectors are xyz by columns: t(3,n); node numbers count from 1. Every call takes `stat` (absent: a failure prints its
!> message and stops; positive values are results with a caveat) and `errmsg` (set on failure, cut or padded).
module rollcon_contact
  use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_int32_t, c_int64_t, c_null_funptr, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_contact_plain
  implicit none
  private
  public :: rc_contact

  type, extends(rc_contact_plain) :: rc_contact
  contains
    procedure :: frame_nodes
    procedure :: frame_nodes_by_component
    procedure, private :: frame_add_elements_int32
    procedure, private :: frame_add_elements_int64
    generic :: frame_add_elements => frame_add_elements_int32, frame_add_elements_int64
    procedure :: set_progress
    procedure :: solve_many
    procedure :: get_tractions
    procedure, private :: get_field_vectors
    procedure, private :: get_field_scalars
    generic :: get_field => get_field_vectors, get_field_scalars
    procedure :: past_get
    procedure :: get_node_states
    procedure :: get_displacements_at
    procedure :: get_body_displacements
    procedure :: get_body_power
    procedure :: get_fields_at
    procedure :: write_body_vtu
    procedure :: get_wear
    procedure :: get_temperatures_at
    procedure :: get_history
  end type

contains

  !> Gives the nodes of the frame, x(3,n).
  subroutine frame_nodes(self, x, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(x, 1) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%frame_nodes', stat, errmsg, &
        'the first extent of x must be 3')
      return
    end if
    call finish(rollcon_contact_frame_nodes(self%handle(), size(x, 2, rc_long), x, 3_rc_long, 1_rc_long), self%handle(), &
      'rc_contact%frame_nodes', stat, errmsg)
  end subroutine

  !> Gives the nodes of the frame in the order x(n,3).
  subroutine frame_nodes_by_component(self, x, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: n
    if (size(x, 2) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%frame_nodes_by_component', stat, errmsg, &
        'the second extent of x must be 3')
      return
    end if
    n = size(x, 1, rc_long)
    call finish(rollcon_contact_frame_nodes(self%handle(), n, x, 1_rc_long, n), self%handle(), &
      'rc_contact%frame_nodes_by_component', stat, errmsg)
  end subroutine

  !> Adds elements of one type (ROLLCON_TRI3, ...): nodes(nodes per element, n), numbered from 1. The tag is 1 if
  !> absent.
  subroutine frame_add_elements_int32(self, type, nodes, tag, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    integer(rc_int), intent(in) :: type
    integer(c_int32_t), intent(in), contiguous :: nodes(:, :)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: t
    t = 1
    if (present(tag)) t = int(tag, rc_int)
    if (nodes_of(type) /= 0 .and. size(nodes, 1) /= nodes_of(type)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%frame_add_elements', stat, errmsg, &
        'the first extent of nodes must be the number of nodes of one element')
      return
    end if
    call finish(rollcon_contact_frame_add_elements(self%handle(), type, size(nodes, 2, rc_long), nodes, 1_rc_int, t), &
      self%handle(), 'rc_contact%frame_add_elements', stat, errmsg)
  end subroutine

  subroutine frame_add_elements_int64(self, type, nodes, tag, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    integer(rc_int), intent(in) :: type
    integer(c_int64_t), intent(in) :: nodes(:, :)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%frame_add_elements_int32(type, narrow_ids(nodes), tag, stat, errmsg)
  end subroutine

  !> Sets `progress`, a bind(C) module procedure that is called in every iteration; absent: no calls. It reads the event
  !> with rc_event_int and rc_event_real; a result other than 0 cancels the solve.
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
    call finish(rollcon_contact_set_progress(self%handle(), f, u), self%handle(), 'rc_contact%set_progress', stat, errmsg)
  end subroutine

  !> Solves the scene for many load cases on the threads of the context. values(p,i) replaces in case i what is
  !> prescribed in the direction parameters(p) (ROLLCON_LONGITUDINAL, ...), or is a factor on the friction coefficients
  !> (ROLLCON_FRICTION). Only the results that are present are computed: status(n), force(3,n), moment(3,n),
  !> approach(n), creep(3,n), derivatives(10,size(parameters),n) of force, moment, approach and creep, statistics(m,n)
  !> of the m `names` (separated by blanks), tractions(3,nodes,n); NaN where a case has none.
  subroutine solve_many(self, parameters, values, status, force, moment, approach, creep, derivatives, names, statistics, &
      tractions, stat, errmsg)
    class(rc_contact), intent(inout) :: self
    integer(rc_int), intent(in), contiguous :: parameters(:)
    real(rc_real), intent(in), contiguous :: values(:, :)
    integer(rc_int), allocatable, intent(out), optional :: status(:)
    real(rc_real), allocatable, intent(out), optional :: force(:, :), moment(:, :), approach(:), creep(:, :)
    real(rc_real), allocatable, intent(out), optional :: derivatives(:, :, :), statistics(:, :), tractions(:, :, :)
    character(len=*), intent(in), optional :: names
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(len=:), allocatable :: columns
    real(rc_real), allocatable :: table(:, :)
    integer(rc_int), allocatable :: state(:)
    integer(rc_long) :: n, width, nodes, elements, needed
    integer(rc_int) :: rc
    integer :: p, at
    if (size(values, 1) /= size(parameters)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%solve_many', stat, errmsg, &
        'the first extent of values must be the number of parameters')
      return
    end if
    if (present(statistics) .neqv. present(names)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%solve_many', stat, errmsg, &
        'names and statistics must come together')
      return
    end if
    n = size(values, 2, rc_long)
    p = size(parameters)
    nodes = 0
    elements = 0
    rc = ROLLCON_OK
    if (present(tractions)) rc = rollcon_contact_get_size(self%handle(), nodes, elements)
    columns = ''
    needed = 0
    width = 0
    call want(present(force), 'force', 3_rc_long)
    call want(present(moment), 'moment', 3_rc_long)
    call want(present(approach), 'approach', 1_rc_long)
    call want(present(creep), 'creep', 3_rc_long)
    call want(present(derivatives), 'derivatives', 10_rc_long*p)
    if (present(names)) call want(.true., names, words(names))
    call want(present(tractions), 'tractions', 3*nodes)
    allocate (table(max(width, 1_rc_long), max(n, 1_rc_long)), state(max(n, 1_rc_long)))
    table = 0
    state = 0
    if (rc == ROLLCON_OK) rc = rollcon_contact_solve_many(self%handle(), c_text(parameter_names(parameters)), n, values, &
      c_text(columns), width, table, needed, state)
    at = 0
    if (present(status)) status = state(1:n)
    if (present(force)) force = next(3)
    if (present(moment)) moment = next(3)
    if (present(approach)) approach = reshape(next(1), [n])
    if (present(creep)) creep = next(3)
    if (present(derivatives)) derivatives = reshape(next(10*p), [10_rc_long, int(p, rc_long), n])
    if (present(statistics)) statistics = next(int(words(names)))
    if (present(tractions)) tractions = reshape(next(int(3*nodes)), [3_rc_long, nodes, n])
    call finish(rc, self%handle(), 'rc_contact%solve_many', stat, errmsg)

  contains

    subroutine want(present, name, count)
      logical, intent(in) :: present
      character(len=*), intent(in) :: name
      integer(rc_long), intent(in) :: count
      if (.not. present) return
      columns = columns//' '//name
      width = width + count
    end subroutine

    function next(count) result(rows)
      integer, intent(in) :: count
      real(rc_real) :: rows(count, n)
      rows = table(at + 1:at + count, 1:n)
      at = at + count
    end function

  end subroutine

  !> Returns the names that the library knows parameters by.
  pure function parameter_names(parameters) result(text)
    integer(rc_int), intent(in) :: parameters(:)
    character(len=:), allocatable :: text
    character(len=16) :: digits
    integer :: i
    text = ''
    do i = 1, size(parameters)
      select case (parameters(i))
      case (ROLLCON_LONGITUDINAL)
        text = text//' longitudinal'
      case (ROLLCON_LATERAL)
        text = text//' lateral'
      case (ROLLCON_NORMAL)
        text = text//' normal'
      case (ROLLCON_SPIN)
        text = text//' spin'
      case (ROLLCON_FRICTION)
        text = text//' friction'
      case default
        write (digits, '(i0)') parameters(i)
        text = text//' '//trim(digits)
      end select
    end do
  end function

  !> Returns tractions on body 1, t(3,n), in local axes if `axes` is absent.
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
    call finish(status, self%handle(), 'rc_contact%get_tractions', stat, errmsg)
  end subroutine

  !> Returns values of a field (ROLLCON_FIELD_POINT, ...) at the nodes: v(components,n), or v(n) for scalar fields.
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
    call finish(status, self%handle(), 'rc_contact%get_field', stat, errmsg)
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
    call finish(status, self%handle(), 'rc_contact%get_field', stat, errmsg)
  end subroutine

  !> Returns what the next step in time starts from, for past_set: of another run, or of another contact of such
  !> bodies on the same frame.
  subroutine past_get(self, past, stat, errmsg)
    class(rc_contact), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: past(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: none(1)
    integer(rc_long) :: n
    integer(rc_int) :: status
    n = 0
    status = rollcon_contact_past_get(self%handle(), 0_rc_long, none, n)
    if (status == ROLLCON_ERR_CAPACITY) status = ROLLCON_OK
    if (status < 0) n = 0
    allocate (past(n))
    if (status == ROLLCON_OK) status = rollcon_contact_past_get(self%handle(), n, past, n)
    call finish(status, self%handle(), 'rc_contact%past_get', stat, errmsg)
  end subroutine

  !> Returns ROLLCON_OPEN, ROLLCON_STICK, ROLLCON_SLIP or ROLLCON_EXCLUDED at each node.
  subroutine get_node_states(self, status, stat, errmsg)
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
    if (s == ROLLCON_OK) s = rollcon_contact_get_node_states(self%handle(), n, status)
    call finish(s, self%handle(), 'rc_contact%get_node_states', stat, errmsg)
  end subroutine

  !> Returns displacements u(3,n) of body 1 or 2 at points xy(2,n) of the contact surface, in local axes.
  subroutine get_displacements_at(self, which, xy, u, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), intent(in), contiguous :: xy(:, :)
    real(rc_real), allocatable, intent(out) :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(xy, 1) /= 2) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%get_displacements_at', stat, errmsg, &
        'the first extent of xy must be 2')
      return
    end if
    allocate (u(3, size(xy, 2)))
    u = 0
    call finish(rollcon_contact_get_displacements_at(self%handle(), which, size(xy, 2, rc_long), xy, u), &
      self%handle(), 'rc_contact%get_displacements_at', stat, errmsg)
  end subroutine

  !> Returns temperatures temperature(2,n) of the surfaces of bodies 1 and 2 at points xy(2,n) of the plane of the axes.
  subroutine get_temperatures_at(self, xy, temperature, stat, errmsg)
    class(rc_contact), intent(in) :: self
    real(rc_real), intent(in), contiguous :: xy(:, :)
    real(rc_real), allocatable, intent(out) :: temperature(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(xy, 1) /= 2) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%get_temperatures_at', stat, errmsg, &
        'the first extent of xy must be 2')
      return
    end if
    allocate (temperature(2, size(xy, 2)))
    temperature = 0
    call finish(rollcon_contact_get_temperatures_at(self%handle(), size(xy, 2, rc_long), xy, temperature), &
      self%handle(), 'rc_contact%get_temperatures_at', stat, errmsg)
  end subroutine

  !> Returns displacements u(3,n) of all nodes of body 1 or 2, of finite or boundary elements, in its axes.
  subroutine get_body_displacements(self, which, u, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), allocatable, intent(out) :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: none(1)
    integer(rc_long) :: n
    integer(rc_int) :: status
    n = 0
    status = rollcon_contact_get_body_displacements(self%handle(), which, 0_rc_long, none, n)
    allocate (u(3, n/3))
    u = 0
    if (status == ROLLCON_OK) &
      status = rollcon_contact_get_body_displacements(self%handle(), which, n, u, n)
    call finish(status, self%handle(), 'rc_contact%get_body_displacements', stat, errmsg)
  end subroutine

  !> Returns the power that body 1 or 2, a viscoelastic section, loses in each harmonic of its way, from 0 on.
  subroutine get_body_power(self, which, power, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), allocatable, intent(out) :: power(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: none(1)
    integer(rc_long) :: n
    integer(rc_int) :: status
    n = 0
    status = rollcon_contact_get_body_power(self%handle(), which, 0_rc_long, none, n)
    allocate (power(n))
    power = 0
    if (status == ROLLCON_OK) &
      status = rollcon_contact_get_body_power(self%handle(), which, n, power, n)
    call finish(status, self%handle(), 'rc_contact%get_body_power', stat, errmsg)
  end subroutine

  !> Returns displacements u(3,n) and stresses stress(6,n) (s11, s22, s33, s12, s13, s23) at points xyz(3,n) inside body
  !> 1 or 2; points and results are in the axes of the contact (ROLLCON_IN_CONTACT; body 1 at n <= 0, body 2 at n >= 0)
  !> or of the body (ROLLCON_IN_BODY).
  subroutine get_fields_at(self, which, xyz, in_axes, u, stress, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: which, in_axes
    real(rc_real), intent(in), contiguous :: xyz(:, :)
    real(rc_real), allocatable, intent(out) :: u(:, :), stress(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(xyz, 1) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_contact%get_fields_at', stat, errmsg, &
        'the first extent of xyz must be 3')
      return
    end if
    allocate (u(3, size(xyz, 2)), stress(6, size(xyz, 2)))
    u = 0
    stress = 0
    call finish(rollcon_contact_get_fields_at(self%handle(), which, size(xyz, 2, rc_long), xyz, in_axes, u, stress), &
      self%handle(), 'rc_contact%get_fields_at', stat, errmsg)
  end subroutine

  !> Writes elements of body 1 or 2 with displacements, smoothed stresses and von Mises's stress, as a VTU file.
  subroutine write_body_vtu(self, which, path, stat, errmsg)
    class(rc_contact), intent(in) :: self
    integer(rc_int), intent(in) :: which
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_contact_write_body(self%handle(), which, c_text(path)), self%handle(), &
      'rc_contact%write_body_vtu', stat, errmsg)
  end subroutine

  !> Returns the depth depth(n) that a pass of the contact wears off at places y(n) along t2, and the volume per length
  !> rolled, by a law, 'archard' ([i] or [i1, i2, angle]) or 't_gamma' (pairs of energy and rate).
  subroutine get_wear(self, law, parameters, y, depth, volume, stat, errmsg)
    class(rc_contact), intent(in) :: self
    character(len=*), intent(in) :: law
    real(rc_real), intent(in), contiguous :: parameters(:), y(:)
    real(rc_real), allocatable, intent(out) :: depth(:)
    real(rc_real), intent(out), optional :: volume
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: whole
    whole = 0
    allocate (depth(size(y)))
    depth = 0
    call finish(rollcon_contact_get_wear(self%handle(), c_text(law), size(parameters, kind=rc_int), parameters, &
      size(y, kind=rc_long), y, depth, whole), self%handle(), 'rc_contact%get_wear', stat, errmsg)
    if (present(volume)) volume = whole
  end subroutine

  !> Returns the iterations of the last solve: rows(columns,n) with the columns asked for, separated by blanks: phase,
  !> iteration, residual_normal, residual_tangential, step, nodes_contact, nodes_slip, seconds, error_function.
  subroutine get_history(self, columns, rows, stat, errmsg)
    class(rc_contact), intent(in) :: self
    character(len=*), intent(in) :: columns
    real(rc_real), allocatable, intent(out) :: rows(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: none(1)
    integer(rc_long) :: n
    integer(rc_int) :: status
    n = 0
    status = rollcon_contact_get_history(self%handle(), c_text(columns), 0_rc_long, none, n)
    if (status < 0) n = 0
    allocate (rows(words(columns), n))
    rows = 0
    if (n > 0) status = rollcon_contact_get_history(self%handle(), c_text(columns), n, rows, n)
    call finish(status, self%handle(), 'rc_contact%get_history', stat, errmsg)
  end subroutine

  pure integer(rc_int) function axes_or_local(axes)
    integer(rc_int), intent(in), optional :: axes
    axes_or_local = ROLLCON_LOCAL
    if (present(axes)) axes_or_local = axes
  end function

  !> Reads all values of a field one after the other, and the number of nodes n.
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
