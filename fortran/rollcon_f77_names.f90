! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.

!> A text of the library with this layer's names in place of those of rollcon.h.
module rollcon_f77_names
  implicit none
  private
  public :: names_77
  integer, parameter :: count = 102
  type :: pair
    character(len=48) :: c
    character(len=16) :: f77
  end type
contains

  pure function names_77(text) result(told)
    character(len=*), intent(in) :: text
    character(len=:), allocatable :: told
    type(pair) :: name(count)
    integer :: i, at, length
    name(1) = pair('rollcon_contact_get_displacements_at', 'RCDISP')
    name(2) = pair('rollcon_contact_add_frame_elements', 'RCELEM')
    name(3) = pair('rollcon_contact_set_friction_field', 'RCFRIF')
    name(4) = pair('rollcon_contact_get_error_function', 'RCERRF')
    name(5) = pair('rollcon_contact_set_gap_quadratic', 'RCGAPQ')
    name(6) = pair('rollcon_body_tag_faces_of_nodes', 'RCBTGN')
    name(7) = pair('rollcon_body_get_profile_length', 'RCBPLE')
    name(8) = pair('rollcon_contact_set_frame_nodes', 'RCNODE or RCNODT')
    name(9) = pair('rollcon_contact_frame_from_body', 'RCFRAM')
    name(10) = pair('rollcon_contact_frame_rectangle', 'RCFREC')
    name(11) = pair('rollcon_contact_frame_automatic', 'RCFAUT')
    name(12) = pair('rollcon_contact_set_creep_field', 'RCCRPF')
    name(13) = pair('rollcon_contact_get_sensitivity', 'RCSENS')
    name(14) = pair('rollcon_body_set_contact_faces', 'RCBFAC')
    name(15) = pair('rollcon_body_set_profile_shape', 'RCBPSH')
    name(16) = pair('rollcon_body_get_profile_point', 'RCBPPT')
    name(17) = pair('rollcon_body_get_displacements', 'RCBDIS')
    name(18) = pair('rollcon_contact_request_cancel', 'RCSTOP')
    name(19) = pair('rollcon_contact_frame_ellipse', 'RCFELL')
    name(20) = pair('rollcon_contact_get_tractions', 'RCTRAC')
    name(21) = pair('rollcon_contact_get_resultant', 'RCRESU')
    name(22) = pair('rollcon_body_extrude_profile', 'RCBEXT')
    name(23) = pair('rollcon_body_revolve_profile', 'RCBREV')
    name(24) = pair('rollcon_contact_frame_strips', 'RCFSTR')
    name(25) = pair('rollcon_contact_set_gap_grid', 'RCGAPG')
    name(26) = pair('rollcon_contact_set_velocity', 'RCVEL')
    name(27) = pair('rollcon_contact_set_friction', 'RCFRIC')
    name(28) = pair('rollcon_contact_set_progress', 'RCPROG or RCNOPR')
    name(29) = pair('rollcon_context_set_threads', 'RCTHRD')
    name(30) = pair('rollcon_contact_set_rolling', 'RCROLL')
    name(31) = pair('rollcon_contact_get_history', 'RCHIST')
    name(32) = pair('rollcon_body_write_profile', 'RCBPWR')
    name(33) = pair('rollcon_contact_solve_many', 'RCCASE')
    name(34) = pair('rollcon_contact_get_status', 'RCNSTA')
    name(35) = pair('rollcon_contact_get_motion', 'RCMOTN')
    name(36) = pair('rollcon_context_set_latch', 'RCLTCH')
    name(37) = pair('rollcon_body_add_elements', 'RCBELM')
    name(38) = pair('rollcon_body_set_traction', 'RCBTRC')
    name(39) = pair('rollcon_body_set_pressure', 'RCBPRS')
    name(40) = pair('rollcon_body_option_count', 'RCBNOP')
    name(41) = pair('rollcon_body_read_profile', 'RCBPRD')
    name(42) = pair('rollcon_body_get_reaction', 'RCBREA')
    name(43) = pair('rollcon_contact_set_creep', 'RCCRP')
    name(44) = pair('rollcon_contact_prescribe', 'RCPRES')
    name(45) = pair('rollcon_contact_get_field', 'RCFELD')
    name(46) = pair('rollcon_body_set_elastic', 'RCELAS')
    name(47) = pair('rollcon_body_set_support', 'RCSUPP or RCHOLD')
    name(48) = pair('rollcon_body_option_info', 'RCBOPI')
    name(49) = pair('rollcon_body_set_profile', 'RCBPRO')
    name(50) = pair('rollcon_contact_set_pose', 'RCPOSE')
    name(51) = pair('rollcon_contact_set_axes', 'RCAXES')
    name(52) = pair('rollcon_contact_set_real', 'RCSETR')
    name(53) = pair('rollcon_contact_get_real', 'RCGETR')
    name(54) = pair('rollcon_contact_get_size', 'RCSIZE')
    name(55) = pair('rollcon_contact_get_stat', 'RCSTAT')
    name(56) = pair('rollcon_contact_get_plan', 'RCPLAN')
    name(57) = pair('rollcon_context_release', 'RCFREE')
    name(58) = pair('rollcon_context_set_log', 'RCLOG')
    name(59) = pair('rollcon_body_option_doc', 'RCBOPD')
    name(60) = pair('rollcon_body_stat_count', 'RCBNST')
    name(61) = pair('rollcon_contact_release', 'RCFREE')
    name(62) = pair('rollcon_contact_set_gap', 'RCGAP')
    name(63) = pair('rollcon_contact_set_int', 'RCSETI')
    name(64) = pair('rollcon_contact_set_str', 'RCSETS')
    name(65) = pair('rollcon_contact_get_int', 'RCGETI')
    name(66) = pair('rollcon_contact_get_str', 'RCGETS')
    name(67) = pair('rollcon_version_string', 'RCVERS')
    name(68) = pair('rollcon_context_create', 'RCINIT')
    name(69) = pair('rollcon_context_retain', 'RCKEEP')
    name(70) = pair('rollcon_body_set_nodes', 'RCBNOD or RCBNDT')
    name(71) = pair('rollcon_body_tag_faces', 'RCBTGF')
    name(72) = pair('rollcon_body_stat_name', 'RCBSTN')
    name(73) = pair('rollcon_contact_create', 'RCPAIR')
    name(74) = pair('rollcon_contact_retain', 'RCKEEP')
    name(75) = pair('rollcon_status_string', 'RCSTEX')
    name(76) = pair('rollcon_context_check', 'RCCHEK')
    name(77) = pair('rollcon_body_get_kind', 'RCKIND')
    name(78) = pair('rollcon_body_set_real', 'RCBSTR')
    name(79) = pair('rollcon_body_get_real', 'RCBGTR')
    name(80) = pair('rollcon_body_get_size', 'RCBSIZ')
    name(81) = pair('rollcon_body_get_stat', 'RCBSTA')
    name(82) = pair('rollcon_contact_solve', 'RCSOLV')
    name(83) = pair('rollcon_contact_reset', 'RCRSET')
    name(84) = pair('rollcon_contact_write', 'RCWRIT')
    name(85) = pair('rollcon_body_release', 'RCFREE')
    name(86) = pair('rollcon_body_prepare', 'RCPREP')
    name(87) = pair('rollcon_body_set_int', 'RCBSTI')
    name(88) = pair('rollcon_body_get_int', 'RCBGTI')
    name(89) = pair('rollcon_option_count', 'RCNOPT')
    name(90) = pair('rollcon_has_feature', 'RCHAS')
    name(91) = pair('rollcon_body_create', 'RCBODY')
    name(92) = pair('rollcon_body_retain', 'RCKEEP')
    name(93) = pair('rollcon_option_info', 'RCOPTI')
    name(94) = pair('rollcon_build_info', 'RCINFO')
    name(95) = pair('rollcon_last_error', 'RCLERR')
    name(96) = pair('rollcon_option_doc', 'RCOPTD')
    name(97) = pair('rollcon_stat_count', 'RCNSTT')
    name(98) = pair('rollcon_body_save', 'RCBSAV')
    name(99) = pair('rollcon_body_load', 'RCBLOD')
    name(100) = pair('rollcon_stat_name', 'RCSTNM')
    name(101) = pair('rollcon_version', 'RCVERS')
    name(102) = pair('rollcon_abi', 'RCVERS')
    told = text
    do i = 1, count
      length = len_trim(name(i)%c)
      do
        at = index(told, name(i)%c(:length))
        if (at == 0) exit
        told = told(:at - 1)//trim(name(i)%f77)//told(at + length:)
      end do
    end do
  end function
end module rollcon_f77_names
