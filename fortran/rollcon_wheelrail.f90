!> Provides what the generated type rc_wheelrail_plain, a wheel on its rail, does not have.
module rollcon_wheelrail
  use, intrinsic :: iso_c_binding, only: c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_contact
  use rollcon_table
  use rollcon_wheelrail_plain
  implicit none
  private
  public :: rc_wheelrail

  type, extends(rc_wheelrail_plain) :: rc_wheelrail
  contains
    procedure :: set_table
    procedure :: get_contact
    procedure :: copy
    procedure :: past_get
    procedure :: solve_many
    procedure :: find_wear
    procedure :: find_contact_points
    procedure :: find_conicity
  end type

contains

  !> Takes forces along the surfaces from a creep-force table from now on; without a table from none.
  subroutine set_table(self, table, stat, errmsg)
    class(rc_wheelrail), intent(inout) :: self
    class(rc_table), intent(in), optional :: table
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    p = c_null_ptr
    if (present(table)) p = table%handle()
    call finish(rollcon_wheelrail_set_table(self%handle(), p), self%handle(), 'rc_wheelrail%set_table', stat, errmsg)
  end subroutine

  !> Returns the contact of a patch, counted from 1, to be read; the next solve of the wheel on its rail changes it.
  subroutine get_contact(self, patch, contact, stat, errmsg)
    class(rc_wheelrail), intent(in) :: self
    integer, intent(in) :: patch
    type(rc_contact), intent(inout) :: contact
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    integer :: kept
    call contact%free()
    p = c_null_ptr
    status = rollcon_wheelrail_get_contact(self%handle(), int(patch - 1, rc_int), p)
    if (status == ROLLCON_OK) then
      call contact%from_id(int(rollcon_id_of(p)), kept)  ! a reference of its own
      call rollcon_contact_release(p)
    end if
    call finish(status, self%handle(), 'rc_wheelrail%get_contact', stat, errmsg)
  end subroutine

  !> Returns what the next step in time starts from, for past_set: of another run, or of another such wheel.
  subroutine past_get(self, past, stat, errmsg)
    class(rc_wheelrail), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: past(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: none(1)
    integer(rc_long) :: n
    integer(rc_int) :: status
    n = 0
    status = rollcon_wheelrail_past_get(self%handle(), 0_rc_long, none, n)
    if (status == ROLLCON_ERR_CAPACITY) status = ROLLCON_OK
    if (status < 0) n = 0
    allocate (past(n))
    if (status == ROLLCON_OK) status = rollcon_wheelrail_past_get(self%handle(), n, past, n)
    call finish(status, self%handle(), 'rc_wheelrail%past_get', stat, errmsg)
  end subroutine

  !> Makes another wheel on its rail with the same bodies, inputs and last solution.
  subroutine copy(self, other, stat, errmsg)
    class(rc_wheelrail), intent(in) :: self
    class(rc_wheelrail), intent(inout) :: other
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    integer :: kept
    call other%free()
    p = c_null_ptr
    status = rollcon_wheelrail_copy(self%handle(), p)
    if (status == ROLLCON_OK) then
      call other%from_id(int(rollcon_id_of(p)), kept)  ! a reference of its own
      call rollcon_wheelrail_release(p)
    end if
    call finish(status, self%handle(), 'rc_wheelrail%copy', stat, errmsg)
  end subroutine

  !> Solves many positions(6,n) and velocities(6,n) over threads, each by itself from nothing. totals(columns,n) has the
  !> columns asked for, separated by blanks: force_x, force_y, force_z, moment_x, moment_y, moment_z on the wheel in the
  !> track, z, vertical_force, friction_power; status(n) as solve would return.
  subroutine solve_many(self, positions, velocities, columns, totals, status, stat, errmsg)
    class(rc_wheelrail), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: positions(:, :), velocities(:, :)
    character(len=*), intent(in) :: columns
    real(rc_real), allocatable, intent(out) :: totals(:, :)
    integer(rc_int), allocatable, intent(out), optional :: status(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int), allocatable :: state(:)
    integer(rc_int) :: rc
    if (size(positions, 1) /= 6 .or. any(shape(positions) /= shape(velocities))) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_wheelrail%solve_many', stat, errmsg, &
        'positions and velocities must both be (6,n)')
      return
    end if
    allocate (totals(words(columns), size(positions, 2)), state(size(positions, 2)))
    totals = 0
    state = 0
    rc = rollcon_wheelrail_solve_many(self%handle(), size(positions, 2, rc_long), positions, velocities, c_text(columns), &
      totals, state)
    if (present(status)) status = state
    call finish(rc, self%handle(), 'rc_wheelrail%solve_many', stat, errmsg)
  end subroutine

  !> Returns what a spectrum of positions(6,n) with velocities(6,n) and weights(n) wears off both profiles per pass, at
  !> `points` points at equal arc lengths: wheel and rail, and the volumes(2) of both per length rolled.
  !> rc_contact%get_wear describes the laws.
  subroutine find_wear(self, positions, velocities, weights, law, parameters, points, wheel, rail, volumes, status, stat, &
    errmsg)
    class(rc_wheelrail), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: positions(:, :), velocities(:, :), weights(:), parameters(:)
    character(len=*), intent(in) :: law
    integer, intent(in) :: points
    real(rc_real), allocatable, intent(out) :: wheel(:), rail(:)
    real(rc_real), intent(out), optional :: volumes(2)
    integer(rc_int), allocatable, intent(out), optional :: status(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int), allocatable :: state(:)
    real(rc_real) :: whole(2)
    integer(rc_int) :: rc
    if (size(positions, 1) /= 6 .or. any(shape(positions) /= shape(velocities)) .or. size(weights) /= size(positions, 2)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_wheelrail%find_wear', stat, errmsg, &
        'positions and velocities must both be (6,n), weights (n)')
      return
    end if
    allocate (wheel(max(points, 0)), rail(max(points, 0)), state(size(weights)))
    wheel = 0
    rail = 0
    whole = 0
    state = 0
    rc = rollcon_wheelrail_find_wear(self%handle(), size(weights, kind=rc_long), positions, velocities, weights, c_text(law), &
      size(parameters, kind=rc_int), parameters, int(points, rc_long), wheel, rail, whole, state)
    if (present(status)) status = state
    if (present(volumes)) volumes = whole
    call finish(rc, self%handle(), 'rc_wheelrail%find_wear', stat, errmsg)
  end subroutine

  !> Finds where both wheels of a rigid wheelset touch rigid rails over its lateral shift; this is the left one.
  !> points(columns,n) has the columns asked for, separated by blanks: z and roll of the wheelset, radius_difference;
  !> left_y and left_z of the contact in the track, left_angle, left_wheel_y on the wheel's profile, left_radius;
  !> right_y, ...
  subroutine find_contact_points(self, right, shift, columns, points, stat, errmsg)
    class(rc_wheelrail), intent(inout) :: self
    class(rc_wheelrail), intent(inout) :: right
    real(rc_real), intent(in), contiguous :: shift(:)
    character(len=*), intent(in) :: columns
    real(rc_real), allocatable, intent(out) :: points(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    allocate (points(words(columns), size(shift)))
    points = 0
    call finish(rollcon_wheelrail_find_contact_points(self%handle(), right%handle(), size(shift, kind=rc_long), shift, &
      c_text(columns), points), self%handle(), 'rc_wheelrail%find_contact_points', stat, errmsg)
  end subroutine

  !> Returns the equivalent conicity of EN 15302 for each amplitude, and the wavelength of the motion; this is the left
  !> wheel.
  subroutine find_conicity(self, right, amplitude, conicity, wavelength, stat, errmsg)
    class(rc_wheelrail), intent(inout) :: self
    class(rc_wheelrail), intent(inout) :: right
    real(rc_real), intent(in), contiguous :: amplitude(:)
    real(rc_real), allocatable, intent(out) :: conicity(:), wavelength(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    allocate (conicity(size(amplitude)), wavelength(size(amplitude)))
    conicity = 0
    wavelength = 0
    call finish(rollcon_wheelrail_find_conicity(self%handle(), right%handle(), size(amplitude, kind=rc_long), amplitude, &
      conicity, wavelength), self%handle(), 'rc_wheelrail%find_conicity', stat, errmsg)
  end subroutine

end module rollcon_wheelrail
