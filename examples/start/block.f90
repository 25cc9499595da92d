program block_and_ball
  use rollcon
  implicit none
  integer, parameter :: wp = rc_real
  type(rc_context) :: context
  type(rc_body) :: block, ball
  type(rc_contact) :: contact
  integer(rc_int), allocatable :: bottom(:)
  real(wp) :: force(3), moment(3), pressure, approach, creep(3)

  call context%create()
  call block%create(context, ROLLCON_BODY_FEM)
  call block%read_mesh('block.inp', '')
  call block%tag_group('steel', 1)
  call block%set_elastic(1e4_wp, 0.3_wp, tag=1)
  call block%get_group_nodes('bottom', bottom)
  call block%set_support(bottom)
  call block%tag_group('top', 2)
  call block%set_contact_faces([2])
  call ball%create(context, ROLLCON_BODY_RIGID)
  call contact%create(context, block, ball)
  call contact%frame_rectangle(ROLLCON_QUAD4, 12, 12, -5.0_wp, 5.0_wp, -5.0_wp, 5.0_wp)
  call contact%set_gap_quadratic(1/400.0_wp, 1/400.0_wp, 0.0_wp)
  call contact%set_friction('coulomb', [0.3_wp])
  call contact%set_rolling(10.0_wp)
  call contact%set_creep(-0.002_wp, 0.0_wp, 0.0_wp)
  call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, 1500.0_wp)
  call contact%solve()
  call contact%get_resultant(force, moment)
  call contact%get_motion(approach, creep)
  call contact%get_stat('max_pressure', pressure)
  print '(a, f0.1, a, f6.4, a, i0, a)', 'largest pressure ', pressure, ' MPa, approach ', approach, &
    ' mm, friction ', nint(force(1)), ' N'
end program
