!> Runs one scene over the library itself from both Fortran layers: results that agree, callbacks, statuses that are no
!> failures, derivatives and cases. It is built with trapping of invalid operations, divisions by zero and overflows,
!> which no call may trigger in the caller. The C tests show what each argument means, and mapping_test that it arrives.
module scene
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  use, intrinsic :: iso_c_binding, only: c_ptr
  use rollcon
  implicit none
  private
  public :: run

  integer, parameter :: side = 9, nodes = side**2, elements = (side - 1)**2
  real(rc_real), parameter :: half_width = 1.3_rc_real, mu = 0.1_rc_real, load = 298.6_rc_real
  type(rc_context) :: context
  type(rc_body) :: sphere, plane
  type(rc_contact) :: contact  ! module variable, which the callbacks look at
  integer :: failures = 0, calls = 0, status_inside = 0, icon = 0

contains

  subroutine demand(ok, what)
    logical, intent(in) :: ok
    character(len=*), intent(in) :: what
    if (ok) return
    failures = failures + 1
    write (*, '(2a)') 'not so: ', what
  end subroutine

  !> Makes a sphere of radius 50 on a plane.
  subroutine make()
    real(rc_real) :: x(3, nodes)
    integer :: connectivity(4, elements), i, j, k, n
    n = 0
    do j = 0, side - 1
      do i = 0, side - 1
        k = j*side + i + 1
        x(:, k) = [half_width*(2*i - side + 1)/(side - 1), half_width*(2*j - side + 1)/(side - 1), 0.0_rc_real]
        if (i + 1 == side .or. j + 1 == side) cycle
        n = n + 1
        connectivity(:, n) = [k, k + 1, k + 1 + side, k + side]
      end do
    end do
    call context%create()
    call sphere%create(context, ROLLCON_BODY_HALFSPACE)
    call sphere%set_elastic(1e4_rc_real, 0.3_rc_real)
    call plane%create(context, ROLLCON_BODY_RIGID)
    call contact%create(context, sphere, plane)
    call contact%frame_nodes(x)
    call contact%frame_add_elements(ROLLCON_QUAD4, connectivity)
    call contact%set_gap_quadratic(0.01_rc_real, 0.01_rc_real, 0.0_rc_real)
    call contact%set_friction('coulomb', [mu])
    call contact%set_rolling(10.0_rc_real)
    call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, load)
  end subroutine

  function watch(event, user) result(stop_now) bind(c)
    type(c_ptr), value :: event, user
    integer(rc_int) :: stop_now
    calls = calls + 1
    call demand(rc_event_int(event, ROLLCON_EVENT_PHASE) >= 1, 'phase')
    call demand(rc_event_real(event, ROLLCON_EVENT_SECONDS) >= 0, 'seconds')
    call demand(rc_event_int(event, 7_rc_int) == -1, 'unknown key')
    call contact%set_rolling(11.0_rc_real, stat=status_inside)
    stop_now = 1
  end function

  subroutine watch_77(iphase, iter, resid, secs, icancl)
    integer :: iphase, iter, icancl
    double precision :: resid, secs
    external :: rcroll
    calls = calls + 1
    call demand(iphase >= 1 .and. iter >= 0 .and. resid >= 0 .and. secs >= 0, 'arguments of WATCH')
    call rcroll(icon, 11d0, status_inside)
    icancl = 1
  end subroutine

  subroutine run()
    integer :: stat
    call make()
    icon = contact%id()
    call contact%set_progress(watch)
    call contact%solve(stat)
    call demand(stat == ROLLCON_CANCELLED .and. calls == 1, 'cancelled')
    call demand(status_inside == ROLLCON_ERR_BUSY, 'busy inside a callback')
    call callbacks_77()
    call contact%solve()
    call agree()
    call laws()
    call statuses()
    call contact%free()
    if (failures > 0) error stop 1
  end subroutine

  subroutine callbacks_77()
    external :: rcprog, rcsolv, rcnopr
    integer :: ierr
    calls = 0
    status_inside = 0
    call rcprog(icon, watch_77, ierr)
    call rcsolv(icon, ierr)
    call demand(ierr == ROLLCON_CANCELLED .and. calls == 1, 'cancelled by WATCH')
    call demand(status_inside == ROLLCON_ERR_BUSY, 'busy inside WATCH')
    call rcnopr(icon, ierr)
    call rcsolv(icon, ierr)
    call demand(ierr == ROLLCON_OK .and. calls == 1, 'not called again')
  end subroutine

  !> Checks that both layers give the same, and that the results of one call fit those of others.
  subroutine agree()
    external :: rctrac, rcsens, rccase
    real(rc_real), allocatable :: t(:, :), weight(:), force(:, :), slopes(:, :, :)
    real(rc_real) :: f(3), m(3), by_load(10)
    double precision :: t77(3, nodes), f77(3), m77(3), approach77, creep77(3), table(13, 2)
    integer :: ierr, n, status(2)
    call contact%get_tractions(t)
    call contact%get_field(ROLLCON_FIELD_WEIGHT, weight)
    call contact%get_resultant(f, m)
    call demand(maxval(abs(matmul(t, weight) - f)) < 1e-8_rc_real*load, 'resultant of the tractions')
    call demand(abs(f(3) + load) < 1e-6_rc_real*load, 'the load')
    call rctrac(icon, 0, nodes, t77, ierr)
    call demand(ierr == 0 .and. all(.not. abs(t77 - t) > 0), 'RCTRAC')
    call contact%get_sensitivity(ROLLCON_NORMAL, by_load(1:3), by_load(4:6), by_load(7), by_load(8:10))
    call rcsens(icon, 3, f77, m77, approach77, creep77, ierr)
    call demand(all(.not. abs([f77, m77, approach77, creep77] - by_load) > 0), 'RCSENS')
    call contact%solve_many([ROLLCON_NORMAL], reshape([load, 0.8_rc_real*load], [1, 2]), force=force, &
      derivatives=slopes)
    call demand(abs(force(3, 2) + 0.8_rc_real*load) < 1e-6_rc_real*load, 'force of a case')
    call demand(maxval(abs(slopes(:, 1, 1) - by_load)) < 1e-6_rc_real, 'derivatives of a case')
    call rccase(icon, 'NORMAL', 2, [load, 0.8_rc_real*load], 'FORCE DERIVATIVES', 13, table, n, status, ierr)
    call demand(ierr == 0 .and. n == 13 .and. all(.not. abs(table(:3, :) - force) > 0) &
      .and. all(.not. abs(table(4:, :) - slopes(:, 1, :)) > 0), 'RCCASE')
  end subroutine

  !> Sets every law of friction from both layers: the same forces, and others than Coulomb's.
  subroutine laws()
    external :: rcfric, rcfrim, rcfria, rclayr, rcheat, rctmps, rcresu, rcsolv
    character(len=21), parameter :: name(6) = [character(len=21) :: 'orthotropic', 'orthotropic_collinear', 'linear', &
      'rational', 'exponential', 'temperature']
    real(rc_real), parameter :: orthotropic(3) = [0.1_rc_real, 0.05_rc_real, 0.7_rc_real], &
      falling(3) = [0.04_rc_real, 0.06_rc_real, 0.02_rc_real], &
      hot(4) = [0.0_rc_real, 0.1_rc_real, 0.01_rc_real, 0.05_rc_real], point(2, 1) = 0, &
      across(2, 2) = reshape([-1.0_rc_real, 0.06_rc_real, 1.0_rc_real, 0.1_rc_real], [2, 2])
    real(rc_real), allocatable :: given(:), temperature(:, :)
    real(rc_real) :: f(3), coulomb(3), moment(3)
    double precision :: f77(3), m77(3), t77(2, 1)
    integer :: i, ierr
    call contact%set_creep(4e-3_rc_real, 1e-3_rc_real, 0.0_rc_real)
    call contact%solve()
    call contact%get_resultant(coulomb, moment)
    do i = 1, 2
      call contact%set_heat(int(i, rc_int), 50.0_rc_real, 3.5_rc_real, 0.0_rc_real)
    end do
    do i = 1, 10
      select case (i)
      case (1, 2)
        given = orthotropic
      case (3:5)
        given = falling
      case (6)
        given = hot
      end select
      if (i <= 6) call contact%set_friction(trim(name(i)), given)
      if (i == 7) then
        call contact%set_friction('exponential', falling)
        call contact%set_friction_memory(1e-3_rc_real, 1e-3_rc_real)
      else if (i == 8) then
        call contact%set_friction_memory(0.0_rc_real, 0.0_rc_real)
        call contact%set_friction('coulomb', [mu])
        call contact%set_layer(1e-4_rc_real)
      else if (i == 9) then
        call contact%set_layer(1e-4_rc_real, 3.0_rc_real, 10.0_rc_real)
      else if (i == 10) then
        call contact%set_layer(0.0_rc_real)
        call contact%set_friction_across(across)
      end if
      call contact%solve()
      call contact%get_resultant(f, moment)
      call demand(maxval(abs(f - coulomb)) > 1e-4_rc_real*load, 'a law that is not Coulomb''s')
      call contact%get_temperatures_at(point, temperature)
      call demand(temperature(1, 1) > 0, 'a temperature')
      ! The rim goes away and comes back by the other layer.
      call rcfrim(icon, 0d0, 0d0, ierr)
      call rclayr(icon, 0d0, 0d0, 0d0, ierr)
      call rcfria(icon, 0, across, ierr)
      call rcheat(icon, 2, 1d0, 1d0, 1d0, ierr)
      call rcfric(icon, 'COULOMB', 1, [dble(mu)], ierr)
      call rcsolv(icon, ierr)
      call rcheat(icon, 2, 50d0, 3.5d0, 0d0, ierr)
      if (i <= 6) call rcfric(icon, name(i), size(given), given, ierr)
      if (i == 7) call rcfric(icon, 'exponential', 3, falling, ierr)
      if (i == 7) call rcfrim(icon, 1d-3, 1d-3, ierr)
      if (i == 8) call rclayr(icon, 1d-4, 0d0, 0d0, ierr)
      if (i == 9) call rclayr(icon, 1d-4, 3d0, 10d0, ierr)
      if (i == 10) call rcfria(icon, 2, across, ierr)
      call demand(ierr == 0, 'set by the FORTRAN 77 layer')
      call rcsolv(icon, ierr)
      call rcresu(icon, 0, f77, m77, ierr)
      call demand(ierr == 0 .and. maxval(abs(f77 - f)) < 1e-7_rc_real*load, 'forces of both layers')
      call rctmps(icon, 1, point, t77, ierr)
      call demand(ierr == 0 .and. maxval(abs(t77 - temperature)) < 1e-6_rc_real*temperature(1, 1), 'RCTMPS')
    end do
    call contact%set_friction('coulomb', [mu])
    call rcfria(icon, 0, across, ierr)
    call contact%solve()
  end subroutine

  subroutine statuses()
    integer :: stat
    real(rc_real) :: nan
    real(rc_real), allocatable :: t(:, :)
    nan = ieee_value(1.0_rc_real, ieee_quiet_nan)
    call contact%set_rolling(nan, stat)
    call demand(stat == ROLLCON_ERR_NONFINITE, 'speed NaN')
    call contact%prescribe(ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 1.5_rc_real*mu*load)
    call contact%solve(stat)
    call demand(stat == ROLLCON_ERR_LOAD, 'force beyond friction')
    call contact%set_creep(0.0_rc_real, 0.0_rc_real, 0.0_rc_real)
    call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_MOTION, -0.001_rc_real)
    call contact%solve()  ! a status > 0 does not stop
    call contact%solve(stat)
    call demand(stat == ROLLCON_NO_CONTACT, 'bodies apart')
    call contact%reset()
    call contact%get_tractions(t, stat=stat)
    call demand(stat == ROLLCON_ERR_STATE, 'tractions after a reset')
  end subroutine

end module scene

program scene_test
  use scene, only: run
  implicit none
  call run()
end program
