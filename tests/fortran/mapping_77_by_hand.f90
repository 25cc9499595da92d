!> Tests the subroutines of the FORTRAN 77 layer whose calls follow no rule, its refusals, and its handling of texts.
module mapping_77_by_hand
  use mapping
  implicit none
  private
  public :: mapped_by_hand

  integer :: ierr
  character(len=200) :: text
  logical :: seen = .false.

contains

  subroutine mapped_by_hand()
    external :: rcvers, rcinfo, rchas, rcstex, rclcav, rcnopt, rcnstt
    integer :: i, j
    call rcvers(i, j, text)
    call demand(i == 2 .and. j == 1 .and. text == 'text of version_string', 'version')
    call rcinfo(text)
    call gave_text('build', text, 'text of build_info')
    call rchas('Some NAME ', i)
    call told('has_feature', '<some name>', 0)
    call demand(i == 2, 'a feature')
    call rcstex(-7, text)
    call told('status_string', '-7', 0)
    call gave_text('status', text, 'text of status_string')
    call rclcav(text)
    call gave_text('last caveat', text, 'text of last_caveat')
    call rcnopt(2, i)
    call told('option_count', '2', 0)
    call rcnstt(6, j)
    call told('stat_count', '6', 0)
    call demand(i == 2 .and. j == 2, 'counts')
    call references()
    call callbacks()
    call refusals()
    call texts()
    call cases()
  end subroutine

  subroutine references()
    external :: rckeep, rcfree
    integer :: spare(5)
    spare = [ictx, ibody2, icon, iwr, itab]
    call rckeep(ictx, ierr)
    call told('context_retain', 'context1', ierr)
    call rckeep(ibody2, ierr)
    call told('body_retain', 'body2', ierr)
    call rckeep(icon, ierr)
    call told('contact_retain', 'contact1', ierr)
    call rckeep(iwr, ierr)
    call told('wheelrail_retain', 'wheelrail1', ierr)
    call rckeep(itab, ierr)
    call told('table_retain', 'table1', ierr)
    call rcfree(spare(1), ierr)
    call told('context_release', 'context1', ierr)
    call rcfree(spare(2), ierr)
    call told('body_release', 'body2', ierr)
    call rcfree(spare(3), ierr)
    call told('contact_release', 'contact1', ierr)
    call rcfree(spare(4), ierr)
    call told('wheelrail_release', 'wheelrail1', ierr)
    call rcfree(spare(5), ierr)
    call told('table_release', 'table1', ierr)
    call demand(all(spare == 0), 'released handles are 0')
    call rcfree(spare(1), ierr)
    call status_is('release of 0', ierr, 0)
    call answers(ROLLCON_ERR_STATE)
    call rckeep(icon, ierr)
    call status_is('RCKEEP', ierr, int(ROLLCON_ERR_STATE))
    call answers(ROLLCON_OK)
  end subroutine

  subroutine watch(iphase, iter, resid, secs, icancl)
    integer :: iphase, iter, icancl
    double precision :: resid, secs
    seen = iphase == 200 .and. iter == 200 .and. .not. abs(resid - 200.5d0) > 0 .and. .not. abs(secs - 200.5d0) > 0
    icancl = 5
  end subroutine

  subroutine sink(level, line)
    integer :: level
    character(len=*) :: line
    seen = level == 2 .and. line == 'a message'
  end subroutine

  subroutine callbacks()
    external :: rcprog, rcnopr, rclog, rctprg, rctnop
    call rcprog(icon, watch, ierr)
    call told('contact_set_progress', 'contact1 1', ierr)
    call demand(seen, 'arguments of WATCH')
    call told('event_get_int', '7 2 room', 0)
    call told('event_get_real', '7 102 room', 0)
    call rcnopr(icon, ierr)
    call told('contact_set_progress', 'contact1 null', ierr)
    call rctprg(itab, watch, ierr)
    call told('table_set_progress', 'table1 1', ierr)
    call rctnop(itab, ierr)
    call told('table_set_progress', 'table1 null', ierr)
    seen = .false.
    call rclog(ictx, 3, sink, ierr)
    call told('context_set_log', 'context1 3 0', ierr)
    call demand(seen, 'arguments of SINK')
  end subroutine

  subroutine says(words, handle, status)
    character(len=*), intent(in) :: words, handle
    integer(rc_int), intent(in), optional :: status
    external :: rclerr
    integer :: wanted
    wanted = ROLLCON_ERR_ARGUMENT
    if (present(status)) wanted = status
    call rclerr(text)
    call refused(handle, ierr, text, words, wanted)
  end subroutine

  !> Tests what the layer finds itself, in its own names.
  subroutine refusals()
    external :: rcnode, rcnodt, rcbnod, rcbndt, rcelem, rcbelm, rcbtgf, rcbtgn, rcsupp, rchold, rcfree, rckeep
    integer :: ids(4), dead
    double precision :: x(12)
    x = 0
    ids = 1
    dead = ictx + 1
    call rcnode(icon, 4, x, 2, ierr)
    call says('RCNODE: LDX is 2; allowed: 3 or more', 'contact1')
    call rcnodt(icon, 4, x, 3, ierr)
    call says('RCNODT: LDX is 3; allowed: N or more', 'contact1')
    call rcbnod(ibody, 4, x, -7, ierr)
    call says('RCBNOD: LDX is -7; allowed: 3 or more', 'body1')
    call rcbndt(ibody, 4, x, 3, ierr)
    call says('RCBNDT: LDX is 3; allowed: N or more', 'body1')
    call rcelem(icon, 214, 1, ids, 3, 1, ierr)
    call says('RCELEM: LDC is 3; allowed for this type: 4 or more', 'contact1')
    call rcbelm(ibody, 350, 1, ids, 19, 1, ierr)
    call says('RCBELM: LDC is 19; allowed for this type: 20 or more', 'body1')
    call rcelem(icon, 214, -2, ids, 4, 1, ierr)
    call says('RCELEM: N is -2; allowed: 0 or more', 'contact1')
    call rcbtgf(ibody, -1, ids, ids, 1, ierr)
    call says('RCBTGF: N is -1; allowed: 0 or more', 'body1')
    call rcbtgn(ibody, -1, ids, 1, ierr)
    call says('RCBTGN: N is -1; allowed: 0 or more', 'body1')
    call rcsupp(ibody, -1, ids, 7, x, ierr)
    call says('RCSUPP: N is -1; allowed: 0 or more', 'body1')
    call rchold(ibody, -1, ids, 7, ierr)
    call says('RCHOLD: N is -1; allowed: 0 or more', 'body1')
    call rckeep(0, ierr)
    call says('RCKEEP: IH is no live handle', 'null')
    dead = -5
    call rcfree(dead, ierr)
    call says('RCFREE: IH is no live handle', 'null', ROLLCON_ERR_HANDLE)
    call rcelem(icon, 999, 1, ids, 0, 1, ierr)  ! the library says what it does not know
    call told('contact_frame_add_elements', 'contact1 999 1 [] 1 1', ierr)
  end subroutine

  !> Tests names in any case, paths unchanged, texts cut and padded.
  subroutine texts()
    external :: rcseti, rcsets, rcbsav, rcgets, rcplan, rcfric
    character(len=4) :: short
    double precision :: p(1)
    call rcseti(icon, 'Max_Iterations  ', 77, ierr)
    call told('contact_set_int', 'contact1 <max_iterations> 77', ierr)
    call rcsets(icon, 'CONVECTION', 'GODUNOV ', ierr)
    call told('contact_set_str', 'contact1 <convection> <godunov>', ierr)
    p = 1.5d0
    call rcfric(icon, 'COULOMB', 1, p, ierr)
    call told('contact_set_friction', 'contact1 <coulomb> 1 [1.5]', ierr)
    call rcbsav(ibody, 'A/Path ', ierr)
    call told('body_save', 'body1 <A/Path>', ierr)
    call rcgets(icon, 'convection', short, ierr)
    call demand(short == 'text', 'beginning of a text')
    call says('RCGETS: the text has 23 characters; there is room for 4', 'contact1', ROLLCON_ERR_CAPACITY)
    text = repeat('x', len(text))
    call rcplan(icon, text, ierr)
    call gave_text('padded with blanks', text, 'text of contact_get_plan')
  end subroutine

  subroutine cases()
    external :: rccase
    double precision :: values(2, 2), table(4, 2)
    integer :: n, status(2)
    values = reshape([1.5d0, 2.5d0, 3.5d0, 4.5d0], [2, 2])
    call rccase(icon, 'NORMAL Friction', 2, values, 'FORCE Approach', 4, table, n, status, ierr)
    call told('contact_solve_many', &
      'contact1 <normal friction> 2 [1.5 2.5 3.5 4.5] <force approach> 4 room room room', ierr)
    call gave_reals('results', reshape(table, [8]), 600.5_rc_real)
    call gave_integers('states', status, 800)
    call demand(n == 4, 'columns of results')
    call answers(ROLLCON_ERR_STATE)
    status = -1
    call rccase(icon, 'normal', 2, values, 'force', 4, table, n, status, ierr)
    call status_is('RCCASE', ierr, int(ROLLCON_ERR_STATE))
    call demand(all(status == -1), 'a failure leaves the states alone')
    call answers(ROLLCON_OK)
  end subroutine

end module mapping_77_by_hand
