!> Provides functions without an object: tables of settings and of counters, whose entries count from 1, what a progress
!> callback may read, and invariants of stresses.
module rollcon_tables
  use, intrinsic :: iso_c_binding, only: c_char, c_null_char, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  implicit none
  private
  public :: rc_option_count, rc_option_info, rc_option_doc, rc_stat_count, rc_stat_name, rc_event_int, rc_event_real
  public :: rc_body_option_count, rc_body_option_info, rc_body_option_doc, rc_body_stat_count, rc_body_stat_name
  public :: rc_stress_invariants, rc_wear_profile
  public :: rc_wheelrail_stat_count, rc_wheelrail_stat_name, rc_wheelrail_patch_stat_count, rc_wheelrail_patch_stat_name

contains

  !> Returns principal stresses principal(3,n), the largest first, von Mises's stress and the largest shear stress of
  !> stress(6,n).
  subroutine rc_stress_invariants(stress, principal, von_mises, shear, stat, errmsg)
    real(rc_real), intent(in), contiguous :: stress(:, :)
    real(rc_real), allocatable, intent(out) :: principal(:, :)
    real(rc_real), allocatable, intent(out) :: von_mises(:), shear(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(stress, 1) /= 6) then
      call finish(ROLLCON_ERR_ARGUMENT, c_null_ptr, 'rc_stress_invariants', stat, errmsg, &
        'the first extent of stress must be 6')
      return
    end if
    allocate (principal(3, size(stress, 2)), von_mises(size(stress, 2)), shear(size(stress, 2)))
    principal = 0
    von_mises = 0
    shear = 0
    call finish(rollcon_stress_invariants(size(stress, 2, rc_long), stress, principal, von_mises, shear), c_null_ptr, &
      'rc_stress_invariants', stat, errmsg)
  end subroutine

  !> Wears points yz(2,n) of a profile by rate(n), depth per distance, along the normal: returns worn(2,n), and how much
  !> of the distance was taken so that none is worn deeper than most_depth. side 1: the body lies at greater z (a rail),
  !> -1: at lesser z.
  subroutine rc_wear_profile(yz, rate, side, distance, most_depth, smoothing, worn, taken, stat, errmsg)
    real(rc_real), intent(in), contiguous :: yz(:, :), rate(:)
    integer(rc_int), intent(in) :: side
    real(rc_real), intent(in) :: distance, most_depth, smoothing
    real(rc_real), allocatable, intent(out) :: worn(:, :)
    real(rc_real), intent(out) :: taken
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    taken = 0
    if (size(yz, 1) /= 2 .or. size(yz, 2) /= size(rate)) then
      call finish(ROLLCON_ERR_ARGUMENT, c_null_ptr, 'rc_wear_profile', stat, errmsg, &
        'the extents of yz must be 2 and that of rate')
      return
    end if
    allocate (worn(2, size(rate)))
    worn = 0
    call finish(rollcon_wear_profile(size(rate, kind=rc_long), yz, rate, side, distance, most_depth, &
      smoothing, worn, taken), c_null_ptr, 'rc_wear_profile', stat, errmsg)
  end subroutine

  integer function rc_option_count()
    rc_option_count = int(rollcon_option_count())
  end function

  !> Returns name, type (ROLLCON_TYPE_INT, ...), range and standard value of option i.
  subroutine rc_option_info(i, name, type, low, high, standard, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    integer(rc_int), intent(out) :: type
    real(rc_real), intent(out) :: low, high, standard
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: buffer(usual_text)
    buffer(1) = c_null_char
    type = 0
    low = 0
    high = 0
    standard = 0
    call finish(rollcon_option_info(int(i - 1, rc_int), usual_text, buffer, type, low, high, standard), c_null_ptr, &
      'rc_option_info', stat, errmsg)
    name = f_text(buffer)
  end subroutine

  subroutine rc_option_doc(i, text, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: text
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable :: buffer(:)
    integer(rc_long) :: needed
    integer(rc_int) :: status
    allocate (buffer(1))
    needed = 0
    status = rollcon_option_doc(int(i - 1, rc_int), 0_rc_long, buffer, needed)
    deallocate (buffer)
    allocate (buffer(max(needed, 1_rc_long)))
    buffer(1) = c_null_char
    if (status == ROLLCON_OK) status = rollcon_option_doc(int(i - 1, rc_int), size(buffer, kind=rc_long), buffer, needed)
    text = f_text(buffer)
    call finish(status, c_null_ptr, 'rc_option_doc', stat, errmsg)
  end subroutine

  integer function rc_stat_count()
    rc_stat_count = int(rollcon_stat_count())
  end function

  subroutine rc_stat_name(i, name, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: buffer(usual_text)
    integer(rc_long) :: needed
    buffer(1) = c_null_char
    needed = 0
    call finish(rollcon_stat_name(int(i - 1, rc_int), usual_text, buffer, needed), c_null_ptr, 'rc_stat_name', stat, errmsg)
    name = f_text(buffer)
  end subroutine

  integer function rc_body_option_count()
    rc_body_option_count = int(rollcon_body_option_count())
  end function

  !> Returns name, type (ROLLCON_TYPE_INT, ...), range and standard value of option i of a body.
  subroutine rc_body_option_info(i, name, type, low, high, standard, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    integer(rc_int), intent(out) :: type
    real(rc_real), intent(out) :: low, high, standard
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: buffer(usual_text)
    buffer(1) = c_null_char
    type = 0
    low = 0
    high = 0
    standard = 0
    call finish(rollcon_body_option_info(int(i - 1, rc_int), usual_text, buffer, type, low, high, standard), c_null_ptr, &
      'rc_body_option_info', stat, errmsg)
    name = f_text(buffer)
  end subroutine

  subroutine rc_body_option_doc(i, text, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: text
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable :: buffer(:)
    integer(rc_long) :: needed
    integer(rc_int) :: status
    allocate (buffer(1))
    needed = 0
    status = rollcon_body_option_doc(int(i - 1, rc_int), 0_rc_long, buffer, needed)
    deallocate (buffer)
    allocate (buffer(max(needed, 1_rc_long)))
    buffer(1) = c_null_char
    if (status == ROLLCON_OK) &
      status = rollcon_body_option_doc(int(i - 1, rc_int), size(buffer, kind=rc_long), buffer, needed)
    text = f_text(buffer)
    call finish(status, c_null_ptr, 'rc_body_option_doc', stat, errmsg)
  end subroutine

  integer function rc_body_stat_count()
    rc_body_stat_count = int(rollcon_body_stat_count())
  end function

  subroutine rc_body_stat_name(i, name, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: buffer(usual_text)
    integer(rc_long) :: needed
    buffer(1) = c_null_char
    needed = 0
    call finish(rollcon_body_stat_name(int(i - 1, rc_int), usual_text, buffer, needed), c_null_ptr, 'rc_body_stat_name', stat, &
      errmsg)
    name = f_text(buffer)
  end subroutine

  integer function rc_wheelrail_stat_count()
    rc_wheelrail_stat_count = int(rollcon_wheelrail_stat_count())
  end function

  !> Returns the name of statistic i of a wheel on its rail.
  subroutine rc_wheelrail_stat_name(i, name, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: buffer(usual_text)
    integer(rc_long) :: needed
    buffer(1) = c_null_char
    needed = 0
    call finish(rollcon_wheelrail_stat_name(int(i - 1, rc_int), usual_text, buffer, needed), c_null_ptr, &
      'rc_wheelrail_stat_name', stat, errmsg)
    name = f_text(buffer)
  end subroutine

  integer function rc_wheelrail_patch_stat_count()
    rc_wheelrail_patch_stat_count = int(rollcon_wheelrail_patch_stat_count())
  end function

  !> Returns the name of statistic i of a patch of a wheel on its rail.
  subroutine rc_wheelrail_patch_stat_name(i, name, stat, errmsg)
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: buffer(usual_text)
    integer(rc_long) :: needed
    buffer(1) = c_null_char
    needed = 0
    call finish(rollcon_wheelrail_patch_stat_name(int(i - 1, rc_int), usual_text, buffer, needed), c_null_ptr, &
      'rc_wheelrail_patch_stat_name', stat, errmsg)
    name = f_text(buffer)
  end subroutine

  !> Returns entry `key` (ROLLCON_EVENT_PHASE, ROLLCON_EVENT_ITERATION) of the event that a progress callback was given;
  !> -1 for other keys.
  function rc_event_int(event, key) result(value)
    type(c_ptr), intent(in) :: event
    integer(rc_int), intent(in) :: key
    integer(rc_long) :: value
    value = 0
    if (rollcon_event_get_int(event, key, value) /= ROLLCON_OK) value = -1
  end function

  !> Returns entry `key` (ROLLCON_EVENT_RESIDUAL, ROLLCON_EVENT_SECONDS) of the event that a progress callback was
  !> given; -1 for other keys.
  function rc_event_real(event, key) result(value)
    type(c_ptr), intent(in) :: event
    integer(rc_int), intent(in) :: key
    real(rc_real) :: value
    value = 0
    if (rollcon_event_get_real(event, key, value) /= ROLLCON_OK) value = -1
  end function

end module rollcon_tables
