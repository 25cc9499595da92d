!> A prepared body saved and loaded from Fortran 2008; built with trapping of invalid operations, divisions by zero and
!> overflows, which no call may trigger in the caller.
program saved_body
  use, intrinsic :: iso_fortran_env, only: int64
  use rollcon
  implicit none
  type(rc_context) :: context, other
  type(rc_body) :: cube, again
  real(rc_real) :: x(3, 8), count
  real(rc_real), allocatable :: u(:, :), v(:, :)
  integer :: faces(4, 6), f, stat, unit, failures = 0
  integer(int64) :: ticks
  character(len=200) :: message
  character(len=:), allocatable :: path
  character(len=40) :: number

  call system_clock(ticks)
  write (number, '(i0)') ticks
  path = 'saved_body_'//trim(number)//'.rcb'
  x = reshape(real([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1], rc_real), [3, 8])
  faces = reshape([1, 5, 8, 4, 2, 3, 7, 6, 1, 2, 6, 5, 4, 8, 7, 3, 1, 4, 3, 2, 5, 6, 7, 8], [4, 6])
  call context%create()
  call other%create()
  if (rc_has_feature('bem')) then
    call cube%create(context, ROLLCON_BODY_BEM)
    call cube%set_elastic(200.0_rc_real, 0.3_rc_real)
    call cube%set_nodes(x)
    do f = 1, 6
      call cube%add_elements(ROLLCON_QUAD4, faces(:, f:f), f)
    end do
    call cube%set_support([1, 2, 3, 4], ROLLCON_DOF_X + ROLLCON_DOF_Y + ROLLCON_DOF_Z)
    call cube%set_pressure(6, 2.0_rc_real)
    call cube%save(path)
    call again%load(other, path)
    call again%get_stat('factorizations', count)
    call demand(nint(count) == 0, 'nothing is factorised')
    call again%get_stat('loaded', count)
    call demand(nint(count) == 1, 'it is from a file')
    call cube%get_displacements(u)
    call again%get_displacements(v)
    call demand(all(abs(u - v) <= 0), 'the same displacements')
    call demand(maxval(abs(u)) > 0, 'there are displacements')
    open (newunit=unit, file=path, status='old')
    close (unit, status='delete')
  end if
  message = ''
  call again%load(other, path, stat, message)
  call demand(stat == ROLLCON_ERR_IO .and. index(message, path) > 0, 'the text names the missing file')
  call again%save(path, stat)
  call demand(stat /= ROLLCON_OK, 'a body that was not loaded cannot be saved')
  call cube%create(context, ROLLCON_BODY_RIGID)
  call cube%save('no/such/folder/'//path, stat, message)
  call demand(stat == ROLLCON_ERR_IO, 'there is no such folder')
  write (*, '(i0, a)') failures, ' failures'
  if (failures > 0) error stop 1
  ! A main program's own are not freed at its end.
  if (allocated(u)) deallocate (u, v)
  deallocate (path)

contains

  subroutine demand(ok, what)
    logical, intent(in) :: ok
    character(len=*), intent(in) :: what
    if (ok) return
    failures = failures + 1
    write (*, '(3a)') 'wrong: ', what, trim(message)
  end subroutine

end program
