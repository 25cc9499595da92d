!> Derivatives from the type-bound procedure and from the FORTRAN 77 layer against differences of solves.
program sensitivity_test
  use rollcon
  implicit none
  integer, parameter :: side = 9, nodes = side**2, elements = (side - 1)**2
  real(rc_real), parameter :: half_width = 1.3_rc_real, load = 298.6_rc_real, mu = 0.1_rc_real
  type(rc_context) :: context
  type(rc_body) :: sphere, plane
  type(rc_contact) :: contact
  real(rc_real) :: x(3, nodes), value(5), slope(10), found(10), low(10), high(10), result(10), step, error
  double precision :: f(3), xm(3), appr, cr(3)
  integer(rc_int) :: p
  integer :: connectivity(4, elements), i, j, k, n, ierr, failures = 0
  external :: rcsens

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
  call context%create()
  call sphere%create(context, ROLLCON_BODY_HALFSPACE)
  call sphere%set_elastic(1e4_rc_real, 0.3_rc_real)
  call plane%create(context, ROLLCON_BODY_RIGID)
  call contact%create(context, sphere, plane)
  call contact%set_frame_nodes(x)
  call contact%add_frame_elements(ROLLCON_QUAD4, connectivity)
  call contact%set_gap_quadratic(0.01_rc_real, 0.01_rc_real, 0.0_rc_real)
  call contact%set('tolerance', 1e-13_rc_real)

  ! Longitudinal force and normal load, lateral creepage and spin.
  value = [10.0_rc_real, 3e-4_rc_real, load, 2e-4_rc_real, mu]
  call solve(value, result)
  do p = ROLLCON_LONGITUDINAL, ROLLCON_FRICTION
    call solve(value, result)
    call contact%get_sensitivity(p, found(1:3), found(4:6), found(7), found(8:10))
    call rcsens(contact%id(), int(p), f, xm, appr, cr, ierr)
    if (ierr /= 0 .or. any(abs(found - [f, xm, appr, cr]) > 0)) call fail('FORTRAN 77 differs')
    step = 1e-4_rc_real*value(p)
    call solve(moved(-step), low)
    call solve(moved(step), high)
    slope = (high - low)/(2*step)
    if (p == ROLLCON_FRICTION) slope = mu*slope
    error = 0
    do i = 1, 10  ! over the result (moments: over the lateral forces) per size of the parameter
      error = max(error, abs(found(i) - slope(i))/merge(norm2(result(1:2)), abs(result(i)), i <= 6) &
        *merge(1.0_rc_real, abs(value(p)), p == ROLLCON_FRICTION))
    end do
    write (*, '(a, i0, a, es8.1, a)') 'parameter ', p, ': error ', error, ' (bound 1e-6)'
    if (.not. error < 1e-6_rc_real) call fail('not the slope of solves')
  end do
  if (failures > 0) stop 1

contains

  function moved(by) result(v)
    real(rc_real), intent(in) :: by
    real(rc_real) :: v(5)
    v = value
    v(p) = v(p) + by
  end function

  subroutine solve(v, r)
    real(rc_real), intent(in) :: v(5)
    real(rc_real), intent(out) :: r(10)
    integer :: stat
    call contact%prescribe(ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, v(1))
    call contact%prescribe(ROLLCON_LATERAL, ROLLCON_BY_MOTION, v(2))
    call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, v(3))
    call contact%prescribe(ROLLCON_SPIN, ROLLCON_BY_MOTION, v(4))
    call contact%set_friction('coulomb', [v(5)])
    call contact%solve(stat)
    if (stat /= ROLLCON_OK) call fail('a solve')
    call contact%get_resultant(r(1:3), r(4:6))
    call contact%get_motion(r(7), r(8:10))
  end subroutine

  subroutine fail(what)
    character(len=*), intent(in) :: what
    failures = failures + 1
    write (*, '(2a)') 'wrong: ', what
  end subroutine
end program
