!> Tests the procedures of the Fortran 2008 layer that are written by hand: arguments, results, refusals.
module mapping_by_hand
  use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int32_t, c_int64_t, c_loc, c_ptr
  use mapping
  implicit none
  private
  public :: mapped_by_hand

  real(rc_real), parameter :: x(3, 2) = reshape([1.5_rc_real, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, &
    6.5_rc_real], [3, 2])
  character(len=*), parameter :: written = '[1.5 2.5 3.5 4.5 5.5 6.5]'
  integer(c_int64_t), parameter :: far = 4294967299_c_int64_t
  integer :: seen = 0
  integer, target :: mark = 77
  integer :: stat
  character(len=200) :: message

contains

  subroutine mapped_by_hand()
    call facts()
    call references()
    call callbacks()
    call meshes()
    call supports()
    call settings()
    call tables()
    call results()
    call cases()
    call patches()
    call wheelsets()
  end subroutine

  subroutine facts()
    call demand(rc_version() == 2 .and. rc_abi() == 1 .and. rc_has_feature('some name'), 'numbers of the library')
    call told('has_feature', '<some name>', 0)
    call gave_text('version', rc_version_string(), 'text of version_string')
    call gave_text('build', rc_build_info(), 'text of build_info')
    call gave_text('last error', rc_last_error(), 'text of last_error')
    call gave_text('last caveat', rc_last_caveat(), 'text of last_caveat')
    call gave_text('status', rc_status_string(-7), 'text of status_string')
    call told('status_string', '-7', 0)
  end subroutine

  subroutine force_tables()
    type(rc_table) :: other
    real(rc_real), allocatable :: samples(:)
    real(rc_real) :: inputs(9, 2), results(3, 2), derivatives(9, 3, 2)
    integer :: i
    character(len=*), parameter :: listed = '[1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5 9.5 10.5 11.5 12.5 13.5 14.5 15.5 '// &
      '16.5 17.5 18.5]'
    inputs = reshape([(i + 0.5_rc_real, i=1, 18)], [9, 2])
    call other%load(context, 'a path ', stat, message)
    call told('table_load', 'context1 <a path> room', stat)
    call other%standard(context, stat, message)
    call told('table_standard', 'context1 room', stat)
    call table%evaluate(inputs, results, stat=stat)
    call told('table_evaluate', 'table1 2 '//listed//' room', stat)
    call gave_reals('results', reshape(results, [6]), 300.5_rc_real)
    call table%evaluate(inputs, results, derivatives, stat)
    call told('table_evaluate_derivatives', 'table1 2 '//listed//' room room', stat)
    call gave_reals('derivatives', reshape(derivatives, [54]), 400.5_rc_real)
    call table%evaluate_contact(contact, results(:, 1), stat=stat)
    call told('table_evaluate_contact', 'table1 contact1 -1 room', stat)
    call table%evaluate_contact(contact, results(:, 1), 0.25_rc_real, stat)
    call told('table_evaluate_contact', 'table1 contact1 0.25 room', stat)
    call table%get_samples(samples, stat)
    call status_is('samples', stat, 0)
    call table%evaluate(inputs(:8, :), results, stat=stat, errmsg=message)
    call status_is('inputs of 8', stat, int(ROLLCON_ERR_ARGUMENT))
    call answers(ROLLCON_ERR_STATE)
    call other%load(context, 'a path', stat, message)
    call failed('table_load', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call other%standard(context, stat, message)
    call failed('table_standard', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call table%evaluate(inputs, results, derivatives, stat, message)
    call failed('table_evaluate_derivatives', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call table%evaluate_contact(contact, results(:, 1), stat=stat, errmsg=message)
    call failed('table_evaluate_contact', stat, message)
    call answers(ROLLCON_OK)
  end subroutine

  subroutine references()
    type(rc_context) :: other
    type(rc_body) :: one
    type(rc_contact) :: two
    type(rc_wheelrail) :: three
    type(rc_table) :: four
    call told('context_create', '1 room', 0)
    other = context
    call told('context_retain', 'context1', 0)
    one = body2
    call told('body_retain', 'body2', 0)
    two = contact
    call told('contact_retain', 'contact1', 0)
    three = wheelrail
    call told('wheelrail_retain', 'wheelrail1', 0)
    four = table
    call told('table_retain', 'table1', 0)
    call four%free()
    call told('table_release', 'table1', 0)
    call three%free()
    call told('wheelrail_release', 'wheelrail1', 0)
    call two%free()
    call told('contact_release', 'contact1', 0)
    call one%free()
    call told('body_release', 'body2', 0)
    call other%free()
    call told('context_release', 'context1', 0)
    call other%from_id(context%id(), stat)
    call told('context_from_id', '268435457', stat)
    call one%from_id(body2%id(), stat)
    call told('body_from_id', '536870914', stat)
    call two%from_id(contact%id(), stat)
    call told('contact_from_id', '805306369', stat)
    call three%from_id(wheelrail%id(), stat)
    call told('wheelrail_from_id', '1073741825', stat)
    call told('id_of', 'wheelrail1', 0)
    call four%from_id(table%id(), stat)
    call told('table_from_id', '1342177281', stat)
    call force_tables()
    call one%load(context, 'a path ', stat, message)
    call told('body_load', 'context1 <a path> room', stat)
    call demand(one%id() /= body2%id(), 'a body of its own')
    call answers(ROLLCON_ERR_STATE)
    call one%load(context, 'a path', stat, message)
    call failed('body_load', stat, message)
    call demand(.not. c_associated(one%handle()), 'a failure leaves no body')
    call body%copy(one, stat, message)
    call told('body_copy', 'body1 room', stat)
    call demand(one%id() /= body%id(), 'a copy of its own')
    call answers(ROLLCON_ERR_STATE)
    call body%copy(one, stat, message)
    call failed('body_copy', stat, message)
    call demand(.not. c_associated(one%handle()), 'a failure leaves no copy')
    call context%set_threads(11, stat)
    call told('context_set_threads', 'context1 11', stat)
    call context%set_communicator(12, stat)
    call told('context_set_communicator', 'context1 12', stat)
    call context%set_latch(21, stat)
    call told('context_set_latch', 'context1 21', stat)
    call answers(ROLLCON_NOT_CONVERGED)
    call context%check(stat)
    call wrong('context_check', f_text_at(recorder_said(c_text('context_check'))), 'context1')
    call status_is('a status > 0', stat, int(ROLLCON_NOT_CONVERGED))
    call contact%solve()  ! this does not stop
    call answers(ROLLCON_ERR_STATE)
    call context%check(stat, message)
    call failed('context_check', stat, message)
  end subroutine

  !> Is called by the recorder: the event is 7.
  function watch(event, user) result(stop_now) bind(c)
    type(c_ptr), value :: event, user
    integer(c_int32_t) :: stop_now
    integer, pointer :: given
    stop_now = 5
    if (c_associated(user)) then
      call c_f_pointer(user, given)
      stop_now = int(given, c_int32_t)
    end if
    call demand(rc_event_int(event, ROLLCON_EVENT_ITERATION) == 200, 'integer of an event')
    call demand(.not. abs(rc_event_real(event, ROLLCON_EVENT_SECONDS) - 200.5_rc_real) > 0, 'real of an event')
  end function

  subroutine sink(level, text, user) bind(c)
    integer(c_int32_t), value :: level
    type(c_ptr), value :: text, user
    if (level == 2 .and. f_text_at(text) == 'a message') seen = seen + 1
    if (c_associated(user)) seen = seen + 10
  end subroutine

  subroutine callbacks()
    call contact%set_progress(watch, stat=stat)
    call told('contact_set_progress', 'contact1 5', stat)
    call told('event_get_int', '7 2 room', 0)
    call told('event_get_real', '7 102 room', 0)
    call contact%set_progress(watch, c_loc(mark), stat, message)
    call told('contact_set_progress', 'contact1 77', stat)
    call contact%set_progress(stat=stat)
    call told('contact_set_progress', 'contact1 null', stat)
    call table%set_progress(watch, c_loc(mark), stat, message)
    call told('table_set_progress', 'table1 77', stat)
    call table%set_progress(stat=stat)
    call told('table_set_progress', 'table1 null', stat)
    call context%set_log(ROLLCON_LOG_INFO, sink, stat=stat)
    call told('context_set_log', 'context1 3 0', stat)
    call context%set_log(ROLLCON_LOG_INFO, sink, c_loc(mark), stat)
    call demand(seen == 12, 'messages, and what the caller gave')
    call context%set_log(0_rc_int, stat=stat)
    call told('context_set_log', 'context1 0 null', stat)
  end subroutine

  subroutine meshes()
    integer(c_int32_t), parameter :: nodes(3, 2) = reshape([1_c_int32_t, 2_c_int32_t, 3_c_int32_t, 4_c_int32_t, &
      5_c_int32_t, 6_c_int32_t], [3, 2])
    integer(c_int64_t) :: wide(3, 2)
    call body%set_nodes(x, stat, message)
    call told('body_set_nodes', 'body1 2 '//written, stat)
    call body%set_nodes_by_component(transpose(x), stat, message)
    call told('body_set_nodes', 'body1 2 '//written, stat)
    call contact%frame_nodes(x, stat, message)
    call told('contact_frame_nodes', 'contact1 2 '//written, stat)
    call contact%frame_nodes_by_component(transpose(x), stat, message)
    call told('contact_frame_nodes', 'contact1 2 '//written, stat)
    call body%set_nodes(x(:2, :), stat, message)
    call refused('body1', stat, message, 'rc_body%set_nodes: the first extent of x must be 3')
    call body%set_nodes_by_component(x, stat, message)
    call refused('body1', stat, message, 'rc_body%set_nodes_by_component: the second extent of x must be 3')
    call contact%frame_nodes(x(:2, :), stat, message)
    call refused('contact1', stat, message, 'rc_contact%frame_nodes: the first extent of x must be 3')
    call contact%frame_nodes_by_component(x, stat, message)
    call refused('contact1', stat, message, 'rc_contact%frame_nodes_by_component: the second extent of x must be 3')

    call body%add_elements(ROLLCON_TRI3, nodes, 9, stat, message)
    call told('body_add_elements', 'body1 203 2 [1 2 3 4 5 6] 1 9', stat)
    call body%add_elements(ROLLCON_TRI3, nodes, stat=stat)
    call told('body_add_elements', 'body1 203 2 [1 2 3 4 5 6] 1 1', stat)
    wide = nodes
    wide(2, 1) = far  ! this names no node, instead of node 3
    call body%add_elements(ROLLCON_TRI3, wide, 9, stat, message)
    call told('body_add_elements', 'body1 203 2 [1 0 3 4 5 6] 1 9', stat)
    call body%add_elements(ROLLCON_TET4, reshape([1, 2, 3, 4], [4, 1]), stat=stat)
    call told('body_add_elements', 'body1 304 1 [1 2 3 4] 1 0', stat)
    call contact%frame_add_elements(ROLLCON_TRI3, nodes, 9, stat, message)
    call told('contact_frame_add_elements', 'contact1 203 2 [1 2 3 4 5 6] 1 9', stat)
    call contact%frame_add_elements(ROLLCON_TRI3, wide, stat=stat)
    call told('contact_frame_add_elements', 'contact1 203 2 [1 0 3 4 5 6] 1 1', stat)
    call body%add_elements(ROLLCON_QUAD4, nodes, 9, stat, message)
    call refused('body1', stat, message, &
      'rc_body%add_elements: the first extent of nodes must be the number of nodes of one element')
    call contact%frame_add_elements(ROLLCON_QUAD4, nodes, 9, stat, message)
    call refused('contact1', stat, message, &
      'rc_contact%frame_add_elements: the first extent of nodes must be the number of nodes of one element')
    call widths(body)
  end subroutine

  !> Tests that elements of every type have as many nodes as the library takes them to have.
  subroutine widths(b)
    type(rc_body), intent(inout) :: b
    integer(rc_int), parameter :: types(11) = [ROLLCON_TRI3, ROLLCON_TRI6, ROLLCON_QUAD4, ROLLCON_QUAD8, &
      ROLLCON_QUAD9, ROLLCON_TET4, ROLLCON_TET10, ROLLCON_WEDGE6, ROLLCON_WEDGE15, ROLLCON_HEX8, ROLLCON_HEX20]
    integer, parameter :: counts(11) = [3, 6, 4, 8, 9, 4, 10, 6, 15, 8, 20]
    integer :: ids(20, 1), i, n
    ids(:, 1) = [(i, i=1, 20)]
    do i = 1, 11
      n = counts(i)
      call b%add_elements(types(i), ids(:n, :), stat=stat)
      call status_is('nodes of an element', stat, 0)
      call b%add_elements(types(i), ids(:n - 1, :), stat=stat)
      call status_is('too few nodes of an element', stat, int(ROLLCON_ERR_ARGUMENT))
    end do
  end subroutine

  subroutine supports()
    integer(c_int32_t), parameter :: pair(2) = [5_c_int32_t, 6_c_int32_t], one(1) = [7_c_int32_t]
    integer(c_int64_t), parameter :: wide(2) = [5_c_int64_t, far]
    call body%tag_faces(pair, pair - 3_c_int32_t, 9, stat, message)
    call told('body_tag_faces', 'body1 2 [5 6] [2 3] 1 9', stat)
    call body%tag_faces(wide, wide - 3, 9, stat, message)
    call told('body_tag_faces', 'body1 2 [5 0] [2 0] 1 9', stat)
    call body%tag_faces(pair(1:0), pair(1:0), 9, stat)
    call told('body_tag_faces', 'body1 0 [] [] 1 9', stat)
    call body%tag_faces(pair, one, 9, stat, message)
    call refused('body1', stat, message, 'rc_body%tag_faces: the extents of elements and faces must be the same')
    call body%tag_faces_of_nodes(pair, 9, stat, message)
    call told('body_tag_faces_of_nodes', 'body1 2 [5 6] 1 9', stat)
    call body%tag_faces_of_nodes(wide, 9, stat, message)
    call told('body_tag_faces_of_nodes', 'body1 2 [5 0] 1 9', stat)
    call body%tag_faces_of_nodes(pair(1:0), 9, stat)
    call told('body_tag_faces_of_nodes', 'body1 0 [] 1 9', stat)
    call body%set_support(pair, ROLLCON_DOF_Y, x, stat, message)
    call told('body_set_support', 'body1 2 [5 6] 1 2 '//written, stat)
    call body%set_support(wide, stat=stat)
    call told('body_set_support', 'body1 2 [5 0] 1 7 [0 0 0 0 0 0]', stat)
    call body%set_support(one, ROLLCON_DOF_Y, x, stat, message)
    call refused('body1', stat, message, 'rc_body%set_support: the extents of values must be 3 and the number of nodes')
    call body%set_node_tractions(9, pair, x, [7.5_rc_real, 8.5_rc_real, 9.5_rc_real], stat, message)
    call told('body_set_node_tractions', 'body1 9 2 [5 6] 1 [7.5 8.5 9.5] '//written, stat)
    call body%set_node_tractions(9, pair, x, stat=stat)
    call told('body_set_node_tractions', 'body1 9 2 [5 6] 1 [0 0 0] '//written, stat)
    call body%set_node_tractions(9, one, x, stat=stat, errmsg=message)
    call refused('body1', stat, message, 'rc_body%set_node_tractions: the extents of tractions must be 3 and the number of nodes')
  end subroutine

  !> Tests settings by name, of a value's type.
  subroutine settings()
    integer(c_int32_t) :: narrow
    integer(c_int64_t) :: wide
    real(rc_real) :: value
    character(len=:), allocatable :: text
    call body%set('a name', 11_c_int32_t, stat)
    call told('body_set_int', 'body1 <a name> 11', stat)
    call body%set('a name', far, stat)
    call told('body_set_int', 'body1 <a name> 4294967299', stat)
    call body%set('a name', 1.5_rc_real, stat)
    call told('body_set_real', 'body1 <a name> 1.5', stat)
    call contact%set('a name', 11_c_int32_t, stat)
    call told('contact_set_int', 'contact1 <a name> 11', stat)
    call contact%set('a name', far, stat)
    call told('contact_set_int', 'contact1 <a name> 4294967299', stat)
    call contact%set('a name', 1.5_rc_real, stat)
    call told('contact_set_real', 'contact1 <a name> 1.5', stat)
    call contact%set('a name', 'a value', stat)
    call told('contact_set_str', 'contact1 <a name> <a value>', stat)
    call body%get('a name', narrow, stat)
    call told('body_get_int', 'body1 <a name> room', stat)
    call body%get('a name', wide, stat)
    call demand(narrow == 200 .and. wide == 200, 'integers of a body')
    call body%get('a name', value, stat)
    call told('body_get_real', 'body1 <a name> room', stat)
    call gave_reals('a real of a body', [value], 200.5_rc_real)
    call contact%get('a name', narrow, stat)
    call told('contact_get_int', 'contact1 <a name> room', stat)
    call contact%get('a name', wide, stat)
    call demand(narrow == 200 .and. wide == 200, 'integers of a contact')
    call contact%get('a name', value, stat)
    call told('contact_get_real', 'contact1 <a name> room', stat)
    call gave_reals('a real of a contact', [value], 200.5_rc_real)
    call contact%get('a name', text, stat)
    call told('contact_get_str', 'contact1 <a name> 24 room room', stat)
    call gave_text('a text of a contact', text, 'text of contact_get_str')
    call answers(ROLLCON_ERR_STATE)
    call contact%get('a name', text, stat, message)
    call failed('contact_get_str', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call body%set('a name', 1.5_rc_real, stat, message)
    call failed('body_set_real', stat, message)
  end subroutine

  subroutine tables()
    character(len=:), allocatable :: text, doc
    integer(rc_int) :: type
    integer :: inside
    real(rc_real) :: low, high, standard
    call demand(rc_option_count(ROLLCON_OF_BODY) == 2 .and. rc_stat_count(ROLLCON_OF_PATCH) == 2, 'counts')
    call told('option_count', '2', 0)
    call told('stat_count', '6', 0)
    call rc_option_info(ROLLCON_OF_BODY, 11, text, type, low, high, standard, doc, stat)
    call told('option_info', '2 10 4096 room room room room room room room', stat)
    call gave_text('name', text, 'text of option_info')
    call gave_text('doc', doc, 'text of option_info')
    call demand(type == 600, 'type')
    call gave_reals('low', [low], 700.5_rc_real)
    call gave_reals('high', [high], 800.5_rc_real)
    call gave_reals('standard', [standard], 900.5_rc_real)
    call rc_stat_info(ROLLCON_OF_WHEELRAIL, 11, text, doc, inside, stat)
    call told('stat_info', '4 10 4096 room room room room', stat)
    call gave_text('name', text, 'text of stat_info')
    call gave_text('doc', doc, 'text of stat_info')
    call demand(inside == 600, 'inside')
    call rc_stat_info(ROLLCON_OF_CONTACT, 11, text, stat=stat)
    call gave_text('name', text, 'text of stat_info')
    call answers(ROLLCON_ERR_STATE)
    call rc_option_info(ROLLCON_OF_BODY, 11, text, type, low, high, standard, stat=stat, errmsg=message)
    call failed('option_info', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call rc_stat_info(ROLLCON_OF_CONTACT, 11, text, stat=stat, errmsg=message)
    call failed('stat_info', stat, message)
  end subroutine

  !> Tests results: the frame has 3 nodes, a field 6 values, a solve 2 iterations.
  subroutine results()
    real(rc_real), allocatable :: v(:, :), s(:)
    integer(rc_int), allocatable :: states(:)
    call body%get_displacements(v, stat)
    call told('body_get_displacements', 'body1 3 room', stat)
    call gave_reals('displacements', reshape(v, [9]), 200.5_rc_real)
    call body%get_group_nodes('Top', states, stat)
    call told('body_get_group_nodes', 'body1 <Top> 1 3 room room', stat)
    call gave_integers('nodes of a group', int(states), 400)
    call contact%get_tractions(v, ROLLCON_GLOBAL, stat)
    call told('contact_get_tractions', 'contact1 1 3 room', stat)
    call gave_reals('tractions', reshape(v, [9]), 300.5_rc_real)
    call contact%get_tractions(v)
    call told('contact_get_tractions', 'contact1 0 3 room', 0)
    call contact%get_field(ROLLCON_FIELD_SLIP, v, ROLLCON_GLOBAL, stat)
    call told('contact_get_field', 'contact1 4 1 9 room room', stat)
    call demand(all(shape(v) == [2, 3]), 'components and nodes of a field')
    call gave_reals('a field', reshape(v, [6]), 400.5_rc_real)
    call contact%get_field(ROLLCON_FIELD_GAP, s, stat=stat)
    call told('contact_get_field', 'contact1 3 0 9 room room', stat)
    call gave_reals('a field', s, 400.5_rc_real)
    call contact%past_get(s, stat)
    call told('contact_past_get', 'contact1 6 room room', stat)
    call contact%get_node_states(states, stat)
    call told('contact_get_node_states', 'contact1 3 room', stat)
    call gave_integers('states', int(states), 200)
    call contact%get_displacements_at(ROLLCON_BODY2, x(:2, :), v, stat)
    call told('contact_get_displacements_at', 'contact1 2 2 [1.5 2.5 4.5 5.5] room', stat)
    call gave_reals('displacements at points', reshape(v, [6]), 400.5_rc_real)
    call contact%get_displacements_at(ROLLCON_BODY2, x, v, stat, message)
    call refused('contact1', stat, message, 'rc_contact%get_displacements_at: the first extent of xy must be 2')
    call contact%get_temperatures_at(x(:2, :), v, stat)
    call told('contact_get_temperatures_at', 'contact1 2 [1.5 2.5 4.5 5.5] room', stat)
    call gave_reals('temperatures at points', reshape(v, [4]), 300.5_rc_real)
    call contact%get_temperatures_at(x, v, stat, message)
    call refused('contact1', stat, message, 'rc_contact%get_temperatures_at: the first extent of xy must be 2')
    call stresses()
    call inside_bodies()
    call contact%get_history('phase  seconds step ', v, stat)
    call told('contact_get_history', 'contact1 <phase  seconds step> 2 room room', stat)
    call gave_reals('history', reshape(v, [6]), 300.5_rc_real)
    call failing(v, s, states)
  end subroutine

  !> Tests fields inside bodies: without displacements given a body's own are read first, 3 nodes.
  subroutine inside_bodies()
    real(rc_real), allocatable :: s(:, :), u(:, :), v(:), xyz(:, :)
    call contact%get_body_displacements(ROLLCON_BODY2, u, stat)
    call told('contact_get_body_displacements', 'contact1 2 6 room room', stat)
    call gave_reals('displacements of a body', reshape(u, [6]), 300.5_rc_real)
    call contact%get_body_power(ROLLCON_BODY2, v, stat)
    call told('contact_get_body_power', 'contact1 2 6 room room', stat)
    call gave_reals('power of a body', v, 300.5_rc_real)
    call body%get_node_stresses(s, x, stat)
    call told('body_get_node_stresses', 'body1 2 [1.5 2.5 3.5 4.5 5.5 6.5] room', stat)
    call gave_reals('stresses at nodes', reshape(s, [12]), 300.5_rc_real)
    call body%get_node_stresses(s, stat=stat)
    call told('body_get_node_stresses', 'body1 3 [200.5 201.5 202.5 203.5 204.5 205.5 206.5 207.5 208.5] room', stat)
    call body%get_point_stresses(s, xyz, x, stat)
    call told('body_get_point_stresses', 'body1 2 [1.5 2.5 3.5 4.5 5.5 6.5] 2 room room room', stat)
    call gave_reals('stresses at integration points', reshape(s, [12]), 400.5_rc_real)
    call gave_reals('their places', reshape(xyz, [6]), 500.5_rc_real)
    call body%get_fields_at(x, u, s, x, stat)
    call told('body_get_fields_at', &
      'body1 2 [1.5 2.5 3.5 4.5 5.5 6.5] 2 [1.5 2.5 3.5 4.5 5.5 6.5] room room', stat)
    call gave_reals('displacements in a body', reshape(u, [6]), 500.5_rc_real)
    call gave_reals('stresses in a body', reshape(s, [12]), 600.5_rc_real)
    call body%write_vtu('a file', x, stat)
    call told('body_write', 'body1 <a file> 2 [1.5 2.5 3.5 4.5 5.5 6.5]', stat)
    call contact%write_body_vtu(ROLLCON_BODY2, 'a file', stat)
    call told('contact_write_body', 'contact1 2 <a file>', stat)
    call wears()
    call body%get_node_stresses(s, x(:2, :), stat, message)
    call refused('body1', stat, message, &
      'rc_body%get_node_stresses: the first extent of an array of points or displacements must be 3')
    call answers(ROLLCON_ERR_STATE)
    call body%get_fields_at(x, u, s, x, stat, message)
    call failed('body_get_fields_at', stat, message)
    call answers(ROLLCON_OK)
  end subroutine

  subroutine wears()
    real(rc_real), allocatable :: depth(:), worn(:, :)
    real(rc_real) :: volume, taken
    call contact%get_wear('a law', [1.5_rc_real], [2.5_rc_real, 3.5_rc_real], depth, volume, stat)
    call told('contact_get_wear', 'contact1 <a law> 1 [1.5] 2 [2.5 3.5] room room', stat)
    call gave_reals('depths', depth, 600.5_rc_real)
    call gave_reals('a volume', [volume], 700.5_rc_real)
    call rc_wear_profile(x(:2, :), [4.5_rc_real, 5.5_rc_real], ROLLCON_BODY_ABOVE, 6.5_rc_real, &
      7.5_rc_real, 8.5_rc_real, worn, taken, stat)
    call told('wear_profile', '2 [1.5 2.5 4.5 5.5] [4.5 5.5] -1 6.5 7.5 8.5 room room', stat)
    call gave_reals('a worn profile', reshape(worn, [4]), 700.5_rc_real)
    call gave_reals('a distance', [taken], 800.5_rc_real)
    call rc_wear_profile(x, [4.5_rc_real, 5.5_rc_real], ROLLCON_BODY_ABOVE, 6.5_rc_real, &
      7.5_rc_real, 8.5_rc_real, worn, taken, stat, message)
    call demand(stat == ROLLCON_ERR_ARGUMENT, 'points of two components')
  end subroutine

  subroutine stresses()
    real(rc_real), allocatable :: s(:, :), u(:, :), von_mises(:), shear(:)
    call contact%get_fields_at(ROLLCON_BODY2, x, ROLLCON_IN_BODY, u, s, stat)
    call told('contact_get_fields_at', 'contact1 2 2 [1.5 2.5 3.5 4.5 5.5 6.5] 1 room room', stat)
    call gave_reals('displacements inside', reshape(u, [6]), 500.5_rc_real)
    call gave_reals('stresses', reshape(s, [12]), 600.5_rc_real)
    call contact%get_fields_at(ROLLCON_BODY2, x(:2, :), ROLLCON_IN_BODY, u, s, stat, message)
    call refused('contact1', stat, message, 'rc_contact%get_fields_at: the first extent of xyz must be 3')
    call rc_stress_invariants(reshape([x, x], [6, 2]), u, von_mises, shear, stat)
    call told('stress_invariants', '2 [1.5 2.5 3.5 4.5 5.5 6.5 1.5 2.5 3.5 4.5 5.5 6.5] room room room', stat)
    call gave_reals('principal stresses', reshape(u, [6]), 200.5_rc_real)
    call gave_reals('von Mises stress', von_mises, 300.5_rc_real)
    call gave_reals('shear stress', shear, 400.5_rc_real)
    call rc_stress_invariants(x, u, von_mises, shear, stat, message)
    call demand(stat == ROLLCON_ERR_ARGUMENT, 'stresses of three components are refused')
    call answers(ROLLCON_ERR_STATE)
    call rc_stress_invariants(reshape([x, x], [6, 2]), u, von_mises, shear, stat, message)
    call failed('stress_invariants', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call contact%get_fields_at(ROLLCON_BODY2, x, ROLLCON_IN_CONTACT, u, s, stat, message)
    call failed('contact_get_fields_at', stat, message)
  end subroutine

  !> Tests failures of calls that ask for a size first: they are reported, and leave no results.
  subroutine failing(v, s, states)
    real(rc_real), allocatable, intent(inout) :: v(:, :), s(:)
    integer(rc_int), allocatable, intent(inout) :: states(:)
    call answers(ROLLCON_ERR_STATE)
    call contact%get_tractions(v, stat=stat)
    call status_is('tractions', stat, int(ROLLCON_ERR_STATE))
    call contact%get_field(ROLLCON_FIELD_GAP, s, stat=stat)
    call status_is('field', stat, int(ROLLCON_ERR_STATE))
    call demand(size(v) == 0 .and. size(s) == 0, 'no results')
    call contact%get_field(ROLLCON_FIELD_SLIP, v, stat=stat)
    call status_is('field of vectors', stat, int(ROLLCON_ERR_STATE))
    call contact%get_node_states(states, stat)
    call status_is('states', stat, int(ROLLCON_ERR_STATE))
    call contact%get_history('phase', v, stat)
    call status_is('history', stat, int(ROLLCON_ERR_STATE))
    call body%get_displacements(v, stat, message)
    call failed('displacements', stat, message)
  end subroutine

  !> Tests the columns of the table of cases: 3 + 3 + 1 + 3 + 20 + 2 + 9 numbers, the first of which is 600.5.
  subroutine cases()
    integer(rc_int), parameter :: parameters(2) = [ROLLCON_NORMAL, ROLLCON_FRICTION]
    real(rc_real), allocatable :: force(:, :), moment(:, :), approach(:), creep(:, :), slopes(:, :, :)
    real(rc_real), allocatable :: numbers(:, :), t(:, :, :)
    integer(rc_int), allocatable :: status(:)
    integer :: k
    call contact%solve_many(parameters, x(:2, :), status, force, moment, approach, creep, slopes, &
      ' iterations  seconds', numbers, t, stat, message)
    call told('contact_solve_many', 'contact1 < normal friction> 2 [1.5 2.5 4.5 5.5]' &
      //' < force moment approach creep derivatives  iterations  seconds tractions> 41 room room room', stat)
    call gave_integers('states of cases', int(status), 800)
    do k = 1, 2
      call gave_reals('forces of cases', force(:, k), first(0))
      call gave_reals('moments of cases', moment(:, k), first(3))
      call gave_reals('approaches of cases', approach(k:k), first(6))
      call gave_reals('creepages of cases', creep(:, k), first(7))
      call gave_reals('derivatives of cases', reshape(slopes(:, :, k), [20]), first(10))
      call gave_reals('statistics of cases', numbers(:, k), first(30))
      call gave_reals('tractions of cases', reshape(t(:, :, k), [9]), first(32))
    end do
    call contact%solve_many([ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_SPIN], x, approach=approach, stat=stat)
    call told('contact_solve_many', &
      'contact1 < longitudinal lateral spin> 2 '//written//' < approach> 1 room room room', stat)
    call contact%solve_many([77_rc_int], x(1:1, 1:0), status, force=force, stat=stat)
    call demand(stat == 0 .and. size(status) == 0 .and. size(force, 2) == 0, 'an empty list has no results')
    call contact%solve_many(parameters, x, stat=stat, errmsg=message)
    call refused('contact1', stat, message, &
      'rc_contact%solve_many: the first extent of values must be the number of parameters')
    call contact%solve_many(parameters, x(:2, :), names='seconds', stat=stat, errmsg=message)
    call refused('contact1', stat, message, 'rc_contact%solve_many: names and statistics must come together')
    call answers(ROLLCON_ERR_STATE)
    call contact%solve_many(parameters, x(:2, :), tractions=t, stat=stat, errmsg=message)
    call failed('contact_solve_many', stat, message)
  contains
    real(rc_real) function first(column)
      integer, intent(in) :: column
      first = 600.5_rc_real + 41*(k - 1) + column
    end function
  end subroutine

  !> Tests patches, which count from 1; the reference that C gave becomes the variable's.
  subroutine patches()
    type(rc_contact) :: of_patch
    integer(c_int32_t) :: narrow
    real(rc_real) :: value
    call wheelrail%set_table(table, stat, message)
    call told('wheelrail_set_table', 'wheelrail1 table1', stat)
    call wheelrail%set_table(stat=stat)
    call told('wheelrail_set_table', 'wheelrail1 null', stat)
    call wheelrail%set('a name', 1.5_rc_real, stat)
    call told('wheelrail_set_real', 'wheelrail1 <a name> 1.5', stat)
    call wheelrail%set('a name', 11_c_int32_t, stat)
    call told('wheelrail_set_int', 'wheelrail1 <a name> 11', stat)
    call wheelrail%get('a name', narrow, stat)
    call told('wheelrail_get_int', 'wheelrail1 <a name> room', stat)
    call demand(narrow == 200, 'an integer of a wheel')
    call wheelrail%get('a name', value, stat)
    call told('wheelrail_get_real', 'wheelrail1 <a name> room', stat)
    call gave_reals('a real of a wheel', [value], 200.5_rc_real)
    call wheelrail%get_contact(11, of_patch, stat, message)
    call told('wheelrail_get_contact', 'wheelrail1 10 room', stat)
    call told('contact_retain', 'contact2', stat)
    call told('contact_release', 'contact2', stat)
    call demand(of_patch%id() == contact%id() + 1, 'the contact of a patch')
    call answers(ROLLCON_ERR_STATE)
    call wheelrail%get_contact(1, of_patch, stat, message)
    call failed('wheelrail_get_contact', stat, message)
    call demand(.not. c_associated(of_patch%handle()), 'a failure leaves no contact')
    call answers(ROLLCON_ERR_STATE)
    call wheelrail%set_table(table, stat, message)
    call failed('wheelrail_set_table', stat, message)
  end subroutine

  subroutine wheelsets()
    real(rc_real), allocatable :: points(:, :), conicity(:), wavelength(:), totals(:, :)
    real(rc_real), allocatable :: depth(:), rail_depth(:), past(:)
    real(rc_real) :: volumes(2)
    integer(rc_int), allocatable :: states(:)
    type(rc_wheelrail) :: other
    call answers(ROLLCON_OK)
    call wheelrail%find_contact_points(wheelrail, [1.5_rc_real, 2.5_rc_real], 'z right_radius', points, stat, message)
    call told('wheelrail_find_contact_points', 'wheelrail1 wheelrail1 2 [1.5 2.5] <z right_radius> room', stat)
    call gave_reals('points', reshape(points, [4]), 500.5_rc_real)
    call wheelrail%find_conicity(wheelrail, [1.5_rc_real, 2.5_rc_real], conicity, wavelength, stat, message)
    call told('wheelrail_find_conicity', 'wheelrail1 wheelrail1 2 [1.5 2.5] room room', stat)
    call gave_reals('conicity', conicity, 400.5_rc_real)
    call gave_reals('wavelength', wavelength, 500.5_rc_real)
    call wheelrail%solve_many(reshape([1.5_rc_real, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, 6.5_rc_real], &
      [6, 1]), reshape([6.5_rc_real, 5.5_rc_real, 4.5_rc_real, 3.5_rc_real, 2.5_rc_real, 1.5_rc_real], [6, 1]), 'z', totals, &
      states, stat, message)
    call told('wheelrail_solve_many', &
      'wheelrail1 1 [1.5 2.5 3.5 4.5 5.5 6.5] [6.5 5.5 4.5 3.5 2.5 1.5] <z> room room', stat)
    call gave_reals('totals', reshape(totals, [1]), 500.5_rc_real)
    call demand(all(states == 600), 'states of positions')
    call wheelrail%solve_many(reshape([1.5_rc_real], [1, 1]), reshape([1.5_rc_real], [1, 1]), 'z', totals, stat=stat)
    call demand(stat == ROLLCON_ERR_ARGUMENT, 'six components')
    call wheelrail%find_wear(reshape([1.5_rc_real, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, 6.5_rc_real], &
      [6, 1]), reshape([6.5_rc_real, 5.5_rc_real, 4.5_rc_real, 3.5_rc_real, 2.5_rc_real, 1.5_rc_real], [6, 1]), &
      [7.5_rc_real], 'a law', [8.5_rc_real], 2, depth, rail_depth, volumes, states, stat, message)
    call told('wheelrail_find_wear', 'wheelrail1 1 [1.5 2.5 3.5 4.5 5.5 6.5] [6.5 5.5 4.5 3.5 2.5 1.5] [7.5] '// &
      '<a law> 1 [8.5] 2 room room room room', stat)
    call gave_reals('wear of the wheel', depth, 900.5_rc_real)
    call gave_reals('wear of the rail', rail_depth, 1000.5_rc_real)
    call gave_reals('volumes', volumes, 1100.5_rc_real)
    call demand(all(states == 1200), 'states of positions that wear')
    call wheelrail%copy(other, stat, message)
    call told('wheelrail_copy', 'wheelrail1 room', stat)
    call told('wheelrail_retain', 'wheelrail2', stat)
    call told('wheelrail_release', 'wheelrail2', stat)
    call wheelrail%past_get(past, stat)
    call told('wheelrail_past_get', 'wheelrail1 6 room room', stat)
    call answers(ROLLCON_ERR_STATE)
    call wheelrail%copy(other, stat, message)
    call failed('wheelrail_copy', stat, message)
    call demand(.not. c_associated(other%handle()), 'a failure leaves no copy')
    call answers(ROLLCON_ERR_STATE)
    call wheelrail%solve_many(reshape([1.5_rc_real, 2.5_rc_real, 3.5_rc_real, 4.5_rc_real, 5.5_rc_real, 6.5_rc_real], &
      [6, 1]), reshape([6.5_rc_real, 5.5_rc_real, 4.5_rc_real, 3.5_rc_real, 2.5_rc_real, 1.5_rc_real], [6, 1]), 'z', totals, &
      states, stat, message)
    call failed('wheelrail_solve_many', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call wheelrail%find_contact_points(wheelrail, [1.5_rc_real], 'z', points, stat, message)
    call failed('wheelrail_find_contact_points', stat, message)
    call answers(ROLLCON_ERR_STATE)
    call wheelrail%find_conicity(wheelrail, [1.5_rc_real], conicity, wavelength, stat, message)
    call failed('wheelrail_find_conicity', stat, message)
  end subroutine

end module mapping_by_hand
