!> Tests the life of objects behind Fortran variables: assignment adds a reference, free and the end of a variable's
!> life drop it.
module reference_cases
  use, intrinsic :: iso_c_binding, only: c_ptr
  use rollcon
  implicit none
  private
  public :: run

  type :: wheel
    integer :: number = 0
    type(rc_body) :: body
  end type

  type(rc_context) :: context
  integer :: failures = 0

contains

  logical function alive(p)
    type(c_ptr), intent(in) :: p
    alive = rollcon_id_of(p) /= 0
  end function

  subroutine demand(ok, what)
    logical, intent(in) :: ok
    character(len=*), intent(in) :: what
    if (ok) return
    failures = failures + 1
    write (*, '(2a)') 'wrong: ', what
  end subroutine

  subroutine local_variable(p)
    type(c_ptr), intent(out) :: p
    type(rc_body) :: b
    call b%create(context, ROLLCON_BODY_RIGID)
    p = b%handle()
    call demand(alive(p), 'alive in its scope')
  end subroutine

  subroutine local_contact(p)
    type(c_ptr), intent(out) :: p
    type(rc_body) :: a, b
    type(rc_contact) :: c
    call a%create(context, ROLLCON_BODY_HALFSPACE)
    call b%create(context, ROLLCON_BODY_RIGID)
    call c%create(context, a, b)
    p = c%handle()
  end subroutine

  subroutine local_copy(b)
    type(rc_body), intent(in) :: b
    type(rc_body) :: copy
    copy = b
    call demand(copy%id() == b%id(), 'a copy is the same object')
  end subroutine

  subroutine local_component(p)
    type(c_ptr), intent(out) :: p
    type(wheel) :: w
    call w%body%create(context, ROLLCON_BODY_RIGID)
    p = w%body%handle()
  end subroutine

  subroutine local_array(p)
    type(c_ptr), intent(out) :: p(3)
    type(rc_body) :: b(3)
    type(rc_body), allocatable :: copies(:)
    integer :: i
    do i = 1, 3
      call b(i)%create(context, ROLLCON_BODY_RIGID)
      p(i) = b(i)%handle()
    end do
    allocate (copies(3))
    copies = b
    call b%free()
    call demand(alive(p(1)) .and. alive(p(2)) .and. alive(p(3)), 'array assignment adds references')
    deallocate (copies)
    call demand(.not. (alive(p(1)) .or. alive(p(2)) .or. alive(p(3))), 'deallocation drops references')
    call b(1)%create(context, ROLLCON_BODY_RIGID)
    p(1) = b(1)%handle()
  end subroutine

  subroutine run()
    type(rc_body) :: a, b
    type(rc_contact) :: c, d
    type(rc_context) :: other
    type(c_ptr) :: p, q, many(3)
    integer :: stat, i
    character(len=400) :: message

    call context%create()
    call local_variable(p)
    call demand(.not. alive(p), 'a variable that goes out of scope drops its reference')
    call local_contact(p)
    call demand(.not. alive(p), 'so does a contact')
    call local_component(p)
    call demand(.not. alive(p), 'so does a component')
    call local_array(many)
    call demand(.not. alive(many(1)), 'so does an array')

    call a%create(context, ROLLCON_BODY_HALFSPACE)
    p = a%handle()
    call local_copy(a)
    call demand(alive(p), 'the end of a copy leaves the original alone')
    a = a
    call demand(alive(p), 'self-assignment')
    b = a
    call a%free()
    call a%free()
    call demand(alive(p), 'the copy keeps the object')
    call b%set_elastic(1e4_rc_real, 0.3_rc_real)
    call a%create(context, ROLLCON_BODY_RIGID)
    q = a%handle()
    call c%create(context, b, a)
    b = a
    call demand(alive(q), 'a second name for the rigid body')
    call a%free()
    call b%free()
    call c%set_friction('coulomb', [0.1_rc_real], stat)
    call demand(stat == ROLLCON_OK, 'a contact keeps its bodies')
    d = c
    call d%from_id(c%id())
    call c%free()
    call d%set_rolling(-1.0_rc_real, stat, message)
    call demand(stat == ROLLCON_ERR_ARGUMENT, 'the other name of the contact works')
    p = d%handle()
    other = context
    q = other%handle()
    call context%free()
    call other%free()
    call d%set_rolling(-2.0_rc_real, stat, message)
    call demand(index(message, 'rollcon_contact_set_rolling') > 0, 'texts of failures outlive the names of the context')
    call d%free()
    call demand(.not. alive(p), 'the contact is gone')
    call demand(.not. alive(q), 'and with it the context')

    ! Leaks would use up the 65536 slots for handles.
    call context%create()
    do i = 1, 100000
      call local_variable(p)
    end do
    call context%free()
    write (*, '(i0, a)') failures, ' failures'
    if (failures > 0) error stop 1
  end subroutine

end module reference_cases

program references_test
  use reference_cases, only: run
  implicit none
  call run()
end program references_test
