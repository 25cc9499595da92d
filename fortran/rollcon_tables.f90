!> Provides functions without an object: tables of settings and of counters, whose entries count from 1, what a progress
!> callback may read, and invariants of stresses.
module rollcon_tables
  use, intrinsic :: iso_c_binding, only: c_char, c_null_char, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  implicit none
  private
  public :: rc_option_count, rc_option_info, rc_stat_count, rc_stat_info, rc_event_int, rc_event_real
  public :: rc_stress_invariants, rc_wear_profile

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

  !> Returns how many options a kind of object has (ROLLCON_OF_BODY, ...).
  integer function rc_option_count(kind)
    integer(rc_int), intent(in) :: kind
    rc_option_count = int(rollcon_option_count(kind))
  end function

  !> Returns name, type (ROLLCON_TYPE_INT, ...), range, standard value and meaning of option i of a kind of object.
  subroutine rc_option_info(kind, i, name, type, low, high, standard, doc, stat, errmsg)
    integer(rc_int), intent(in) :: kind
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    integer(rc_int), intent(out) :: type
    real(rc_real), intent(out) :: low, high, standard
    character(len=:), allocatable, intent(out), optional :: doc
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: short(usual_text), long(usual_text)
    integer(rc_long) :: needed
    short(1) = c_null_char
    long(1) = c_null_char
    type = 0
    low = 0
    high = 0
    standard = 0
    needed = 0
    call finish(rollcon_option_info(kind, int(i - 1, rc_int), usual_text, short, long, needed, type, low, high, &
      standard), c_null_ptr, 'rc_option_info', stat, errmsg)
    name = f_text(short)
    if (present(doc)) doc = f_text(long)
  end subroutine

  !> Returns how many statistics a kind of object has (ROLLCON_OF_BODY, ...).
  integer function rc_stat_count(kind)
    integer(rc_int), intent(in) :: kind
    rc_stat_count = int(rollcon_stat_count(kind))
  end function

  !> Returns name and meaning of statistic i of a kind of object; inside: 1 if it counts work inside the library, which
  !> is promised to nobody.
  subroutine rc_stat_info(kind, i, name, doc, inside, stat, errmsg)
    integer(rc_int), intent(in) :: kind
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: name
    character(len=:), allocatable, intent(out), optional :: doc
    integer, intent(out), optional :: inside
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char) :: short(usual_text), long(usual_text)
    integer(rc_long) :: needed
    integer(rc_int) :: counts
    short(1) = c_null_char
    long(1) = c_null_char
    needed = 0
    counts = 0
    call finish(rollcon_stat_info(kind, int(i - 1, rc_int), usual_text, short, long, needed, counts), c_null_ptr, &
      'rc_stat_info', stat, errmsg)
    name = f_text(short)
    if (present(doc)) doc = f_text(long)
    if (present(inside)) inside = int(counts)
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
