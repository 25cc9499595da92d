! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.
!
! The C functions of rollcon 1.0.0-rc2, argument by argument; rollcon.h documents them. Handles are
! type(c_ptr), texts are arrays of characters ended by c_null_char. Callbacks must be bind(C)
! module procedures, passed by c_funloc: a contained procedure would need an executable stack.
module rollcon_c
  use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
  implicit none
  public

  integer(c_int32_t), parameter :: rollcon_header_version = 10000_c_int32_t
  integer(c_int32_t), parameter :: rollcon_header_abi = 1_c_int32_t

  ! status
  integer(c_int32_t), parameter :: rollcon_ok = 0_c_int32_t
  integer(c_int32_t), parameter :: rollcon_not_converged = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_no_contact = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_cancelled = 3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_rim_contact = 4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_coarse = 5_c_int32_t
  integer(c_int32_t), parameter :: rollcon_inaccurate = 6_c_int32_t
  integer(c_int32_t), parameter :: rollcon_too_deep = 7_c_int32_t
  integer(c_int32_t), parameter :: rollcon_derailed = 8_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_argument = -1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_handle = -2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_nonfinite = -3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_mesh = -4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_state = -5_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_option = -6_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_capacity = -7_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_singular = -8_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_memory = -9_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_unsupported = -10_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_busy = -11_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_load = -12_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_io = -13_c_int32_t
  integer(c_int32_t), parameter :: rollcon_err_internal = -99_c_int32_t

  ! body kind
  integer(c_int32_t), parameter :: rollcon_body_fem = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_body_bem = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_body_halfspace = 3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_body_rigid = 4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_body_section = 5_c_int32_t
  integer(c_int32_t), parameter :: rollcon_body_condensed = 6_c_int32_t

  ! form of a matrix
  integer(c_int32_t), parameter :: rollcon_stiffness = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_flexibility = 2_c_int32_t

  ! element type
  integer(c_int32_t), parameter :: rollcon_tri3 = 203_c_int32_t
  integer(c_int32_t), parameter :: rollcon_tri6 = 206_c_int32_t
  integer(c_int32_t), parameter :: rollcon_quad4 = 214_c_int32_t
  integer(c_int32_t), parameter :: rollcon_quad8 = 218_c_int32_t
  integer(c_int32_t), parameter :: rollcon_quad9 = 219_c_int32_t
  integer(c_int32_t), parameter :: rollcon_tet4 = 304_c_int32_t
  integer(c_int32_t), parameter :: rollcon_tet10 = 310_c_int32_t
  integer(c_int32_t), parameter :: rollcon_wedge6 = 326_c_int32_t
  integer(c_int32_t), parameter :: rollcon_wedge15 = 335_c_int32_t
  integer(c_int32_t), parameter :: rollcon_hex8 = 338_c_int32_t
  integer(c_int32_t), parameter :: rollcon_hex20 = 350_c_int32_t

  ! dof
  integer(c_int32_t), parameter :: rollcon_dof_x = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_dof_y = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_dof_z = 4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_dof_xyz = 7_c_int32_t

  ! direction
  integer(c_int32_t), parameter :: rollcon_longitudinal = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_lateral = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_normal = 3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_spin = 4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_tilt_1 = 6_c_int32_t
  integer(c_int32_t), parameter :: rollcon_tilt_2 = 7_c_int32_t

  ! parameter
  integer(c_int32_t), parameter :: rollcon_friction = 5_c_int32_t

  ! how
  integer(c_int32_t), parameter :: rollcon_by_motion = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_by_force = 2_c_int32_t

  ! axes
  integer(c_int32_t), parameter :: rollcon_local = 0_c_int32_t
  integer(c_int32_t), parameter :: rollcon_global = 1_c_int32_t

  ! field
  integer(c_int32_t), parameter :: rollcon_field_point = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_traction = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_gap = 3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_slip = 4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_displacement1 = 5_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_displacement2 = 6_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_area = 7_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_friction = 8_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_pressure = 9_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_rigid_slip = 10_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_friction_power = 11_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_weight = 12_c_int32_t
  integer(c_int32_t), parameter :: rollcon_field_temperature = 13_c_int32_t

  ! side
  integer(c_int32_t), parameter :: rollcon_left = -1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_right = 1_c_int32_t

  ! body of a contact
  integer(c_int32_t), parameter :: rollcon_body1 = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_body2 = 2_c_int32_t

  ! moving contact
  integer(c_int32_t), parameter :: rollcon_contact_itself = 0_c_int32_t

  ! profile of a wheel on its rail
  integer(c_int32_t), parameter :: rollcon_wheel = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_rail = 2_c_int32_t

  ! inside of a profile
  integer(c_int32_t), parameter :: rollcon_body_below = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_body_above = -1_c_int32_t

  ! axes of points
  integer(c_int32_t), parameter :: rollcon_in_contact = 0_c_int32_t
  integer(c_int32_t), parameter :: rollcon_in_body = 1_c_int32_t

  ! axes of the track
  integer(c_int32_t), parameter :: rollcon_in_track = 0_c_int32_t
  integer(c_int32_t), parameter :: rollcon_in_wheelset = 1_c_int32_t

  ! node status
  integer(c_int32_t), parameter :: rollcon_open = 0_c_int32_t
  integer(c_int32_t), parameter :: rollcon_stick = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_slip = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_excluded = 3_c_int32_t

  ! step
  integer(c_int32_t), parameter :: rollcon_steady = 0_c_int32_t
  integer(c_int32_t), parameter :: rollcon_rolling_step = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_shift_step = 2_c_int32_t

  ! log level
  integer(c_int32_t), parameter :: rollcon_log_error = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_log_warning = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_log_info = 3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_log_debug = 4_c_int32_t

  ! option type
  integer(c_int32_t), parameter :: rollcon_type_int = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_type_real = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_type_str = 3_c_int32_t

  ! kind of object
  integer(c_int32_t), parameter :: rollcon_of_body = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_of_contact = 3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_of_wheelrail = 4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_of_patch = 6_c_int32_t
  integer(c_int32_t), parameter :: rollcon_of_procedure = 7_c_int32_t

  ! event key
  integer(c_int32_t), parameter :: rollcon_event_phase = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_event_iteration = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_event_residual = 101_c_int32_t
  integer(c_int32_t), parameter :: rollcon_event_seconds = 102_c_int32_t

  ! phase
  integer(c_int32_t), parameter :: rollcon_phase_compliance = 1_c_int32_t
  integer(c_int32_t), parameter :: rollcon_phase_normal = 2_c_int32_t
  integer(c_int32_t), parameter :: rollcon_phase_tangential = 3_c_int32_t
  integer(c_int32_t), parameter :: rollcon_phase_full = 4_c_int32_t
  integer(c_int32_t), parameter :: rollcon_phase_cases = 5_c_int32_t

  abstract interface

    subroutine rollcon_log_fn(level, message, user) bind(C)
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: level
      type(c_ptr), value :: message
      type(c_ptr), value :: user
    end subroutine rollcon_log_fn

    function rollcon_progress_fn(event, user) result(rc) bind(C)
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: event
      type(c_ptr), value :: user
      integer(c_int32_t) :: rc
    end function rollcon_progress_fn

  end interface

  interface

    function rollcon_version() result(rc) bind(C, name="rollcon_version")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t) :: rc
    end function rollcon_version

    function rollcon_abi() result(rc) bind(C, name="rollcon_abi")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t) :: rc
    end function rollcon_abi

    function rollcon_version_string() result(rc) bind(C, name="rollcon_version_string")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr) :: rc
    end function rollcon_version_string

    function rollcon_build_info() result(rc) bind(C, name="rollcon_build_info")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr) :: rc
    end function rollcon_build_info

    function rollcon_has_feature(name) result(rc) bind(C, name="rollcon_has_feature")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int32_t) :: rc
    end function rollcon_has_feature

    function rollcon_status_string(status) result(rc) bind(C, name="rollcon_status_string")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: status
      type(c_ptr) :: rc
    end function rollcon_status_string

    function rollcon_last_error() result(rc) bind(C, name="rollcon_last_error")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr) :: rc
    end function rollcon_last_error

    function rollcon_last_caveat() result(rc) bind(C, name="rollcon_last_caveat")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr) :: rc
    end function rollcon_last_caveat

    function rollcon_context_create(header_abi, context) &
        result(rc) bind(C, name="rollcon_context_create")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: header_abi
      type(c_ptr), intent(out) :: context
      integer(c_int32_t) :: rc
    end function rollcon_context_create

    subroutine rollcon_context_release(context) bind(C, name="rollcon_context_release")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
    end subroutine rollcon_context_release

    function rollcon_context_set_log(context, max_level, fn, user) &
        result(rc) bind(C, name="rollcon_context_set_log")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      integer(c_int32_t), value :: max_level
      type(c_funptr), value :: fn
      type(c_ptr), value :: user
      integer(c_int32_t) :: rc
    end function rollcon_context_set_log

    function rollcon_context_set_threads(context, n) &
        result(rc) bind(C, name="rollcon_context_set_threads")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      integer(c_int32_t), value :: n
      integer(c_int32_t) :: rc
    end function rollcon_context_set_threads

    function rollcon_context_set_communicator(context, communicator) &
        result(rc) bind(C, name="rollcon_context_set_communicator")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      integer(c_int32_t), value :: communicator
      integer(c_int32_t) :: rc
    end function rollcon_context_set_communicator

    function rollcon_context_set_latch(context, on) &
        result(rc) bind(C, name="rollcon_context_set_latch")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      integer(c_int32_t), value :: on
      integer(c_int32_t) :: rc
    end function rollcon_context_set_latch

    function rollcon_context_check(context) result(rc) bind(C, name="rollcon_context_check")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      integer(c_int32_t) :: rc
    end function rollcon_context_check

    function rollcon_body_create(context, kind, body) result(rc) bind(C, name="rollcon_body_create")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      integer(c_int32_t), value :: kind
      type(c_ptr), intent(out) :: body
      integer(c_int32_t) :: rc
    end function rollcon_body_create

    subroutine rollcon_body_release(body) bind(C, name="rollcon_body_release")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
    end subroutine rollcon_body_release

    function rollcon_body_set_elastic(body, tag, young, poisson) &
        result(rc) bind(C, name="rollcon_body_set_elastic")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      real(c_double), value :: young
      real(c_double), value :: poisson
      integer(c_int32_t) :: rc
    end function rollcon_body_set_elastic

    function rollcon_body_set_viscoelastic(body, tag, n, ratios, times) &
        result(rc) bind(C, name="rollcon_body_set_viscoelastic")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: ratios(*)
      real(c_double), intent(in) :: times(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_viscoelastic

    function rollcon_body_set_moduli(body, tag, n, frequencies, storage, loss) &
        result(rc) bind(C, name="rollcon_body_set_moduli")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: frequencies(*)
      real(c_double), intent(in) :: storage(*)
      real(c_double), intent(in) :: loss(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_moduli

    function rollcon_body_prepare(body) result(rc) bind(C, name="rollcon_body_prepare")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t) :: rc
    end function rollcon_body_prepare

    function rollcon_body_get_kind(body, kind) result(rc) bind(C, name="rollcon_body_get_kind")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), intent(inout) :: kind
      integer(c_int32_t) :: rc
    end function rollcon_body_get_kind

    function rollcon_body_save(body, path) result(rc) bind(C, name="rollcon_body_save")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_save

    function rollcon_body_load(context, path, body) result(rc) bind(C, name="rollcon_body_load")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: body
      integer(c_int32_t) :: rc
    end function rollcon_body_load

    function rollcon_body_copy(body, copy) result(rc) bind(C, name="rollcon_body_copy")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      type(c_ptr), intent(out) :: copy
      integer(c_int32_t) :: rc
    end function rollcon_body_copy

    function rollcon_body_set_nodes(body, n, x, node_stride, component_stride) &
        result(rc) bind(C, name="rollcon_body_set_nodes")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: x(*)
      integer(c_int64_t), value :: node_stride
      integer(c_int64_t), value :: component_stride
      integer(c_int32_t) :: rc
    end function rollcon_body_set_nodes

    function rollcon_body_add_elements(body, type, n, connectivity, index_base, tag) &
        result(rc) bind(C, name="rollcon_body_add_elements")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: type
      integer(c_int64_t), value :: n
      integer(c_int32_t), intent(in) :: connectivity(*)
      integer(c_int32_t), value :: index_base
      integer(c_int32_t), value :: tag
      integer(c_int32_t) :: rc
    end function rollcon_body_add_elements

    function rollcon_body_tag_faces(body, n, elements, faces, index_base, tag) &
        result(rc) bind(C, name="rollcon_body_tag_faces")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: n
      integer(c_int32_t), intent(in) :: elements(*)
      integer(c_int32_t), intent(in) :: faces(*)
      integer(c_int32_t), value :: index_base
      integer(c_int32_t), value :: tag
      integer(c_int32_t) :: rc
    end function rollcon_body_tag_faces

    function rollcon_body_tag_faces_of_nodes(body, n, nodes, index_base, tag) &
        result(rc) bind(C, name="rollcon_body_tag_faces_of_nodes")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: n
      integer(c_int32_t), intent(in) :: nodes(*)
      integer(c_int32_t), value :: index_base
      integer(c_int32_t), value :: tag
      integer(c_int32_t) :: rc
    end function rollcon_body_tag_faces_of_nodes

    function rollcon_body_set_support(body, n, nodes, index_base, dof_mask, values) &
        result(rc) bind(C, name="rollcon_body_set_support")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: n
      integer(c_int32_t), intent(in) :: nodes(*)
      integer(c_int32_t), value :: index_base
      integer(c_int32_t), value :: dof_mask
      real(c_double), intent(in) :: values(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_support

    function rollcon_body_set_traction(body, tag, traction) &
        result(rc) bind(C, name="rollcon_body_set_traction")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      real(c_double), intent(in) :: traction(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_traction

    function rollcon_body_set_body_force(body, tag, force) &
        result(rc) bind(C, name="rollcon_body_set_body_force")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      real(c_double), intent(in) :: force(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_body_force

    function rollcon_body_set_rotation(body, tag, density, origin, rate) &
        result(rc) bind(C, name="rollcon_body_set_rotation")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      real(c_double), value :: density
      real(c_double), intent(in) :: origin(*)
      real(c_double), intent(in) :: rate(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_rotation

    function rollcon_body_set_pressure(body, tag, pressure) &
        result(rc) bind(C, name="rollcon_body_set_pressure")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      real(c_double), value :: pressure
      integer(c_int32_t) :: rc
    end function rollcon_body_set_pressure

    function rollcon_body_set_springs(body, tag, stiffness) &
        result(rc) bind(C, name="rollcon_body_set_springs")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      real(c_double), intent(in) :: stiffness(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_springs

    function rollcon_body_set_node_tractions(body, tag, n, nodes, index_base, along, tractions) &
        result(rc) bind(C, name="rollcon_body_set_node_tractions")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: tag
      integer(c_int64_t), value :: n
      integer(c_int32_t), intent(in) :: nodes(*)
      integer(c_int32_t), value :: index_base
      real(c_double), intent(in) :: along(*)
      real(c_double), intent(in) :: tractions(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_node_tractions

    function rollcon_body_set_contact_faces(body, n, tags) &
        result(rc) bind(C, name="rollcon_body_set_contact_faces")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: n
      integer(c_int32_t), intent(in) :: tags(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_contact_faces

    function rollcon_body_revolve(body, origin, axis) result(rc) bind(C, name="rollcon_body_revolve")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), intent(in) :: origin(*)
      real(c_double), intent(in) :: axis(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_revolve

    function rollcon_body_extrude(body, origin, direction, period) &
        result(rc) bind(C, name="rollcon_body_extrude")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), intent(in) :: origin(*)
      real(c_double), intent(in) :: direction(*)
      real(c_double), value :: period
      integer(c_int32_t) :: rc
    end function rollcon_body_extrude

    function rollcon_body_set_condensed(body, form, n, matrix) &
        result(rc) bind(C, name="rollcon_body_set_condensed")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: form
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: matrix(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_condensed

    function rollcon_body_read_condensed(body, form, path) &
        result(rc) bind(C, name="rollcon_body_read_condensed")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: form
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_read_condensed

    function rollcon_body_write_condensed(body, form, path) &
        result(rc) bind(C, name="rollcon_body_write_condensed")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: form
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_write_condensed

    function rollcon_body_read_mesh(body, path, part) &
        result(rc) bind(C, name="rollcon_body_read_mesh")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: path(*)
      character(kind=c_char), intent(in) :: part(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_read_mesh

    function rollcon_body_tag_group(body, group, tag) &
        result(rc) bind(C, name="rollcon_body_tag_group")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: group(*)
      integer(c_int32_t), value :: tag
      integer(c_int32_t) :: rc
    end function rollcon_body_tag_group

    function rollcon_body_get_group_count(body, n) &
        result(rc) bind(C, name="rollcon_body_get_group_count")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), intent(inout) :: n
      integer(c_int32_t) :: rc
    end function rollcon_body_get_group_count

    function rollcon_body_get_group_name(body, i, capacity, text, needed) &
        result(rc) bind(C, name="rollcon_body_get_group_name")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t), value :: i
      integer(c_int64_t), value :: capacity
      character(kind=c_char), intent(out) :: text(*)
      integer(c_int64_t), intent(inout) :: needed
      integer(c_int32_t) :: rc
    end function rollcon_body_get_group_name

    function rollcon_body_get_group_nodes(body, group, index_base, capacity, nodes, n_nodes) &
        result(rc) bind(C, name="rollcon_body_get_group_nodes")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: group(*)
      integer(c_int32_t), value :: index_base
      integer(c_int64_t), value :: capacity
      integer(c_int32_t), intent(out) :: nodes(*)
      integer(c_int64_t), intent(inout) :: n_nodes
      integer(c_int32_t) :: rc
    end function rollcon_body_get_group_nodes

    function rollcon_body_set_int(body, name, value) result(rc) bind(C, name="rollcon_body_set_int")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int64_t), value :: value
      integer(c_int32_t) :: rc
    end function rollcon_body_set_int

    function rollcon_body_set_real(body, name, value) &
        result(rc) bind(C, name="rollcon_body_set_real")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: value
      integer(c_int32_t) :: rc
    end function rollcon_body_set_real

    function rollcon_body_get_int(body, name, value) result(rc) bind(C, name="rollcon_body_get_int")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int64_t), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_body_get_int

    function rollcon_body_get_real(body, name, value) &
        result(rc) bind(C, name="rollcon_body_get_real")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_body_get_real

    function rollcon_body_set_profile(body, n, points, filter_length) &
        result(rc) bind(C, name="rollcon_body_set_profile")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: points(*)
      real(c_double), value :: filter_length
      integer(c_int32_t) :: rc
    end function rollcon_body_set_profile

    function rollcon_body_set_profile_shape(body, shape, n, parameters) &
        result(rc) bind(C, name="rollcon_body_set_profile_shape")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: shape(*)
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: parameters(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_set_profile_shape

    function rollcon_body_read_profile(body, path, unit, mirror, filter_length) &
        result(rc) bind(C, name="rollcon_body_read_profile")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: path(*)
      real(c_double), value :: unit
      integer(c_int32_t), value :: mirror
      real(c_double), value :: filter_length
      integer(c_int32_t) :: rc
    end function rollcon_body_read_profile

    function rollcon_body_add_slice(body, u, n, features) &
        result(rc) bind(C, name="rollcon_body_add_slice")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), value :: u
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: features(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_add_slice

    function rollcon_body_read_slices(body, path, mm, unit, mirror, filter_length) &
        result(rc) bind(C, name="rollcon_body_read_slices")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: path(*)
      real(c_double), value :: mm
      real(c_double), value :: unit
      integer(c_int32_t), value :: mirror
      real(c_double), value :: filter_length
      integer(c_int32_t) :: rc
    end function rollcon_body_read_slices

    function rollcon_body_add_wave(body, amplitude, wavelength, phase) &
        result(rc) bind(C, name="rollcon_body_add_wave")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), value :: amplitude
      real(c_double), value :: wavelength
      real(c_double), value :: phase
      integer(c_int32_t) :: rc
    end function rollcon_body_add_wave

    function rollcon_body_write_profile(body, path, unit) &
        result(rc) bind(C, name="rollcon_body_write_profile")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: path(*)
      real(c_double), value :: unit
      integer(c_int32_t) :: rc
    end function rollcon_body_write_profile

    function rollcon_body_extrude_profile(body, origin, along, z_axis) &
        result(rc) bind(C, name="rollcon_body_extrude_profile")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), intent(in) :: origin(*)
      real(c_double), intent(in) :: along(*)
      real(c_double), intent(in) :: z_axis(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_extrude_profile

    function rollcon_body_revolve_profile(body, origin, axis, radius) &
        result(rc) bind(C, name="rollcon_body_revolve_profile")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), intent(in) :: origin(*)
      real(c_double), intent(in) :: axis(*)
      real(c_double), value :: radius
      integer(c_int32_t) :: rc
    end function rollcon_body_revolve_profile

    function rollcon_body_get_profile_length(body, length) &
        result(rc) bind(C, name="rollcon_body_get_profile_length")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), intent(inout) :: length
      integer(c_int32_t) :: rc
    end function rollcon_body_get_profile_length

    function rollcon_body_get_profile_point(body, s, point, tangent, curvature) &
        result(rc) bind(C, name="rollcon_body_get_profile_point")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), value :: s
      real(c_double), intent(out) :: point(*)
      real(c_double), intent(out) :: tangent(*)
      real(c_double), intent(inout) :: curvature
      integer(c_int32_t) :: rc
    end function rollcon_body_get_profile_point

    function rollcon_body_get_size(body, nodes, elements) &
        result(rc) bind(C, name="rollcon_body_get_size")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), intent(inout) :: nodes
      integer(c_int64_t), intent(inout) :: elements
      integer(c_int32_t) :: rc
    end function rollcon_body_get_size

    function rollcon_body_get_displacements(body, capacity, u) &
        result(rc) bind(C, name="rollcon_body_get_displacements")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: u(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_get_displacements

    function rollcon_body_get_node_stresses(body, nodes, u, stress) &
        result(rc) bind(C, name="rollcon_body_get_node_stresses")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: nodes
      real(c_double), intent(in) :: u(*)
      real(c_double), intent(out) :: stress(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_get_node_stresses

    function rollcon_body_get_point_stresses(body, nodes, u, capacity, stress, xyz, n_rows) &
        result(rc) bind(C, name="rollcon_body_get_point_stresses")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: nodes
      real(c_double), intent(in) :: u(*)
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: stress(*)
      real(c_double), intent(out) :: xyz(*)
      integer(c_int64_t), intent(inout) :: n_rows
      integer(c_int32_t) :: rc
    end function rollcon_body_get_point_stresses

    function rollcon_body_get_fields_at(body, nodes, u, n, xyz, displacement, stress) &
        result(rc) bind(C, name="rollcon_body_get_fields_at")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int64_t), value :: nodes
      real(c_double), intent(in) :: u(*)
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: xyz(*)
      real(c_double), intent(out) :: displacement(*)
      real(c_double), intent(out) :: stress(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_get_fields_at

    function rollcon_body_write(body, path, nodes, u) result(rc) bind(C, name="rollcon_body_write")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int64_t), value :: nodes
      real(c_double), intent(in) :: u(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_write

    function rollcon_body_get_reaction(body, force, moment) &
        result(rc) bind(C, name="rollcon_body_get_reaction")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      real(c_double), intent(out) :: force(*)
      real(c_double), intent(out) :: moment(*)
      integer(c_int32_t) :: rc
    end function rollcon_body_get_reaction

    function rollcon_body_get_stat(body, name, value) &
        result(rc) bind(C, name="rollcon_body_get_stat")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_body_get_stat

    function rollcon_contact_create(context, body1, body2, contact) &
        result(rc) bind(C, name="rollcon_contact_create")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      type(c_ptr), value :: body1
      type(c_ptr), value :: body2
      type(c_ptr), intent(out) :: contact
      integer(c_int32_t) :: rc
    end function rollcon_contact_create

    subroutine rollcon_contact_release(contact) bind(C, name="rollcon_contact_release")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
    end subroutine rollcon_contact_release

    function rollcon_contact_frame_nodes(contact, n, x, node_stride, component_stride) &
        result(rc) bind(C, name="rollcon_contact_frame_nodes")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: x(*)
      integer(c_int64_t), value :: node_stride
      integer(c_int64_t), value :: component_stride
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_nodes

    function rollcon_contact_frame_add_elements(contact, type, n, connectivity, index_base, tag) &
        result(rc) bind(C, name="rollcon_contact_frame_add_elements")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: type
      integer(c_int64_t), value :: n
      integer(c_int32_t), intent(in) :: connectivity(*)
      integer(c_int32_t), value :: index_base
      integer(c_int32_t), value :: tag
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_add_elements

    function rollcon_contact_frame_from_file(contact, path, part) &
        result(rc) bind(C, name="rollcon_contact_frame_from_file")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: path(*)
      character(kind=c_char), intent(in) :: part(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_from_file

    function rollcon_contact_frame_from_body(contact, which, tag) &
        result(rc) bind(C, name="rollcon_contact_frame_from_body")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      integer(c_int32_t), value :: tag
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_from_body

    function rollcon_contact_frame_rectangle(contact, type, nx, ny, x_least, x_greatest, y_least, &
        y_greatest) result(rc) bind(C, name="rollcon_contact_frame_rectangle")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: type
      integer(c_int32_t), value :: nx
      integer(c_int32_t), value :: ny
      real(c_double), value :: x_least
      real(c_double), value :: x_greatest
      real(c_double), value :: y_least
      real(c_double), value :: y_greatest
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_rectangle

    function rollcon_contact_frame_ellipse(contact, along, across, a, b, angle) &
        result(rc) bind(C, name="rollcon_contact_frame_ellipse")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: along
      integer(c_int32_t), value :: across
      real(c_double), value :: a
      real(c_double), value :: b
      real(c_double), value :: angle
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_ellipse

    function rollcon_contact_frame_strips(contact, along, n, lines) &
        result(rc) bind(C, name="rollcon_contact_frame_strips")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: along
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: lines(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_strips

    function rollcon_contact_frame_automatic(contact) &
        result(rc) bind(C, name="rollcon_contact_frame_automatic")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t) :: rc
    end function rollcon_contact_frame_automatic

    function rollcon_contact_set_pose(contact, which, rotation, translation) &
        result(rc) bind(C, name="rollcon_contact_set_pose")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      real(c_double), intent(in) :: rotation(*)
      real(c_double), intent(in) :: translation(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_pose

    function rollcon_contact_set_axes(contact, origin, rolling, normal) &
        result(rc) bind(C, name="rollcon_contact_set_axes")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), intent(in) :: origin(*)
      real(c_double), intent(in) :: rolling(*)
      real(c_double), intent(in) :: normal(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_axes

    function rollcon_contact_set_gap(contact, n, gap) &
        result(rc) bind(C, name="rollcon_contact_set_gap")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: gap(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_gap

    function rollcon_contact_set_gap_quadratic(contact, a, b, c) &
        result(rc) bind(C, name="rollcon_contact_set_gap_quadratic")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), value :: a
      real(c_double), value :: b
      real(c_double), value :: c
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_gap_quadratic

    function rollcon_contact_set_gap_grid(contact, nx, x_least, x_greatest, y_least, y_greatest, &
        n, gap) result(rc) bind(C, name="rollcon_contact_set_gap_grid")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: nx
      real(c_double), value :: x_least
      real(c_double), value :: x_greatest
      real(c_double), value :: y_least
      real(c_double), value :: y_greatest
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: gap(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_gap_grid

    function rollcon_contact_set_rolling(contact, speed) &
        result(rc) bind(C, name="rollcon_contact_set_rolling")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), value :: speed
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_rolling

    function rollcon_contact_set_creep(contact, longitudinal, lateral, spin) &
        result(rc) bind(C, name="rollcon_contact_set_creep")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), value :: longitudinal
      real(c_double), value :: lateral
      real(c_double), value :: spin
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_creep

    function rollcon_contact_set_step(contact, kind, dt) &
        result(rc) bind(C, name="rollcon_contact_set_step")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: kind
      real(c_double), value :: dt
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_step

    function rollcon_contact_set_velocity(contact, which, velocity, angular_velocity, point) &
        result(rc) bind(C, name="rollcon_contact_set_velocity")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      real(c_double), intent(in) :: velocity(*)
      real(c_double), intent(in) :: angular_velocity(*)
      real(c_double), intent(in) :: point(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_velocity

    function rollcon_contact_set_creep_field(contact, n, slip) &
        result(rc) bind(C, name="rollcon_contact_set_creep_field")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: slip(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_creep_field

    function rollcon_contact_prescribe(contact, direction, how, value) &
        result(rc) bind(C, name="rollcon_contact_prescribe")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: direction
      integer(c_int32_t), value :: how
      real(c_double), value :: value
      integer(c_int32_t) :: rc
    end function rollcon_contact_prescribe

    function rollcon_contact_set_friction(contact, law, n, parameters) &
        result(rc) bind(C, name="rollcon_contact_set_friction")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: law(*)
      integer(c_int32_t), value :: n
      real(c_double), intent(in) :: parameters(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_friction

    function rollcon_contact_set_friction_memory(contact, length, least_speed) &
        result(rc) bind(C, name="rollcon_contact_set_friction_memory")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), value :: length
      real(c_double), value :: least_speed
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_friction_memory

    function rollcon_contact_set_layer(contact, flexibility, stress, hardening) &
        result(rc) bind(C, name="rollcon_contact_set_layer")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), value :: flexibility
      real(c_double), value :: stress
      real(c_double), value :: hardening
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_layer

    function rollcon_contact_set_friction_across(contact, n, points) &
        result(rc) bind(C, name="rollcon_contact_set_friction_across")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: points(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_friction_across

    function rollcon_contact_set_heat(contact, which, conductivity, heat_capacity, temperature) &
        result(rc) bind(C, name="rollcon_contact_set_heat")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      real(c_double), value :: conductivity
      real(c_double), value :: heat_capacity
      real(c_double), value :: temperature
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_heat

    function rollcon_contact_set_friction_field(contact, n, mu) &
        result(rc) bind(C, name="rollcon_contact_set_friction_field")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: mu(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_friction_field

    function rollcon_contact_set_int(contact, name, value) &
        result(rc) bind(C, name="rollcon_contact_set_int")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int64_t), value :: value
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_int

    function rollcon_contact_set_real(contact, name, value) &
        result(rc) bind(C, name="rollcon_contact_set_real")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: value
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_real

    function rollcon_contact_set_str(contact, name, value) &
        result(rc) bind(C, name="rollcon_contact_set_str")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: name(*)
      character(kind=c_char), intent(in) :: value(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_str

    function rollcon_contact_get_int(contact, name, value) &
        result(rc) bind(C, name="rollcon_contact_get_int")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int64_t), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_int

    function rollcon_contact_get_real(contact, name, value) &
        result(rc) bind(C, name="rollcon_contact_get_real")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_real

    function rollcon_contact_get_str(contact, name, capacity, text, needed) &
        result(rc) bind(C, name="rollcon_contact_get_str")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int64_t), value :: capacity
      character(kind=c_char), intent(out) :: text(*)
      integer(c_int64_t), intent(inout) :: needed
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_str

    function rollcon_contact_set_procedure(contact, procedure) &
        result(rc) bind(C, name="rollcon_contact_set_procedure")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: procedure(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_procedure

    function rollcon_contact_set_progress(contact, fn, user) &
        result(rc) bind(C, name="rollcon_contact_set_progress")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      type(c_funptr), value :: fn
      type(c_ptr), value :: user
      integer(c_int32_t) :: rc
    end function rollcon_contact_set_progress

    function rollcon_event_get_int(event, key, value) &
        result(rc) bind(C, name="rollcon_event_get_int")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: event
      integer(c_int32_t), value :: key
      integer(c_int64_t), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_event_get_int

    function rollcon_event_get_real(event, key, value) &
        result(rc) bind(C, name="rollcon_event_get_real")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: event
      integer(c_int32_t), value :: key
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_event_get_real

    function rollcon_contact_request_cancel(contact) &
        result(rc) bind(C, name="rollcon_contact_request_cancel")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t) :: rc
    end function rollcon_contact_request_cancel

    function rollcon_contact_solve(contact) result(rc) bind(C, name="rollcon_contact_solve")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t) :: rc
    end function rollcon_contact_solve

    function rollcon_contact_solve_many(contact, parameters, n_cases, values, columns, capacity, &
        results, n_results, status) result(rc) bind(C, name="rollcon_contact_solve_many")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: parameters(*)
      integer(c_int64_t), value :: n_cases
      real(c_double), intent(in) :: values(*)
      character(kind=c_char), intent(in) :: columns(*)
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: results(*)
      integer(c_int64_t), intent(inout) :: n_results
      integer(c_int32_t), intent(out) :: status(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_solve_many

    function rollcon_contact_repeat_step(contact) &
        result(rc) bind(C, name="rollcon_contact_repeat_step")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t) :: rc
    end function rollcon_contact_repeat_step

    function rollcon_contact_past_get(contact, capacity, past, n_values) &
        result(rc) bind(C, name="rollcon_contact_past_get")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: past(*)
      integer(c_int64_t), intent(inout) :: n_values
      integer(c_int32_t) :: rc
    end function rollcon_contact_past_get

    function rollcon_contact_past_set(contact, n, past) &
        result(rc) bind(C, name="rollcon_contact_past_set")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: past(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_past_set

    function rollcon_contact_reset(contact) result(rc) bind(C, name="rollcon_contact_reset")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t) :: rc
    end function rollcon_contact_reset

    function rollcon_contact_get_size(contact, nodes, elements) &
        result(rc) bind(C, name="rollcon_contact_get_size")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), intent(inout) :: nodes
      integer(c_int64_t), intent(inout) :: elements
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_size

    function rollcon_contact_get_tractions(contact, axes, capacity, t) &
        result(rc) bind(C, name="rollcon_contact_get_tractions")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: axes
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: t(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_tractions

    function rollcon_contact_get_field(contact, field, axes, capacity, v, n_values) &
        result(rc) bind(C, name="rollcon_contact_get_field")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: field
      integer(c_int32_t), value :: axes
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: v(*)
      integer(c_int64_t), intent(inout) :: n_values
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_field

    function rollcon_contact_get_node_states(contact, capacity, status) &
        result(rc) bind(C, name="rollcon_contact_get_node_states")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: capacity
      integer(c_int32_t), intent(out) :: status(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_node_states

    function rollcon_contact_get_resultant(contact, axes, force, moment) &
        result(rc) bind(C, name="rollcon_contact_get_resultant")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: axes
      real(c_double), intent(out) :: force(*)
      real(c_double), intent(out) :: moment(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_resultant

    function rollcon_contact_get_motion(contact, approach, creep) &
        result(rc) bind(C, name="rollcon_contact_get_motion")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), intent(inout) :: approach
      real(c_double), intent(out) :: creep(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_motion

    function rollcon_contact_get_tilt(contact, tilt) &
        result(rc) bind(C, name="rollcon_contact_get_tilt")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), intent(out) :: tilt(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_tilt

    function rollcon_contact_get_sensitivity(contact, parameter, force, moment, approach, creep) &
        result(rc) bind(C, name="rollcon_contact_get_sensitivity")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: parameter
      real(c_double), intent(out) :: force(*)
      real(c_double), intent(out) :: moment(*)
      real(c_double), intent(inout) :: approach
      real(c_double), intent(out) :: creep(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_sensitivity

    function rollcon_contact_get_displacements_at(contact, which, n, xy, u) &
        result(rc) bind(C, name="rollcon_contact_get_displacements_at")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: xy(*)
      real(c_double), intent(out) :: u(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_displacements_at

    function rollcon_contact_get_fields_at(contact, which, n, xyz, in_axes, u, stress) &
        result(rc) bind(C, name="rollcon_contact_get_fields_at")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: xyz(*)
      integer(c_int32_t), value :: in_axes
      real(c_double), intent(out) :: u(*)
      real(c_double), intent(out) :: stress(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_fields_at

    function rollcon_contact_find_stress(contact, which, measure, n, parameters, value, place) &
        result(rc) bind(C, name="rollcon_contact_find_stress")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      character(kind=c_char), intent(in) :: measure(*)
      integer(c_int32_t), value :: n
      real(c_double), intent(in) :: parameters(*)
      real(c_double), intent(inout) :: value
      real(c_double), intent(out) :: place(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_find_stress

    function rollcon_contact_get_body_displacements(contact, which, capacity, u, n_values) &
        result(rc) bind(C, name="rollcon_contact_get_body_displacements")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: u(*)
      integer(c_int64_t), intent(inout) :: n_values
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_body_displacements

    function rollcon_contact_get_body_power(contact, which, capacity, power, n_values) &
        result(rc) bind(C, name="rollcon_contact_get_body_power")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: power(*)
      integer(c_int64_t), intent(inout) :: n_values
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_body_power

    function rollcon_contact_write_body(contact, which, path) &
        result(rc) bind(C, name="rollcon_contact_write_body")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_write_body

    function rollcon_contact_write_loads(contact, which, path) &
        result(rc) bind(C, name="rollcon_contact_write_loads")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t), value :: which
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_write_loads

    function rollcon_contact_get_temperatures_at(contact, n, xy, temperature) &
        result(rc) bind(C, name="rollcon_contact_get_temperatures_at")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: xy(*)
      real(c_double), intent(out) :: temperature(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_temperatures_at

    function rollcon_contact_get_fatigue_index(contact, shear_yield, index) &
        result(rc) bind(C, name="rollcon_contact_get_fatigue_index")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), value :: shear_yield
      real(c_double), intent(inout) :: index
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_fatigue_index

    function rollcon_contact_get_equivalent_ellipse(contact, inputs, center) &
        result(rc) bind(C, name="rollcon_contact_get_equivalent_ellipse")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      real(c_double), intent(out) :: inputs(*)
      real(c_double), intent(out) :: center(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_equivalent_ellipse

    function rollcon_contact_get_wear(contact, law, n, parameters, points, y, depth, volume) &
        result(rc) bind(C, name="rollcon_contact_get_wear")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: law(*)
      integer(c_int32_t), value :: n
      real(c_double), intent(in) :: parameters(*)
      integer(c_int64_t), value :: points
      real(c_double), intent(in) :: y(*)
      real(c_double), intent(out) :: depth(*)
      real(c_double), intent(inout) :: volume
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_wear

    function rollcon_wear_profile(points, yz, rate, side, distance, most_depth, smoothing, worn, &
        taken) result(rc) bind(C, name="rollcon_wear_profile")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int64_t), value :: points
      real(c_double), intent(in) :: yz(*)
      real(c_double), intent(in) :: rate(*)
      integer(c_int32_t), value :: side
      real(c_double), value :: distance
      real(c_double), value :: most_depth
      real(c_double), value :: smoothing
      real(c_double), intent(out) :: worn(*)
      real(c_double), intent(inout) :: taken
      integer(c_int32_t) :: rc
    end function rollcon_wear_profile

    function rollcon_stress_invariants(n, stress, principal, von_mises, shear) &
        result(rc) bind(C, name="rollcon_stress_invariants")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: stress(*)
      real(c_double), intent(out) :: principal(*)
      real(c_double), intent(out) :: von_mises(*)
      real(c_double), intent(out) :: shear(*)
      integer(c_int32_t) :: rc
    end function rollcon_stress_invariants

    function rollcon_contact_get_stat(contact, name, value) &
        result(rc) bind(C, name="rollcon_contact_get_stat")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_stat

    function rollcon_contact_get_history(contact, columns, capacity, rows, n_rows) &
        result(rc) bind(C, name="rollcon_contact_get_history")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: columns(*)
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: rows(*)
      integer(c_int64_t), intent(inout) :: n_rows
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_history

    function rollcon_contact_get_plan(contact, capacity, text, needed) &
        result(rc) bind(C, name="rollcon_contact_get_plan")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: capacity
      character(kind=c_char), intent(out) :: text(*)
      integer(c_int64_t), intent(inout) :: needed
      integer(c_int32_t) :: rc
    end function rollcon_contact_get_plan

    function rollcon_contact_write(contact, path) result(rc) bind(C, name="rollcon_contact_write")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: rc
    end function rollcon_contact_write

    function rollcon_wheelrail_create(context, wheel, rail, side, wheelrail) &
        result(rc) bind(C, name="rollcon_wheelrail_create")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      type(c_ptr), value :: wheel
      type(c_ptr), value :: rail
      integer(c_int32_t), value :: side
      type(c_ptr), intent(out) :: wheelrail
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_create

    subroutine rollcon_wheelrail_release(wheelrail) bind(C, name="rollcon_wheelrail_release")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
    end subroutine rollcon_wheelrail_release

    function rollcon_wheelrail_set_track(wheelrail, gauge, gauge_height, cant) &
        result(rc) bind(C, name="rollcon_wheelrail_set_track")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), value :: gauge
      real(c_double), value :: gauge_height
      real(c_double), value :: cant
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_track

    function rollcon_wheelrail_set_wheelset(wheelrail, back_to_back, flange_back, radius) &
        result(rc) bind(C, name="rollcon_wheelrail_set_wheelset")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), value :: back_to_back
      real(c_double), value :: flange_back
      real(c_double), value :: radius
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_wheelset

    function rollcon_wheelrail_place_rail(wheelrail, y, z, cant) &
        result(rc) bind(C, name="rollcon_wheelrail_place_rail")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), value :: y
      real(c_double), value :: z
      real(c_double), value :: cant
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_place_rail

    function rollcon_wheelrail_set_roller(wheelrail, radius, rate) &
        result(rc) bind(C, name="rollcon_wheelrail_set_roller")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), value :: radius
      real(c_double), value :: rate
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_roller

    function rollcon_wheelrail_set_step(wheelrail, kind, dt) &
        result(rc) bind(C, name="rollcon_wheelrail_set_step")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: kind
      real(c_double), value :: dt
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_step

    function rollcon_wheelrail_repeat_step(wheelrail) &
        result(rc) bind(C, name="rollcon_wheelrail_repeat_step")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_repeat_step

    function rollcon_wheelrail_past_get(wheelrail, capacity, past, n_values) &
        result(rc) bind(C, name="rollcon_wheelrail_past_get")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: past(*)
      integer(c_int64_t), intent(inout) :: n_values
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_past_get

    function rollcon_wheelrail_past_set(wheelrail, n, past) &
        result(rc) bind(C, name="rollcon_wheelrail_past_set")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: past(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_past_set

    function rollcon_wheelrail_set_tape_circle(wheelrail, y) &
        result(rc) bind(C, name="rollcon_wheelrail_set_tape_circle")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), value :: y
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_tape_circle

    function rollcon_wheelrail_set_flexibility(wheelrail, displacement, rate) &
        result(rc) bind(C, name="rollcon_wheelrail_set_flexibility")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), intent(in) :: displacement(*)
      real(c_double), intent(in) :: rate(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_flexibility

    function rollcon_wheelrail_set_rail_springs(wheelrail, stiffness, force) &
        result(rc) bind(C, name="rollcon_wheelrail_set_rail_springs")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), intent(in) :: stiffness(*)
      real(c_double), intent(in) :: force(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_rail_springs

    function rollcon_wheelrail_set_rail_deviation(wheelrail, deviation, rate) &
        result(rc) bind(C, name="rollcon_wheelrail_set_rail_deviation")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), intent(in) :: deviation(*)
      real(c_double), intent(in) :: rate(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_rail_deviation

    function rollcon_wheelrail_set_position(wheelrail, position) &
        result(rc) bind(C, name="rollcon_wheelrail_set_position")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), intent(in) :: position(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_position

    function rollcon_wheelrail_set_velocity(wheelrail, velocity) &
        result(rc) bind(C, name="rollcon_wheelrail_set_velocity")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), intent(in) :: velocity(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_velocity

    function rollcon_wheelrail_prescribe_vertical(wheelrail, how, force) &
        result(rc) bind(C, name="rollcon_wheelrail_prescribe_vertical")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: how
      real(c_double), value :: force
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_prescribe_vertical

    function rollcon_wheelrail_prescribe_longitudinal(wheelrail, how, force) &
        result(rc) bind(C, name="rollcon_wheelrail_prescribe_longitudinal")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: how
      real(c_double), value :: force
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_prescribe_longitudinal

    function rollcon_wheelrail_set_friction(wheelrail, law, n, parameters) &
        result(rc) bind(C, name="rollcon_wheelrail_set_friction")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      character(kind=c_char), intent(in) :: law(*)
      integer(c_int32_t), value :: n
      real(c_double), intent(in) :: parameters(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_friction

    function rollcon_wheelrail_set_law_by_angle(wheelrail, law, points, n, parameters) &
        result(rc) bind(C, name="rollcon_wheelrail_set_law_by_angle")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      character(kind=c_char), intent(in) :: law(*)
      integer(c_int32_t), value :: points
      integer(c_int32_t), value :: n
      real(c_double), intent(in) :: parameters(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_law_by_angle

    function rollcon_wheelrail_set_friction_memory(wheelrail, length, least_speed) &
        result(rc) bind(C, name="rollcon_wheelrail_set_friction_memory")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), value :: length
      real(c_double), value :: least_speed
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_friction_memory

    function rollcon_wheelrail_set_layer(wheelrail, flexibility, stress, hardening) &
        result(rc) bind(C, name="rollcon_wheelrail_set_layer")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      real(c_double), value :: flexibility
      real(c_double), value :: stress
      real(c_double), value :: hardening
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_layer

    function rollcon_wheelrail_set_heat(wheelrail, which, conductivity, heat_capacity, temperature) &
        result(rc) bind(C, name="rollcon_wheelrail_set_heat")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: which
      real(c_double), value :: conductivity
      real(c_double), value :: heat_capacity
      real(c_double), value :: temperature
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_heat

    function rollcon_wheelrail_set_table(wheelrail, table) &
        result(rc) bind(C, name="rollcon_wheelrail_set_table")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      type(c_ptr), value :: table
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_table

    function rollcon_wheelrail_solve(wheelrail) result(rc) bind(C, name="rollcon_wheelrail_solve")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_solve

    function rollcon_wheelrail_request_cancel(wheelrail) &
        result(rc) bind(C, name="rollcon_wheelrail_request_cancel")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_request_cancel

    function rollcon_wheelrail_solve_many(wheelrail, n, positions, velocities, columns, totals, &
        status) result(rc) bind(C, name="rollcon_wheelrail_solve_many")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: positions(*)
      real(c_double), intent(in) :: velocities(*)
      character(kind=c_char), intent(in) :: columns(*)
      real(c_double), intent(out) :: totals(*)
      integer(c_int32_t), intent(out) :: status(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_solve_many

    function rollcon_wheelrail_find_wear(wheelrail, n_cases, positions, velocities, weights, law, &
        n, parameters, points, wheel, rail, volumes, status) &
        result(rc) bind(C, name="rollcon_wheelrail_find_wear")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int64_t), value :: n_cases
      real(c_double), intent(in) :: positions(*)
      real(c_double), intent(in) :: velocities(*)
      real(c_double), intent(in) :: weights(*)
      character(kind=c_char), intent(in) :: law(*)
      integer(c_int32_t), value :: n
      real(c_double), intent(in) :: parameters(*)
      integer(c_int64_t), value :: points
      real(c_double), intent(out) :: wheel(*)
      real(c_double), intent(out) :: rail(*)
      real(c_double), intent(out) :: volumes(*)
      integer(c_int32_t), intent(out) :: status(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_find_wear

    function rollcon_wheelrail_snapshot(wheelrail, place) &
        result(rc) bind(C, name="rollcon_wheelrail_snapshot")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: place
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_snapshot

    function rollcon_wheelrail_rollback(wheelrail, place) &
        result(rc) bind(C, name="rollcon_wheelrail_rollback")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: place
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_rollback

    function rollcon_wheelrail_copy(wheelrail, copy) &
        result(rc) bind(C, name="rollcon_wheelrail_copy")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      type(c_ptr), intent(out) :: copy
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_copy

    function rollcon_wheelrail_reset(wheelrail) result(rc) bind(C, name="rollcon_wheelrail_reset")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_reset

    function rollcon_wheelrail_set_int(wheelrail, name, value) &
        result(rc) bind(C, name="rollcon_wheelrail_set_int")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int64_t), value :: value
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_int

    function rollcon_wheelrail_set_real(wheelrail, name, value) &
        result(rc) bind(C, name="rollcon_wheelrail_set_real")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: value
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_set_real

    function rollcon_wheelrail_get_int(wheelrail, name, value) &
        result(rc) bind(C, name="rollcon_wheelrail_get_int")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int64_t), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_int

    function rollcon_wheelrail_get_real(wheelrail, name, value) &
        result(rc) bind(C, name="rollcon_wheelrail_get_real")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_real

    function rollcon_wheelrail_get_patch_count(wheelrail, patches) &
        result(rc) bind(C, name="rollcon_wheelrail_get_patch_count")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int64_t), intent(inout) :: patches
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_patch_count

    function rollcon_wheelrail_get_resultant(wheelrail, axes, force, moment) &
        result(rc) bind(C, name="rollcon_wheelrail_get_resultant")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: axes
      real(c_double), intent(out) :: force(*)
      real(c_double), intent(out) :: moment(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_resultant

    function rollcon_wheelrail_get_derivative(wheelrail, entry, force, moment, z) &
        result(rc) bind(C, name="rollcon_wheelrail_get_derivative")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: entry
      real(c_double), intent(out) :: force(*)
      real(c_double), intent(out) :: moment(*)
      real(c_double), intent(inout) :: z
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_derivative

    function rollcon_wheelrail_get_stat(wheelrail, name, value) &
        result(rc) bind(C, name="rollcon_wheelrail_get_stat")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_stat

    function rollcon_wheelrail_get_profile_point(wheelrail, which, share, point) &
        result(rc) bind(C, name="rollcon_wheelrail_get_profile_point")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: which
      real(c_double), value :: share
      real(c_double), intent(out) :: point(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_profile_point

    function rollcon_wheelrail_get_patch_stat(wheelrail, patch, name, value) &
        result(rc) bind(C, name="rollcon_wheelrail_get_patch_stat")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: patch
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_patch_stat

    function rollcon_wheelrail_get_patch_axes(wheelrail, patch, origin, axes) &
        result(rc) bind(C, name="rollcon_wheelrail_get_patch_axes")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: patch
      real(c_double), intent(out) :: origin(*)
      real(c_double), intent(out) :: axes(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_patch_axes

    function rollcon_wheelrail_get_contact(wheelrail, patch, contact) &
        result(rc) bind(C, name="rollcon_wheelrail_get_contact")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t), value :: patch
      type(c_ptr), intent(out) :: contact
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_get_contact

    function rollcon_wheelrail_find_contact_points(left, right, n, shift, columns, points) &
        result(rc) bind(C, name="rollcon_wheelrail_find_contact_points")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: left
      type(c_ptr), value :: right
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: shift(*)
      character(kind=c_char), intent(in) :: columns(*)
      real(c_double), intent(out) :: points(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_find_contact_points

    function rollcon_wheelrail_find_conicity(left, right, n, amplitude, conicity, wavelength) &
        result(rc) bind(C, name="rollcon_wheelrail_find_conicity")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: left
      type(c_ptr), value :: right
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: amplitude(*)
      real(c_double), intent(out) :: conicity(*)
      real(c_double), intent(out) :: wavelength(*)
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_find_conicity

    function rollcon_option_count(kind) result(rc) bind(C, name="rollcon_option_count")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: kind
      integer(c_int32_t) :: rc
    end function rollcon_option_count

    function rollcon_option_info(kind, i, capacity, name, doc, needed, type, low, high, standard) &
        result(rc) bind(C, name="rollcon_option_info")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: kind
      integer(c_int32_t), value :: i
      integer(c_int64_t), value :: capacity
      character(kind=c_char), intent(out) :: name(*)
      character(kind=c_char), intent(out) :: doc(*)
      integer(c_int64_t), intent(inout) :: needed
      integer(c_int32_t), intent(inout) :: type
      real(c_double), intent(inout) :: low
      real(c_double), intent(inout) :: high
      real(c_double), intent(inout) :: standard
      integer(c_int32_t) :: rc
    end function rollcon_option_info

    function rollcon_stat_count(kind) result(rc) bind(C, name="rollcon_stat_count")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: kind
      integer(c_int32_t) :: rc
    end function rollcon_stat_count

    function rollcon_stat_info(kind, i, capacity, name, doc, needed, inside) &
        result(rc) bind(C, name="rollcon_stat_info")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: kind
      integer(c_int32_t), value :: i
      integer(c_int64_t), value :: capacity
      character(kind=c_char), intent(out) :: name(*)
      character(kind=c_char), intent(out) :: doc(*)
      integer(c_int64_t), intent(inout) :: needed
      integer(c_int32_t), intent(inout) :: inside
      integer(c_int32_t) :: rc
    end function rollcon_stat_info

    function rollcon_report(handle, status, message) result(rc) bind(C, name="rollcon_report")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: handle
      integer(c_int32_t), value :: status
      character(kind=c_char), intent(in) :: message(*)
      integer(c_int32_t) :: rc
    end function rollcon_report

    function rollcon_context_retain(context) result(rc) bind(C, name="rollcon_context_retain")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      integer(c_int32_t) :: rc
    end function rollcon_context_retain

    function rollcon_body_retain(body) result(rc) bind(C, name="rollcon_body_retain")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: body
      integer(c_int32_t) :: rc
    end function rollcon_body_retain

    function rollcon_contact_retain(contact) result(rc) bind(C, name="rollcon_contact_retain")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: contact
      integer(c_int32_t) :: rc
    end function rollcon_contact_retain

    function rollcon_wheelrail_retain(wheelrail) result(rc) bind(C, name="rollcon_wheelrail_retain")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: wheelrail
      integer(c_int32_t) :: rc
    end function rollcon_wheelrail_retain

    function rollcon_table_retain(table) result(rc) bind(C, name="rollcon_table_retain")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int32_t) :: rc
    end function rollcon_table_retain

    function rollcon_id_of(handle) result(rc) bind(C, name="rollcon_id_of")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: handle
      integer(c_int32_t) :: rc
    end function rollcon_id_of

    function rollcon_context_from_id(id) result(rc) bind(C, name="rollcon_context_from_id")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: id
      type(c_ptr) :: rc
    end function rollcon_context_from_id

    function rollcon_body_from_id(id) result(rc) bind(C, name="rollcon_body_from_id")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: id
      type(c_ptr) :: rc
    end function rollcon_body_from_id

    function rollcon_contact_from_id(id) result(rc) bind(C, name="rollcon_contact_from_id")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: id
      type(c_ptr) :: rc
    end function rollcon_contact_from_id

    function rollcon_wheelrail_from_id(id) result(rc) bind(C, name="rollcon_wheelrail_from_id")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: id
      type(c_ptr) :: rc
    end function rollcon_wheelrail_from_id

    function rollcon_table_from_id(id) result(rc) bind(C, name="rollcon_table_from_id")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      integer(c_int32_t), value :: id
      type(c_ptr) :: rc
    end function rollcon_table_from_id

    function rollcon_table_create(context, table) result(rc) bind(C, name="rollcon_table_create")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      type(c_ptr), intent(out) :: table
      integer(c_int32_t) :: rc
    end function rollcon_table_create

    subroutine rollcon_table_release(table) bind(C, name="rollcon_table_release")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
    end subroutine rollcon_table_release

    function rollcon_table_load(context, path, table) result(rc) bind(C, name="rollcon_table_load")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: table
      integer(c_int32_t) :: rc
    end function rollcon_table_load

    function rollcon_table_standard(context, table) result(rc) bind(C, name="rollcon_table_standard")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: context
      type(c_ptr), intent(out) :: table
      integer(c_int32_t) :: rc
    end function rollcon_table_standard

    function rollcon_table_set_ratios(table, intervals, least, greatest) &
        result(rc) bind(C, name="rollcon_table_set_ratios")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int32_t), value :: intervals
      real(c_double), value :: least
      real(c_double), value :: greatest
      integer(c_int32_t) :: rc
    end function rollcon_table_set_ratios

    function rollcon_table_set_resolution(table, magnitudes, angles, directions) &
        result(rc) bind(C, name="rollcon_table_set_resolution")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int32_t), value :: magnitudes
      integer(c_int32_t), value :: angles
      integer(c_int32_t), value :: directions
      integer(c_int32_t) :: rc
    end function rollcon_table_set_resolution

    function rollcon_table_set_frame(table, along, across) &
        result(rc) bind(C, name="rollcon_table_set_frame")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int32_t), value :: along
      integer(c_int32_t), value :: across
      integer(c_int32_t) :: rc
    end function rollcon_table_set_frame

    function rollcon_table_set_poissons(table, n, poissons) &
        result(rc) bind(C, name="rollcon_table_set_poissons")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: poissons(*)
      integer(c_int32_t) :: rc
    end function rollcon_table_set_poissons

    function rollcon_table_set_bodies(table, youngs, poissons, n, frictions) &
        result(rc) bind(C, name="rollcon_table_set_bodies")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      real(c_double), intent(in) :: youngs(*)
      real(c_double), intent(in) :: poissons(*)
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: frictions(*)
      integer(c_int32_t) :: rc
    end function rollcon_table_set_bodies

    function rollcon_table_set_progress(table, fn, user) &
        result(rc) bind(C, name="rollcon_table_set_progress")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      type(c_funptr), value :: fn
      type(c_ptr), value :: user
      integer(c_int32_t) :: rc
    end function rollcon_table_set_progress

    function rollcon_table_request_cancel(table) &
        result(rc) bind(C, name="rollcon_table_request_cancel")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int32_t) :: rc
    end function rollcon_table_request_cancel

    function rollcon_table_make(table, part, parts) result(rc) bind(C, name="rollcon_table_make")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int32_t), value :: part
      integer(c_int32_t), value :: parts
      integer(c_int32_t) :: rc
    end function rollcon_table_make

    function rollcon_table_get_samples(table, capacity, samples, count) &
        result(rc) bind(C, name="rollcon_table_get_samples")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int64_t), value :: capacity
      real(c_double), intent(out) :: samples(*)
      integer(c_int64_t), intent(inout) :: count
      integer(c_int32_t) :: rc
    end function rollcon_table_get_samples

    function rollcon_table_add_samples(table, n, samples) &
        result(rc) bind(C, name="rollcon_table_add_samples")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: samples(*)
      integer(c_int32_t) :: rc
    end function rollcon_table_add_samples

    function rollcon_table_save(table, path) result(rc) bind(C, name="rollcon_table_save")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      character(kind=c_char), intent(in) :: path(*)
      integer(c_int32_t) :: rc
    end function rollcon_table_save

    function rollcon_table_evaluate(table, n, inputs, results) &
        result(rc) bind(C, name="rollcon_table_evaluate")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: inputs(*)
      real(c_double), intent(out) :: results(*)
      integer(c_int32_t) :: rc
    end function rollcon_table_evaluate

    function rollcon_table_evaluate_derivatives(table, n, inputs, results, derivatives) &
        result(rc) bind(C, name="rollcon_table_evaluate_derivatives")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      integer(c_int64_t), value :: n
      real(c_double), intent(in) :: inputs(*)
      real(c_double), intent(out) :: results(*)
      real(c_double), intent(out) :: derivatives(*)
      integer(c_int32_t) :: rc
    end function rollcon_table_evaluate_derivatives

    function rollcon_table_evaluate_contact(table, contact, friction, results) &
        result(rc) bind(C, name="rollcon_table_evaluate_contact")
      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
      implicit none
      type(c_ptr), value :: table
      type(c_ptr), value :: contact
      real(c_double), value :: friction
      real(c_double), intent(out) :: results(*)
      integer(c_int32_t) :: rc
    end function rollcon_table_evaluate_contact

  end interface
end module rollcon_c
