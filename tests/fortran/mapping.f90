!> Serves the tests of the Fortran layers over the recorder (tests/bindings/record.h): what a call wrote down, what it
!> gave, and how it passes on a failure.
module mapping
  use, intrinsic :: iso_c_binding, only: c_ptr
  use rollcon
  use rollcon_support, only: c_text, f_text_at, rc_int
  implicit none
  public

  type(rc_context) :: context
  type(rc_body) :: body, body2
  type(rc_contact) :: contact
  type(rc_wheelrail) :: wheelrail
  type(rc_table) :: table
  integer :: ictx = 0, ibody = 0, ibody2 = 0, icon = 0, iwr = 0, itab = 0, failures = 0, checks = 0

  interface
    function recorder_said(function) result(p) bind(c)
      import
      character(kind=c_char), intent(in) :: function(*)
      type(c_ptr) :: p
    end function
    subroutine recorder_answers(status) bind(c)
      import
      integer(c_int32_t), value :: status
    end subroutine
    function recorder_missing() result(p) bind(c)
      import
      type(c_ptr) :: p
    end function
  end interface
  external :: rcinit, rcbody, rcpair, rcwhel, rctabl

contains

  subroutine begin()
    call context%create()
    call body%create(context, ROLLCON_BODY_FEM)
    call told('body_create', 'context1 1 room', 0)
    call body2%create(context, ROLLCON_BODY_RIGID)
    call contact%create(context, body, body2)
    call told('contact_create', 'context1 body1 body2 room', 0)
    call wheelrail%create(context, body, body2, ROLLCON_LEFT)
    call told('wheelrail_create', 'context1 body1 body2 -1 room', 0)
    call table%create(context)
    call told('table_create', 'context1 room', 0)
  end subroutine

  subroutine begin_77()
    integer :: ierr
    call rcinit(ictx, ierr)
    call rcbody(ictx, 1, ibody, ierr)
    call rcbody(ictx, 4, ibody2, ierr)
    call rcpair(ictx, ibody, ibody2, icon, ierr)
    call rcwhel(ictx, ibody, ibody2, -1, iwr, ierr)
    call rctabl(ictx, itab, ierr)
  end subroutine

  subroutine answers(status)
    integer(rc_int), intent(in) :: status
    call recorder_answers(status)
  end subroutine

  subroutine wrong(what, found, wanted)
    character(len=*), intent(in) :: what, found, wanted
    checks = checks + 1
    if (found == wanted) return
    failures = failures + 1
    write (*, '(6a)') what, ': ', trim(found), ' instead of ', trim(wanted)
  end subroutine

  subroutine told(function, wanted, stat)
    character(len=*), intent(in) :: function, wanted
    integer, intent(in) :: stat
    call wrong(function, f_text_at(recorder_said(c_text(function))), wanted)
    call status_is(function, stat, 0)
  end subroutine

  subroutine status_is(what, stat, wanted)
    character(len=*), intent(in) :: what
    integer, intent(in) :: stat, wanted
    character(len=24) :: digits(2)
    write (digits, '(i0)') stat, wanted
    call wrong(what//', status', digits(1), digits(2))
  end subroutine

  !> Checks that the status and the text of the recorder arrive.
  subroutine failed(function, stat, message)
    character(len=*), intent(in) :: function, message
    integer, intent(in) :: stat
    call status_is(function, stat, int(ROLLCON_ERR_STATE))
    call wrong(function//', message', message, 'text of last_error')
    call answers(ROLLCON_OK)
  end subroutine

  !> Checks a refusal of the layer itself: its words are the last error, by rollcon_report.
  subroutine refused(handle, stat, message, words, status)
    character(len=*), intent(in) :: handle, message, words
    integer, intent(in) :: stat
    integer, intent(in), optional :: status
    integer :: wanted
    character(len=24) :: digits
    wanted = ROLLCON_ERR_ARGUMENT
    if (present(status)) wanted = status
    write (digits, '(i0)') wanted
    call status_is(words, stat, wanted)
    call wrong(words, f_text_at(recorder_said(c_text('report'))), handle//' '//trim(digits)//' <'//words//'>')
    call wrong(words, message, 'text of last_error')
  end subroutine

  !> Checks numbers that come one after the other from the recorder.
  subroutine gave_reals(what, found, first)
    character(len=*), intent(in) :: what
    real(rc_real), intent(in) :: found(:), first
    integer :: i
    call demand(size(found) > 0 .and. all([(.not. abs(found(i) - first - (i - 1)) > 0, i=1, size(found))]), what)
  end subroutine

  subroutine gave_integers(what, found, first)
    character(len=*), intent(in) :: what
    integer, intent(in) :: found(:), first
    integer :: i
    call demand(size(found) > 0 .and. all([(found(i) == first + i - 1, i=1, size(found))]), what)
  end subroutine

  subroutine gave_text(what, found, wanted)
    character(len=*), intent(in) :: what, found, wanted
    call wrong(what, found, wanted)
  end subroutine

  subroutine gave_kind(id, kind)
    integer, intent(in) :: id, kind
    call demand(id/2**28 == kind, 'kind of a new handle')
  end subroutine

  subroutine demand(ok, what)
    logical, intent(in) :: ok
    character(len=*), intent(in) :: what
    checks = checks + 1
    if (ok) return
    failures = failures + 1
    write (*, '(2a)') 'not so: ', what
  end subroutine

  !> Checks that all functions were called except those named.
  subroutine done(but)
    character(len=*), intent(in) :: but
    call wrong('never called', f_text_at(recorder_missing()), but)
    write (*, '(i0, a, i0, a)') checks, ' checks, ', failures, ' failures'
    if (failures > 0) error stop 1
  end subroutine

end module mapping
