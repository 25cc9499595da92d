!> Tests texts of failures found by the types themselves, and a program that checks once, at its end.
program last_error_test
  use rollcon
  implicit none
  type(rc_context) :: context
  type(rc_body) :: body, none
  integer :: stat, failures = 0
  character(len=300) :: message

  call context%create()
  call demand(rc_last_error() == '', 'no text before the first failure')
  call body%create(context, ROLLCON_BODY_HALFSPACE)
  call body%set_elastic(-1.0_rc_real, 0.3_rc_real, stat=stat, errmsg=message)
  call demand(index(message, 'young is -1') > 0, 'text of the library: '//trim(message))
  call none%set_elastic(1.0_rc_real, 0.3_rc_real, stat=stat, errmsg=message)
  call demand(stat == ROLLCON_ERR_ARGUMENT .and. index(message, 'body is NULL') > 0, 'text without a handle: '//trim(message))
  call body%set_nodes(reshape([0.0_rc_real, 1.0_rc_real], [2, 1]), stat, message)
  call demand(stat == ROLLCON_ERR_ARGUMENT .and. message == 'rc_body%set_nodes: the first extent of x must be 3', &
    'text of the type: '//trim(message))
  call demand(message == rc_last_error(), 'the text of the type is the last error')

  call context%set_latch(1)
  call body%set_elastic(1.0_rc_real, 0.3_rc_real)
  call body%set_nodes(reshape([0.0_rc_real, 1.0_rc_real], [2, 1]), stat)
  call body%set_elastic(-2.0_rc_real, 0.3_rc_real, stat=stat)
  call body%prepare(stat)
  call context%check(stat, message)
  call demand(stat == ROLLCON_ERR_ARGUMENT .and. index(message, 'rc_body%set_nodes') == 1, 'the first failure: '//trim(message))
  call context%set_latch(0)
  call context%check(stat)
  call demand(stat == ROLLCON_OK, 'latch off')
  call body%prepare(stat)
  call demand(stat == ROLLCON_OK, 'the body is as it was before the failure')
  call body%free()
  call context%free()
  if (failures > 0) stop 1

contains

  subroutine demand(good, what)
    logical, intent(in) :: good
    character(len=*), intent(in) :: what
    if (good) return
    write (*, '(2a)') 'not so: ', what
    failures = failures + 1
  end subroutine

end program
