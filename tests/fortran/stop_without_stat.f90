!> Must print the library's message and end with an error at a failure without the argument stat.
program stop_without_stat
  use rollcon
  implicit none
  type(rc_context) :: context
  type(rc_body) :: body
  call context%create()
  call body%create(context, ROLLCON_BODY_HALFSPACE)
  call body%set_elastic(-1.0_rc_real, 0.3_rc_real)
  write (*, '(a)') 'not reached'
end program stop_without_stat
