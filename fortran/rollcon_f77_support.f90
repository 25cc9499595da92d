!> What the FORTRAN 77 layer shares: integers to handles and back, blank-padded texts, and callbacks.
module rollcon_f77_support
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_funloc, c_int32_t, c_int64_t, c_loc, &
    c_null_char, c_null_funptr, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support, only: c_text, f_text, f_text_at, nodes_of, usual_text
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

  !> A caller's subroutine, found again by C through the address of this box. Boxes live as long as the program: an
  !> object keeps the address for as long as it lives itself. One box per handle.
  type :: box
    integer(c_int32_t) :: id = 0
    procedure(progress_77), pointer, nopass :: progress => null()
    procedure(log_77), pointer, nopass :: log => null()
    type(box), pointer :: next => null()
  end type
  type(box), pointer, save, private :: boxes => null()

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

  !> As nodes_of, for INTEGERs of the caller's width.
  pure integer function nodes_77(type)
    integer, intent(in) :: type
    nodes_77 = 0
    if (type > 0 .and. type < 1000) nodes_77 = int(nodes_of(int(type, c_int32_t)))
  end function

  !> Node numbers of N elements without gaps between them.
  subroutine pack_77(itype, n, ic, ldc, packed, ierr)
    integer, intent(in) :: itype, n, ldc
    integer, intent(in) :: ic(max(ldc, 1), *)
    integer(c_int32_t), allocatable, intent(out) :: packed(:, :)
    integer, intent(out) :: ierr
    integer :: i, j, npe, no_room
    npe = nodes_77(itype)
    ierr = ROLLCON_ERR_ARGUMENT
    if (ldc < npe .or. n < 0) return
    ierr = ROLLCON_ERR_MEMORY
    allocate (packed(npe, n), stat=no_room)
    if (no_room /= 0) return
    do j = 1, n
      do i = 1, npe
        packed(i, j) = narrow(ic(i, j))
      end do
    end do
    ierr = ROLLCON_OK
  end subroutine

  !> The N numbers of a list.
  subroutine pack_list_77(n, list, packed, ierr)
    integer, intent(in) :: n
    integer, intent(in) :: list(*)
    integer(c_int32_t), allocatable, intent(out) :: packed(:)
    integer, intent(out) :: ierr
    integer :: i, no_room
    ierr = ROLLCON_ERR_ARGUMENT
    if (n < 0) return
    ierr = ROLLCON_ERR_MEMORY
    allocate (packed(n), stat=no_room)
    if (no_room /= 0) return
    do i = 1, n
      packed(i) = narrow(list(i))
    end do
    ierr = ROLLCON_OK
  end subroutine

  !> RCMANY, and the derivatives at an address that may be null.
  subroutine solve_many_77(contact, np, ipar, nc, v, istat, f, xm, appr, creep, d, ierr)
    type(c_ptr), intent(in) :: contact, d
    integer, intent(in) :: np, nc, ipar(*)
    integer, intent(inout) :: istat(*)
    double precision, intent(in) :: v(*)
    double precision, intent(inout), target :: f(*), xm(*), appr(*), creep(*)
    integer, intent(out) :: ierr
    integer(c_int32_t), allocatable :: p(:)
    integer(c_int32_t), allocatable, target :: s(:)
    integer :: i, no_room
    call pack_list_77(np, ipar, p, ierr)
    if (ierr /= ROLLCON_OK) return
    allocate (s(max(nc, 1)), stat=no_room)
    if (no_room /= 0) then
      ierr = ROLLCON_ERR_MEMORY
      return
    end if
    s = 0
    ierr = rollcon_contact_solve_many(contact, narrow(np), p, int(nc, c_int64_t), v, c_text(''), 0_c_int64_t, c_loc(s), &
      c_loc(f), c_loc(xm), c_loc(appr), c_loc(creep), d, c_null_ptr, c_null_ptr)
    if (ierr < 0) return
    do i = 1, nc
      istat(i) = int(s(i))
    end do
  end subroutine

  !> The buffer's text, padded with blanks; ROLLCON_ERR_CAPACITY (and the beginning of the text) if it is longer.
  subroutine give_text(buffer, text, status)
    character(kind=c_char), intent(in) :: buffer(:)
    character(len=*), intent(out) :: text
    integer, intent(inout) :: status
    character(len=:), allocatable :: whole
    whole = f_text(buffer)
    text = whole
    if (len(whole) > len(text) .and. status >= 0) status = ROLLCON_ERR_CAPACITY
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
