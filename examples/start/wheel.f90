program wheel_on_rail
  use rollcon
  implicit none
  type(rc_context) :: context
  type(rc_body) :: body(2)
  type(rc_wheelrail) :: wheel
  character(len=5) :: profile(2) = ['s1002', '60e1 ']
  real(rc_real) :: force(3), moment(3), position(6) = 0
  integer :: patches
  integer :: i

  call context%create()
  do i = 1, 2
    call body(i)%create(context, ROLLCON_BODY_HALFSPACE)
    call body(i)%set_elastic(210e3_rc_real, 0.28_rc_real)
    call body(i)%set_profile_shape(trim(profile(i)), [1.0_rc_real])  ! a millimetre
  end do
  call wheel%create(context, body(1), body(2), ROLLCON_RIGHT)
  call wheel%set_track(1435.0_rc_real, 14.0_rc_real, atan(1/40.0_rc_real))
  call wheel%set_wheelset(1360.0_rc_real, -70.0_rc_real, 460.0_rc_real)
  call wheel%set_friction('coulomb', [0.3_rc_real])
  call wheel%prescribe_vertical(ROLLCON_BY_FORCE, 80e3_rc_real)
  call wheel%set_velocity([20e3_rc_real, 0.0_rc_real, 0.0_rc_real, 0.0_rc_real, 0.0_rc_real, -20e3_rc_real/460])
  print '(a)', '   y  patches   Fx, kN   Fy, kN   Fz, kN'
  do i = 0, 6, 2
    position(2) = i
    call wheel%set_position(position)
    call wheel%solve()
    call wheel%get_resultant(force, moment)
    call wheel%get_patch_count(patches)
    print '(i4, i9, 3f9.2)', i, patches, force/1000
  end do
end program
