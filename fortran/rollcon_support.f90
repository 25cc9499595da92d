!> Holds what the types of rollcon's Fortran layers have in common: texts to and from C, and one rule for failures.
module rollcon_support
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int32_t, c_int64_t, c_null_char, &
    c_null_ptr, c_ptr
  use, intrinsic :: iso_fortran_env, only: error_unit
  use rollcon_c
  implicit none
  private

  integer, parameter, public :: rc_int = c_int32_t, rc_long = c_int64_t, rc_real = c_double

  !> This room holds nearly every text of the library; longer ones are asked for a second time.
  integer(rc_long), parameter, public :: usual_text = 4096_rc_long  ! every name and meaning is shorter

  public :: c_text, f_text, f_text_at, finish, nodes_of, is_volume_type, narrow_ids, words
  public :: rc_last_error, rc_last_caveat, rc_version, rc_abi, rc_version_string, rc_build_info, rc_has_feature, rc_status_string

contains

  !> Returns a NUL-terminated copy, without trailing blanks.
  pure function c_text(text) result(copy)
    character(len=*), intent(in) :: text
    character(kind=c_char) :: copy(len_trim(text) + 1)
    integer :: i
    do i = 1, len_trim(text)
      copy(i) = text(i:i)
    end do
    copy(len_trim(text) + 1) = c_null_char
  end function

  !> Returns the number of words, separated by blanks.
  pure integer(rc_long) function words(text)
    character(len=*), intent(in) :: text
    logical :: inside
    integer :: i
    words = 0
    inside = .false.
    do i = 1, len(text)
      if (text(i:i) /= ' ' .and. .not. inside) words = words + 1
      inside = text(i:i) /= ' '
    end do
  end function

  !> Returns the text in a buffer, up to its NUL.
  pure function f_text(buffer) result(text)
    character(kind=c_char), intent(in) :: buffer(:)
    character(len=:), allocatable :: text
    integer :: i, n
    n = 0
    do while (n < size(buffer))
      if (buffer(n + 1) == c_null_char) exit
      n = n + 1
    end do
    allocate (character(len=n) :: text)
    do i = 1, n
      text(i:i) = buffer(i)
    end do
  end function

  !> Returns a copy of a text that the library owns.
  function f_text_at(address) result(text)
    type(c_ptr), intent(in) :: address
    character(len=:), allocatable :: text
    integer, parameter :: longest = 65536
    character(kind=c_char), pointer :: buffer(:)
    integer :: i, n
    n = 0
    if (c_associated(address)) then
      call c_f_pointer(address, buffer, [longest])
      do while (n < longest)
        if (buffer(n + 1) == c_null_char) exit
        n = n + 1
      end do
    end if
    allocate (character(len=n) :: text)
    do i = 1, n
      text(i:i) = buffer(i)
    end do
  end function

  !> Applies the rule of every call: `stat`, if present, gets the status; if it is absent, a failure (status < 0) prints
  !> the message and stops. `errmsg` gets the message of a failure, cut or padded to its length, and is left alone
  !> otherwise.
  subroutine finish(status, context, what, stat, errmsg, message)
    integer(rc_int), intent(in) :: status
    type(c_ptr), intent(in) :: context
    character(len=*), intent(in) :: what
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(len=*), intent(in), optional :: message
    character(len=:), allocatable :: text
    integer(rc_int) :: ignored
    if (present(stat)) stat = int(status)
    if (present(message)) ignored = rollcon_report(context, status, c_text(what//': '//message))
    if (status >= 0 .or. (present(stat) .and. .not. present(errmsg))) return
    text = f_text_at(rollcon_last_error())
    if (present(errmsg)) errmsg = text
    if (present(stat)) return
    write (error_unit, '(2a)') 'rollcon: ', text
    error stop 1
  end subroutine

  !> Returns the nodes of one element; 0 for types that the library does not know.
  pure integer function nodes_of(type)
    integer(rc_int), intent(in) :: type
    select case (type)
    case (ROLLCON_TRI3)
      nodes_of = 3
    case (ROLLCON_TRI6)
      nodes_of = 6
    case (ROLLCON_QUAD4)
      nodes_of = 4
    case (ROLLCON_QUAD8)
      nodes_of = 8
    case (ROLLCON_QUAD9)
      nodes_of = 9
    case (ROLLCON_TET4)
      nodes_of = 4
    case (ROLLCON_TET10)
      nodes_of = 10
    case (ROLLCON_WEDGE6)
      nodes_of = 6
    case (ROLLCON_WEDGE15)
      nodes_of = 15
    case (ROLLCON_HEX8)
      nodes_of = 8
    case (ROLLCON_HEX20)
      nodes_of = 20
    case default
      nodes_of = 0
    end select
  end function

  pure logical function is_volume_type(type)
    integer(rc_int), intent(in) :: type
    select case (type)
    case (ROLLCON_TET4, ROLLCON_TET10, ROLLCON_WEDGE6, ROLLCON_WEDGE15, ROLLCON_HEX8, ROLLCON_HEX20)
      is_volume_type = .true.
    case default
      is_volume_type = .false.
    end select
  end function

  !> Returns node ids that fit 32 bits; others become 0, which the library reports as out of range.
  elemental integer(rc_int) function narrow_ids(id)
    integer(rc_long), intent(in) :: id
    narrow_ids = int(merge(id, 0_rc_long, abs(id) <= huge(narrow_ids)), rc_int)
  end function

  !> Returns major * 10000 + minor * 100 + patch of the library that runs.
  integer function rc_version()
    rc_version = int(rollcon_version())
  end function

  integer function rc_abi()
    rc_abi = int(rollcon_abi())
  end function

  function rc_version_string() result(text)
    character(len=:), allocatable :: text
    text = f_text_at(rollcon_version_string())
  end function

  !> Returns licences and options of the library that runs.
  function rc_build_info() result(text)
    character(len=:), allocatable :: text
    text = f_text_at(rollcon_build_info())
  end function

  logical function rc_has_feature(name)
    character(len=*), intent(in) :: name
    rc_has_feature = rollcon_has_feature(c_text(name)) /= 0
  end function

  !> Returns the text of the last failure in this thread.
  function rc_last_error() result(text)
    character(len=:), allocatable :: text
    text = f_text_at(rollcon_last_error())
  end function

  !> Returns the text of the last call in this thread that returned a status above zero.
  function rc_last_caveat() result(text)
    character(len=:), allocatable :: text
    text = f_text_at(rollcon_last_caveat())
  end function

  function rc_status_string(status) result(text)
    integer, intent(in) :: status
    character(len=:), allocatable :: text
    text = f_text_at(rollcon_status_string(int(status, rc_int)))
  end function

end module rollcon_support
