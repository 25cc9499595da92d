! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.

!> The life of a wheelrail and its plain procedures. rc_wheelrail (module rollcon_wheelrail) adds the others; programs use
!> that type. A variable is one reference to the object: assignment adds a reference, `free` and the end of the
!> variable's life drop it.
module rollcon_wheelrail_plain
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int32_t, c_int64_t, c_null_char, &
    c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_context
  use rollcon_body
  implicit none
  private
  public :: rc_wheelrail_plain

  type :: rc_wheelrail_plain
    private
    type(c_ptr) :: p = c_null_ptr
  contains
    procedure :: create
    procedure :: set_track => wheelrail_set_track
    procedure :: set_wheelset => wheelrail_set_wheelset
    procedure :: place_rail => wheelrail_place_rail
    procedure :: set_roller => wheelrail_set_roller
    procedure :: set_step => wheelrail_set_step
    procedure :: repeat_step => wheelrail_repeat_step
    procedure :: past_set => wheelrail_past_set
    procedure :: set_tape_circle => wheelrail_set_tape_circle
    procedure :: set_flexibility => wheelrail_set_flexibility
    procedure :: set_rail_springs => wheelrail_set_rail_springs
    procedure :: set_rail_deviation => wheelrail_set_rail_deviation
    procedure :: set_position => wheelrail_set_position
    procedure :: set_velocity => wheelrail_set_velocity
    procedure :: prescribe_vertical => wheelrail_prescribe_vertical
    procedure :: prescribe_longitudinal => wheelrail_prescribe_longitudinal
    procedure :: set_friction => wheelrail_set_friction
    procedure :: set_law_by_angle => wheelrail_set_law_by_angle
    procedure :: set_friction_memory => wheelrail_set_friction_memory
    procedure :: set_layer => wheelrail_set_layer
    procedure :: set_heat => wheelrail_set_heat
    procedure :: solve => wheelrail_solve
    procedure :: request_cancel => wheelrail_request_cancel
    procedure :: snapshot => wheelrail_snapshot
    procedure :: rollback => wheelrail_rollback
    procedure :: reset => wheelrail_reset
    procedure :: get_patch_count => wheelrail_get_patch_count
    procedure :: get_resultant => wheelrail_get_resultant
    procedure :: get_derivative => wheelrail_get_derivative
    procedure :: get_stat => wheelrail_get_stat
    procedure :: get_profile_point => wheelrail_get_profile_point
    procedure :: get_patch_stat => wheelrail_get_patch_stat
    procedure :: get_patch_axes => wheelrail_get_patch_axes
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
    procedure, private :: set_option_int32
    procedure, private :: set_option_int64
    procedure, private :: set_option_real
    generic :: set => set_option_int32, set_option_int64, set_option_real
    procedure, private :: get_option_int32
    procedure, private :: get_option_int64
    procedure, private :: get_option_real
    generic :: get => get_option_int32, get_option_int64, get_option_real
    procedure, private :: assign
    generic :: assignment(=) => assign
    final :: finalize
  end type

contains

  !> A new wheelrail; a failure leaves none.
  subroutine create(self, context, wheel, rail, side, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    type(rc_context), intent(in) :: context
    type(rc_body), intent(in) :: wheel
    type(rc_body), intent(in) :: rail
    integer(rc_int), intent(in) :: side
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    call self%free()
    status = rollcon_wheelrail_create(context%handle(), wheel%handle(), rail%handle(), side, self%p)
    if (status /= ROLLCON_OK) self%p = c_null_ptr
    call finish(status, context%handle(), 'rc_wheelrail%create', stat, errmsg)
  end subroutine

  !> Gives the reference back; the object lives on while another variable or the library uses it.
  impure elemental subroutine release(self)
    class(rc_wheelrail_plain), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_wheelrail_release(self%p)
    self%p = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_wheelrail_plain), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_wheelrail_plain), intent(inout) :: self
    class(rc_wheelrail_plain), intent(in) :: other
    type(c_ptr) :: p
    p = other%p
    if (c_associated(p)) then
      if (rollcon_wheelrail_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    call self%free()
    self%p = p
  end subroutine

  !> Adds a reference to the wheelrail that `id` names (as the FORTRAN 77 layer counts them).
  subroutine from_id(self, id, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    p = rollcon_wheelrail_from_id(int(id, rc_int))
    status = rollcon_wheelrail_retain(p)
    call self%free()
    if (status == ROLLCON_OK) self%p = p
    call finish(status, c_null_ptr, 'rc_wheelrail%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_wheelrail_plain), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_wheelrail_plain), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_int32(self, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_int(self%p, c_text(name), int(value, rc_long)), self%p, &
      'rc_wheelrail%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_int64(self, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_int(self%p, c_text(name), value), self%p, &
      'rc_wheelrail%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_real(self, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_real(self%p, c_text(name), value), self%p, &
      'rc_wheelrail%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_int32(self, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: wide
    wide = 0
    call finish(rollcon_wheelrail_get_int(self%p, c_text(name), wide), self%p, &
      'rc_wheelrail%get', stat, errmsg)
    value = int(wide, c_int32_t)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_int64(self, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_wheelrail_get_int(self%p, c_text(name), value), self%p, &
      'rc_wheelrail%get', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_real(self, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_wheelrail_get_real(self%p, c_text(name), value), self%p, &
      'rc_wheelrail%get', stat, errmsg)
  end subroutine

  !> Says where the rails lie: each is canted, its top is at z = 0, and its gauge side is half the gauge from the middle
  !> of the track.
  subroutine wheelrail_set_track(self, gauge, gauge_height, cant, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: gauge
    real(rc_real), intent(in) :: gauge_height
    real(rc_real), intent(in) :: cant
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_track(self%p, gauge, gauge_height, cant), self%p, 'rc_wheelrail%set_track', stat, &
      errmsg)
  end subroutine

  !> Sets the dimensions of the wheelset.
  subroutine wheelrail_set_wheelset(self, back_to_back, flange_back, radius, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: back_to_back
    real(rc_real), intent(in) :: flange_back
    real(rc_real), intent(in) :: radius
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_wheelset(self%p, back_to_back, flange_back, radius), self%p, &
      'rc_wheelrail%set_wheelset', stat, errmsg)
  end subroutine

  !> Places the rail by the origin of its profile in the track, in place of rollcon_wheelrail_set_track. Deviations of
  !> the rail roll about this origin then.
  subroutine wheelrail_place_rail(self, y, z, cant, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: y
    real(rc_real), intent(in) :: z
    real(rc_real), intent(in) :: cant
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_place_rail(self%p, y, z, cant), self%p, 'rc_wheelrail%place_rail', stat, errmsg)
  end subroutine

  !> Makes the rail a roller of a test rig: its profile turns about an axis along y, one radius below the top of the
  !> rail, or below the origin of a rail that is placed by its origin (rollcon_wheelrail_place_rail). The contact moves
  !> over the roller at the rate times the radius plus the forward speed of the wheelset, which is 0 on a rig. Entry 0
  !> of the position is the distance of the wheelset from the place above the axis, length. ROLLCON_ERR_ARGUMENT: the
  !> track has a cant. The solve refuses profiles that vary, tables, conformal contacts and sections
  !> (ROLLCON_ERR_UNSUPPORTED).
  subroutine wheelrail_set_roller(self, radius, rate, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: radius
    real(rc_real), intent(in) :: rate
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_roller(self%p, radius, rate), self%p, 'rc_wheelrail%set_roller', stat, errmsg)
  end subroutine

  !> Makes every solve from now on a step in time of length dt; ROLLCON_STEADY makes it a steady state again.
  !> ROLLCON_ROLLING_STEP: the wheel rolls on as its velocity says. ROLLCON_SHIFT_STEP: nothing rolls, velocities times
  !> dt are shifts, and the forward speed may be 0. Patches carry their tractions from step to step and hand them on by
  !> place where they move, part or merge. The first step starts from the steady state that was solved last, or from
  !> rest if there is none; for rest call rollcon_wheelrail_reset. A step that fails keeps the state before it. The
  !> solve refuses sections, tables and conformal contacts, and calls with lists of positions refuse steps
  !> (ROLLCON_ERR_UNSUPPORTED).
  subroutine wheelrail_set_step(self, kind, dt, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: kind
    real(rc_real), intent(in) :: dt
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_step(self%p, kind, dt), self%p, 'rc_wheelrail%set_step', stat, errmsg)
  end subroutine

  !> Takes the last step back: the next solve starts from where that step started. This is possible once after each step
  !> that succeeded (else ROLLCON_ERR_STATE).
  subroutine wheelrail_repeat_step(self, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_repeat_step(self%p), self%p, 'rc_wheelrail%repeat_step', stat, errmsg)
  end subroutine

  !> Lets the next step start from numbers that rollcon_wheelrail_past_get gave; they are copied. Track and wheelset
  !> must be set (ROLLCON_ERR_STATE). ROLLCON_ERR_ARGUMENT: the numbers were changed, or belong to the other side or to
  !> other elastic constants; the past stays as it was. The results of the last solve are gone.
  subroutine wheelrail_past_set(self, past, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: past(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_past_set(self%p, size(past, 1, rc_long), past), self%p, 'rc_wheelrail%past_set', &
      stat, errmsg)
  end subroutine

  !> Says where on the wheel's profile the radius of rollcon_wheelrail_set_wheelset is measured, after that call, which
  !> takes it where the profile has z = 0.
  subroutine wheelrail_set_tape_circle(self, y, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: y
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_tape_circle(self%p, y), self%p, 'rc_wheelrail%set_tape_circle', stat, errmsg)
  end subroutine

  !> Displaces the wheel in the axes of the wheelset, which bends, and says how that changes. The wheel is displaced at
  !> the origin of its profile below the axle, and turned there. The standard is 0.
  subroutine wheelrail_set_flexibility(self, displacement, rate, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: displacement(6)
    real(rc_real), intent(in) :: rate(6)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_flexibility(self%p, displacement, rate), self%p, 'rc_wheelrail%set_flexibility', &
      stat, errmsg)
  end subroutine

  !> Puts the rail on springs along y and z of the track: beside its deviation it gives way until stiffness times
  !> deflection is the force of the wheel on it plus the force given here. Statistics rail_deflection_y and _z are what
  !> was found.
  subroutine wheelrail_set_rail_springs(self, stiffness, force, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: stiffness(2)
    real(rc_real), intent(in) :: force(2)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_rail_springs(self%p, stiffness, force), self%p, 'rc_wheelrail%set_rail_springs', &
      stat, errmsg)
  end subroutine

  !> Sets the deviation of the rail from its place in the track and how it changes: irregularities, and rails that give
  !> way. The standard is 0.
  subroutine wheelrail_set_rail_deviation(self, deviation, rate, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: deviation(3)
    real(rc_real), intent(in) :: rate(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_rail_deviation(self%p, deviation, rate), self%p, &
      'rc_wheelrail%set_rail_deviation', stat, errmsg)
  end subroutine

  !> Sets the position of the wheelset. z = 0 is where the tread's datum of a centred wheelset is at the height of the
  !> rails' top; z is not used where a vertical force is prescribed (statistic "z" is what was found), except as the
  !> start of the search.
  subroutine wheelrail_set_position(self, position, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: position(6)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_position(self%p, position), self%p, 'rc_wheelrail%set_position', stat, errmsg)
  end subroutine

  !> Sets the velocity of the wheelset.
  subroutine wheelrail_set_velocity(self, velocity, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: velocity(6)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_velocity(self%p, velocity), self%p, 'rc_wheelrail%set_velocity', stat, errmsg)
  end subroutine

  !> Prescribes the height of the wheelset by motion, from its position (standard), or by the vertical force; z is then
  !> found by the solve.
  subroutine wheelrail_prescribe_vertical(self, how, force, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: how
    real(rc_real), intent(in), optional :: force
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: force_or_standard
    force_or_standard = 0
    if (present(force)) force_or_standard = force
    call finish(rollcon_wheelrail_prescribe_vertical(self%p, how, force_or_standard), self%p, &
      'rc_wheelrail%prescribe_vertical', stat, errmsg)
  end subroutine

  !> Prescribes the pitch rate by motion, from the velocity (standard), or the force on the wheel along the wheelset's
  !> x; the pitch rate is then found by the solve, from that of the velocity on (statistic "pitch_rate").
  subroutine wheelrail_prescribe_longitudinal(self, how, force, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: how
    real(rc_real), intent(in), optional :: force
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: force_or_standard
    force_or_standard = 0
    if (present(force)) force_or_standard = force
    call finish(rollcon_wheelrail_prescribe_longitudinal(self%p, how, force_or_standard), self%p, &
      'rc_wheelrail%prescribe_longitudinal', stat, errmsg)
  end subroutine

  !> Sets the law of friction: one of rollcon_contact_set_friction, or "by_angle", Coulomb's law by the inclination of
  !> the rail, angle1, mu1, angle2, mu2, ... (rollcon_wheelrail_set_law_by_angle). Angles of orthotropic laws count in
  !> the axes of the patch, those of a left wheel in the mirror. Where friction falls and several solutions exist, a
  !> solve continues the last one, and one from nothing begins with the friction of rest.
  subroutine wheelrail_set_friction(self, law, parameters, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    character(len=*), intent(in) :: law
    real(rc_real), intent(in), contiguous :: parameters(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_friction(self%p, c_text(law), size(parameters, 1, rc_int), parameters), self%p, &
      'rc_wheelrail%set_friction', stat, errmsg)
  end subroutine

  !> Sets a law whose parameters follow the inclination of the rail's surface, linear between points and constant beyond
  !> them: lubricated gauge faces under dry heads. The inclination is atan dz/dy of a right rail with y to the right and
  !> z down, its cant included, its deviation not: negative on the gauge face; left rails are mirrored, so that one
  !> table serves both. The greatest coefficient follows the inclination across a patch, the form of the law is that at
  !> the reference of the patch.
  subroutine wheelrail_set_law_by_angle(self, law, points, parameters, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    character(len=*), intent(in) :: law
    integer, intent(in) :: points
    real(rc_real), intent(in), contiguous :: parameters(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish( &
      rollcon_wheelrail_set_law_by_angle(self%p, c_text(law), int(points, rc_int), size(parameters, 1, rc_int), parameters), &
      self%p, 'rc_wheelrail%set_law_by_angle', stat, errmsg)
  end subroutine

  !> Gives friction that falls with the slip speed a memory, as for a contact.
  subroutine wheelrail_set_friction_memory(self, length, least_speed, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: length
    real(rc_real), intent(in) :: least_speed
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_friction_memory(self%p, length, least_speed), self%p, &
      'rc_wheelrail%set_friction_memory', stat, errmsg)
  end subroutine

  !> Puts a thin layer between wheel and rail, as between the bodies of a contact.
  subroutine wheelrail_set_layer(self, flexibility, stress, hardening, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    real(rc_real), intent(in) :: flexibility
    real(rc_real), intent(in), optional :: stress
    real(rc_real), intent(in), optional :: hardening
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: stress_or_standard
    real(rc_real) :: hardening_or_standard
    stress_or_standard = 0
    if (present(stress)) stress_or_standard = stress
    hardening_or_standard = 0
    if (present(hardening)) hardening_or_standard = hardening
    call finish(rollcon_wheelrail_set_layer(self%p, flexibility, stress_or_standard, hardening_or_standard), self%p, &
      'rc_wheelrail%set_layer', stat, errmsg)
  end subroutine

  !> Says what wheel or rail does with heat, for the temperatures of the contacts of patches
  !> (rollcon_contact_get_temperatures_at) and for friction that depends on them. The call is needed for both.
  subroutine wheelrail_set_heat(self, which, conductivity, heat_capacity, temperature, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), intent(in) :: conductivity
    real(rc_real), intent(in) :: heat_capacity
    real(rc_real), intent(in) :: temperature
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_set_heat(self%p, which, conductivity, heat_capacity, temperature), self%p, &
      'rc_wheelrail%set_heat', stat, errmsg)
  end subroutine

  !> Finds the patches and solves each as a steady rolling contact, from the last solution where there is one. The
  !> status is the worst of the patches' in the order that holds for all calls. RIM_CONTACT: a patch ends at the end of
  !> a profile, or is not within its frame; NO_CONTACT: the wheel is lifted; the log has the numbers. ROLLCON_ERR_STATE
  !> names the call that is missing. ROLLCON_ERR_ARGUMENT: with this z wheel and rail overlap by more than a tenth of
  !> the wheel's radius. ROLLCON_ERR_LOAD: with this y no height brings the wheel on the rail, or no overlap up to a
  !> tenth of the radius carries the vertical force. ROLLCON_ERR_MESH: a conformal patch (option conformal) turns by
  !> more than 60 degrees to a side.
  subroutine wheelrail_solve(self, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_solve(self%p), self%p, 'rc_wheelrail%solve', stat, errmsg)
  end subroutine

  !> Asks a running rollcon_wheelrail_solve or rollcon_wheelrail_solve_many to stop (an atomic store) before its next
  !> patch, height or position. It returns ROLLCON_CANCELLED; the wheel stays usable.
  subroutine wheelrail_request_cancel(self, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_request_cancel(self%p), self%p, 'rc_wheelrail%request_cancel', stat, errmsg)
  end subroutine

  !> Takes a snapshot of what is set and of the last solution, kept at a place within the wheel, for
  !> rollcon_wheelrail_rollback, because integrators step back. Nothing is allocated where as much was kept before.
  subroutine wheelrail_snapshot(self, place, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer, intent(in) :: place
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_snapshot(self%p, int(place, rc_int)), self%p, 'rc_wheelrail%snapshot', stat, errmsg)
  end subroutine

  !> Goes back to a snapshot: inputs, results, and later solves are as if nothing had been done since, to the last bit.
  !> ROLLCON_ERR_STATE: there is no snapshot at this place, or track or wheelset have been set since. The snapshot
  !> stays. Contacts of patches that were new since then are no longer those of this wheel.
  subroutine wheelrail_rollback(self, place, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer, intent(in) :: place
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_rollback(self%p, int(place, rc_int)), self%p, 'rc_wheelrail%rollback', stat, errmsg)
  end subroutine

  !> Forgets the solution, the warm starts and what was before a step in time (bodies are at rest); keeps what was set
  !> and all that was computed for the frames.
  subroutine wheelrail_reset(self, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_wheelrail_reset(self%p), self%p, 'rc_wheelrail%reset', stat, errmsg)
  end subroutine

  !> Returns the number of patches, from 0.
  subroutine wheelrail_get_patch_count(self, patches, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    integer, intent(out) :: patches
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: patches_c
    patches_c = 0
    call finish(rollcon_wheelrail_get_patch_count(self%p, patches_c), self%p, 'rc_wheelrail%get_patch_count', stat, &
      errmsg)
    patches = int(patches_c)
  end subroutine

  !> Returns the force of all patches on the wheel and its moment about the wheelset's centre.
  subroutine wheelrail_get_resultant(self, force, moment, axes, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    real(rc_real), intent(out) :: force(3)
    real(rc_real), intent(out) :: moment(3)
    integer(rc_int), intent(in), optional :: axes
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: axes_or_standard
    axes_or_standard = ROLLCON_IN_TRACK
    if (present(axes)) axes_or_standard = axes
    force = 0
    moment = 0
    call finish(rollcon_wheelrail_get_resultant(self%p, axes_or_standard, force, moment), self%p, &
      'rc_wheelrail%get_resultant', stat, errmsg)
  end subroutine

  !> Returns the derivatives of the totals of the last solve by one entry of its position or velocity: those of what
  !> rollcon_wheelrail_get_resultant gives in the track, and derivatives of the wheelset's z. Where the height was found
  !> from a vertical force, that force stays and z follows; entry 2 has none then. They are those of Newton's systems at
  !> the solutions of the patches, whose axes and strips move; with a creep-force table, on conformal frames, with laws
  !> other than Coulomb's and with a layer, central differences of solves. The first call finds all twelve and keeps
  !> them until the next solve. ROLLCON_ERR_STATE: no solution, or one that did not converge. ROLLCON_ERR_SINGULAR: a
  !> patch begins or ends here.
  subroutine wheelrail_get_derivative(self, entry, force, moment, z, stat, errmsg)
    class(rc_wheelrail_plain), intent(inout) :: self
    integer, intent(in) :: entry
    real(rc_real), intent(out) :: force(3)
    real(rc_real), intent(out) :: moment(3)
    real(rc_real), intent(out) :: z
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    force = 0
    moment = 0
    z = 0
    call finish(rollcon_wheelrail_get_derivative(self%p, int(entry, rc_int), force, moment, z), self%p, &
      'rc_wheelrail%get_derivative', stat, errmsg)
  end subroutine

  !> Returns one number about the last solve: height, vertical force, frictional power, counts. Names:
  !> rollcon_stat_info; meanings: docs/wheelrail.md.
  subroutine wheelrail_get_stat(self, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_wheelrail_get_stat(self%p, c_text(name), value), self%p, 'rc_wheelrail%get_stat', stat, errmsg)
  end subroutine

  !> Returns where a point of the wheel's or the rail's profile stood in the last solve, in the track, for pictures. The
  !> wheel's profile is that in the plane of its axle, below it; of profiles that vary, the section there.
  subroutine wheelrail_get_profile_point(self, which, share, point, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    integer(rc_int), intent(in) :: which
    real(rc_real), intent(in) :: share
    real(rc_real), intent(out) :: point(2)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    point = 0
    call finish(rollcon_wheelrail_get_profile_point(self%p, which, share, point), self%p, &
      'rc_wheelrail%get_profile_point', stat, errmsg)
  end subroutine

  !> Returns one number about a patch: position, angle, rolling radius, creepages, forces, status. Names:
  !> rollcon_stat_info; meanings: docs/wheelrail.md.
  subroutine wheelrail_get_patch_stat(self, patch, name, value, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    integer, intent(in) :: patch
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_wheelrail_get_patch_stat(self%p, int(patch - 1, rc_int), c_text(name), value), self%p, &
      'rc_wheelrail%get_patch_stat', stat, errmsg)
  end subroutine

  !> Returns origin and axes of the contact of a patch (rollcon_wheelrail_get_contact) in the track: a node at (x, y, z)
  !> of the contact is at origin + x t1 + y t2 + z n. The axes of a left wheel are a mirror image: a left-handed triple.
  subroutine wheelrail_get_patch_axes(self, patch, origin, axes, stat, errmsg)
    class(rc_wheelrail_plain), intent(in) :: self
    integer, intent(in) :: patch
    real(rc_real), intent(out) :: origin(3)
    real(rc_real), intent(out) :: axes(9)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    origin = 0
    axes = 0
    call finish(rollcon_wheelrail_get_patch_axes(self%p, int(patch - 1, rc_int), origin, axes), self%p, &
      'rc_wheelrail%get_patch_axes', stat, errmsg)
  end subroutine

end module rollcon_wheelrail_plain
