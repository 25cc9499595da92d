!> A wheel on its rail: what the generated type rc_wheelrail_plain does not have.
module rollcon_wheelrail
  use, intrinsic :: iso_c_binding, only: c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_contact
  use rollcon_wheelrail_plain
  implicit none
  private
  public :: rc_wheelrail

  type, extends(rc_wheelrail_plain) :: rc_wheelrail
  contains
    procedure :: get_contact
  end type

contains

  !> The contact of a patch, counted from 1: to be read; the next solve of the wheel on its rail changes it.
  subroutine get_contact(self, patch, contact, stat, errmsg)
    class(rc_wheelrail), intent(in) :: self
    integer, intent(in) :: patch
    type(rc_contact), intent(inout) :: contact
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    integer :: kept
    call contact%free()
    p = c_null_ptr
    status = rollcon_wheelrail_get_contact(self%handle(), int(patch - 1, rc_int), p)
    if (status == ROLLCON_OK) then
      call contact%from_id(int(rollcon_id_of(p)), kept)  ! a reference of its own
      call rollcon_contact_release(p)
    end if
    call finish(status, self%handle(), 'rc_wheelrail%get_contact', stat, errmsg)
  end subroutine

end module rollcon_wheelrail
