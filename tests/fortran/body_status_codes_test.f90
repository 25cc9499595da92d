!> Bodies with a mesh from Fortran 2008: every status that a caller can meet, and a stretched cube; built with trapping of
!> invalid operations, divisions by zero and overflows, which no call may trigger in the caller.
module body_cases
  use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
  use rollcon
  implicit none
  private
  public :: run

  real(rc_real), parameter :: young = 200.0_rc_real, poisson = 0.3_rc_real, zero = 0.0_rc_real, one = 1.0_rc_real

  !> A cube; faces 1 to 6: x = 0, x = 1, y = 0, y = 1, z = 0, z = 1.
  real(rc_real), parameter :: x(3, 8) = reshape([zero, zero, zero, one, zero, zero, one, one, zero, zero, one, zero, &
    zero, zero, one, one, zero, one, one, one, one, zero, one, one], [3, 8])
  integer, parameter :: face(4, 6) = reshape([1, 5, 8, 4, 2, 3, 7, 6, 1, 2, 6, 5, 4, 8, 7, 3, 1, 4, 3, 2, 5, 6, 7, 8], [4, 6])

  type(rc_context) :: context
  type(rc_body) :: plane, halfspace
  real(rc_real) :: nan, infinity
  integer :: failures = 0, checks = 0

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

  subroutine make_cube(b)
    type(rc_body), intent(inout) :: b
    integer :: f
    call b%create(context, ROLLCON_BODY_BEM)
    call b%set_elastic(young, poisson)
    call b%set_nodes(x)
    do f = 1, 6
      call b%add_elements(ROLLCON_QUAD4, face(:, f:f), f)
    end do
  end subroutine

  subroutine meshes()
    type(rc_body) :: b
    integer :: stat, n, m, bad(4, 1)
    integer(rc_long) :: far(4, 1)
    real(rc_real) :: y(3, 8), two(2, 4)
    character(len=400) :: message
    call halfspace%set_nodes(x, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'mesh of a half-space')
    call plane%set_nodes(x, stat)
    call expect(stat, ROLLCON_OK, 'mesh of a rigid body')
    call plane%set_pressure(1, one, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'pressure on a rigid body')
    call b%set_nodes(x, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'body never made')

    call b%create(context, ROLLCON_BODY_BEM)
    call b%add_elements(ROLLCON_QUAD4, face, 1, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'elements before nodes')
    call b%set_nodes(two, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'two coordinates')
    y = x
    y(2, 5) = nan
    call b%set_nodes(y, stat, message)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'NaN coordinate')
    call demand(index(message, 'rollcon_body_set_nodes') > 0, 'message names the function: '//trim(message))
    call b%set_nodes_by_component(transpose(x), stat)
    call expect(stat, ROLLCON_OK, 'x(n,3)')
    call b%set_nodes_by_component(x, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'x(3,8) for x(n,3)')
    bad(:, 1) = [1, 2, 9, 3]
    call b%add_elements(ROLLCON_QUAD4, bad, stat=stat)
    call expect(stat, ROLLCON_ERR_MESH, 'id beyond the last node')
    far(:, 1) = [1_rc_long, 2_rc_long, 4294967299_rc_long, 4_rc_long]
    call b%add_elements(ROLLCON_QUAD4, far, stat=stat)
    call expect(stat, ROLLCON_ERR_MESH, 'id beyond 32 bits')
    call b%add_elements(ROLLCON_TRI3, bad, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'four nodes per triangle')
    call b%add_elements(999_rc_int, bad, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'unknown type of element')
    call b%get_size(n, m, stat)
    call demand(n == 8 .and. m == 0, 'refused elements are not there')
    call b%prepare(stat)
    call expect(stat, ROLLCON_ERR_STATE, 'no material')
    call b%set_elastic(young, poisson)
    call b%add_elements(ROLLCON_QUAD4, face(:, 1:5))
    call b%set_support([1, 2, 3])
    call b%prepare(stat)
    call expect(stat, ROLLCON_ERR_MESH, 'a face is missing')
    call b%add_elements(ROLLCON_QUAD4, face([4, 3, 2, 1], 6:6))
    call b%prepare(stat)
    call expect(stat, ROLLCON_ERR_MESH, 'a face is flipped')
  end subroutine

  subroutine supports_and_loads()
    type(rc_body) :: b
    integer :: stat
    real(rc_real) :: v(3, 2)
    call b%create(context, ROLLCON_BODY_BEM)
    call b%set_traction(1, [zero, zero, one], stat)
    call expect(stat, ROLLCON_ERR_STATE, 'traction without elements')
    call make_cube(b)
    call b%prepare(stat)
    call expect(stat, ROLLCON_ERR_SINGULAR, 'a body in the air')
    call b%set_support([1, 9], stat=stat)
    call expect(stat, ROLLCON_ERR_MESH, 'support of a node that is not there')
    call b%set_support([1_rc_long, 4294967299_rc_long], stat=stat)
    call expect(stat, ROLLCON_ERR_MESH, 'support beyond 32 bits')
    call b%set_support([1, 2], 8_rc_int, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'a fourth component')
    v = 0
    v(2, 2) = nan
    call b%set_support([1, 2], ROLLCON_DOF_Y, v, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'NaN displacement')
    call b%set_support([1, 2, 3], ROLLCON_DOF_Y, v, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'two values for three nodes')
    call b%set_traction(7, [zero, zero, one], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'traction on a tag that is not there')
    call b%set_traction(6, [zero, infinity, one], stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'infinite traction')
    call b%set_pressure(0, one, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'pressure on a tag that is not there')
    call b%set_pressure(6, nan, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'pressure NaN')
    call b%set_contact_faces([6, 9], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'contact faces that are not there')
    call b%set_contact_faces([6, 2], stat)
    call expect(stat, ROLLCON_OK, 'contact faces')
    call b%set_contact_faces([integer ::], stat)
    call expect(stat, ROLLCON_OK, 'standard contact faces')
    call b%prepare(stat)
    call expect(stat, ROLLCON_ERR_SINGULAR, 'refused supports hold nothing')
  end subroutine

  subroutine options()
    type(rc_body) :: b
    integer :: stat, keep, i
    integer(rc_int) :: type
    real(rc_real) :: accuracy, low, high, standard
    character(len=:), allocatable :: name, doc
    call b%create(context, ROLLCON_BODY_BEM)
    call b%set('no such option', 1, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'unknown option')
    call b%set('keep_factors', 0.5_rc_real, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'real for an integer')
    call b%set('accuracy', 7.0_rc_real, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'accuracy out of range')
    call b%set('accuracy', nan, stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'accuracy NaN')
    call b%set('accuracy', 1e-5_rc_real)
    call b%get('accuracy', accuracy)
    call demand(abs(accuracy - 1e-5_rc_real) <= 0, 'accuracy read back')
    call b%set('keep_factors', 0)
    call b%get('keep_factors', keep)
    call demand(keep == 0, 'keep_factors read back')
    call b%get('accuracy', keep, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'integer from a real')
    call demand(rc_body_option_count() == 8, 'number of options')
    do i = 1, rc_body_option_count()
      call rc_body_option_info(i, name, type, low, high, standard)
      call rc_body_option_doc(i, doc)
      call demand(len(name) > 0 .and. len(doc) > 0 .and. low <= standard .and. standard <= high, 'option '//name)
    end do
    call rc_body_option_info(0, name, type, low, high, standard, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'option before the first')
    call rc_body_option_doc(9, doc, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'option after the last')
    call rc_body_stat_name(rc_body_stat_count() + 1, name, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'statistic after the last')
    call rc_body_stat_name(1, name, stat)
    call expect(stat, ROLLCON_OK, 'first statistic')
  end subroutine

  !> u = stress/E (-nu x, -nu y, z), held at z = 0 and at three points of the bottom.
  subroutine stretched_cube()
    type(rc_body) :: b
    real(rc_real), parameter :: stress = 2.0_rc_real, relative_bound = 1e-6_rc_real
    real(rc_real), allocatable :: u(:, :)
    real(rc_real) :: exact(3, 8), force(3), moment(3), value, error
    integer :: stat
    call make_cube(b)
    call b%get_displacements(u, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'displacements before preparation')
    call b%get_reaction(force, moment, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'reaction before preparation')
    call b%get_stat('unknowns', value, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'statistic before preparation')
    call b%set_support([1, 2, 3, 4], ROLLCON_DOF_Z)
    call b%set_support([1], ROLLCON_DOF_X + ROLLCON_DOF_Y)
    call b%set_support([2], ROLLCON_DOF_Y)
    call b%set_traction(6, [zero, zero, stress + one])
    call b%set_pressure(6, one)
    call b%prepare()
    call b%prepare()
    call b%set_nodes(x, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'nodes of a prepared body')
    call b%set('keep_factors', 0, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'option of a prepared body')
    call b%get_displacements(u)
    exact(1:2, :) = -poisson*stress/young*x(1:2, :)
    exact(3, :) = stress/young*x(3, :)
    call demand(size(u, 1) == 3 .and. size(u, 2) == 8, 'shape of the displacements')
    error = maxval(abs(u - exact))/(stress/young)
    write (*, '(a, es9.2, a, es9.2)') 'stretched cube: error ', error, ', bound ', relative_bound
    call demand(error <= relative_bound, 'displacements of a stretched cube')
    call b%get_reaction(force, moment)
    error = max(maxval(abs(force - [zero, zero, -stress])), maxval(abs(moment - [-one, one, zero])))
    write (*, '(a, es9.2, a, es9.2)') 'its reaction: error ', error, ', bound ', relative_bound
    call demand(error <= relative_bound, 'reaction of a stretched cube')
    call b%get_stat('unknowns', value)
    call demand(value >= 24, 'unknowns')
    call b%get_stat('no such number', value, stat)
    call expect(stat, ROLLCON_ERR_OPTION, 'unknown statistic')
    call expect(int(rollcon_body_get_displacements(b%handle(), 7_rc_long, u)), ROLLCON_ERR_CAPACITY, 'room for seven nodes')
  end subroutine

  subroutine poses()
    type(rc_body) :: b
    type(rc_contact) :: c
    real(rc_real), allocatable :: points(:, :)
    real(rc_real) :: turn(3, 3), mirror(3, 3)
    integer :: stat, n, m
    call make_cube(b)
    call c%create(context, b, plane)
    turn = reshape([zero, one, zero, -one, zero, zero, zero, zero, one], [3, 3])
    mirror = reshape([-one, zero, zero, zero, one, zero, zero, zero, one], [3, 3])
    call c%set_pose(3, turn, [zero, zero, zero], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'pose of a third body')
    call c%set_pose(1, mirror, [zero, zero, zero], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'a mirror')
    call c%set_pose(1, 2*turn, [zero, zero, zero], stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'no rotation')
    call c%set_pose(1, turn, [zero, nan, zero], stat)
    call expect(stat, ROLLCON_ERR_NONFINITE, 'translation NaN')
    call c%set_pose(1, turn, [zero, zero, one], stat)
    call expect(stat, ROLLCON_OK, 'pose')
    call c%frame_from_body(1, 9, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'frame of a tag that is not there')
    call c%frame_from_body(0, 6, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'frame of body 0')
    call c%frame_from_body(1, 6, stat)
    call expect(stat, ROLLCON_OK, 'frame of the top')
    call c%get_size(n, m)
    call demand(n == 4 .and. m == 1, 'size of that frame')

    ! A solve far from contact tells where the nodes of the frame are: the rotation is not transposed.
    call b%set_support([1, 2, 3, 4])
    call c%set_friction('coulomb', [0.1_rc_real])
    call c%set_gap_quadratic(zero, zero, zero)
    call c%prescribe(ROLLCON_NORMAL, ROLLCON_BY_MOTION, -one)
    call c%solve(stat)
    call expect(stat, ROLLCON_NO_CONTACT, 'bodies apart')
    call c%get_field(ROLLCON_FIELD_POINT, points, ROLLCON_GLOBAL)
    call demand(maxval(abs(points - (matmul(turn, x(:, 5:8)) + spread([zero, zero, one], 2, 4)))) < 1e-12_rc_real, &
      'nodes follow the pose of their body')
  end subroutine

  subroutine run()
    if (.not. rc_has_feature('bem')) then
      write (*, '(a)') 'this build has no boundary elements'
      return
    end if
    nan = ieee_value(nan, ieee_quiet_nan)
    infinity = ieee_value(infinity, ieee_positive_inf)
    call context%create()
    call context%set_threads(1)
    call halfspace%create(context, ROLLCON_BODY_HALFSPACE)
    call plane%create(context, ROLLCON_BODY_RIGID)
    call meshes()
    call plane%create(context, ROLLCON_BODY_RIGID)
    call supports_and_loads()
    call options()
    call stretched_cube()
    call poses()
    write (*, '(i0, a, i0, a)') checks, ' checks, ', failures, ' failures'
    if (failures > 0) error stop 1
  end subroutine

end module body_cases

program body_status_codes_test
  use body_cases, only: run
  implicit none
  call run()
end program body_status_codes_test
