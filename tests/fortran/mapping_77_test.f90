! Generated from bindings/api.toml by bindings/generate.py; do not edit.
!> The subroutines of the FORTRAN 77 layer: every argument in its place.
program mapping_77_test
  use mapping
  use mapping_77_by_hand, only: mapped_by_hand
  implicit none
  call begin_77()
  call test_rcinit()
  call test_rcthrd()
  call test_rcltch()
  call test_rcchek()
  call test_rcbody()
  call test_rcelas()
  call test_rcprep()
  call test_rckind()
  call test_rcbsav()
  call test_rcblod()
  call test_rcbcpy()
  call test_rcbnod()
  call test_rcbndt()
  call test_rcbelm()
  call test_rcbtgf()
  call test_rcbtgn()
  call test_rcsupp()
  call test_rchold()
  call test_rcbtrc()
  call test_rcbfor()
  call test_rcbrot()
  call test_rcbprs()
  call test_rcbtrn()
  call test_rcbfac()
  call test_rcbmsh()
  call test_rcbtgr()
  call test_rcbngr()
  call test_rcbgnm()
  call test_rcbgnd()
  call test_rcbsti()
  call test_rcbstr()
  call test_rcbgti()
  call test_rcbgtr()
  call test_rcbopi()
  call test_rcbopd()
  call test_rcbpro()
  call test_rcbpsh()
  call test_rcbprd()
  call test_rcbpwr()
  call test_rcbext()
  call test_rcbrev()
  call test_rcbple()
  call test_rcbppt()
  call test_rcbsiz()
  call test_rcbdis()
  call test_rcbnds()
  call test_rcbpts()
  call test_rcbfld()
  call test_rcbwri()
  call test_rcbrea()
  call test_rcbsta()
  call test_rcbstn()
  call test_rcpair()
  call test_rcnode()
  call test_rcnodt()
  call test_rcelem()
  call test_rcfmsh()
  call test_rcfram()
  call test_rcfrec()
  call test_rcfell()
  call test_rcfstr()
  call test_rcfaut()
  call test_rcpose()
  call test_rcaxes()
  call test_rcgap()
  call test_rcgapq()
  call test_rcgapg()
  call test_rcroll()
  call test_rccrp()
  call test_rcstep()
  call test_rcvel()
  call test_rccrpf()
  call test_rcpres()
  call test_rcfric()
  call test_rcfrim()
  call test_rclayr()
  call test_rclayy()
  call test_rcfria()
  call test_rcheat()
  call test_rcfrif()
  call test_rcseti()
  call test_rcsetr()
  call test_rcsets()
  call test_rcgeti()
  call test_rcgetr()
  call test_rcgets()
  call test_rcopti()
  call test_rcoptd()
  call test_rcstop()
  call test_rcsolv()
  call test_rcrept()
  call test_rcspst()
  call test_rcrpst()
  call test_rcrset()
  call test_rcsize()
  call test_rctrac()
  call test_rcfeld()
  call test_rcnsta()
  call test_rcresu()
  call test_rcmotn()
  call test_rctilt()
  call test_rcsens()
  call test_rcdisp()
  call test_rcstrs()
  call test_rcbodu()
  call test_rcbfat()
  call test_rcwbod()
  call test_rctmps()
  call test_rcfati()
  call test_rcelli()
  call test_rcwear()
  call test_rcwpro()
  call test_rcsinv()
  call test_rcstat()
  call test_rcstnm()
  call test_rchist()
  call test_rcerrf()
  call test_rcplan()
  call test_rcwrit()
  call test_rcwhel()
  call test_rcwtrk()
  call test_rcwset()
  call test_rcwdev()
  call test_rcwpos()
  call test_rcword()
  call test_rcwvel()
  call test_rcwvrt()
  call test_rcwfri()
  call test_rcwtab()
  call test_rcwnot()
  call test_rcwhtz()
  call test_rcwcnf()
  call test_rcwfra()
  call test_rcwacc()
  call test_rcwslv()
  call test_rcwstp()
  call test_rcwmny()
  call test_rcwfwr()
  call test_rcwsav()
  call test_rcwbck()
  call test_rcwcpy()
  call test_rcwrst()
  call test_rcwnpa()
  call test_rcwres()
  call test_rcwder()
  call test_rcwsta()
  call test_rcwstn()
  call test_rcwppt()
  call test_rcwpst()
  call test_rcwpsn()
  call test_rcwpax()
  call test_rcwcon()
  call test_rcwpts()
  call test_rcwcnc()
  call test_rctabl()
  call test_rctlod()
  call test_rctstd()
  call test_rctrat()
  call test_rctres()
  call test_rctfrm()
  call test_rctpoi()
  call test_rctbod()
  call test_rctstp()
  call test_rctmak()
  call test_rctgsm()
  call test_rctasm()
  call test_rctsav()
  call test_rcteva()
  call test_rctevd()
  call test_rctcon()
  call mapped_by_hand()
  call done('')
contains

  subroutine test_rcinit()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcinit(ih, stat)
    call told('context_create', '1 room', stat)
    call gave_kind(ih, 1)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcinit(ih, stat)
    call rclerr(message)
    call failed('context_create', stat, message)
  end subroutine

  subroutine test_rcthrd()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcthrd(ictx, 11, stat)
    call told('context_set_threads', 'context1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcthrd(ictx, 11, stat)
    call rclerr(message)
    call failed('context_set_threads', stat, message)
  end subroutine

  subroutine test_rcltch()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcltch(ictx, 11, stat)
    call told('context_set_latch', 'context1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcltch(ictx, 11, stat)
    call rclerr(message)
    call failed('context_set_latch', stat, message)
  end subroutine

  subroutine test_rcchek()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcchek(ictx, stat)
    call told('context_check', 'context1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcchek(ictx, stat)
    call rclerr(message)
    call failed('context_check', stat, message)
  end subroutine

  subroutine test_rcbody()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbody(ictx, 11, ih, stat)
    call told('body_create', 'context1 11 room', stat)
    call gave_kind(ih, 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbody(ictx, 11, ih, stat)
    call rclerr(message)
    call failed('body_create', stat, message)
  end subroutine

  subroutine test_rcelas()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcelas(ibody, 11, 2.5d0, 3.5d0, stat)
    call told('body_set_elastic', 'body1 11 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcelas(ibody, 11, 2.5d0, 3.5d0, stat)
    call rclerr(message)
    call failed('body_set_elastic', stat, message)
  end subroutine

  subroutine test_rcprep()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcprep(ibody, stat)
    call told('body_prepare', 'body1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcprep(ibody, stat)
    call rclerr(message)
    call failed('body_prepare', stat, message)
  end subroutine

  subroutine test_rckind()
    integer :: kind
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rckind(ibody, kind, stat)
    call told('body_get_kind', 'body1 room', stat)
    call gave_integers('kind', int([kind]), 100)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rckind(ibody, kind, stat)
    call rclerr(message)
    call failed('body_get_kind', stat, message)
  end subroutine

  subroutine test_rcbsav()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbsav(ibody, 'text 1', stat)
    call told('body_save', 'body1 <text 1>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbsav(ibody, 'text 1', stat)
    call rclerr(message)
    call failed('body_save', stat, message)
  end subroutine

  subroutine test_rcblod()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcblod(ictx, 'text 1', ih, stat)
    call told('body_load', 'context1 <text 1> room', stat)
    call gave_kind(ih, 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcblod(ictx, 'text 1', ih, stat)
    call rclerr(message)
    call failed('body_load', stat, message)
  end subroutine

  subroutine test_rcbcpy()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbcpy(ibody, ih, stat)
    call told('body_copy', 'body1 room', stat)
    call gave_kind(ih, 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbcpy(ibody, ih, stat)
    call rclerr(message)
    call failed('body_copy', stat, message)
  end subroutine

  subroutine test_rcbnod()
    double precision :: xyz(4, 2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    xyz = -1
    xyz(:3, :) = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [3, 2])
    call rcbnod(ibody, 2, xyz, 4, stat)
    call told('body_set_nodes', 'body1 2 [2.125 2.25 2.375 2.5 2.625 2.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    xyz = -1
    xyz(:3, :) = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [3, 2])
    call rcbnod(ibody, 2, xyz, 4, stat)
    call rclerr(message)
    call failed('body_set_nodes', stat, message)
  end subroutine

  subroutine test_rcbndt()
    double precision :: xyz(2, 3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    xyz = -1
    xyz = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [2, 3], order=[2, 1])
    call rcbndt(ibody, 2, xyz, 2, stat)
    call told('body_set_nodes', 'body1 2 [2.125 2.25 2.375 2.5 2.625 2.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    xyz = -1
    xyz = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [2, 3], order=[2, 1])
    call rcbndt(ibody, 2, xyz, 2, stat)
    call rclerr(message)
    call failed('body_set_nodes', stat, message)
  end subroutine

  subroutine test_rcbelm()
    integer :: ids(4, 2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    ids = -1
    ids(:3, :) = reshape([31, 32, 33, 34, 35, 36], [3, 2])
    call rcbelm(ibody, 203, 2, ids, 4, 51, stat)
    call told('body_add_elements', 'body1 203 2 [31 32 33 34 35 36] 1 51', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    ids = -1
    ids(:3, :) = reshape([31, 32, 33, 34, 35, 36], [3, 2])
    call rcbelm(ibody, 203, 2, ids, 4, 51, stat)
    call rclerr(message)
    call failed('body_add_elements', stat, message)
  end subroutine

  subroutine test_rcbtgf()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbtgf(ibody, 2, [21, 22], [31, 32], 51, stat)
    call told('body_tag_faces', 'body1 2 [21 22] [31 32] 1 51', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbtgf(ibody, 2, [21, 22], [31, 32], 51, stat)
    call rclerr(message)
    call failed('body_tag_faces', stat, message)
  end subroutine

  subroutine test_rcbtgn()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbtgn(ibody, 2, [21, 22], 41, stat)
    call told('body_tag_faces_of_nodes', 'body1 2 [21 22] 1 41', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbtgn(ibody, 2, [21, 22], 41, stat)
    call rclerr(message)
    call failed('body_tag_faces_of_nodes', stat, message)
  end subroutine

  subroutine test_rcsupp()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcsupp(ibody, 2, [21, 22], 41, [5.125d0, 5.25d0, 5.375d0, 5.5d0, 5.625d0, 5.75d0], stat)
    call told('body_set_support', 'body1 2 [21 22] 1 41 [5.125 5.25 5.375 5.5 5.625 5.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcsupp(ibody, 2, [21, 22], 41, [5.125d0, 5.25d0, 5.375d0, 5.5d0, 5.625d0, 5.75d0], stat)
    call rclerr(message)
    call failed('body_set_support', stat, message)
  end subroutine

  subroutine test_rchold()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rchold(ibody, 2, [21, 22], 41, stat)
    call told('body_set_support', 'body1 2 [21 22] 1 41 [0 0 0 0 0 0]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rchold(ibody, 2, [21, 22], 41, stat)
    call rclerr(message)
    call failed('body_set_support', stat, message)
  end subroutine

  subroutine test_rcbtrc()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbtrc(ibody, 11, [2.125d0, 2.25d0, 2.375d0], stat)
    call told('body_set_traction', 'body1 11 [2.125 2.25 2.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbtrc(ibody, 11, [2.125d0, 2.25d0, 2.375d0], stat)
    call rclerr(message)
    call failed('body_set_traction', stat, message)
  end subroutine

  subroutine test_rcbfor()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbfor(ibody, 11, [2.125d0, 2.25d0, 2.375d0], stat)
    call told('body_set_body_force', 'body1 11 [2.125 2.25 2.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbfor(ibody, 11, [2.125d0, 2.25d0, 2.375d0], stat)
    call rclerr(message)
    call failed('body_set_body_force', stat, message)
  end subroutine

  subroutine test_rcbrot()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbrot(ibody, 11, 2.5d0, [3.125d0, 3.25d0, 3.375d0], [4.125d0, 4.25d0, 4.375d0], stat)
    call told('body_set_rotation', 'body1 11 2.5 [3.125 3.25 3.375] [4.125 4.25 4.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbrot(ibody, 11, 2.5d0, [3.125d0, 3.25d0, 3.375d0], [4.125d0, 4.25d0, 4.375d0], stat)
    call rclerr(message)
    call failed('body_set_rotation', stat, message)
  end subroutine

  subroutine test_rcbprs()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbprs(ibody, 11, 2.5d0, stat)
    call told('body_set_pressure', 'body1 11 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbprs(ibody, 11, 2.5d0, stat)
    call rclerr(message)
    call failed('body_set_pressure', stat, message)
  end subroutine

  subroutine test_rcbtrn()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbtrn(ibody, 11, 2, [31, 32], [5.125d0, 5.25d0, 5.375d0], [6.125d0, 6.25d0, 6.375d0, 6.5d0, 6.625d0, &
      6.75d0], stat)
    call told('body_set_node_tractions', &
      'body1 11 2 [31 32] 1 [5.125 5.25 5.375] [6.125 6.25 6.375 6.5 6.625 6.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbtrn(ibody, 11, 2, [31, 32], [5.125d0, 5.25d0, 5.375d0], [6.125d0, 6.25d0, 6.375d0, 6.5d0, 6.625d0, &
      6.75d0], stat)
    call rclerr(message)
    call failed('body_set_node_tractions', stat, message)
  end subroutine

  subroutine test_rcbfac()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbfac(ibody, 2, [21, 22], stat)
    call told('body_set_contact_faces', 'body1 2 [21 22]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbfac(ibody, 2, [21, 22], stat)
    call rclerr(message)
    call failed('body_set_contact_faces', stat, message)
  end subroutine

  subroutine test_rcbmsh()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbmsh(ibody, 'text 1', 'text 2', stat)
    call told('body_read_mesh', 'body1 <text 1> <text 2>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbmsh(ibody, 'text 1', 'text 2', stat)
    call rclerr(message)
    call failed('body_read_mesh', stat, message)
  end subroutine

  subroutine test_rcbtgr()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbtgr(ibody, 'text 1', 21, stat)
    call told('body_tag_group', 'body1 <text 1> 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbtgr(ibody, 'text 1', 21, stat)
    call rclerr(message)
    call failed('body_tag_group', stat, message)
  end subroutine

  subroutine test_rcbngr()
    integer :: n
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbngr(ibody, n, stat)
    call told('body_get_group_count', 'body1 room', stat)
    call gave_integers('n', int([n]), 100)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbngr(ibody, n, stat)
    call rclerr(message)
    call failed('body_get_group_count', stat, message)
  end subroutine

  subroutine test_rcbgnm()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbgnm(ibody, 11, text, stat)
    call told('body_get_group_name', 'body1 10 28 room room', stat)
    call gave_text('text', text, 'text of body_get_group_name')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbgnm(ibody, 11, text, stat)
    call rclerr(message)
    call failed('body_get_group_name', stat, message)
  end subroutine

  subroutine test_rcbgnd()
    integer :: nodes(6)
    integer :: nn
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbgnd(ibody, 'text 1', 6, nodes, nn, stat)
    call told('body_get_group_nodes', 'body1 <text 1> 1 3 room room', stat)
    call gave_integers('nodes', int(nodes(:3)), 400)
    call gave_integers('nn', int([nn]), 3)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbgnd(ibody, 'text 1', 6, nodes, nn, stat)
    call rclerr(message)
    call failed('body_get_group_nodes', stat, message)
  end subroutine

  subroutine test_rcbsti()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbsti(ibody, 'text 1', 21, stat)
    call told('body_set_int', 'body1 <text 1> 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbsti(ibody, 'text 1', 21, stat)
    call rclerr(message)
    call failed('body_set_int', stat, message)
  end subroutine

  subroutine test_rcbstr()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbstr(ibody, 'text 1', 2.5d0, stat)
    call told('body_set_real', 'body1 <text 1> 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbstr(ibody, 'text 1', 2.5d0, stat)
    call rclerr(message)
    call failed('body_set_real', stat, message)
  end subroutine

  subroutine test_rcbgti()
    integer :: ivalue
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbgti(ibody, 'text 1', ivalue, stat)
    call told('body_get_int', 'body1 <text 1> room', stat)
    call gave_integers('ivalue', int([ivalue]), 200)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbgti(ibody, 'text 1', ivalue, stat)
    call rclerr(message)
    call failed('body_get_int', stat, message)
  end subroutine

  subroutine test_rcbgtr()
    double precision :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbgtr(ibody, 'text 1', value, stat)
    call told('body_get_real', 'body1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbgtr(ibody, 'text 1', value, stat)
    call rclerr(message)
    call failed('body_get_real', stat, message)
  end subroutine

  subroutine test_rcbopi()
    character(len=60) :: name
    integer :: itype
    double precision :: xlow
    double precision :: high
    double precision :: standard
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbopi(1, name, itype, xlow, high, standard, stat)
    call told('body_option_info', '0 512 room room room room room', stat)
    call gave_text('name', name, 'text of body_option_info')
    call gave_integers('itype', int([itype]), 300)
    call gave_reals('xlow', [xlow], 400.5_rc_real)
    call gave_reals('high', [high], 500.5_rc_real)
    call gave_reals('standard', [standard], 600.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbopi(1, name, itype, xlow, high, standard, stat)
    call rclerr(message)
    call failed('body_option_info', stat, message)
  end subroutine

  subroutine test_rcbopd()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbopd(1, text, stat)
    call told('body_option_doc', '0 24 room room', stat)
    call gave_text('text', text, 'text of body_option_doc')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbopd(1, text, stat)
    call rclerr(message)
    call failed('body_option_doc', stat, message)
  end subroutine

  subroutine test_rcbpro()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbpro(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], 3.5d0, stat)
    call told('body_set_profile', 'body1 2 [2.125 2.25 2.375 2.5] 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbpro(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], 3.5d0, stat)
    call rclerr(message)
    call failed('body_set_profile', stat, message)
  end subroutine

  subroutine test_rcbpsh()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbpsh(ibody, 'text 1', 2, [3.125d0, 3.25d0], stat)
    call told('body_set_profile_shape', 'body1 <text 1> 2 [3.125 3.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbpsh(ibody, 'text 1', 2, [3.125d0, 3.25d0], stat)
    call rclerr(message)
    call failed('body_set_profile_shape', stat, message)
  end subroutine

  subroutine test_rcbprd()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbprd(ibody, 'text 1', 2.5d0, 31, 4.5d0, stat)
    call told('body_read_profile', 'body1 <text 1> 2.5 31 4.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbprd(ibody, 'text 1', 2.5d0, 31, 4.5d0, stat)
    call rclerr(message)
    call failed('body_read_profile', stat, message)
  end subroutine

  subroutine test_rcbpwr()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbpwr(ibody, 'text 1', 2.5d0, stat)
    call told('body_write_profile', 'body1 <text 1> 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbpwr(ibody, 'text 1', 2.5d0, stat)
    call rclerr(message)
    call failed('body_write_profile', stat, message)
  end subroutine

  subroutine test_rcbext()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbext(ibody, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], [3.125d0, 3.25d0, 3.375d0], stat)
    call told('body_extrude_profile', 'body1 [1.125 1.25 1.375] [2.125 2.25 2.375] [3.125 3.25 3.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbext(ibody, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], [3.125d0, 3.25d0, 3.375d0], stat)
    call rclerr(message)
    call failed('body_extrude_profile', stat, message)
  end subroutine

  subroutine test_rcbrev()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbrev(ibody, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], 3.5d0, stat)
    call told('body_revolve_profile', 'body1 [1.125 1.25 1.375] [2.125 2.25 2.375] 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbrev(ibody, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], 3.5d0, stat)
    call rclerr(message)
    call failed('body_revolve_profile', stat, message)
  end subroutine

  subroutine test_rcbple()
    double precision :: xlength
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbple(ibody, xlength, stat)
    call told('body_get_profile_length', 'body1 room', stat)
    call gave_reals('xlength', [xlength], 100.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbple(ibody, xlength, stat)
    call rclerr(message)
    call failed('body_get_profile_length', stat, message)
  end subroutine

  subroutine test_rcbppt()
    double precision :: point(2)
    double precision :: tangent(2)
    double precision :: curvature
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbppt(ibody, 1.5d0, point, tangent, curvature, stat)
    call told('body_get_profile_point', 'body1 1.5 room room room', stat)
    call gave_reals('point', point, 200.5_rc_real)
    call gave_reals('tangent', tangent, 300.5_rc_real)
    call gave_reals('curvature', [curvature], 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbppt(ibody, 1.5d0, point, tangent, curvature, stat)
    call rclerr(message)
    call failed('body_get_profile_point', stat, message)
  end subroutine

  subroutine test_rcbsiz()
    integer :: nodes
    integer :: ielements
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbsiz(ibody, nodes, ielements, stat)
    call told('body_get_size', 'body1 room room', stat)
    call gave_integers('nodes', int([nodes]), 3)
    call gave_integers('ielements', int([ielements]), 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbsiz(ibody, nodes, ielements, stat)
    call rclerr(message)
    call failed('body_get_size', stat, message)
  end subroutine

  subroutine test_rcbdis()
    double precision :: u(18)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbdis(ibody, 6, u, stat)
    call told('body_get_displacements', 'body1 6 room', stat)
    call gave_reals('u', u, 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbdis(ibody, 6, u, stat)
    call rclerr(message)
    call failed('body_get_displacements', stat, message)
  end subroutine

  subroutine test_rcbnds()
    double precision :: stress(12)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbnds(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], stress, stat)
    call told('body_get_node_stresses', 'body1 2 [2.125 2.25 2.375 2.5 2.625 2.75] room', stat)
    call gave_reals('stress', stress, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbnds(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], stress, stat)
    call rclerr(message)
    call failed('body_get_node_stresses', stat, message)
  end subroutine

  subroutine test_rcbpts()
    double precision :: stress(36)
    double precision :: xyz(18)
    integer :: nr
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbpts(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], 6, stress, xyz, nr, stat)
    call told('body_get_point_stresses', 'body1 2 [2.125 2.25 2.375 2.5 2.625 2.75] 6 room room room', stat)
    call gave_reals('stress', stress, 400.5_rc_real)
    call gave_reals('xyz', xyz, 500.5_rc_real)
    call gave_integers('nr', int([nr]), 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbpts(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], 6, stress, xyz, nr, stat)
    call rclerr(message)
    call failed('body_get_point_stresses', stat, message)
  end subroutine

  subroutine test_rcbfld()
    double precision :: displacement(6)
    double precision :: stress(12)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbfld(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], 2, [4.125d0, 4.25d0, 4.375d0, 4.5d0, &
      4.625d0, 4.75d0], displacement, stress, stat)
    call told('body_get_fields_at', &
      'body1 2 [2.125 2.25 2.375 2.5 2.625 2.75] 2 [4.125 4.25 4.375 4.5 4.625 4.75] room room', stat)
    call gave_reals('displacement', displacement, 500.5_rc_real)
    call gave_reals('stress', stress, 600.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbfld(ibody, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], 2, [4.125d0, 4.25d0, 4.375d0, 4.5d0, &
      4.625d0, 4.75d0], displacement, stress, stat)
    call rclerr(message)
    call failed('body_get_fields_at', stat, message)
  end subroutine

  subroutine test_rcbwri()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbwri(ibody, 'text 1', 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], stat)
    call told('body_write', 'body1 <text 1> 2 [3.125 3.25 3.375 3.5 3.625 3.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbwri(ibody, 'text 1', 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], stat)
    call rclerr(message)
    call failed('body_write', stat, message)
  end subroutine

  subroutine test_rcbrea()
    double precision :: force(3)
    double precision :: xmoment(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbrea(ibody, force, xmoment, stat)
    call told('body_get_reaction', 'body1 room room', stat)
    call gave_reals('force', force, 100.5_rc_real)
    call gave_reals('xmoment', xmoment, 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbrea(ibody, force, xmoment, stat)
    call rclerr(message)
    call failed('body_get_reaction', stat, message)
  end subroutine

  subroutine test_rcbsta()
    double precision :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbsta(ibody, 'text 1', value, stat)
    call told('body_get_stat', 'body1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbsta(ibody, 'text 1', value, stat)
    call rclerr(message)
    call failed('body_get_stat', stat, message)
  end subroutine

  subroutine test_rcbstn()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbstn(1, text, stat)
    call told('body_stat_name', '0 23 room room', stat)
    call gave_text('text', text, 'text of body_stat_name')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbstn(1, text, stat)
    call rclerr(message)
    call failed('body_stat_name', stat, message)
  end subroutine

  subroutine test_rcpair()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcpair(ictx, ibody, ibody2, ih, stat)
    call told('contact_create', 'context1 body1 body2 room', stat)
    call gave_kind(ih, 3)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcpair(ictx, ibody, ibody2, ih, stat)
    call rclerr(message)
    call failed('contact_create', stat, message)
  end subroutine

  subroutine test_rcnode()
    double precision :: xyz(4, 2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    xyz = -1
    xyz(:3, :) = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [3, 2])
    call rcnode(icon, 2, xyz, 4, stat)
    call told('contact_set_frame_nodes', 'contact1 2 [2.125 2.25 2.375 2.5 2.625 2.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    xyz = -1
    xyz(:3, :) = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [3, 2])
    call rcnode(icon, 2, xyz, 4, stat)
    call rclerr(message)
    call failed('contact_set_frame_nodes', stat, message)
  end subroutine

  subroutine test_rcnodt()
    double precision :: xyz(2, 3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    xyz = -1
    xyz = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [2, 3], order=[2, 1])
    call rcnodt(icon, 2, xyz, 2, stat)
    call told('contact_set_frame_nodes', 'contact1 2 [2.125 2.25 2.375 2.5 2.625 2.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    xyz = -1
    xyz = reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0], [2, 3], order=[2, 1])
    call rcnodt(icon, 2, xyz, 2, stat)
    call rclerr(message)
    call failed('contact_set_frame_nodes', stat, message)
  end subroutine

  subroutine test_rcelem()
    integer :: ids(4, 2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    ids = -1
    ids(:3, :) = reshape([31, 32, 33, 34, 35, 36], [3, 2])
    call rcelem(icon, 203, 2, ids, 4, 51, stat)
    call told('contact_add_frame_elements', 'contact1 203 2 [31 32 33 34 35 36] 1 51', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    ids = -1
    ids(:3, :) = reshape([31, 32, 33, 34, 35, 36], [3, 2])
    call rcelem(icon, 203, 2, ids, 4, 51, stat)
    call rclerr(message)
    call failed('contact_add_frame_elements', stat, message)
  end subroutine

  subroutine test_rcfmsh()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfmsh(icon, 'text 1', 'text 2', stat)
    call told('contact_read_frame', 'contact1 <text 1> <text 2>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfmsh(icon, 'text 1', 'text 2', stat)
    call rclerr(message)
    call failed('contact_read_frame', stat, message)
  end subroutine

  subroutine test_rcfram()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfram(icon, 11, 21, stat)
    call told('contact_frame_from_body', 'contact1 11 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfram(icon, 11, 21, stat)
    call rclerr(message)
    call failed('contact_frame_from_body', stat, message)
  end subroutine

  subroutine test_rcfrec()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfrec(icon, 203, 21, 31, 4.5d0, 5.5d0, 6.5d0, 7.5d0, stat)
    call told('contact_frame_rectangle', 'contact1 203 21 31 4.5 5.5 6.5 7.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfrec(icon, 203, 21, 31, 4.5d0, 5.5d0, 6.5d0, 7.5d0, stat)
    call rclerr(message)
    call failed('contact_frame_rectangle', stat, message)
  end subroutine

  subroutine test_rcfell()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfell(icon, 11, 21, 3.5d0, 4.5d0, 5.5d0, stat)
    call told('contact_frame_ellipse', 'contact1 11 21 3.5 4.5 5.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfell(icon, 11, 21, 3.5d0, 4.5d0, 5.5d0, stat)
    call rclerr(message)
    call failed('contact_frame_ellipse', stat, message)
  end subroutine

  subroutine test_rcfstr()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfstr(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], stat)
    call told('contact_frame_strips', 'contact1 11 2 [3.125 3.25 3.375 3.5 3.625 3.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfstr(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], stat)
    call rclerr(message)
    call failed('contact_frame_strips', stat, message)
  end subroutine

  subroutine test_rcfaut()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfaut(icon, stat)
    call told('contact_frame_automatic', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfaut(icon, stat)
    call rclerr(message)
    call failed('contact_frame_automatic', stat, message)
  end subroutine

  subroutine test_rcpose()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcpose(icon, 11, reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0], [3, &
      3], order=[2, 1]), [3.125d0, 3.25d0, 3.375d0], stat)
    call told('contact_set_pose', 'contact1 11 [2.125 2.25 2.375 2.5 2.625 2.75 2.875 3 3.125] [3.125 3.25 3.375]', &
      stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcpose(icon, 11, reshape([2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0], [3, &
      3], order=[2, 1]), [3.125d0, 3.25d0, 3.375d0], stat)
    call rclerr(message)
    call failed('contact_set_pose', stat, message)
  end subroutine

  subroutine test_rcaxes()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcaxes(icon, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], [3.125d0, 3.25d0, 3.375d0], stat)
    call told('contact_set_axes', 'contact1 [1.125 1.25 1.375] [2.125 2.25 2.375] [3.125 3.25 3.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcaxes(icon, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], [3.125d0, 3.25d0, 3.375d0], stat)
    call rclerr(message)
    call failed('contact_set_axes', stat, message)
  end subroutine

  subroutine test_rcgap()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcgap(icon, 2, [2.125d0, 2.25d0], stat)
    call told('contact_set_gap', 'contact1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcgap(icon, 2, [2.125d0, 2.25d0], stat)
    call rclerr(message)
    call failed('contact_set_gap', stat, message)
  end subroutine

  subroutine test_rcgapq()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcgapq(icon, 1.5d0, 2.5d0, 3.5d0, stat)
    call told('contact_set_gap_quadratic', 'contact1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcgapq(icon, 1.5d0, 2.5d0, 3.5d0, stat)
    call rclerr(message)
    call failed('contact_set_gap_quadratic', stat, message)
  end subroutine

  subroutine test_rcgapg()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcgapg(icon, 11, 2.5d0, 3.5d0, 4.5d0, 5.5d0, 2, [7.125d0, 7.25d0], stat)
    call told('contact_set_gap_grid', 'contact1 11 2.5 3.5 4.5 5.5 2 [7.125 7.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcgapg(icon, 11, 2.5d0, 3.5d0, 4.5d0, 5.5d0, 2, [7.125d0, 7.25d0], stat)
    call rclerr(message)
    call failed('contact_set_gap_grid', stat, message)
  end subroutine

  subroutine test_rcroll()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcroll(icon, 1.5d0, stat)
    call told('contact_set_rolling', 'contact1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcroll(icon, 1.5d0, stat)
    call rclerr(message)
    call failed('contact_set_rolling', stat, message)
  end subroutine

  subroutine test_rccrp()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rccrp(icon, 1.5d0, 2.5d0, 3.5d0, stat)
    call told('contact_set_creep', 'contact1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rccrp(icon, 1.5d0, 2.5d0, 3.5d0, stat)
    call rclerr(message)
    call failed('contact_set_creep', stat, message)
  end subroutine

  subroutine test_rcstep()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcstep(icon, 11, 2.5d0, stat)
    call told('contact_set_step', 'contact1 11 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcstep(icon, 11, 2.5d0, stat)
    call rclerr(message)
    call failed('contact_set_step', stat, message)
  end subroutine

  subroutine test_rcvel()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcvel(icon, 11, [2.125d0, 2.25d0, 2.375d0], [3.125d0, 3.25d0, 3.375d0], [4.125d0, 4.25d0, 4.375d0], stat)
    call told('contact_set_velocity', 'contact1 11 [2.125 2.25 2.375] [3.125 3.25 3.375] [4.125 4.25 4.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcvel(icon, 11, [2.125d0, 2.25d0, 2.375d0], [3.125d0, 3.25d0, 3.375d0], [4.125d0, 4.25d0, 4.375d0], stat)
    call rclerr(message)
    call failed('contact_set_velocity', stat, message)
  end subroutine

  subroutine test_rccrpf()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rccrpf(icon, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], stat)
    call told('contact_set_creep_field', 'contact1 2 [2.125 2.25 2.375 2.5]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rccrpf(icon, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], stat)
    call rclerr(message)
    call failed('contact_set_creep_field', stat, message)
  end subroutine

  subroutine test_rcpres()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcpres(icon, 11, 21, 3.5d0, stat)
    call told('contact_prescribe', 'contact1 11 21 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcpres(icon, 11, 21, 3.5d0, stat)
    call rclerr(message)
    call failed('contact_prescribe', stat, message)
  end subroutine

  subroutine test_rcfric()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfric(icon, 'text 1', 2, [3.125d0, 3.25d0], stat)
    call told('contact_set_friction', 'contact1 <text 1> 2 [3.125 3.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfric(icon, 'text 1', 2, [3.125d0, 3.25d0], stat)
    call rclerr(message)
    call failed('contact_set_friction', stat, message)
  end subroutine

  subroutine test_rcfrim()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfrim(icon, 1.5d0, 2.5d0, stat)
    call told('contact_set_friction_memory', 'contact1 1.5 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfrim(icon, 1.5d0, 2.5d0, stat)
    call rclerr(message)
    call failed('contact_set_friction_memory', stat, message)
  end subroutine

  subroutine test_rclayr()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rclayr(icon, 1.5d0, stat)
    call told('contact_set_layer', 'contact1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rclayr(icon, 1.5d0, stat)
    call rclerr(message)
    call failed('contact_set_layer', stat, message)
  end subroutine

  subroutine test_rclayy()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rclayy(icon, 1.5d0, 2.5d0, stat)
    call told('contact_set_layer_yield', 'contact1 1.5 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rclayy(icon, 1.5d0, 2.5d0, stat)
    call rclerr(message)
    call failed('contact_set_layer_yield', stat, message)
  end subroutine

  subroutine test_rcfria()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfria(icon, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], stat)
    call told('contact_set_friction_across', 'contact1 2 [2.125 2.25 2.375 2.5]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfria(icon, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], stat)
    call rclerr(message)
    call failed('contact_set_friction_across', stat, message)
  end subroutine

  subroutine test_rcheat()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcheat(icon, 11, 2.5d0, 3.5d0, 4.5d0, stat)
    call told('contact_set_heat', 'contact1 11 2.5 3.5 4.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcheat(icon, 11, 2.5d0, 3.5d0, 4.5d0, stat)
    call rclerr(message)
    call failed('contact_set_heat', stat, message)
  end subroutine

  subroutine test_rcfrif()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfrif(icon, 2, [2.125d0, 2.25d0], stat)
    call told('contact_set_friction_field', 'contact1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfrif(icon, 2, [2.125d0, 2.25d0], stat)
    call rclerr(message)
    call failed('contact_set_friction_field', stat, message)
  end subroutine

  subroutine test_rcseti()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcseti(icon, 'text 1', 21, stat)
    call told('contact_set_int', 'contact1 <text 1> 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcseti(icon, 'text 1', 21, stat)
    call rclerr(message)
    call failed('contact_set_int', stat, message)
  end subroutine

  subroutine test_rcsetr()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcsetr(icon, 'text 1', 2.5d0, stat)
    call told('contact_set_real', 'contact1 <text 1> 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcsetr(icon, 'text 1', 2.5d0, stat)
    call rclerr(message)
    call failed('contact_set_real', stat, message)
  end subroutine

  subroutine test_rcsets()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcsets(icon, 'text 1', 'text 2', stat)
    call told('contact_set_str', 'contact1 <text 1> <text 2>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcsets(icon, 'text 1', 'text 2', stat)
    call rclerr(message)
    call failed('contact_set_str', stat, message)
  end subroutine

  subroutine test_rcgeti()
    integer :: ivalue
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcgeti(icon, 'text 1', ivalue, stat)
    call told('contact_get_int', 'contact1 <text 1> room', stat)
    call gave_integers('ivalue', int([ivalue]), 200)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcgeti(icon, 'text 1', ivalue, stat)
    call rclerr(message)
    call failed('contact_get_int', stat, message)
  end subroutine

  subroutine test_rcgetr()
    double precision :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcgetr(icon, 'text 1', value, stat)
    call told('contact_get_real', 'contact1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcgetr(icon, 'text 1', value, stat)
    call rclerr(message)
    call failed('contact_get_real', stat, message)
  end subroutine

  subroutine test_rcgets()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcgets(icon, 'text 1', text, stat)
    call told('contact_get_str', 'contact1 <text 1> 24 room room', stat)
    call gave_text('text', text, 'text of contact_get_str')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcgets(icon, 'text 1', text, stat)
    call rclerr(message)
    call failed('contact_get_str', stat, message)
  end subroutine

  subroutine test_rcopti()
    character(len=60) :: name
    integer :: itype
    double precision :: xlow
    double precision :: high
    double precision :: standard
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcopti(1, name, itype, xlow, high, standard, stat)
    call told('option_info', '0 512 room room room room room', stat)
    call gave_text('name', name, 'text of option_info')
    call gave_integers('itype', int([itype]), 300)
    call gave_reals('xlow', [xlow], 400.5_rc_real)
    call gave_reals('high', [high], 500.5_rc_real)
    call gave_reals('standard', [standard], 600.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcopti(1, name, itype, xlow, high, standard, stat)
    call rclerr(message)
    call failed('option_info', stat, message)
  end subroutine

  subroutine test_rcoptd()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcoptd(1, text, stat)
    call told('option_doc', '0 19 room room', stat)
    call gave_text('text', text, 'text of option_doc')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcoptd(1, text, stat)
    call rclerr(message)
    call failed('option_doc', stat, message)
  end subroutine

  subroutine test_rcstop()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcstop(icon, stat)
    call told('contact_request_cancel', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcstop(icon, stat)
    call rclerr(message)
    call failed('contact_request_cancel', stat, message)
  end subroutine

  subroutine test_rcsolv()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcsolv(icon, stat)
    call told('contact_solve', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcsolv(icon, stat)
    call rclerr(message)
    call failed('contact_solve', stat, message)
  end subroutine

  subroutine test_rcrept()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcrept(icon, stat)
    call told('contact_repeat_step', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcrept(icon, stat)
    call rclerr(message)
    call failed('contact_repeat_step', stat, message)
  end subroutine

  subroutine test_rcspst()
    double precision :: past(6)
    integer :: nv
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcspst(icon, 6, past, nv, stat)
    call told('contact_save_past', 'contact1 6 room room', stat)
    call gave_reals('past', past, 200.5_rc_real)
    call gave_integers('nv', int([nv]), 6)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcspst(icon, 6, past, nv, stat)
    call rclerr(message)
    call failed('contact_save_past', stat, message)
  end subroutine

  subroutine test_rcrpst()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcrpst(icon, 2, [2.125d0, 2.25d0], stat)
    call told('contact_restore_past', 'contact1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcrpst(icon, 2, [2.125d0, 2.25d0], stat)
    call rclerr(message)
    call failed('contact_restore_past', stat, message)
  end subroutine

  subroutine test_rcrset()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcrset(icon, stat)
    call told('contact_reset', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcrset(icon, stat)
    call rclerr(message)
    call failed('contact_reset', stat, message)
  end subroutine

  subroutine test_rcsize()
    integer :: nodes
    integer :: ielements
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcsize(icon, nodes, ielements, stat)
    call told('contact_get_size', 'contact1 room room', stat)
    call gave_integers('nodes', int([nodes]), 3)
    call gave_integers('ielements', int([ielements]), 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcsize(icon, nodes, ielements, stat)
    call rclerr(message)
    call failed('contact_get_size', stat, message)
  end subroutine

  subroutine test_rctrac()
    double precision :: t(18)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctrac(icon, 11, 6, t, stat)
    call told('contact_get_tractions', 'contact1 11 6 room', stat)
    call gave_reals('t', t, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctrac(icon, 11, 6, t, stat)
    call rclerr(message)
    call failed('contact_get_tractions', stat, message)
  end subroutine

  subroutine test_rcfeld()
    double precision :: v(6)
    integer :: nv
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfeld(icon, 11, 21, 6, v, nv, stat)
    call told('contact_get_field', 'contact1 11 21 6 room room', stat)
    call gave_reals('v', v, 400.5_rc_real)
    call gave_integers('nv', int([nv]), 6)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfeld(icon, 11, 21, 6, v, nv, stat)
    call rclerr(message)
    call failed('contact_get_field', stat, message)
  end subroutine

  subroutine test_rcnsta()
    integer :: istatus(6)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcnsta(icon, 6, istatus, stat)
    call told('contact_get_status', 'contact1 3 room', stat)
    call gave_integers('istatus', int(istatus(:3)), 200)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcnsta(icon, 6, istatus, stat)
    call rclerr(message)
    call failed('contact_get_status', stat, message)
  end subroutine

  subroutine test_rcresu()
    double precision :: force(3)
    double precision :: xmoment(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcresu(icon, 11, force, xmoment, stat)
    call told('contact_get_resultant', 'contact1 11 room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('xmoment', xmoment, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcresu(icon, 11, force, xmoment, stat)
    call rclerr(message)
    call failed('contact_get_resultant', stat, message)
  end subroutine

  subroutine test_rcmotn()
    double precision :: approach
    double precision :: creep(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcmotn(icon, approach, creep, stat)
    call told('contact_get_motion', 'contact1 room room', stat)
    call gave_reals('approach', [approach], 100.5_rc_real)
    call gave_reals('creep', creep, 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcmotn(icon, approach, creep, stat)
    call rclerr(message)
    call failed('contact_get_motion', stat, message)
  end subroutine

  subroutine test_rctilt()
    double precision :: tilt(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctilt(icon, tilt, stat)
    call told('contact_get_tilt', 'contact1 room', stat)
    call gave_reals('tilt', tilt, 100.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctilt(icon, tilt, stat)
    call rclerr(message)
    call failed('contact_get_tilt', stat, message)
  end subroutine

  subroutine test_rcsens()
    double precision :: force(3)
    double precision :: xmoment(3)
    double precision :: approach
    double precision :: creep(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcsens(icon, 11, force, xmoment, approach, creep, stat)
    call told('contact_get_sensitivity', 'contact1 11 room room room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('xmoment', xmoment, 300.5_rc_real)
    call gave_reals('approach', [approach], 400.5_rc_real)
    call gave_reals('creep', creep, 500.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcsens(icon, 11, force, xmoment, approach, creep, stat)
    call rclerr(message)
    call failed('contact_get_sensitivity', stat, message)
  end subroutine

  subroutine test_rcdisp()
    double precision :: u(6)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcdisp(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0], u, stat)
    call told('contact_get_displacements_at', 'contact1 11 2 [3.125 3.25 3.375 3.5] room', stat)
    call gave_reals('u', u, 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcdisp(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0], u, stat)
    call rclerr(message)
    call failed('contact_get_displacements_at', stat, message)
  end subroutine

  subroutine test_rcstrs()
    double precision :: stress(12)
    double precision :: u(6)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcstrs(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], stress, u, stat)
    call told('contact_get_stresses_at', 'contact1 11 2 [3.125 3.25 3.375 3.5 3.625 3.75] room room', stat)
    call gave_reals('stress', stress, 400.5_rc_real)
    call gave_reals('u', u, 500.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcstrs(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], stress, u, stat)
    call rclerr(message)
    call failed('contact_get_stresses_at', stat, message)
  end subroutine

  subroutine test_rcbodu()
    double precision :: u(6)
    integer :: nv
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbodu(icon, 11, 6, u, nv, stat)
    call told('contact_get_body_displacements', 'contact1 11 6 room room', stat)
    call gave_reals('u', u, 300.5_rc_real)
    call gave_integers('nv', int([nv]), 6)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbodu(icon, 11, 6, u, nv, stat)
    call rclerr(message)
    call failed('contact_get_body_displacements', stat, message)
  end subroutine

  subroutine test_rcbfat()
    double precision :: displacement(6)
    double precision :: stress(12)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcbfat(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], displacement, stress, stat)
    call told('contact_get_body_fields_at', 'contact1 11 2 [3.125 3.25 3.375 3.5 3.625 3.75] room room', stat)
    call gave_reals('displacement', displacement, 400.5_rc_real)
    call gave_reals('stress', stress, 500.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcbfat(icon, 11, 2, [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0], displacement, stress, stat)
    call rclerr(message)
    call failed('contact_get_body_fields_at', stat, message)
  end subroutine

  subroutine test_rcwbod()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwbod(icon, 11, 'text 2', stat)
    call told('contact_write_body', 'contact1 11 <text 2>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwbod(icon, 11, 'text 2', stat)
    call rclerr(message)
    call failed('contact_write_body', stat, message)
  end subroutine

  subroutine test_rctmps()
    double precision :: temperature(4)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctmps(icon, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], temperature, stat)
    call told('contact_get_temperatures_at', 'contact1 2 [2.125 2.25 2.375 2.5] room', stat)
    call gave_reals('temperature', temperature, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctmps(icon, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], temperature, stat)
    call rclerr(message)
    call failed('contact_get_temperatures_at', stat, message)
  end subroutine

  subroutine test_rcfati()
    double precision :: xindex
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcfati(icon, 1.5d0, xindex, stat)
    call told('contact_get_fatigue_index', 'contact1 1.5 room', stat)
    call gave_reals('xindex', [xindex], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcfati(icon, 1.5d0, xindex, stat)
    call rclerr(message)
    call failed('contact_get_fatigue_index', stat, message)
  end subroutine

  subroutine test_rcelli()
    double precision :: xinputs(9)
    double precision :: center(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcelli(icon, xinputs, center, stat)
    call told('contact_get_equivalent_ellipse', 'contact1 room room', stat)
    call gave_reals('xinputs', xinputs, 100.5_rc_real)
    call gave_reals('center', center, 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcelli(icon, xinputs, center, stat)
    call rclerr(message)
    call failed('contact_get_equivalent_ellipse', stat, message)
  end subroutine

  subroutine test_rcwear()
    double precision :: depth(2)
    double precision :: volume
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwear(icon, 'text 1', 2, [3.125d0, 3.25d0], 2, [5.125d0, 5.25d0], depth, volume, stat)
    call told('contact_get_wear', 'contact1 <text 1> 2 [3.125 3.25] 2 [5.125 5.25] room room', stat)
    call gave_reals('depth', depth, 600.5_rc_real)
    call gave_reals('volume', [volume], 700.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwear(icon, 'text 1', 2, [3.125d0, 3.25d0], 2, [5.125d0, 5.25d0], depth, volume, stat)
    call rclerr(message)
    call failed('contact_get_wear', stat, message)
  end subroutine

  subroutine test_rcwpro()
    double precision :: worn(4)
    double precision :: taken
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwpro(2, [1.125d0, 1.25d0, 1.375d0, 1.5d0], [2.125d0, 2.25d0], 31, 4.5d0, 5.5d0, 6.5d0, worn, taken, stat)
    call told('wear_profile', '2 [1.125 1.25 1.375 1.5] [2.125 2.25] 31 4.5 5.5 6.5 room room', stat)
    call gave_reals('worn', worn, 700.5_rc_real)
    call gave_reals('taken', [taken], 800.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwpro(2, [1.125d0, 1.25d0, 1.375d0, 1.5d0], [2.125d0, 2.25d0], 31, 4.5d0, 5.5d0, 6.5d0, worn, taken, stat)
    call rclerr(message)
    call failed('wear_profile', stat, message)
  end subroutine

  subroutine test_rcsinv()
    double precision :: principal(6)
    double precision :: von_mises(2)
    double precision :: shear(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcsinv(2, [1.125d0, 1.25d0, 1.375d0, 1.5d0, 1.625d0, 1.75d0, 1.875d0, 2.0d0, 2.125d0, 2.25d0, 2.375d0, &
      2.5d0], principal, von_mises, shear, stat)
    call told('stress_invariants', &
      '2 [1.125 1.25 1.375 1.5 1.625 1.75 1.875 2 2.125 2.25 2.375 2.5] room room room', stat)
    call gave_reals('principal', principal, 200.5_rc_real)
    call gave_reals('von_mises', von_mises, 300.5_rc_real)
    call gave_reals('shear', shear, 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcsinv(2, [1.125d0, 1.25d0, 1.375d0, 1.5d0, 1.625d0, 1.75d0, 1.875d0, 2.0d0, 2.125d0, 2.25d0, 2.375d0, &
      2.5d0], principal, von_mises, shear, stat)
    call rclerr(message)
    call failed('stress_invariants', stat, message)
  end subroutine

  subroutine test_rcstat()
    double precision :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcstat(icon, 'text 1', value, stat)
    call told('contact_get_stat', 'contact1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcstat(icon, 'text 1', value, stat)
    call rclerr(message)
    call failed('contact_get_stat', stat, message)
  end subroutine

  subroutine test_rcstnm()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcstnm(1, text, stat)
    call told('stat_name', '0 18 room room', stat)
    call gave_text('text', text, 'text of stat_name')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcstnm(1, text, stat)
    call rclerr(message)
    call failed('stat_name', stat, message)
  end subroutine

  subroutine test_rchist()
    double precision :: rows(48)
    integer :: nr
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rchist(icon, 6, rows, nr, stat)
    call told('contact_get_history', 'contact1 6 room room', stat)
    call gave_reals('rows', rows, 200.5_rc_real)
    call gave_integers('nr', int([nr]), 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rchist(icon, 6, rows, nr, stat)
    call rclerr(message)
    call failed('contact_get_history', stat, message)
  end subroutine

  subroutine test_rcerrf()
    double precision :: psi(6)
    double precision :: seconds(6)
    integer :: nr
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcerrf(icon, 6, psi, seconds, nr, stat)
    call told('contact_get_error_function', 'contact1 6 room room room', stat)
    call gave_reals('psi', psi, 200.5_rc_real)
    call gave_reals('seconds', seconds, 300.5_rc_real)
    call gave_integers('nr', int([nr]), 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcerrf(icon, 6, psi, seconds, nr, stat)
    call rclerr(message)
    call failed('contact_get_error_function', stat, message)
  end subroutine

  subroutine test_rcplan()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcplan(icon, text, stat)
    call told('contact_get_plan', 'contact1 25 room room', stat)
    call gave_text('text', text, 'text of contact_get_plan')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcplan(icon, text, stat)
    call rclerr(message)
    call failed('contact_get_plan', stat, message)
  end subroutine

  subroutine test_rcwrit()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwrit(icon, 'text 1', stat)
    call told('contact_write', 'contact1 <text 1>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwrit(icon, 'text 1', stat)
    call rclerr(message)
    call failed('contact_write', stat, message)
  end subroutine

  subroutine test_rcwhel()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwhel(ictx, ibody, ibody2, 31, ih, stat)
    call told('wheelrail_create', 'context1 body1 body2 31 room', stat)
    call gave_kind(ih, 4)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwhel(ictx, ibody, ibody2, 31, ih, stat)
    call rclerr(message)
    call failed('wheelrail_create', stat, message)
  end subroutine

  subroutine test_rcwtrk()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwtrk(iwr, 1.5d0, 2.5d0, 3.5d0, stat)
    call told('wheelrail_set_track', 'wheelrail1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwtrk(iwr, 1.5d0, 2.5d0, 3.5d0, stat)
    call rclerr(message)
    call failed('wheelrail_set_track', stat, message)
  end subroutine

  subroutine test_rcwset()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwset(iwr, 1.5d0, 2.5d0, 3.5d0, stat)
    call told('wheelrail_set_wheelset', 'wheelrail1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwset(iwr, 1.5d0, 2.5d0, 3.5d0, stat)
    call rclerr(message)
    call failed('wheelrail_set_wheelset', stat, message)
  end subroutine

  subroutine test_rcwdev()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwdev(iwr, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], stat)
    call told('wheelrail_set_rail_deviation', 'wheelrail1 [1.125 1.25 1.375] [2.125 2.25 2.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwdev(iwr, [1.125d0, 1.25d0, 1.375d0], [2.125d0, 2.25d0, 2.375d0], stat)
    call rclerr(message)
    call failed('wheelrail_set_rail_deviation', stat, message)
  end subroutine

  subroutine test_rcwpos()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwpos(iwr, [1.125d0, 1.25d0, 1.375d0, 1.5d0, 1.625d0, 1.75d0], stat)
    call told('wheelrail_set_position', 'wheelrail1 [1.125 1.25 1.375 1.5 1.625 1.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwpos(iwr, [1.125d0, 1.25d0, 1.375d0, 1.5d0, 1.625d0, 1.75d0], stat)
    call rclerr(message)
    call failed('wheelrail_set_position', stat, message)
  end subroutine

  subroutine test_rcword()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcword(iwr, 11, stat)
    call told('wheelrail_set_roll_outside', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcword(iwr, 11, stat)
    call rclerr(message)
    call failed('wheelrail_set_roll_outside', stat, message)
  end subroutine

  subroutine test_rcwvel()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwvel(iwr, [1.125d0, 1.25d0, 1.375d0, 1.5d0, 1.625d0, 1.75d0], stat)
    call told('wheelrail_set_velocity', 'wheelrail1 [1.125 1.25 1.375 1.5 1.625 1.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwvel(iwr, [1.125d0, 1.25d0, 1.375d0, 1.5d0, 1.625d0, 1.75d0], stat)
    call rclerr(message)
    call failed('wheelrail_set_velocity', stat, message)
  end subroutine

  subroutine test_rcwvrt()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwvrt(iwr, 11, 2.5d0, stat)
    call told('wheelrail_prescribe_vertical', 'wheelrail1 11 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwvrt(iwr, 11, 2.5d0, stat)
    call rclerr(message)
    call failed('wheelrail_prescribe_vertical', stat, message)
  end subroutine

  subroutine test_rcwfri()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwfri(iwr, 1.5d0, stat)
    call told('wheelrail_set_friction', 'wheelrail1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwfri(iwr, 1.5d0, stat)
    call rclerr(message)
    call failed('wheelrail_set_friction', stat, message)
  end subroutine

  subroutine test_rcwtab()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwtab(iwr, itab, stat)
    call told('wheelrail_set_table', 'wheelrail1 table1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwtab(iwr, itab, stat)
    call rclerr(message)
    call failed('wheelrail_set_table', stat, message)
  end subroutine

  subroutine test_rcwnot()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwnot(iwr, stat)
    call told('wheelrail_forget_table', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwnot(iwr, stat)
    call rclerr(message)
    call failed('wheelrail_forget_table', stat, message)
  end subroutine

  subroutine test_rcwhtz()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwhtz(iwr, 11, stat)
    call told('wheelrail_set_hertzian', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwhtz(iwr, 11, stat)
    call rclerr(message)
    call failed('wheelrail_set_hertzian', stat, message)
  end subroutine

  subroutine test_rcwcnf()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwcnf(iwr, 11, stat)
    call told('wheelrail_set_conformal', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwcnf(iwr, 11, stat)
    call rclerr(message)
    call failed('wheelrail_set_conformal', stat, message)
  end subroutine

  subroutine test_rcwfra()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwfra(iwr, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], stat)
    call told('wheelrail_set_friction_by_angle', 'wheelrail1 2 [2.125 2.25 2.375 2.5]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwfra(iwr, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0], stat)
    call rclerr(message)
    call failed('wheelrail_set_friction_by_angle', stat, message)
  end subroutine

  subroutine test_rcwacc()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwacc(iwr, 1.5d0, stat)
    call told('wheelrail_set_accuracy', 'wheelrail1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwacc(iwr, 1.5d0, stat)
    call rclerr(message)
    call failed('wheelrail_set_accuracy', stat, message)
  end subroutine

  subroutine test_rcwslv()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwslv(iwr, stat)
    call told('wheelrail_solve', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwslv(iwr, stat)
    call rclerr(message)
    call failed('wheelrail_solve', stat, message)
  end subroutine

  subroutine test_rcwstp()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwstp(iwr, stat)
    call told('wheelrail_request_cancel', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwstp(iwr, stat)
    call rclerr(message)
    call failed('wheelrail_request_cancel', stat, message)
  end subroutine

  subroutine test_rcwmny()
    double precision :: totals(18)
    integer :: istatus(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwmny(iwr, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0], [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0, 4.375d0, &
      4.5d0], totals, istatus, stat)
    call told('wheelrail_solve_many', &
      'wheelrail1 2 [2.125 2.25 2.375 2.5 2.625 2.75 2.875 3 3.125 3.25 3.375 3.5] [3.125 3.25 3.375 3.5 3.625 3&
    &.75 3.875 4 4.125 4.25 4.375 4.5] room room', &
      stat)
    call gave_reals('totals', totals, 400.5_rc_real)
    call gave_integers('istatus', int(istatus), 500)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwmny(iwr, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0], [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0, 4.375d0, &
      4.5d0], totals, istatus, stat)
    call rclerr(message)
    call failed('wheelrail_solve_many', stat, message)
  end subroutine

  subroutine test_rcwfwr()
    double precision :: wheel(2)
    double precision :: rail(2)
    double precision :: volumes(2)
    integer :: istatus(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwfwr(iwr, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0], [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0, 4.375d0, &
      4.5d0], [4.125d0, 4.25d0], 'text 5', 2, [7.125d0, 7.25d0], 2, wheel, rail, volumes, istatus, stat)
    call told('wheelrail_find_wear', &
      'wheelrail1 2 [2.125 2.25 2.375 2.5 2.625 2.75 2.875 3 3.125 3.25 3.375 3.5] [3.125 3.25 3.375 3.5 3.625 3&
    &.75 3.875 4 4.125 4.25 4.375 4.5] [4.125 4.25] <text 5> 2 [7.125 7.25] 2 room room room room', &
      stat)
    call gave_reals('wheel', wheel, 900.5_rc_real)
    call gave_reals('rail', rail, 1000.5_rc_real)
    call gave_reals('volumes', volumes, 1100.5_rc_real)
    call gave_integers('istatus', int(istatus), 1200)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwfwr(iwr, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0], [3.125d0, 3.25d0, 3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0, 4.375d0, &
      4.5d0], [4.125d0, 4.25d0], 'text 5', 2, [7.125d0, 7.25d0], 2, wheel, rail, volumes, istatus, stat)
    call rclerr(message)
    call failed('wheelrail_find_wear', stat, message)
  end subroutine

  subroutine test_rcwsav()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwsav(iwr, 11, stat)
    call told('wheelrail_save', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwsav(iwr, 11, stat)
    call rclerr(message)
    call failed('wheelrail_save', stat, message)
  end subroutine

  subroutine test_rcwbck()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwbck(iwr, 11, stat)
    call told('wheelrail_restore', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwbck(iwr, 11, stat)
    call rclerr(message)
    call failed('wheelrail_restore', stat, message)
  end subroutine

  subroutine test_rcwcpy()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwcpy(iwr, ih, stat)
    call told('wheelrail_copy', 'wheelrail1 room', stat)
    call gave_kind(ih, 4)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwcpy(iwr, ih, stat)
    call rclerr(message)
    call failed('wheelrail_copy', stat, message)
  end subroutine

  subroutine test_rcwrst()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwrst(iwr, stat)
    call told('wheelrail_reset', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwrst(iwr, stat)
    call rclerr(message)
    call failed('wheelrail_reset', stat, message)
  end subroutine

  subroutine test_rcwnpa()
    integer :: ipatches
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwnpa(iwr, ipatches, stat)
    call told('wheelrail_get_patch_count', 'wheelrail1 room', stat)
    call gave_integers('ipatches', int([ipatches]), 100)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwnpa(iwr, ipatches, stat)
    call rclerr(message)
    call failed('wheelrail_get_patch_count', stat, message)
  end subroutine

  subroutine test_rcwres()
    double precision :: force(3)
    double precision :: xmoment(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwres(iwr, 11, force, xmoment, stat)
    call told('wheelrail_get_resultant', 'wheelrail1 11 room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('xmoment', xmoment, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwres(iwr, 11, force, xmoment, stat)
    call rclerr(message)
    call failed('wheelrail_get_resultant', stat, message)
  end subroutine

  subroutine test_rcwder()
    double precision :: force(3)
    double precision :: xmoment(3)
    double precision :: z
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwder(iwr, 11, force, xmoment, z, stat)
    call told('wheelrail_get_derivative', 'wheelrail1 11 room room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('xmoment', xmoment, 300.5_rc_real)
    call gave_reals('z', [z], 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwder(iwr, 11, force, xmoment, z, stat)
    call rclerr(message)
    call failed('wheelrail_get_derivative', stat, message)
  end subroutine

  subroutine test_rcwsta()
    double precision :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwsta(iwr, 'text 1', value, stat)
    call told('wheelrail_get_stat', 'wheelrail1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwsta(iwr, 'text 1', value, stat)
    call rclerr(message)
    call failed('wheelrail_get_stat', stat, message)
  end subroutine

  subroutine test_rcwstn()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwstn(1, text, stat)
    call told('wheelrail_stat_name', '0 28 room room', stat)
    call gave_text('text', text, 'text of wheelrail_stat_name')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwstn(1, text, stat)
    call rclerr(message)
    call failed('wheelrail_stat_name', stat, message)
  end subroutine

  subroutine test_rcwppt()
    double precision :: point(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwppt(iwr, 11, 2.5d0, point, stat)
    call told('wheelrail_get_profile_point', 'wheelrail1 11 2.5 room', stat)
    call gave_reals('point', point, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwppt(iwr, 11, 2.5d0, point, stat)
    call rclerr(message)
    call failed('wheelrail_get_profile_point', stat, message)
  end subroutine

  subroutine test_rcwpst()
    double precision :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwpst(iwr, 11, 'text 2', value, stat)
    call told('wheelrail_get_patch_stat', 'wheelrail1 10 <text 2> room', stat)
    call gave_reals('value', [value], 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwpst(iwr, 11, 'text 2', value, stat)
    call rclerr(message)
    call failed('wheelrail_get_patch_stat', stat, message)
  end subroutine

  subroutine test_rcwpsn()
    character(len=60) :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwpsn(1, text, stat)
    call told('wheelrail_patch_stat_name', '0 34 room room', stat)
    call gave_text('text', text, 'text of wheelrail_patch_stat_name')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwpsn(1, text, stat)
    call rclerr(message)
    call failed('wheelrail_patch_stat_name', stat, message)
  end subroutine

  subroutine test_rcwpax()
    double precision :: origin(3)
    double precision :: axes(9)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwpax(iwr, 11, origin, axes, stat)
    call told('wheelrail_get_patch_axes', 'wheelrail1 10 room room', stat)
    call gave_reals('origin', origin, 200.5_rc_real)
    call gave_reals('axes', axes, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwpax(iwr, 11, origin, axes, stat)
    call rclerr(message)
    call failed('wheelrail_get_patch_axes', stat, message)
  end subroutine

  subroutine test_rcwcon()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwcon(iwr, 11, ih, stat)
    call told('wheelrail_get_contact', 'wheelrail1 10 room', stat)
    call gave_kind(ih, 3)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwcon(iwr, 11, ih, stat)
    call rclerr(message)
    call failed('wheelrail_get_contact', stat, message)
  end subroutine

  subroutine test_rcwpts()
    double precision :: points(26)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwpts(iwr, iwr, 2, [3.125d0, 3.25d0], points, stat)
    call told('wheelrail_find_contact_points', 'wheelrail1 wheelrail1 2 [3.125 3.25] room', stat)
    call gave_reals('points', points, 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwpts(iwr, iwr, 2, [3.125d0, 3.25d0], points, stat)
    call rclerr(message)
    call failed('wheelrail_find_contact_points', stat, message)
  end subroutine

  subroutine test_rcwcnc()
    double precision :: conicity(2)
    double precision :: wavelength(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcwcnc(iwr, iwr, 2, [3.125d0, 3.25d0], conicity, wavelength, stat)
    call told('wheelrail_find_conicity', 'wheelrail1 wheelrail1 2 [3.125 3.25] room room', stat)
    call gave_reals('conicity', conicity, 400.5_rc_real)
    call gave_reals('wavelength', wavelength, 500.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcwcnc(iwr, iwr, 2, [3.125d0, 3.25d0], conicity, wavelength, stat)
    call rclerr(message)
    call failed('wheelrail_find_conicity', stat, message)
  end subroutine

  subroutine test_rctabl()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctabl(ictx, ih, stat)
    call told('table_create', 'context1 room', stat)
    call gave_kind(ih, 5)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctabl(ictx, ih, stat)
    call rclerr(message)
    call failed('table_create', stat, message)
  end subroutine

  subroutine test_rctlod()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctlod(ictx, 'text 1', ih, stat)
    call told('table_load', 'context1 <text 1> room', stat)
    call gave_kind(ih, 5)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctlod(ictx, 'text 1', ih, stat)
    call rclerr(message)
    call failed('table_load', stat, message)
  end subroutine

  subroutine test_rctstd()
    integer :: ih
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctstd(ictx, ih, stat)
    call told('table_standard', 'context1 room', stat)
    call gave_kind(ih, 5)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctstd(ictx, ih, stat)
    call rclerr(message)
    call failed('table_standard', stat, message)
  end subroutine

  subroutine test_rctrat()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctrat(itab, 11, 2.5d0, 3.5d0, stat)
    call told('table_set_ratios', 'table1 11 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctrat(itab, 11, 2.5d0, 3.5d0, stat)
    call rclerr(message)
    call failed('table_set_ratios', stat, message)
  end subroutine

  subroutine test_rctres()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctres(itab, 11, 21, 31, stat)
    call told('table_set_resolution', 'table1 11 21 31', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctres(itab, 11, 21, 31, stat)
    call rclerr(message)
    call failed('table_set_resolution', stat, message)
  end subroutine

  subroutine test_rctfrm()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctfrm(itab, 11, 21, stat)
    call told('table_set_frame', 'table1 11 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctfrm(itab, 11, 21, stat)
    call rclerr(message)
    call failed('table_set_frame', stat, message)
  end subroutine

  subroutine test_rctpoi()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctpoi(itab, 2, [2.125d0, 2.25d0], stat)
    call told('table_set_poissons', 'table1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctpoi(itab, 2, [2.125d0, 2.25d0], stat)
    call rclerr(message)
    call failed('table_set_poissons', stat, message)
  end subroutine

  subroutine test_rctbod()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctbod(itab, [1.125d0, 1.25d0], [2.125d0, 2.25d0], 2, [4.125d0, 4.25d0], stat)
    call told('table_set_bodies', 'table1 [1.125 1.25] [2.125 2.25] 2 [4.125 4.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctbod(itab, [1.125d0, 1.25d0], [2.125d0, 2.25d0], 2, [4.125d0, 4.25d0], stat)
    call rclerr(message)
    call failed('table_set_bodies', stat, message)
  end subroutine

  subroutine test_rctstp()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctstp(itab, stat)
    call told('table_request_cancel', 'table1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctstp(itab, stat)
    call rclerr(message)
    call failed('table_request_cancel', stat, message)
  end subroutine

  subroutine test_rctmak()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctmak(itab, 11, 21, stat)
    call told('table_make', 'table1 11 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctmak(itab, 11, 21, stat)
    call rclerr(message)
    call failed('table_make', stat, message)
  end subroutine

  subroutine test_rctgsm()
    double precision :: samples(6)
    integer :: icount
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctgsm(itab, 6, samples, icount, stat)
    call told('table_get_samples', 'table1 6 room room', stat)
    call gave_reals('samples', samples, 200.5_rc_real)
    call gave_integers('icount', int([icount]), 300)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctgsm(itab, 6, samples, icount, stat)
    call rclerr(message)
    call failed('table_get_samples', stat, message)
  end subroutine

  subroutine test_rctasm()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctasm(itab, 2, [2.125d0, 2.25d0], stat)
    call told('table_add_samples', 'table1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctasm(itab, 2, [2.125d0, 2.25d0], stat)
    call rclerr(message)
    call failed('table_add_samples', stat, message)
  end subroutine

  subroutine test_rctsav()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctsav(itab, 'text 1', stat)
    call told('table_save', 'table1 <text 1>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctsav(itab, 'text 1', stat)
    call rclerr(message)
    call failed('table_save', stat, message)
  end subroutine

  subroutine test_rcteva()
    double precision :: results(6)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rcteva(itab, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0], results, stat)
    call told('table_evaluate', &
      'table1 2 [2.125 2.25 2.375 2.5 2.625 2.75 2.875 3 3.125 3.25 3.375 3.5 3.625 3.75 3.875 4 4.125 4.25] room', &
      stat)
    call gave_reals('results', results, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rcteva(itab, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0], results, stat)
    call rclerr(message)
    call failed('table_evaluate', stat, message)
  end subroutine

  subroutine test_rctevd()
    double precision :: results(6)
    double precision :: derivatives(54)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctevd(itab, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0], results, derivatives, stat)
    call told('table_evaluate_derivatives', &
      'table1 2 [2.125 2.25 2.375 2.5 2.625 2.75 2.875 3 3.125 3.25 3.375 3.5 3.625 3.75 3.875 4 4.125 4.25] room room', &
      stat)
    call gave_reals('results', results, 300.5_rc_real)
    call gave_reals('derivatives', derivatives, 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctevd(itab, 2, [2.125d0, 2.25d0, 2.375d0, 2.5d0, 2.625d0, 2.75d0, 2.875d0, 3.0d0, 3.125d0, 3.25d0, &
      3.375d0, 3.5d0, 3.625d0, 3.75d0, 3.875d0, 4.0d0, 4.125d0, 4.25d0], results, derivatives, stat)
    call rclerr(message)
    call failed('table_evaluate_derivatives', stat, message)
  end subroutine

  subroutine test_rctcon()
    double precision :: results(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call rctcon(itab, icon, 2.5d0, results, stat)
    call told('table_evaluate_contact', 'table1 contact1 2.5 room', stat)
    call gave_reals('results', results, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call rctcon(itab, icon, 2.5d0, results, stat)
    call rclerr(message)
    call failed('table_evaluate_contact', stat, message)
  end subroutine
end program
