program first_contact
  use rollcon
  implicit none
  type(rc_context) :: context
  type(rc_body) :: wheel, rail
  type(rc_contact) :: contact
  real(rc_real) :: force(3), moment(3), pressure, approach, creep(3)

  call context%create()                     ! a failure without stat= stops with the library's words
  call wheel%create(context, ROLLCON_BODY_HALFSPACE)
  call rail%create(context, ROLLCON_BODY_HALFSPACE)
  call wheel%set_elastic(210e3_rc_real, 0.28_rc_real)
  call rail%set_elastic(210e3_rc_real, 0.28_rc_real)
  call contact%create(context, wheel, rail)
  call contact%set_gap_quadratic(1/920.0_rc_real, 1/600.0_rc_real, 0.0_rc_real)
  call contact%set_friction('coulomb', [0.3_rc_real])
  call contact%set_rolling(20e3_rc_real)
  call contact%set_creep(-0.001_rc_real, 0.0_rc_real, 0.0_rc_real)
  call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, 80e3_rc_real)
  call contact%solve()
  call contact%get_resultant(force, moment)
  call contact%get_motion(approach, creep)
  call contact%get_stat('max_pressure', pressure)
  print '(a, i0, a, i0, a, f6.4, a)', 'driving force ', nint(force(1)), ' N, largest pressure ', nint(pressure), &
    ' MPa, approach ', approach, ' mm'
end program
