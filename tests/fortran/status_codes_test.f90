!> Every status that a Fortran 2008 caller can meet, from calls that deserve it; built with trapping of invalid operations,
!> divisions by zero and overflows, which no call may trigger in the caller.
module status_cases
  use, intrinsic :: iso_c_binding, only: c_associated, c_ptr
  use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
  use rollcon
  implicit none
  private
  public :: run

  integer, parameter :: side = 9, nodes = side**2, elements = (side - 1)**2
  real(rc_real), parameter :: half_width = 1.3_rc_real, mu = 0.1_rc_real, load = 298.6_rc_real

  type(rc_context) :: context
  type(rc_body) :: sphere, plane
  type(rc_contact) :: contact  ! module variable: the callback looks at it
  real(rc_real) :: x(3, nodes), nan, infinity
  integer :: connectivity(4, elements), failures = 0, checks = 0, calls = 0, status_inside = 0, lines = 0

contains

  subroutine expect(status, wanted, what)
    integer, intent(in) :: status
    integer(rc_int), intent(in) :: wanted
    character(len=*), intent(in) :: what
    checks = checks + 1
    if (status == wanted) return
    failures = failures + 1
    write (*, '(a, i0, a, i0, 2a)') 'status ', status, ' instead of ', wanted, ': ', what
  end subroutine

  subroutine demand(ok, what)
    logical, intent(in) :: ok
    character(len=*), intent(in) :: what
    checks = checks + 1
    if (ok) return
    failures = failures + 1
    write (*, '(2a)') 'wrong: ', what
  end subroutine

  !> A square frame around the origin.
  subroutine make_frame()
    integer :: i, j, k, n
    n = 0
    do j = 0, side - 1
      do i = 0, side - 1
        k = j*side + i + 1
        x(:, k) = [half_width*(2*i - side + 1)/(side - 1), half_width*(2*j - side + 1)/(side - 1), 0.0_rc_real]
        if (i + 1 < side .and. j + 1 < side) then
          n = n + 1
          connectivity(:, n) = [k, k + 1, k + 1 + side, k + side]
        end if
      end do
    end do
  end subroutine

  !> A contact that solves: sphere of radius 50 on a plane.
  subroutine make_contact(c)
    type(rc_contact), intent(inout) :: c
    call c%create(context, sphere, plane)
    call c%set_frame_nodes(x)
    call c%add_frame_elements(ROLLCON_QUAD4, connectivity)
    call c%set_gap_quadratic(0.01_rc_real, 0.01_rc_real, 0.0_rc_real)
    call c%set_friction('coulomb', [mu])
    call c%set_rolling(10.0_rc_real)
    call c%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, load)
  end subroutine

  function cancel(event, user) result(stop_now) bind(c)
    type(c_ptr), value :: event, user
    integer(rc_int) :: stop_now
    calls = calls + 1
    if (c_associated(user)) failures = failures + 1  ! none was given
    if (rc_event_int(event, ROLLCON_EVENT_PHASE) < 1) failures = failures + 1
    if (rc_event_int(event, ROLLCON_EVENT_ITERATION) < 0) failures = failures + 1
    if (rc_event_real(event, ROLLCON_EVENT_RESIDUAL) < 0) failures = failures + 1
    call contact%set_rolling(11.0_rc_real, stat=status_inside)
    stop_now = 1
  end function

  subroutine sink(level, message, user) bind(c)
    integer(rc_int), value :: level
    type(c_ptr), value :: message, user
    if (level == ROLLCON_LOG_ERROR .and. c_associated(message) .and. .not. c_associated(user)) lines = lines + 1
  end subroutine

  subroutine logs()
    integer :: stat
    call context%set_log(ROLLCON_LOG_ERROR, sink)
    call plane%set_elastic(-1.0_rc_real, 0.3_rc_real, stat=stat)
    call demand(lines == 1, 'a failure is one line of the log')
    call context%set_log(0_rc_int)
    call plane%set_elastic(-1.0_rc_real, 0.3_rc_real, stat=stat)
    call demand(lines == 1, 'no line after the log was turned off')
    call context%set_log(99_rc_int, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'level of the log out of range')
    call context%set_threads(-1, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'fewer than no threads')
  end subroutine

  subroutine handles()
    type(rc_context) :: no_context
    type(rc_body) :: no_body, b
    type(rc_contact) :: no_contact, c
    type(c_ptr) :: p
    integer :: stat, id
    character(len=400) :: message

    call no_context%set_threads(1, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'context never made')
    call no_body%prepare(stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'body never made')
    call no_contact%solve(stat, message)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'contact never made')
    call demand(index(message, 'solve') > 0, 'message without an object names the call')
    call b%create(no_context, ROLLCON_BODY_RIGID, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'body without context')
    call c%create(context, sphere, no_body, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'contact without second body')

    call b%create(context, ROLLCON_BODY_RIGID)
    p = b%handle()
    id = b%id()
    call demand(id > 0, 'a live handle has a positive number')
    call b%free()
    call expect(int(rollcon_body_prepare(p)), ROLLCON_ERR_HANDLE, 'stale body')
    call b%from_id(id, stat)
    call expect(stat, ROLLCON_ERR_HANDLE, 'number of a stale body')
    call b%from_id(context%id(), stat)
    call expect(stat, ROLLCON_ERR_HANDLE, 'number of a context for a body')
    call c%from_id(sphere%id(), stat)
    call expect(stat, ROLLCON_ERR_HANDLE, 'number of a body for a contact')
    call no_context%from_id(123456789, stat)
    call expect(stat, ROLLCON_ERR_HANDLE, 'garbage number')
    call no_context%from_id(-5, stat)
    call expect(stat, ROLLCON_ERR_HANDLE, 'negative number')
    call no_context%from_id(0, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'number zero')
    call expect(int(rollcon_contact_solve(sphere%handle())), ROLLCON_ERR_HANDLE, 'solve of a body')
    call expect(int(rollcon_context_create(999_rc_int, p)), ROLLCON_ERR_UNSUPPORTED, 'header of another library')
  end subroutine

  subroutine bodies()
    type(rc_body) :: b
    integer :: stat
    integer(rc_int) :: kind
    character(len=400) :: message
    call b%create(context, ROLLCON_BODY_FEM, stat)
    if (rc_has_feature('fem')) then
      call expect(stat, ROLLCON_OK, 'finite elements')
    else
      call expect(stat, ROLLCON_ERR_UNSUPPORTED, 'finite elements')
    end if
    call b%create(context, 77_rc_int, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'unknown kind of body')
    call b%create(context, ROLLCON_BODY_HALFSPACE)
    call b%get_kind(kind, stat)
    call expect(stat, ROLLCON_OK, 'kind of a body')
    call demand(kind == ROLLCON_BODY_HALFSPACE, 'kind is half-space')
    call b%prepare(stat)
    call expect(stat, ROLLCON_ERR_STATE, 'half-space without material')
    call b%set_elastic(-1.0_rc_real, 0.3_rc_real, stat=stat, errmsg=message)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'E < 0')
    call demand(index(message, 'rollcon_body_set_elastic') > 0, 'message names the function: '//trim(message))
    call demand(message == rc_last_error(), 'message is the last error')
    call b%set_elastic(0.0_rc_real, 0.3_rc_real, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'E = 0')
    call b%set_elastic(1.0_rc_real, -1.0_rc_real, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'nu = -1')
    call b%set_elastic(1.0_rc_real, 0.501_rc_real, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'nu > 0.5')
    call b%set_elastic(nan, 0.3_rc_real, stat=stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'E NaN')
    call b%set_elastic(1.0_rc_real, infinity, stat=stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'nu infinite')
    call b%set_elastic(1.0_rc_real, 0.5_rc_real, stat=stat)
    call expect(stat, ROLLCON_OK, 'nu = 0.5')
    call b%prepare(stat)
    call expect(stat, ROLLCON_OK, 'prepare')
    call b%set_elastic(1.0_rc_real, 0.3_rc_real, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'material of a prepared body')
    call plane%set_elastic(1.0_rc_real, 0.3_rc_real, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'material of a rigid body')
  end subroutine

  subroutine frames()
    type(rc_contact) :: c
    integer :: stat, bad(4, 1)
    integer(rc_long) :: far(4, 1)
    real(rc_real) :: y(3, nodes), two(2, 4)
    call c%create(context, sphere, plane)
    call c%add_frame_elements(ROLLCON_QUAD4, connectivity, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'elements before nodes')
    two = 0
    call c%set_frame_nodes(two, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'two coordinates')
    y = x
    y(2, 5) = nan
    call c%set_frame_nodes(y, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'NaN coordinate')
    y(2, 5) = -infinity
    call c%set_frame_nodes(y, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'infinite coordinate')
    call c%set_frame_nodes(x(:, 1:0), stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'no nodes')
    call c%set_frame_nodes_by_component(transpose(x), stat)
    call expect(stat, ROLLCON_OK, 'x(n,3)')
    call c%set_frame_nodes(x(:, nodes:1:-1), stat)
    call expect(stat, ROLLCON_OK, 'a section that is not contiguous')
    call c%set_frame_nodes(x)
    bad(:, 1) = [1, 2, nodes + 1, 3]
    call c%add_frame_elements(ROLLCON_QUAD4, bad, stat=stat)
    call expect(stat, ROLLCON_ERR_MESH, 'id beyond the last node')
    bad(:, 1) = [1, 2, 0, 3]
    call c%add_frame_elements(ROLLCON_QUAD4, bad, stat=stat)
    call expect(stat, ROLLCON_ERR_MESH, 'id 0')
    far(:, 1) = [1_rc_long, 2_rc_long, 4294967299_rc_long, 4_rc_long]
    call c%add_frame_elements(ROLLCON_QUAD4, far, stat=stat)
    call expect(stat, ROLLCON_ERR_MESH, 'id beyond 32 bits')
    call c%add_frame_elements(ROLLCON_TRI3, bad, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'four nodes per triangle')
    call c%add_frame_elements(999_rc_int, bad, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'unknown type of element')
    call c%set_axes([0.0_rc_real, nan, 0.0_rc_real], [1.0_rc_real, 0.0_rc_real, 0.0_rc_real], &
      [0.0_rc_real, 0.0_rc_real, 1.0_rc_real], stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'origin NaN')
    call c%set_axes([0.0_rc_real, 0.0_rc_real, 0.0_rc_real], [0.0_rc_real, 0.0_rc_real, 2.0_rc_real], &
      [0.0_rc_real, 0.0_rc_real, 1.0_rc_real], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'rolling along the normal')

    ! shapes are looked at by the solve
    bad(:, 1) = connectivity(:, elements)
    call broken_mesh(bad, 'repeated element')
    bad(:, 1) = [1, 2, 2, 1]
    call broken_mesh(bad, 'degenerate element')
    bad(:, 1) = connectivity([4, 3, 2, 1], elements)
    call broken_mesh(bad, 'flipped element', whole=elements - 1)
  end subroutine

  !> The frame's first elements (all, unless told) and a bad one.
  subroutine broken_mesh(bad, what, whole)
    integer, intent(in) :: bad(:, :)
    character(len=*), intent(in) :: what
    integer, intent(in), optional :: whole
    type(rc_contact) :: c
    integer :: stat, n
    n = elements
    if (present(whole)) n = whole
    call make_contact(c)
    call c%set_frame_nodes(x)
    call c%add_frame_elements(ROLLCON_QUAD4, connectivity(:, 1:n))
    call c%add_frame_elements(ROLLCON_QUAD4, bad, stat=stat)
    if (stat == ROLLCON_OK) call c%solve(stat)
    call expect(stat, ROLLCON_ERR_MESH, what)
  end subroutine

  subroutine scenes()
    type(rc_contact) :: c
    integer :: stat
    real(rc_real) :: v(nodes), w(2, nodes)
    call make_contact(c)
    v = 0.1_rc_real
    w = 0
    call c%set_gap(v(1:5), stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'short gap')
    call c%set_gap(v, stat)
    call expect(stat, ROLLCON_OK, 'gap')
    call c%set_friction_field(v, stat)
    call expect(stat, ROLLCON_OK, 'friction field')
    v(nodes) = -0.1_rc_real
    call c%set_friction_field(v, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'negative friction at one node')
    v(nodes) = nan
    call c%set_gap(v, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'gap NaN')
    call c%set_friction_field(v, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'friction field NaN')
    call c%set_friction_field(v(1:0), stat)
    call expect(stat, ROLLCON_OK, 'friction field removed')
    call c%set_creep_field(w, stat)
    call expect(stat, ROLLCON_OK, 'creep field')
    w(2, 3) = infinity
    call c%set_creep_field(w, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'creep field infinite')
    call c%set_creep_field(w(:, 1:0), stat)
    call expect(stat, ROLLCON_OK, 'creep field removed')
    call c%set_gap_quadratic(0.01_rc_real, nan, 0.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'curvature NaN')
    call c%set_rolling(0.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'V = 0')
    call c%set_rolling(-1.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'V < 0')
    call c%set_rolling(nan, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'V NaN')
    call c%set_creep(nan, 0.0_rc_real, 0.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'creepage NaN')
    call c%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, -1.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'pulling load')
    call c%prescribe(9_rc_int, ROLLCON_BY_FORCE, 1.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'unknown direction')
    call c%prescribe(ROLLCON_SPIN, ROLLCON_BY_FORCE, infinity, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'infinite moment')
    call c%set_friction('coulomb', [-0.1_rc_real], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'mu < 0')
    call c%set_friction('coulomb', [nan], stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'mu NaN')
    call c%set_friction('glue', [0.1_rc_real], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'unknown law')
  end subroutine

  subroutine options()
    type(rc_contact) :: c
    integer :: stat, i, most
    integer(rc_int) :: type
    real(rc_real) :: tolerance, low, high, standard
    character(len=:), allocatable :: name, doc
    call make_contact(c)
    call c%set('no such option', 1, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'unknown option')
    call c%set('max_iterations', 1.5_rc_real, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'real for an integer')
    call c%set('tolerance', 'tight', stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'text for a real')
    call c%set('tolerance', 7.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'tolerance out of range')
    call c%set('tolerance', nan, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'tolerance NaN')
    call c%set('max_iterations', 0, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'no iterations')
    call c%set('convection', 'upwards', stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'unknown scheme')
    call c%set('tolerance', 1e-9_rc_real)
    call c%get('tolerance', tolerance)
    call demand(abs(tolerance - 1e-9_rc_real) <= 0, 'tolerance read back')
    call c%set('max_iterations', 50)
    call c%get('max_iterations', most)
    call demand(most == 50, 'max_iterations read back')
    call c%set('convection', 'godunov')
    call c%get('convection', name)
    call demand(name == 'godunov', 'convection read back')
    call c%get('tolerance', most, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'integer from a real')
    call demand(rc_option_count() > 0, 'there are options')
    do i = 1, rc_option_count()
      call rc_option_info(i, name, type, low, high, standard)
      call rc_option_doc(i, doc)
      call demand(len(name) > 0 .and. len(doc) > 0 .and. low <= high, 'option '//name)
    end do
    call rc_option_info(0, name, type, low, high, standard, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'option before the first')
    call rc_stat_name(rc_stat_count() + 1, name, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'statistic after the last')
    call rc_stat_name(1, name, stat)
    call expect(stat, ROLLCON_OK, 'first statistic')
  end subroutine

  subroutine solves()
    type(rc_contact) :: c
    integer :: stat, n, m
    integer(rc_int), allocatable :: state(:)
    real(rc_real), allocatable :: t(:, :), p(:), s(:, :), psi(:), seconds(:), rows(:, :), u(:, :)
    real(rc_real) :: force(3), moment(3), approach, creep(3), value, little(3)
    character(len=:), allocatable :: text
    character(len=400) :: message
    call make_contact(c)
    call c%get_tractions(t, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'tractions before a solve')
    call c%get_field(ROLLCON_FIELD_SLIP, s, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'field before a solve')
    call c%get_status(state, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'states before a solve')
    call c%get_resultant(force, moment, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'resultant before a solve')
    call c%get_motion(approach, creep, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'motion before a solve')
    call c%get_sensitivity(ROLLCON_NORMAL, force, moment, approach, creep, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'sensitivity before a solve')
    call c%get_plan(text, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'plan before a solve')
    call c%get_size(n, m, stat)
    call expect(stat, ROLLCON_OK, 'size before a solve')
    call demand(n == nodes .and. m == elements, 'size')

    call c%solve(stat)
    call expect(stat, ROLLCON_OK, 'solve')
    call c%get_tractions(t)
    call demand(size(t, 1) == 3 .and. size(t, 2) == nodes, 'shape of the tractions')
    call c%get_field(ROLLCON_FIELD_PRESSURE, p)
    call demand(size(p) == nodes, 'shape of a scalar field')
    call demand(maxval(abs(p + t(3, :))) <= 1e-12_rc_real*maxval(p), 'pressure is the normal traction, reversed')
    call c%get_field(ROLLCON_FIELD_SLIP, s)
    call demand(size(s, 1) == 2, 'slip has two components in local axes')
    call c%get_field(ROLLCON_FIELD_SLIP, s, ROLLCON_GLOBAL)
    call demand(size(s, 1) == 3 .and. size(s, 2) == nodes, 'slip has three components in global axes')
    call c%get_status(state)
    call demand(size(state) == nodes, 'shape of the states')
    call c%get_resultant(force, moment)
    call demand(abs(force(3) + load) < 1e-6_rc_real*load, 'the normal force balances the load')
    call c%get_sensitivity(ROLLCON_NORMAL, force, moment, approach, creep)
    call demand(abs(force(3) + 1) < 1e-9_rc_real .and. approach > 0, 'the normal force by the load')
    call c%get_sensitivity(0_rc_int, force, moment, approach, creep, stat, message)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'sensitivity to nothing')
    call demand(index(message, 'parameter is 0') > 0, 'message names the entry: '//trim(message))
    call c%get_displacements_at(1, reshape([0.0_rc_real, 0.0_rc_real, 2.0_rc_real, 0.5_rc_real], [2, 2]), u)
    call demand(size(u, 1) == 3 .and. size(u, 2) == 2, 'shape of displacements')
    call c%get_displacements_at(3, reshape([0.0_rc_real, 0.0_rc_real], [2, 1]), u, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'displacements of a third body')
    call c%get_displacements_at(1, reshape([nan, 0.0_rc_real], [2, 1]), u, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'displacements at NaN')
    call c%get_history(rows)
    call demand(size(rows, 1) == 8 .and. size(rows, 2) >= 1, 'history')
    call c%get_error_function(psi, seconds)
    call demand(size(psi) == size(rows, 2) .and. size(seconds) == size(psi), 'error function: a value per row')
    call demand(psi(size(psi)) >= 0 .and. psi(size(psi)) < 1e-12_rc_real, 'error function at the end')
    call demand(all(seconds == rows(8, :)), 'error function: time stamps')
    call c%get_plan(text)
    call demand(len(text) > 0, 'plan')
    call c%get_stat('no such number', value, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'unknown statistic')
    call c%get_field(99_rc_int, p, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'unknown field')
    call expect(int(rollcon_contact_get_tractions(c%handle(), ROLLCON_LOCAL, 1_rc_long, little)), ROLLCON_ERR_CAPACITY, &
      'room for one node only')
    call c%write_vtu('/no/such/directory/contact.vtu', stat)
    if (rc_has_feature('vtu')) then
      call expect(stat, ROLLCON_ERR_IO, 'file in a directory that does not exist')
    else
      call expect(stat, ROLLCON_ERR_UNSUPPORTED, 'file in a build that writes none')
    end if
    call c%reset(stat)
    call expect(stat, ROLLCON_OK, 'reset')
    call c%get_tractions(t, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'tractions after a reset')

    call c%prescribe(ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 1.5_rc_real*mu*load)
    call c%solve(stat)
    call expect(stat, ROLLCON_ERR_LOAD, 'force beyond friction')
    call c%set_creep(0.0_rc_real, 0.0_rc_real, 0.0_rc_real)
    call c%prescribe(ROLLCON_NORMAL, ROLLCON_BY_MOTION, -0.001_rc_real)
    call c%solve(stat)
    call expect(stat, ROLLCON_NO_CONTACT, 'bodies apart')
    call c%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, load)
    call c%set_creep(1e-3_rc_real, 0.0_rc_real, 0.0_rc_real)
    call c%reset()
    call c%set('max_iterations', 1)
    call c%solve(stat)
    call expect(stat, ROLLCON_NOT_CONVERGED, 'one iteration')
    call c%get_tractions(t, stat=stat)
    call expect(stat, ROLLCON_OK, 'best iterate')
    call c%get_sensitivity(ROLLCON_FRICTION, force, moment, approach, creep, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'sensitivity of what did not converge')

    call make_contact(contact)
    call contact%set_progress(cancel)
    call contact%solve(stat)
    call expect(stat, ROLLCON_CANCELLED, 'cancelled by the callback')
    call demand(calls == 1, 'the callback was called once')
    call expect(status_inside, ROLLCON_ERR_BUSY, 'call of the contact that is solving')
    call contact%set_progress()
    call contact%solve(stat)
    call expect(stat, ROLLCON_OK, 'solve after a cancelled one')
    call contact%free()

    call c%create(context, sphere, plane)
    call c%solve(stat, message)
    call expect(stat, ROLLCON_ERR_STATE, 'solve of nothing')
    call demand(index(message, 'rollcon_contact_solve') > 0, 'message names the function: '//trim(message))
  end subroutine

  subroutine facts()
    call demand(rc_abi() == ROLLCON_HEADER_ABI, 'binary interface')
    call demand(rc_version() > 0 .and. len(rc_version_string()) > 0, 'version')
    call demand(len(rc_build_info()) > 0, 'build info')
    call demand(rc_has_feature('halfspace') .and. .not. rc_has_feature('no such feature'), 'features')
    call demand(rc_status_string(int(ROLLCON_ERR_MESH)) /= rc_status_string(int(ROLLCON_OK)), 'texts of statuses')
  end subroutine

  subroutine run()
    nan = ieee_value(nan, ieee_quiet_nan)
    infinity = ieee_value(infinity, ieee_positive_inf)
    call make_frame()
    call context%create()
    call context%set_threads(1)
    call sphere%create(context, ROLLCON_BODY_HALFSPACE)
    call sphere%set_elastic(1e4_rc_real, 0.3_rc_real)
    call plane%create(context, ROLLCON_BODY_RIGID)
    call facts()
    call logs()
    call handles()
    call bodies()
    call frames()
    call scenes()
    call options()
    call solves()
    write (*, '(i0, a, i0, a)') checks, ' checks, ', failures, ' failures'
    if (failures > 0) error stop 1
  end subroutine

end module status_cases

program status_codes_test
  use status_cases, only: run
  implicit none
  call run()
end program status_codes_test
