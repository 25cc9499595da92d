! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.

!> The life of a table and its plain procedures. rc_table (module rollcon_table) adds the others; programs use
!> that type. A variable is one reference to the object: assignment adds a reference, `free` and the end of the
!> variable's life drop it.
module rollcon_table_plain
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int32_t, c_int64_t, c_null_char, &
    c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_context
  implicit none
  private
  public :: rc_table_plain

  type :: rc_table_plain
    private
    type(c_ptr) :: p = c_null_ptr
  contains
    procedure :: create
    procedure :: set_ratios => table_set_ratios
    procedure :: set_resolution => table_set_resolution
    procedure :: set_frame => table_set_frame
    procedure :: set_poissons => table_set_poissons
    procedure :: set_bodies => table_set_bodies
    procedure :: request_cancel => table_request_cancel
    procedure :: make => table_make
    procedure :: add_samples => table_add_samples
    procedure :: save => table_save
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
    procedure, private :: assign
    generic :: assignment(=) => assign
    final :: finalize
  end type

contains

  !> A new table; a failure leaves none.
  subroutine create(self, context, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    call self%free()
    status = rollcon_table_create(context%handle(), self%p)
    if (status /= ROLLCON_OK) self%p = c_null_ptr
    call finish(status, context%handle(), 'rc_table%create', stat, errmsg)
  end subroutine

  !> Gives the reference back; the object lives on while another variable or the library uses it.
  impure elemental subroutine release(self)
    class(rc_table_plain), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_table_release(self%p)
    self%p = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_table_plain), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_table_plain), intent(inout) :: self
    class(rc_table_plain), intent(in) :: other
    type(c_ptr) :: p
    p = other%p
    if (c_associated(p)) then
      if (rollcon_table_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    call self%free()
    self%p = p
  end subroutine

  !> Adds a reference to the table that `id` names (as the FORTRAN 77 layer counts them).
  subroutine from_id(self, id, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    p = rollcon_table_from_id(int(id, rc_int))
    status = rollcon_table_retain(p)
    call self%free()
    if (status == ROLLCON_OK) self%p = p
    call finish(status, c_null_ptr, 'rc_table%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_table_plain), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_table_plain), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> Sets which ratios a / b of semi-axes the table has. Call it before the first sample (else ROLLCON_ERR_STATE).
  subroutine table_set_ratios(self, intervals, least, greatest, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    integer, intent(in) :: intervals
    real(rc_real), intent(in) :: least
    real(rc_real), intent(in) :: greatest
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_set_ratios(self%p, int(intervals, rc_int), least, greatest), self%p, &
      'rc_table%set_ratios', stat, errmsg)
  end subroutine

  !> Sets how fine the table is in the creepages. Call it before the first sample (else ROLLCON_ERR_STATE).
  subroutine table_set_resolution(self, magnitudes, angles, directions, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    integer, intent(in) :: magnitudes
    integer, intent(in) :: angles
    integer, intent(in) :: directions
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish( &
      rollcon_table_set_resolution(self%p, int(magnitudes, rc_int), int(angles, rc_int), int(directions, rc_int)), &
      self%p, 'rc_table%set_resolution', stat, errmsg)
  end subroutine

  !> Sets the coarser of the two frames of strips on which samples of circles are solved; those of longer ellipses have
  !> more cells along their length and fewer across. Call it before the first sample (else ROLLCON_ERR_STATE).
  subroutine table_set_frame(self, along, across, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    integer, intent(in) :: along
    integer, intent(in) :: across
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_set_frame(self%p, int(along, rc_int), int(across, rc_int)), self%p, 'rc_table%set_frame', &
      stat, errmsg)
  end subroutine

  !> Makes it a table of bodies of equal elastic constants, which a new one is, and sets its Poisson's ratios; it is
  !> linear between two and beyond them (by twice their distance and at most 0.04, up to 0.5), cubic between more. Call
  !> it before the first sample (else ROLLCON_ERR_STATE).
  subroutine table_set_poissons(self, poissons, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: poissons(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_set_poissons(self%p, size(poissons, 1, rc_long), poissons), self%p, &
      'rc_table%set_poissons', stat, errmsg)
  end subroutine

  !> Makes it a table of two bodies whose elastic constants differ, one of which may be rigid: wheel on rail of another
  !> metal, rubber on steel. Forces of such bodies depend on friction by itself: the table has coefficients of friction,
  !> is linear in the logarithm of two and cubic in that of more, and has none beyond. rollcon_table_evaluate then takes
  !> as shear and poisson the mean values of the bodies (rollcon_contact_get_equivalent_ellipse), and creepages without
  !> the strain under the pressure. Each coefficient of friction takes as long as two to three Poisson's ratios of like
  !> bodies. Bodies whose (1 - 2 nu)/(2 G) are the same make a table of like bodies. Call it before the first sample
  !> (else ROLLCON_ERR_STATE).
  subroutine table_set_bodies(self, youngs, poissons, frictions, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    real(rc_real), intent(in) :: youngs(2)
    real(rc_real), intent(in) :: poissons(2)
    real(rc_real), intent(in), contiguous :: frictions(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_set_bodies(self%p, youngs, poissons, size(frictions, 1, rc_long), frictions), self%p, &
      'rc_table%set_bodies', stat, errmsg)
  end subroutine

  !> Asks a running rollcon_table_make to stop: it returns ROLLCON_CANCELLED within a few solves. What was solved stays,
  !> and the next call goes on.
  subroutine table_request_cancel(self, stat, errmsg)
    class(rc_table_plain), intent(in) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_request_cancel(self%p), self%p, 'rc_table%request_cancel', stat, errmsg)
  end subroutine

  !> Solves the samples of a part of the table that are not there yet, over the context's threads; with the last sample
  !> the table is made. Results depend neither on the number of threads nor on the parts. Several processes make a part
  !> each, one of them then adds the samples of the others.
  subroutine table_make(self, part, parts, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    integer, intent(in) :: part
    integer, intent(in) :: parts
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_make(self%p, int(part, rc_int), int(parts, rc_int)), self%p, 'rc_table%make', stat, &
      errmsg)
  end subroutine

  !> Adds the samples that another table of the same settings has (rollcon_table_get_samples); NaN adds none. With the
  !> last sample the table is made.
  subroutine table_add_samples(self, samples, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: samples(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_add_samples(self%p, size(samples, 1, rc_long), samples), self%p, 'rc_table%add_samples', &
      stat, errmsg)
  end subroutine

  !> Writes the table, with what wheels found to calibrate ellipses, to a file, whole or not at all; an older one is
  !> replaced. ROLLCON_ERR_STATE: the table is not made yet.
  subroutine table_save(self, path, stat, errmsg)
    class(rc_table_plain), intent(inout) :: self
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_table_save(self%p, c_text(path)), self%p, 'rc_table%save', stat, errmsg)
  end subroutine

end module rollcon_table_plain
