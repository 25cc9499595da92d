!> The six steps in Fortran 2008: an elastic sphere rolls on a rigid plane and transmits 75 % of the force at which it
!> would slide. Units: mm, N, MPa. six_steps.c, six_steps_77.f and six_steps.py print the same.
program six_steps
  use rollcon
  implicit none
  real(rc_real), parameter :: radius = 50, young = 1e4_rc_real, poisson = 0.3_rc_real, mu = 0.1_rc_real
  real(rc_real), parameter :: load = 298.6_rc_real, traction_force = 0.75_rc_real*mu*load, speed = 10
  type(rc_context) :: context
  type(rc_body) :: sphere, plane
  type(rc_contact) :: contact
  real(rc_real) :: force(3), moment(3), approach, creep(3)
  real(rc_real), allocatable :: t(:, :)
  integer(rc_int), allocatable :: state(:)
  integer :: status

  ! Step 1 makes the bodies; without the argument stat a failure ends the program with the library's own words.
  call context%create()
  call sphere%create(context, ROLLCON_BODY_HALFSPACE)
  call plane%create(context, ROLLCON_BODY_RIGID)

  ! Step 2 gives the gap between them; the library makes the mesh of the contact, its frame, to fit.
  call contact%create(context, sphere, plane)
  call contact%set_gap_quadratic(1/(2*radius), 1/(2*radius), 0.0_rc_real)

  ! Step 3 sets the materials.
  call sphere%set_elastic(young, poisson)
  call contact%set_friction('coulomb', [mu])

  ! Step 4 sets creepages and loads.
  call contact%set_rolling(speed)
  call contact%set_creep(0.0_rc_real, 0.0_rc_real, 0.0_rc_real)
  call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, load)
  call contact%prescribe(ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, traction_force)

  ! Step 5 solves.
  call contact%solve(stat=status)
  if (status < 0) error stop 'no solution'

  ! Step 6 reads the results.
  call contact%get_resultant(force, moment)
  call contact%get_motion(approach, creep)
  call contact%get_tractions(t)
  call contact%get_node_states(state)
  call print_integers('status', [status])
  call print_numbers('force', force)
  call print_numbers('moment', moment)
  call print_numbers('approach', [approach])
  call print_numbers('creepages', creep)
  call print_numbers('max pressure', [maxval(-t(3, :))])
  call print_integers('stick slip rim', [count(state == ROLLCON_STICK), count(state == ROLLCON_SLIP), &
    count(state == ROLLCON_EXCLUDED)])
  call print_numbers('centre', t(:, (size(t, 2) + 1)/2))
  deallocate (t, state)

contains

  !> Prints six digits; what is zero up to rounding is printed as zero.
  subroutine print_numbers(name, v)
    character(len=*), intent(in) :: name
    real(rc_real), intent(in) :: v(:)
    character(len=13) :: field(3)
    integer :: m
    do m = 1, size(v)
      if (abs(v(m)) < 5e-7_rc_real) then
        field(m) = '     0.000000'
      else
        write (field(m), '(es13.5)') v(m)
      end if
    end do
    write (*, '(a14, 3a13)') [character(len=14) :: name], field(1:size(v))
  end subroutine

  subroutine print_integers(name, v)
    character(len=*), intent(in) :: name
    integer, intent(in) :: v(:)
    write (*, '(a14, 3i13)') [character(len=14) :: name], v
  end subroutine

end program six_steps
