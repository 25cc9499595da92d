! Generated from bindings/api.toml by bindings/generate.py; do not edit.
!> The plain procedures of the types: every argument in its place.
program mapping_test
  use mapping
  use mapping_by_hand, only: mapped_by_hand
  use rollcon
  implicit none
  call begin()
  call body_set_elastic()
  call body_prepare()
  call body_get_kind()
  call body_save()
  call body_set_traction()
  call body_set_body_force()
  call body_set_rotation()
  call body_set_pressure()
  call body_set_contact_faces()
  call body_read_mesh()
  call body_tag_group()
  call body_get_group_count()
  call body_get_group_name()
  call body_set_profile()
  call body_set_profile_shape()
  call body_read_profile()
  call body_write_profile()
  call body_extrude_profile()
  call body_revolve_profile()
  call body_get_profile_length()
  call body_get_profile_point()
  call body_get_size()
  call body_get_reaction()
  call body_get_stat()
  call contact_read_frame()
  call contact_frame_from_body()
  call contact_frame_rectangle()
  call contact_frame_ellipse()
  call contact_frame_strips()
  call contact_frame_automatic()
  call contact_set_pose()
  call contact_set_axes()
  call contact_set_gap()
  call contact_set_gap_quadratic()
  call contact_set_gap_grid()
  call contact_set_rolling()
  call contact_set_creep()
  call contact_set_step()
  call contact_set_velocity()
  call contact_set_creep_field()
  call contact_prescribe()
  call contact_set_friction()
  call contact_set_friction_memory()
  call contact_set_layer()
  call contact_set_layer_yield()
  call contact_set_friction_across()
  call contact_set_heat()
  call contact_set_friction_field()
  call contact_request_cancel()
  call contact_solve()
  call contact_repeat_step()
  call contact_restore_past()
  call contact_reset()
  call contact_get_size()
  call contact_get_resultant()
  call contact_get_motion()
  call contact_get_tilt()
  call contact_get_sensitivity()
  call contact_get_fatigue_index()
  call contact_get_equivalent_ellipse()
  call contact_get_stat()
  call contact_get_plan()
  call contact_write()
  call wheelrail_set_track()
  call wheelrail_set_wheelset()
  call wheelrail_set_rail_deviation()
  call wheelrail_set_position()
  call wheelrail_set_roll_outside()
  call wheelrail_set_velocity()
  call wheelrail_prescribe_vertical()
  call wheelrail_set_friction()
  call wheelrail_forget_table()
  call wheelrail_set_hertzian()
  call wheelrail_set_conformal()
  call wheelrail_set_friction_by_angle()
  call wheelrail_set_accuracy()
  call wheelrail_solve()
  call wheelrail_request_cancel()
  call wheelrail_save()
  call wheelrail_restore()
  call wheelrail_reset()
  call wheelrail_get_patch_count()
  call wheelrail_get_resultant()
  call wheelrail_get_derivative()
  call wheelrail_get_stat()
  call wheelrail_get_profile_point()
  call wheelrail_get_patch_stat()
  call wheelrail_get_patch_axes()
  call table_set_ratios()
  call table_set_resolution()
  call table_set_frame()
  call table_set_poissons()
  call table_set_bodies()
  call table_request_cancel()
  call table_make()
  call table_add_samples()
  call table_save()
  call mapped_by_hand()
  call done('')
contains

  subroutine body_set_elastic()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_elastic(2.5_rc_real, 3.5_rc_real, stat=stat, errmsg=message)
    call told('body_set_elastic', 'body1 0 2.5 3.5', stat)
    call answers(ROLLCON_OK)
    call body%set_elastic(2.5_rc_real, 3.5_rc_real, 11, stat, message)
    call told('body_set_elastic', 'body1 11 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_elastic(2.5_rc_real, 3.5_rc_real, 11, stat, message)
    call failed('body_set_elastic', stat, message)
  end subroutine

  subroutine body_prepare()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%prepare(stat, message)
    call told('body_prepare', 'body1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%prepare(stat, message)
    call failed('body_prepare', stat, message)
  end subroutine

  subroutine body_get_kind()
    integer(rc_int) :: kind
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_kind(kind, stat, message)
    call told('body_get_kind', 'body1 room', stat)
    call gave_integers('kind', int([kind]), 100)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_kind(kind, stat, message)
    call failed('body_get_kind', stat, message)
  end subroutine

  subroutine body_save()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%save('text 1', stat, message)
    call told('body_save', 'body1 <text 1>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%save('text 1', stat, message)
    call failed('body_save', stat, message)
  end subroutine

  subroutine body_set_traction()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_traction(11, [2.125_rc_real, 2.25_rc_real, 2.375_rc_real], stat, message)
    call told('body_set_traction', 'body1 11 [2.125 2.25 2.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_traction(11, [2.125_rc_real, 2.25_rc_real, 2.375_rc_real], stat, message)
    call failed('body_set_traction', stat, message)
  end subroutine

  subroutine body_set_body_force()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_body_force(11, [2.125_rc_real, 2.25_rc_real, 2.375_rc_real], stat, message)
    call told('body_set_body_force', 'body1 11 [2.125 2.25 2.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_body_force(11, [2.125_rc_real, 2.25_rc_real, 2.375_rc_real], stat, message)
    call failed('body_set_body_force', stat, message)
  end subroutine

  subroutine body_set_rotation()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_rotation(11, 2.5_rc_real, [3.125_rc_real, 3.25_rc_real, 3.375_rc_real], [4.125_rc_real, &
      4.25_rc_real, 4.375_rc_real], stat, message)
    call told('body_set_rotation', 'body1 11 2.5 [3.125 3.25 3.375] [4.125 4.25 4.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_rotation(11, 2.5_rc_real, [3.125_rc_real, 3.25_rc_real, 3.375_rc_real], [4.125_rc_real, &
      4.25_rc_real, 4.375_rc_real], stat, message)
    call failed('body_set_rotation', stat, message)
  end subroutine

  subroutine body_set_pressure()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_pressure(11, 2.5_rc_real, stat, message)
    call told('body_set_pressure', 'body1 11 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_pressure(11, 2.5_rc_real, stat, message)
    call failed('body_set_pressure', stat, message)
  end subroutine

  subroutine body_set_contact_faces()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_contact_faces([21, 22], stat, message)
    call told('body_set_contact_faces', 'body1 2 [21 22]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_contact_faces([21, 22], stat, message)
    call failed('body_set_contact_faces', stat, message)
  end subroutine

  subroutine body_read_mesh()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%read_mesh('text 1', 'text 2', stat, message)
    call told('body_read_mesh', 'body1 <text 1> <text 2>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%read_mesh('text 1', 'text 2', stat, message)
    call failed('body_read_mesh', stat, message)
  end subroutine

  subroutine body_tag_group()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%tag_group('text 1', 21, stat, message)
    call told('body_tag_group', 'body1 <text 1> 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%tag_group('text 1', 21, stat, message)
    call failed('body_tag_group', stat, message)
  end subroutine

  subroutine body_get_group_count()
    integer :: n
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_group_count(n, stat, message)
    call told('body_get_group_count', 'body1 room', stat)
    call gave_integers('n', int([n]), 100)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_group_count(n, stat, message)
    call failed('body_get_group_count', stat, message)
  end subroutine

  subroutine body_get_group_name()
    character(len=:), allocatable :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_group_name(11, text, stat, message)
    call told('body_get_group_name', 'body1 10 28 room room', stat)
    call gave_text('text', text, 'text of body_get_group_name')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_group_name(11, text, stat, message)
    call failed('body_get_group_name', stat, message)
  end subroutine

  subroutine body_set_profile()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_profile(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, 2]), stat=stat, &
      errmsg=message)
    call told('body_set_profile', 'body1 2 [2.125 2.25 2.375 2.5] 0', stat)
    call answers(ROLLCON_OK)
    call body%set_profile(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, 2]), 3.5_rc_real, &
      stat, message)
    call told('body_set_profile', 'body1 2 [2.125 2.25 2.375 2.5] 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_profile(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, 2]), 3.5_rc_real, &
      stat, message)
    call failed('body_set_profile', stat, message)
  end subroutine

  subroutine body_set_profile_shape()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%set_profile_shape('text 1', [3.125_rc_real, 3.25_rc_real], stat, message)
    call told('body_set_profile_shape', 'body1 <text 1> 2 [3.125 3.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%set_profile_shape('text 1', [3.125_rc_real, 3.25_rc_real], stat, message)
    call failed('body_set_profile_shape', stat, message)
  end subroutine

  subroutine body_read_profile()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%read_profile('text 1', 2.5_rc_real, stat=stat, errmsg=message)
    call told('body_read_profile', 'body1 <text 1> 2.5 0 0', stat)
    call answers(ROLLCON_OK)
    call body%read_profile('text 1', 2.5_rc_real, 31, 4.5_rc_real, stat, message)
    call told('body_read_profile', 'body1 <text 1> 2.5 31 4.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%read_profile('text 1', 2.5_rc_real, 31, 4.5_rc_real, stat, message)
    call failed('body_read_profile', stat, message)
  end subroutine

  subroutine body_write_profile()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%write_profile('text 1', 2.5_rc_real, stat, message)
    call told('body_write_profile', 'body1 <text 1> 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%write_profile('text 1', 2.5_rc_real, stat, message)
    call failed('body_write_profile', stat, message)
  end subroutine

  subroutine body_extrude_profile()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%extrude_profile([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], [3.125_rc_real, 3.25_rc_real, 3.375_rc_real], stat, message)
    call told('body_extrude_profile', 'body1 [1.125 1.25 1.375] [2.125 2.25 2.375] [3.125 3.25 3.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%extrude_profile([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], [3.125_rc_real, 3.25_rc_real, 3.375_rc_real], stat, message)
    call failed('body_extrude_profile', stat, message)
  end subroutine

  subroutine body_revolve_profile()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%revolve_profile([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], 3.5_rc_real, stat, message)
    call told('body_revolve_profile', 'body1 [1.125 1.25 1.375] [2.125 2.25 2.375] 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%revolve_profile([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], 3.5_rc_real, stat, message)
    call failed('body_revolve_profile', stat, message)
  end subroutine

  subroutine body_get_profile_length()
    real(rc_real) :: length
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_profile_length(length, stat, message)
    call told('body_get_profile_length', 'body1 room', stat)
    call gave_reals('length', [length], 100.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_profile_length(length, stat, message)
    call failed('body_get_profile_length', stat, message)
  end subroutine

  subroutine body_get_profile_point()
    real(rc_real) :: point(2)
    real(rc_real) :: tangent(2)
    real(rc_real) :: curvature
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_profile_point(1.5_rc_real, point, tangent, curvature, stat, message)
    call told('body_get_profile_point', 'body1 1.5 room room room', stat)
    call gave_reals('point', point, 200.5_rc_real)
    call gave_reals('tangent', tangent, 300.5_rc_real)
    call gave_reals('curvature', [curvature], 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_profile_point(1.5_rc_real, point, tangent, curvature, stat, message)
    call failed('body_get_profile_point', stat, message)
  end subroutine

  subroutine body_get_size()
    integer :: nodes
    integer :: elements
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_size(nodes, elements, stat, message)
    call told('body_get_size', 'body1 room room', stat)
    call gave_integers('nodes', int([nodes]), 3)
    call gave_integers('elements', int([elements]), 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_size(nodes, elements, stat, message)
    call failed('body_get_size', stat, message)
  end subroutine

  subroutine body_get_reaction()
    real(rc_real) :: force(3)
    real(rc_real) :: moment(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_reaction(force, moment, stat, message)
    call told('body_get_reaction', 'body1 room room', stat)
    call gave_reals('force', force, 100.5_rc_real)
    call gave_reals('moment', moment, 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_reaction(force, moment, stat, message)
    call failed('body_get_reaction', stat, message)
  end subroutine

  subroutine body_get_stat()
    real(rc_real) :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call body%get_stat('text 1', value, stat, message)
    call told('body_get_stat', 'body1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call body%get_stat('text 1', value, stat, message)
    call failed('body_get_stat', stat, message)
  end subroutine

  subroutine contact_read_frame()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%read_frame('text 1', 'text 2', stat, message)
    call told('contact_read_frame', 'contact1 <text 1> <text 2>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%read_frame('text 1', 'text 2', stat, message)
    call failed('contact_read_frame', stat, message)
  end subroutine

  subroutine contact_frame_from_body()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%frame_from_body(11, 21, stat, message)
    call told('contact_frame_from_body', 'contact1 11 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%frame_from_body(11, 21, stat, message)
    call failed('contact_frame_from_body', stat, message)
  end subroutine

  subroutine contact_frame_rectangle()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%frame_rectangle(203_rc_int, 21, 31, 4.5_rc_real, 5.5_rc_real, 6.5_rc_real, 7.5_rc_real, stat, &
      message)
    call told('contact_frame_rectangle', 'contact1 203 21 31 4.5 5.5 6.5 7.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%frame_rectangle(203_rc_int, 21, 31, 4.5_rc_real, 5.5_rc_real, 6.5_rc_real, 7.5_rc_real, stat, &
      message)
    call failed('contact_frame_rectangle', stat, message)
  end subroutine

  subroutine contact_frame_ellipse()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%frame_ellipse(11, 21, 3.5_rc_real, 4.5_rc_real, stat=stat, errmsg=message)
    call told('contact_frame_ellipse', 'contact1 11 21 3.5 4.5 0', stat)
    call answers(ROLLCON_OK)
    call contact%frame_ellipse(11, 21, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, stat, message)
    call told('contact_frame_ellipse', 'contact1 11 21 3.5 4.5 5.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%frame_ellipse(11, 21, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, stat, message)
    call failed('contact_frame_ellipse', stat, message)
  end subroutine

  subroutine contact_frame_strips()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%frame_strips(11, reshape([3.125_rc_real, 3.25_rc_real, 3.375_rc_real, 3.5_rc_real, 3.625_rc_real, &
      3.75_rc_real], [3, 2]), stat, message)
    call told('contact_frame_strips', 'contact1 11 2 [3.125 3.25 3.375 3.5 3.625 3.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%frame_strips(11, reshape([3.125_rc_real, 3.25_rc_real, 3.375_rc_real, 3.5_rc_real, 3.625_rc_real, &
      3.75_rc_real], [3, 2]), stat, message)
    call failed('contact_frame_strips', stat, message)
  end subroutine

  subroutine contact_frame_automatic()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%frame_automatic(stat, message)
    call told('contact_frame_automatic', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%frame_automatic(stat, message)
    call failed('contact_frame_automatic', stat, message)
  end subroutine

  subroutine contact_set_pose()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_pose(11, reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real, 2.625_rc_real, &
      2.75_rc_real, 2.875_rc_real, 3.0_rc_real, 3.125_rc_real], [3, 3], order=[2, 1]), [3.125_rc_real, &
      3.25_rc_real, 3.375_rc_real], stat, message)
    call told('contact_set_pose', 'contact1 11 [2.125 2.25 2.375 2.5 2.625 2.75 2.875 3 3.125] [3.125 3.25 3.375]', &
      stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_pose(11, reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real, 2.625_rc_real, &
      2.75_rc_real, 2.875_rc_real, 3.0_rc_real, 3.125_rc_real], [3, 3], order=[2, 1]), [3.125_rc_real, &
      3.25_rc_real, 3.375_rc_real], stat, message)
    call failed('contact_set_pose', stat, message)
  end subroutine

  subroutine contact_set_axes()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_axes([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], [3.125_rc_real, 3.25_rc_real, 3.375_rc_real], stat, message)
    call told('contact_set_axes', 'contact1 [1.125 1.25 1.375] [2.125 2.25 2.375] [3.125 3.25 3.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_axes([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], [3.125_rc_real, 3.25_rc_real, 3.375_rc_real], stat, message)
    call failed('contact_set_axes', stat, message)
  end subroutine

  subroutine contact_set_gap()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_gap([2.125_rc_real, 2.25_rc_real], stat, message)
    call told('contact_set_gap', 'contact1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_gap([2.125_rc_real, 2.25_rc_real], stat, message)
    call failed('contact_set_gap', stat, message)
  end subroutine

  subroutine contact_set_gap_quadratic()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_gap_quadratic(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call told('contact_set_gap_quadratic', 'contact1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_gap_quadratic(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call failed('contact_set_gap_quadratic', stat, message)
  end subroutine

  subroutine contact_set_gap_grid()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_gap_grid(11, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, [7.125_rc_real, &
      7.25_rc_real], stat, message)
    call told('contact_set_gap_grid', 'contact1 11 2.5 3.5 4.5 5.5 2 [7.125 7.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_gap_grid(11, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, [7.125_rc_real, &
      7.25_rc_real], stat, message)
    call failed('contact_set_gap_grid', stat, message)
  end subroutine

  subroutine contact_set_rolling()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_rolling(1.5_rc_real, stat, message)
    call told('contact_set_rolling', 'contact1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_rolling(1.5_rc_real, stat, message)
    call failed('contact_set_rolling', stat, message)
  end subroutine

  subroutine contact_set_creep()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_creep(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call told('contact_set_creep', 'contact1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_creep(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call failed('contact_set_creep', stat, message)
  end subroutine

  subroutine contact_set_step()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_step(11_rc_int, 2.5_rc_real, stat, message)
    call told('contact_set_step', 'contact1 11 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_step(11_rc_int, 2.5_rc_real, stat, message)
    call failed('contact_set_step', stat, message)
  end subroutine

  subroutine contact_set_velocity()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_velocity(11, [2.125_rc_real, 2.25_rc_real, 2.375_rc_real], [3.125_rc_real, 3.25_rc_real, &
      3.375_rc_real], [4.125_rc_real, 4.25_rc_real, 4.375_rc_real], stat, message)
    call told('contact_set_velocity', 'contact1 11 [2.125 2.25 2.375] [3.125 3.25 3.375] [4.125 4.25 4.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_velocity(11, [2.125_rc_real, 2.25_rc_real, 2.375_rc_real], [3.125_rc_real, 3.25_rc_real, &
      3.375_rc_real], [4.125_rc_real, 4.25_rc_real, 4.375_rc_real], stat, message)
    call failed('contact_set_velocity', stat, message)
  end subroutine

  subroutine contact_set_creep_field()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_creep_field(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, 2]), stat, &
      message)
    call told('contact_set_creep_field', 'contact1 2 [2.125 2.25 2.375 2.5]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_creep_field(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, 2]), stat, &
      message)
    call failed('contact_set_creep_field', stat, message)
  end subroutine

  subroutine contact_prescribe()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%prescribe(11_rc_int, 21_rc_int, 3.5_rc_real, stat, message)
    call told('contact_prescribe', 'contact1 11 21 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%prescribe(11_rc_int, 21_rc_int, 3.5_rc_real, stat, message)
    call failed('contact_prescribe', stat, message)
  end subroutine

  subroutine contact_set_friction()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_friction('text 1', [3.125_rc_real, 3.25_rc_real], stat, message)
    call told('contact_set_friction', 'contact1 <text 1> 2 [3.125 3.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_friction('text 1', [3.125_rc_real, 3.25_rc_real], stat, message)
    call failed('contact_set_friction', stat, message)
  end subroutine

  subroutine contact_set_friction_memory()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_friction_memory(1.5_rc_real, 2.5_rc_real, stat, message)
    call told('contact_set_friction_memory', 'contact1 1.5 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_friction_memory(1.5_rc_real, 2.5_rc_real, stat, message)
    call failed('contact_set_friction_memory', stat, message)
  end subroutine

  subroutine contact_set_layer()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_layer(1.5_rc_real, stat, message)
    call told('contact_set_layer', 'contact1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_layer(1.5_rc_real, stat, message)
    call failed('contact_set_layer', stat, message)
  end subroutine

  subroutine contact_set_layer_yield()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_layer_yield(1.5_rc_real, 2.5_rc_real, stat, message)
    call told('contact_set_layer_yield', 'contact1 1.5 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_layer_yield(1.5_rc_real, 2.5_rc_real, stat, message)
    call failed('contact_set_layer_yield', stat, message)
  end subroutine

  subroutine contact_set_friction_across()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_friction_across(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, 2]), &
      stat, message)
    call told('contact_set_friction_across', 'contact1 2 [2.125 2.25 2.375 2.5]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_friction_across(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, 2]), &
      stat, message)
    call failed('contact_set_friction_across', stat, message)
  end subroutine

  subroutine contact_set_heat()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_heat(11, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, stat, message)
    call told('contact_set_heat', 'contact1 11 2.5 3.5 4.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_heat(11, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, stat, message)
    call failed('contact_set_heat', stat, message)
  end subroutine

  subroutine contact_set_friction_field()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%set_friction_field([2.125_rc_real, 2.25_rc_real], stat, message)
    call told('contact_set_friction_field', 'contact1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%set_friction_field([2.125_rc_real, 2.25_rc_real], stat, message)
    call failed('contact_set_friction_field', stat, message)
  end subroutine

  subroutine contact_request_cancel()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%request_cancel(stat, message)
    call told('contact_request_cancel', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%request_cancel(stat, message)
    call failed('contact_request_cancel', stat, message)
  end subroutine

  subroutine contact_solve()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%solve(stat, message)
    call told('contact_solve', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%solve(stat, message)
    call failed('contact_solve', stat, message)
  end subroutine

  subroutine contact_repeat_step()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%repeat_step(stat, message)
    call told('contact_repeat_step', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%repeat_step(stat, message)
    call failed('contact_repeat_step', stat, message)
  end subroutine

  subroutine contact_restore_past()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%restore_past([2.125_rc_real, 2.25_rc_real], stat, message)
    call told('contact_restore_past', 'contact1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%restore_past([2.125_rc_real, 2.25_rc_real], stat, message)
    call failed('contact_restore_past', stat, message)
  end subroutine

  subroutine contact_reset()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%reset(stat, message)
    call told('contact_reset', 'contact1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%reset(stat, message)
    call failed('contact_reset', stat, message)
  end subroutine

  subroutine contact_get_size()
    integer :: nodes
    integer :: elements
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_size(nodes, elements, stat, message)
    call told('contact_get_size', 'contact1 room room', stat)
    call gave_integers('nodes', int([nodes]), 3)
    call gave_integers('elements', int([elements]), 2)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_size(nodes, elements, stat, message)
    call failed('contact_get_size', stat, message)
  end subroutine

  subroutine contact_get_resultant()
    real(rc_real) :: force(3)
    real(rc_real) :: moment(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_resultant(force, moment, stat=stat, errmsg=message)
    call told('contact_get_resultant', 'contact1 0 room room', stat)
    call answers(ROLLCON_OK)
    call contact%get_resultant(force, moment, 11_rc_int, stat, message)
    call told('contact_get_resultant', 'contact1 11 room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('moment', moment, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_resultant(force, moment, 11_rc_int, stat, message)
    call failed('contact_get_resultant', stat, message)
  end subroutine

  subroutine contact_get_motion()
    real(rc_real) :: approach
    real(rc_real) :: creep(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_motion(approach, creep, stat, message)
    call told('contact_get_motion', 'contact1 room room', stat)
    call gave_reals('approach', [approach], 100.5_rc_real)
    call gave_reals('creep', creep, 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_motion(approach, creep, stat, message)
    call failed('contact_get_motion', stat, message)
  end subroutine

  subroutine contact_get_tilt()
    real(rc_real) :: tilt(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_tilt(tilt, stat, message)
    call told('contact_get_tilt', 'contact1 room', stat)
    call gave_reals('tilt', tilt, 100.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_tilt(tilt, stat, message)
    call failed('contact_get_tilt', stat, message)
  end subroutine

  subroutine contact_get_sensitivity()
    real(rc_real) :: force(3)
    real(rc_real) :: moment(3)
    real(rc_real) :: approach
    real(rc_real) :: creep(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_sensitivity(11_rc_int, force, moment, approach, creep, stat, message)
    call told('contact_get_sensitivity', 'contact1 11 room room room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('moment', moment, 300.5_rc_real)
    call gave_reals('approach', [approach], 400.5_rc_real)
    call gave_reals('creep', creep, 500.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_sensitivity(11_rc_int, force, moment, approach, creep, stat, message)
    call failed('contact_get_sensitivity', stat, message)
  end subroutine

  subroutine contact_get_fatigue_index()
    real(rc_real) :: index
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_fatigue_index(1.5_rc_real, index, stat, message)
    call told('contact_get_fatigue_index', 'contact1 1.5 room', stat)
    call gave_reals('index', [index], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_fatigue_index(1.5_rc_real, index, stat, message)
    call failed('contact_get_fatigue_index', stat, message)
  end subroutine

  subroutine contact_get_equivalent_ellipse()
    real(rc_real) :: inputs(9)
    real(rc_real) :: center(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_equivalent_ellipse(inputs, center, stat, message)
    call told('contact_get_equivalent_ellipse', 'contact1 room room', stat)
    call gave_reals('inputs', inputs, 100.5_rc_real)
    call gave_reals('center', center, 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_equivalent_ellipse(inputs, center, stat, message)
    call failed('contact_get_equivalent_ellipse', stat, message)
  end subroutine

  subroutine contact_get_stat()
    real(rc_real) :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_stat('text 1', value, stat, message)
    call told('contact_get_stat', 'contact1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_stat('text 1', value, stat, message)
    call failed('contact_get_stat', stat, message)
  end subroutine

  subroutine contact_get_plan()
    character(len=:), allocatable :: text
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%get_plan(text, stat, message)
    call told('contact_get_plan', 'contact1 25 room room', stat)
    call gave_text('text', text, 'text of contact_get_plan')
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%get_plan(text, stat, message)
    call failed('contact_get_plan', stat, message)
  end subroutine

  subroutine contact_write()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call contact%write_vtu('text 1', stat, message)
    call told('contact_write', 'contact1 <text 1>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call contact%write_vtu('text 1', stat, message)
    call failed('contact_write', stat, message)
  end subroutine

  subroutine wheelrail_set_track()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_track(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call told('wheelrail_set_track', 'wheelrail1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_track(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call failed('wheelrail_set_track', stat, message)
  end subroutine

  subroutine wheelrail_set_wheelset()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_wheelset(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call told('wheelrail_set_wheelset', 'wheelrail1 1.5 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_wheelset(1.5_rc_real, 2.5_rc_real, 3.5_rc_real, stat, message)
    call failed('wheelrail_set_wheelset', stat, message)
  end subroutine

  subroutine wheelrail_set_rail_deviation()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_rail_deviation([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], stat, message)
    call told('wheelrail_set_rail_deviation', 'wheelrail1 [1.125 1.25 1.375] [2.125 2.25 2.375]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_rail_deviation([1.125_rc_real, 1.25_rc_real, 1.375_rc_real], [2.125_rc_real, 2.25_rc_real, &
      2.375_rc_real], stat, message)
    call failed('wheelrail_set_rail_deviation', stat, message)
  end subroutine

  subroutine wheelrail_set_position()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_position([1.125_rc_real, 1.25_rc_real, 1.375_rc_real, 1.5_rc_real, 1.625_rc_real, &
      1.75_rc_real], stat, message)
    call told('wheelrail_set_position', 'wheelrail1 [1.125 1.25 1.375 1.5 1.625 1.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_position([1.125_rc_real, 1.25_rc_real, 1.375_rc_real, 1.5_rc_real, 1.625_rc_real, &
      1.75_rc_real], stat, message)
    call failed('wheelrail_set_position', stat, message)
  end subroutine

  subroutine wheelrail_set_roll_outside()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_roll_outside(11, stat, message)
    call told('wheelrail_set_roll_outside', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_roll_outside(11, stat, message)
    call failed('wheelrail_set_roll_outside', stat, message)
  end subroutine

  subroutine wheelrail_set_velocity()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_velocity([1.125_rc_real, 1.25_rc_real, 1.375_rc_real, 1.5_rc_real, 1.625_rc_real, &
      1.75_rc_real], stat, message)
    call told('wheelrail_set_velocity', 'wheelrail1 [1.125 1.25 1.375 1.5 1.625 1.75]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_velocity([1.125_rc_real, 1.25_rc_real, 1.375_rc_real, 1.5_rc_real, 1.625_rc_real, &
      1.75_rc_real], stat, message)
    call failed('wheelrail_set_velocity', stat, message)
  end subroutine

  subroutine wheelrail_prescribe_vertical()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%prescribe_vertical(11_rc_int, stat=stat, errmsg=message)
    call told('wheelrail_prescribe_vertical', 'wheelrail1 11 0', stat)
    call answers(ROLLCON_OK)
    call wheelrail%prescribe_vertical(11_rc_int, 2.5_rc_real, stat, message)
    call told('wheelrail_prescribe_vertical', 'wheelrail1 11 2.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%prescribe_vertical(11_rc_int, 2.5_rc_real, stat, message)
    call failed('wheelrail_prescribe_vertical', stat, message)
  end subroutine

  subroutine wheelrail_set_friction()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_friction(1.5_rc_real, stat, message)
    call told('wheelrail_set_friction', 'wheelrail1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_friction(1.5_rc_real, stat, message)
    call failed('wheelrail_set_friction', stat, message)
  end subroutine

  subroutine wheelrail_forget_table()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%forget_table(stat, message)
    call told('wheelrail_forget_table', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%forget_table(stat, message)
    call failed('wheelrail_forget_table', stat, message)
  end subroutine

  subroutine wheelrail_set_hertzian()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_hertzian(11, stat, message)
    call told('wheelrail_set_hertzian', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_hertzian(11, stat, message)
    call failed('wheelrail_set_hertzian', stat, message)
  end subroutine

  subroutine wheelrail_set_conformal()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_conformal(11, stat, message)
    call told('wheelrail_set_conformal', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_conformal(11, stat, message)
    call failed('wheelrail_set_conformal', stat, message)
  end subroutine

  subroutine wheelrail_set_friction_by_angle()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_friction_by_angle(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, &
      2]), stat, message)
    call told('wheelrail_set_friction_by_angle', 'wheelrail1 2 [2.125 2.25 2.375 2.5]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_friction_by_angle(reshape([2.125_rc_real, 2.25_rc_real, 2.375_rc_real, 2.5_rc_real], [2, &
      2]), stat, message)
    call failed('wheelrail_set_friction_by_angle', stat, message)
  end subroutine

  subroutine wheelrail_set_accuracy()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%set_accuracy(1.5_rc_real, stat, message)
    call told('wheelrail_set_accuracy', 'wheelrail1 1.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%set_accuracy(1.5_rc_real, stat, message)
    call failed('wheelrail_set_accuracy', stat, message)
  end subroutine

  subroutine wheelrail_solve()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%solve(stat, message)
    call told('wheelrail_solve', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%solve(stat, message)
    call failed('wheelrail_solve', stat, message)
  end subroutine

  subroutine wheelrail_request_cancel()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%request_cancel(stat, message)
    call told('wheelrail_request_cancel', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%request_cancel(stat, message)
    call failed('wheelrail_request_cancel', stat, message)
  end subroutine

  subroutine wheelrail_save()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%save(11, stat, message)
    call told('wheelrail_save', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%save(11, stat, message)
    call failed('wheelrail_save', stat, message)
  end subroutine

  subroutine wheelrail_restore()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%restore(11, stat, message)
    call told('wheelrail_restore', 'wheelrail1 11', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%restore(11, stat, message)
    call failed('wheelrail_restore', stat, message)
  end subroutine

  subroutine wheelrail_reset()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%reset(stat, message)
    call told('wheelrail_reset', 'wheelrail1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%reset(stat, message)
    call failed('wheelrail_reset', stat, message)
  end subroutine

  subroutine wheelrail_get_patch_count()
    integer :: patches
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%get_patch_count(patches, stat, message)
    call told('wheelrail_get_patch_count', 'wheelrail1 room', stat)
    call gave_integers('patches', int([patches]), 100)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%get_patch_count(patches, stat, message)
    call failed('wheelrail_get_patch_count', stat, message)
  end subroutine

  subroutine wheelrail_get_resultant()
    real(rc_real) :: force(3)
    real(rc_real) :: moment(3)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%get_resultant(force, moment, stat=stat, errmsg=message)
    call told('wheelrail_get_resultant', 'wheelrail1 0 room room', stat)
    call answers(ROLLCON_OK)
    call wheelrail%get_resultant(force, moment, 11_rc_int, stat, message)
    call told('wheelrail_get_resultant', 'wheelrail1 11 room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('moment', moment, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%get_resultant(force, moment, 11_rc_int, stat, message)
    call failed('wheelrail_get_resultant', stat, message)
  end subroutine

  subroutine wheelrail_get_derivative()
    real(rc_real) :: force(3)
    real(rc_real) :: moment(3)
    real(rc_real) :: z
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%get_derivative(11, force, moment, z, stat, message)
    call told('wheelrail_get_derivative', 'wheelrail1 11 room room room', stat)
    call gave_reals('force', force, 200.5_rc_real)
    call gave_reals('moment', moment, 300.5_rc_real)
    call gave_reals('z', [z], 400.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%get_derivative(11, force, moment, z, stat, message)
    call failed('wheelrail_get_derivative', stat, message)
  end subroutine

  subroutine wheelrail_get_stat()
    real(rc_real) :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%get_stat('text 1', value, stat, message)
    call told('wheelrail_get_stat', 'wheelrail1 <text 1> room', stat)
    call gave_reals('value', [value], 200.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%get_stat('text 1', value, stat, message)
    call failed('wheelrail_get_stat', stat, message)
  end subroutine

  subroutine wheelrail_get_profile_point()
    real(rc_real) :: point(2)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%get_profile_point(11, 2.5_rc_real, point, stat, message)
    call told('wheelrail_get_profile_point', 'wheelrail1 11 2.5 room', stat)
    call gave_reals('point', point, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%get_profile_point(11, 2.5_rc_real, point, stat, message)
    call failed('wheelrail_get_profile_point', stat, message)
  end subroutine

  subroutine wheelrail_get_patch_stat()
    real(rc_real) :: value
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%get_patch_stat(11, 'text 2', value, stat, message)
    call told('wheelrail_get_patch_stat', 'wheelrail1 10 <text 2> room', stat)
    call gave_reals('value', [value], 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%get_patch_stat(11, 'text 2', value, stat, message)
    call failed('wheelrail_get_patch_stat', stat, message)
  end subroutine

  subroutine wheelrail_get_patch_axes()
    real(rc_real) :: origin(3)
    real(rc_real) :: axes(9)
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call wheelrail%get_patch_axes(11, origin, axes, stat, message)
    call told('wheelrail_get_patch_axes', 'wheelrail1 10 room room', stat)
    call gave_reals('origin', origin, 200.5_rc_real)
    call gave_reals('axes', axes, 300.5_rc_real)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call wheelrail%get_patch_axes(11, origin, axes, stat, message)
    call failed('wheelrail_get_patch_axes', stat, message)
  end subroutine

  subroutine table_set_ratios()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%set_ratios(11, 2.5_rc_real, 3.5_rc_real, stat, message)
    call told('table_set_ratios', 'table1 11 2.5 3.5', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%set_ratios(11, 2.5_rc_real, 3.5_rc_real, stat, message)
    call failed('table_set_ratios', stat, message)
  end subroutine

  subroutine table_set_resolution()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%set_resolution(11, 21, 31, stat, message)
    call told('table_set_resolution', 'table1 11 21 31', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%set_resolution(11, 21, 31, stat, message)
    call failed('table_set_resolution', stat, message)
  end subroutine

  subroutine table_set_frame()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%set_frame(11, 21, stat, message)
    call told('table_set_frame', 'table1 11 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%set_frame(11, 21, stat, message)
    call failed('table_set_frame', stat, message)
  end subroutine

  subroutine table_set_poissons()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%set_poissons([2.125_rc_real, 2.25_rc_real], stat, message)
    call told('table_set_poissons', 'table1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%set_poissons([2.125_rc_real, 2.25_rc_real], stat, message)
    call failed('table_set_poissons', stat, message)
  end subroutine

  subroutine table_set_bodies()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%set_bodies([1.125_rc_real, 1.25_rc_real], [2.125_rc_real, 2.25_rc_real], [4.125_rc_real, &
      4.25_rc_real], stat, message)
    call told('table_set_bodies', 'table1 [1.125 1.25] [2.125 2.25] 2 [4.125 4.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%set_bodies([1.125_rc_real, 1.25_rc_real], [2.125_rc_real, 2.25_rc_real], [4.125_rc_real, &
      4.25_rc_real], stat, message)
    call failed('table_set_bodies', stat, message)
  end subroutine

  subroutine table_request_cancel()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%request_cancel(stat, message)
    call told('table_request_cancel', 'table1', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%request_cancel(stat, message)
    call failed('table_request_cancel', stat, message)
  end subroutine

  subroutine table_make()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%make(11, 21, stat, message)
    call told('table_make', 'table1 11 21', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%make(11, 21, stat, message)
    call failed('table_make', stat, message)
  end subroutine

  subroutine table_add_samples()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%add_samples([2.125_rc_real, 2.25_rc_real], stat, message)
    call told('table_add_samples', 'table1 2 [2.125 2.25]', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%add_samples([2.125_rc_real, 2.25_rc_real], stat, message)
    call failed('table_add_samples', stat, message)
  end subroutine

  subroutine table_save()
    integer :: stat
    character(len=80) :: message
    call answers(ROLLCON_OK)
    call table%save('text 1', stat, message)
    call told('table_save', 'table1 <text 1>', stat)
    call answers(ROLLCON_ERR_STATE)
    message = ''
    call table%save('text 1', stat, message)
    call failed('table_save', stat, message)
  end subroutine
end program
