program roller_on_ring
  use rollcon
  implicit none
  integer, parameter :: wp = rc_real
  type(rc_context) :: context
  type(rc_body) :: ring, roller
  type(rc_contact) :: contact
  real(wp) :: tilt, pressure, approach, creep(3), rotation(3, 3), along(3) = [0, 1, 0]
  integer :: i

  call context%create()
  call ring%create(context, ROLLCON_BODY_HALFSPACE)
  call ring%set_elastic(208e3_wp, 0.3_wp)
  call ring%set_profile_shape('line', [10.0_wp, 0.0_wp])
  call ring%revolve_profile([0.0_wp, 0.0_wp, -30.0_wp], along, 30.0_wp)
  call roller%create(context, ROLLCON_BODY_HALFSPACE)
  call roller%set_elastic(208e3_wp, 0.3_wp)
  call roller%set_profile_shape('arc', [2000.0_wp, 5.0_wp])
  call roller%revolve_profile([0.0_wp, 0.0_wp, 6.0_wp], along, 6.0_wp)
  call contact%create(context, ring, roller)
  call contact%set_friction('coulomb', [0.05_wp])
  call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, 1500.0_wp)
  print '(a)', 'tilt, mrad  pressure, MPa  approach, um'
  do i = 0, 2
    tilt = 1e-4_wp*i
    rotation = reshape([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, tilt, 0.0_wp, -tilt, 1.0_wp], [3, 3])
    call contact%set_pose(ROLLCON_BODY2, rotation, [0.0_wp, 0.0_wp, 0.0_wp])
    call contact%solve()
    call contact%get_stat('max_pressure', pressure)
    call contact%get_motion(approach, creep)
    print '(f10.1, i15, f14.2)', 1e3*tilt, nint(pressure), 1e3*approach
  end do
end program
