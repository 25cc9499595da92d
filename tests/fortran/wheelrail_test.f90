!> Runs a wheel on its rail over the library itself from both Fortran layers: the Manchester benchmark at y = 2 mm,
!> where CONTACT has 9799 N, and results of both layers that agree. Units are mm, N, s.
program wheelrail_test
  use rollcon
  implicit none
  real(rc_real), parameter :: load = 9799, cant = atan(1/40.0_rc_real)
  real(rc_real), parameter :: position(6) = [0.0_rc_real, 2.0_rc_real, 0.1529_rc_real, -1.128e-4_rc_real, &
    4.8e-3_rc_real, 0.0_rc_real]
  real(rc_real), parameter :: velocity(6) = [2000.0_rc_real, 0.0_rc_real, 0.0_rc_real, 0.0_rc_real, 0.0_rc_real, &
    -4.3459197_rc_real]
  integer :: failures = 0
  type(rc_context) :: context
  type(rc_body) :: wheel, rail
  real(rc_real) :: force(3)

  call context%create()
  call make(wheel, 's1002')
  call make(rail, '60e1')
  call by_2008()
  call by_77()
  call geometry()
  if (failures > 0) error stop 1

contains

  subroutine demand(ok, what)
    logical, intent(in) :: ok
    character(len=*), intent(in) :: what
    if (ok) return
    failures = failures + 1
    write (*, '(2a)') 'not so: ', what
  end subroutine

  subroutine make(body, shape)
    type(rc_body), intent(inout) :: body
    character(len=*), intent(in) :: shape
    call body%create(context, ROLLCON_BODY_HALFSPACE)
    call body%set_elastic(2*82000*1.28_rc_real, 0.28_rc_real)
    call body%set_profile_shape(shape, [1.0_rc_real])
  end subroutine

  subroutine by_2008()
    type(rc_wheelrail) :: right
    type(rc_contact) :: contact
    real(rc_real) :: moment(3), normal, of_patch(3)
    character(len=:), allocatable :: name
    character(len=200) :: message
    integer :: n, stat
    call right%create(context, wheel, rail, ROLLCON_RIGHT)
    call right%solve(stat, message)
    call demand(stat == ROLLCON_ERR_STATE .and. index(message, 'set_track') > 0, 'the missing call has a name')
    call right%set_track(1435.0_rc_real, 14.0_rc_real, cant)
    call right%set_wheelset(1360.0_rc_real, -70.0_rc_real, 460.0_rc_real)
    call right%set_position(position)
    call right%set_velocity(velocity)
    call right%set_friction('coulomb', [0.3_rc_real])
    call right%solve()
    call right%get_patch_count(n)
    call demand(n == 1, 'one patch')
    call right%get_patch_stat(1, 'normal_force', normal)
    write (*, '(a, f8.1, a)') 'normal force: ', normal, ' N (bound 9799 within 1 %)'
    call demand(abs(normal - load) < 0.01_rc_real*load, 'normal force')
    call right%get_patch_stat(2, 'normal_force', normal, stat)
    call demand(stat == ROLLCON_ERR_ARGUMENT, 'there is no second patch')
    call right%get_resultant(force, moment)
    call right%get_contact(1, contact)
    call right%free()
    call contact%get_resultant(of_patch, moment)
    call demand(abs(norm2(of_patch) - norm2(force)) < 1e-9_rc_real*load, 'the contact outlives the wheel on its rail')
    call rc_stat_info(ROLLCON_OF_WHEELRAIL, 1, name)
    call demand(name == 'z' .and. rc_stat_count(ROLLCON_OF_PATCH) > rc_stat_count(ROLLCON_OF_WHEELRAIL), 'names of statistics')
  end subroutine

  !> Checks the rigid geometry of a wheelset, by both layers.
  subroutine geometry()
    external :: rcwpts, rcwcnc
    type(rc_wheelrail) :: left, right
    real(rc_real), allocatable :: points(:, :), conicity(:), wavelength(:)
    double precision :: p(3, 2), c(1), w(1)
    integer :: ierr, stat
    call left%create(context, wheel, rail, ROLLCON_LEFT)
    call right%create(context, wheel, rail, ROLLCON_RIGHT)
    call left%find_contact_points(right, [0.0_rc_real], 'z', points, stat)
    call demand(stat == ROLLCON_ERR_STATE, 'dimensions are missing')
    call left%set_track(1435.0_rc_real, 14.0_rc_real, cant)
    call left%set_wheelset(1360.0_rc_real, -70.0_rc_real, 460.0_rc_real)
    call right%set_track(1435.0_rc_real, 14.0_rc_real, cant)
    call right%set_wheelset(1360.0_rc_real, -70.0_rc_real, 460.0_rc_real)
    call left%find_contact_points(right, [-2.0_rc_real, 2.0_rc_real], 'radius_difference left_y right_y', points)
    call demand(all(shape(points) == [3, 2]) .and. abs(points(1, 1) + points(1, 2)) < 1e-9_rc_real, 'odd difference')
    call demand(abs(points(2, 1) + points(3, 2)) < 1e-9_rc_real, 'mirrored points')
    call left%find_conicity(right, [3.0_rc_real], conicity, wavelength)
    write (*, '(a, f8.5, a)') 'conicity at 3 mm: ', conicity(1), ' (bound 0.18 within 0.002)'
    call demand(abs(conicity(1) - 0.18_rc_real) < 2e-3_rc_real, 'conicity')
    call rcwpts(left%id(), right%id(), 2, [-2d0, 2d0], 'RADIUS_DIFFERENCE LEFT_Y RIGHT_Y', p, ierr)
    call demand(ierr == 0 .and. all(p == points), 'RCWPTS')
    call rcwcnc(left%id(), right%id(), 1, [3d0], c, w, ierr)
    call demand(ierr == 0 .and. c(1) == conicity(1) .and. w(1) == wavelength(1), 'RCWCNC')
  end subroutine

  subroutine by_77()
    external :: rcwhel, rcwtrk, rcwset, rcwpos, rcwvel, rcwfri, rcwslv, rcwres, rcwnpa, rcwcon, rcwpst, rcfree, rcresu
    integer :: iwr, icon, ierr, n
    double precision :: f(3), m(3), x
    call rcwhel(context%id(), wheel%id(), rail%id(), 1, iwr, ierr)
    call demand(ierr == 0 .and. iwr > 0, 'RCWHEL')
    call rcwtrk(iwr, 1435d0, 14d0, dble(cant), ierr)
    call rcwset(iwr, 1360d0, -70d0, 460d0, ierr)
    call rcwpos(iwr, dble(position), ierr)
    call rcwvel(iwr, dble(velocity), ierr)
    call rcwfri(iwr, 'coulomb', 1, [0.3d0], ierr)
    call rcwslv(iwr, ierr)
    call demand(ierr == 0, 'RCWSLV')
    call rcwnpa(iwr, n, ierr)
    call demand(n == 1, 'RCWNPA')
    call rcwres(iwr, 0, f, m, ierr)
    call demand(ierr == 0 .and. norm2(f - force) < 1d-9*load, 'the same force from both layers')
    call rcwpst(iwr, 0, 'X', x, ierr)
    call demand(ierr == ROLLCON_ERR_ARGUMENT, 'patches count from 1')
    call rcwpst(iwr, 1, 'X', x, ierr)
    call demand(abs(x + 3.368d0) < 0.01d0, 'RCWPST')
    call rcwcon(iwr, 1, icon, ierr)
    call rcfree(iwr, ierr)
    call demand(ierr == 0 .and. iwr == 0, 'RCFREE')
    call rcresu(icon, 0, f, m, ierr)
    call demand(ierr == 0 .and. abs(norm2(f) - norm2(force)) < 1d-9*load, 'RCWCON')
    call rcfree(icon, ierr)
  end subroutine
end program
