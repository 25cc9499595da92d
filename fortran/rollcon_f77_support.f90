!> Serves the FORTRAN 77 layer: integers to handles and back, blank-padded texts, and callbacks.
module rollcon_f77_support
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_funloc, c_int32_t, c_int64_t, c_loc, &
    c_null_char, c_null_funptr, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_f77_names
  use rollcon_support, only: c_text, f_text, f_text_at, nodes_of
  implicit none
  public

  abstract interface
    subroutine progress_77(phase, iteration, residual, seconds, cancel)
      integer :: phase, iteration, cancel
      double precision :: residual, seconds
    end subroutine
    subroutine log_77(level, text)
      integer :: level
      character(len=*) :: text
    end subroutine
  end interface

  !> Holds a caller's subroutine, which C finds again through the address of this box. Boxes live as long as the
  !> program: an object has the address for as long as it lives itself. Each handle has one box.
  type :: box
    integer(c_int32_t) :: id = 0
    procedure(progress_77), pointer, nopass :: progress => null()
    procedure(log_77), pointer, nopass :: log => null()
    type(box), pointer :: next => null()
  end type
  type(box), pointer, save, private :: boxes => null()

  integer(c_int32_t), parameter, private :: no_result = -huge(1_c_int32_t)
  integer, parameter :: of_none = 0, of_context = 1, of_body = 2, of_contact = 3, of_wheelrail = 4, of_table = 5

contains

  !> Numbers that do not fit 32 bits name nothing: -1 does not either.
  integer(c_int32_t) function narrow(i)
    integer, intent(in) :: i
    if (abs(real(i, c_double)) > real(huge(narrow), c_double)) then
      narrow = -1_c_int32_t
    else
      narrow = int(i, c_int32_t)
    end if
  end function

  type(c_ptr) function context_of(id)
    integer, intent(in) :: id
    context_of = rollcon_context_from_id(narrow(id))
  end function

  type(c_ptr) function body_of(id)
    integer, intent(in) :: id
    body_of = rollcon_body_from_id(narrow(id))
  end function

  type(c_ptr) function contact_of(id)
    integer, intent(in) :: id
    contact_of = rollcon_contact_from_id(narrow(id))
  end function

  type(c_ptr) function wheelrail_of(id)
    integer, intent(in) :: id
    wheelrail_of = rollcon_wheelrail_from_id(narrow(id))
  end function

  type(c_ptr) function table_of(id)
    integer, intent(in) :: id
    table_of = rollcon_table_from_id(narrow(id))
  end function

  !> Returns what the handle stands for, which is in the highest bits of its number.
  integer function kind_of(id)
    integer, intent(in) :: id
    kind_of = of_none
    if (id <= 0) return
    if (rollcon_id_of(context_of(id)) == id) kind_of = id/2**28
  end function

  !> Returns a name of the library: NUL-terminated, in lower case whatever the caller's is, without trailing blanks.
  pure function c_name(text) result(copy)
    character(len=*), intent(in) :: text
    character(kind=c_char) :: copy(len_trim(text) + 1)
    integer :: i
    copy = c_text(text)
    do i = 1, size(copy) - 1
      if (lge(copy(i), 'A') .and. lle(copy(i), 'Z')) copy(i) = achar(iachar(copy(i)) + 32)
    end do
  end function

  !> Makes "what number rule", which is wrong, the last error, for log and latch of the handle's context too.
  subroutine refuse(handle, what, number, rule, ierr)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: what, rule
    integer, intent(in) :: number
    integer, intent(out) :: ierr
    character(len=24) :: digits
    write (digits, '(i0)') number
    ierr = rollcon_report(handle, ROLLCON_ERR_ARGUMENT, c_text(what//' '//trim(digits)//rule))
  end subroutine

  subroutine no_memory(handle, name, ierr)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: name
    integer, intent(out) :: ierr
    ierr = rollcon_report(handle, ROLLCON_ERR_MEMORY, c_text(name//': out of memory'))
  end subroutine

  subroutine no_handle(name, id, ierr)
    character(len=*), intent(in) :: name
    integer, intent(in) :: id
    integer, intent(out) :: ierr
    ierr = ROLLCON_ERR_HANDLE
    if (id == 0) ierr = ROLLCON_ERR_ARGUMENT
    ierr = rollcon_report(c_null_ptr, int(ierr, c_int32_t), c_text(name//': IH is no live handle'))
  end subroutine

  !> Serves INTEGERs of the caller's width like nodes_of.
  pure integer function nodes_77(type)
    integer, intent(in) :: type
    nodes_77 = 0
    if (type > 0 .and. type < 1000) nodes_77 = int(nodes_of(int(type, c_int32_t)))
  end function

  !> Packs the node numbers of N elements without gaps between them.
  subroutine pack_77(handle, name, itype, n, ic, ldc, packed, ierr)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: name
    integer, intent(in) :: itype, n, ldc
    integer, intent(in) :: ic(max(ldc, 1), *)
    integer(c_int32_t), allocatable, intent(out) :: packed(:, :)
    integer, intent(out) :: ierr
    character(len=24) :: least
    integer :: i, j, npe, no_room
    npe = nodes_77(itype)
    ierr = ROLLCON_OK
    write (least, '(i0)') npe
    if (ldc < npe) call refuse(handle, name//': LDC is', ldc, '; allowed for this type: '//trim(least)//' or more', ierr)
    if (ierr == ROLLCON_OK .and. n < 0) call refuse(handle, name//': N is', n, '; allowed: 0 or more', ierr)
    if (ierr /= ROLLCON_OK) return
    allocate (packed(npe, n), stat=no_room)
    if (no_room /= 0) then
      call no_memory(handle, name, ierr)
      return
    end if
    do j = 1, n
      do i = 1, npe
        packed(i, j) = narrow(ic(i, j))
      end do
    end do
  end subroutine

  !> Packs the N numbers of a list.
  subroutine pack_list_77(handle, name, n, list, packed, ierr)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: name
    integer, intent(in) :: n
    integer, intent(in) :: list(*)
    integer(c_int32_t), allocatable, intent(out) :: packed(:)
    integer, intent(out) :: ierr
    integer :: i
    ierr = ROLLCON_OK
    if (n < 0) then
      call refuse(handle, name//': N is', n, '; allowed: 0 or more', ierr)
      return
    end if
    call room_77(handle, name, n, packed, ierr)
    if (ierr /= ROLLCON_OK) return
    do i = 1, n
      packed(i) = narrow(list(i))
    end do
  end subroutine

  !> Makes room for N results, none of which is there yet.
  subroutine room_77(handle, name, n, room, ierr)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: name
    integer, intent(in) :: n
    integer(c_int32_t), allocatable, intent(out) :: room(:)
    integer, intent(out) :: ierr
    integer :: no_room
    ierr = ROLLCON_OK
    allocate (room(max(n, 0)), stat=no_room)
    if (no_room /= 0) then
      call no_memory(handle, name, ierr)
    else
      room = no_result
    end if
  end subroutine

  !> Gives the results that are there.
  subroutine give_integers(from, to)
    integer(c_int32_t), intent(in) :: from(:)
    integer, intent(inout) :: to(*)
    integer :: i
    do i = 1, size(from)
      if (from(i) /= no_result) to(i) = int(from(i))
    end do
  end subroutine

  !> Gives the buffer's text, padded with blanks; ROLLCON_ERR_CAPACITY (and the beginning of the text) if it is longer.
  subroutine give_text(handle, name, buffer, text, status)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: name
    character(kind=c_char), intent(in) :: buffer(:)
    character(len=*), intent(out) :: text
    integer, intent(inout) :: status
    character(len=:), allocatable :: whole
    character(len=80) :: why
    whole = f_text(buffer)
    text = whole
    if (len(whole) <= len(text) .or. status < 0) return
    write (why, '(a, i0, a, i0)') ': the text has ', len(whole), ' characters; there is room for ', len(text)
    status = rollcon_report(handle, ROLLCON_ERR_CAPACITY, c_text(name//trim(why)))
  end subroutine

  function box_of(id) result(b)
    integer, intent(in) :: id
    type(box), pointer :: b
    b => boxes
    do while (associated(b))
      if (b%id == narrow(id)) return
      b => b%next
    end do
    allocate (b)
    b%id = narrow(id)
    b%next => boxes
    boxes => b
  end function

  function call_progress(event, user) result(cancel) bind(c, name='rollcon_f77_progress')
    type(c_ptr), value :: event, user
    integer(c_int32_t) :: cancel
    type(box), pointer :: b
    integer(c_int64_t) :: phase, iteration
    real(c_double) :: residual, seconds
    integer :: stop_now
    phase = 0
    iteration = 0
    residual = 0
    seconds = 0
    cancel = rollcon_event_get_int(event, ROLLCON_EVENT_PHASE, phase)
    cancel = rollcon_event_get_int(event, ROLLCON_EVENT_ITERATION, iteration)
    cancel = rollcon_event_get_real(event, ROLLCON_EVENT_RESIDUAL, residual)
    cancel = rollcon_event_get_real(event, ROLLCON_EVENT_SECONDS, seconds)
    call c_f_pointer(user, b)
    stop_now = 0
    call b%progress(int(phase), int(iteration), residual, seconds, stop_now)
    cancel = 0
    if (stop_now /= 0) cancel = 1
  end function

  subroutine call_log(level, message, user) bind(c, name='rollcon_f77_log')
    integer(c_int32_t), value :: level
    type(c_ptr), value :: message, user
    type(box), pointer :: b
    call c_f_pointer(user, b)
    call b%log(int(level), f_text_at(message))
  end subroutine

end module rollcon_f77_support
