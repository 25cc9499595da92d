! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.

!> The life of a body and its plain procedures. rc_body (module rollcon_body) adds the others; programs use
!> that type. A variable is one reference to the object: assignment adds a reference, `free` and the end of the
!> variable's life drop it.
module rollcon_body_plain
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int32_t, c_int64_t, c_null_char, &
    c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_context
  implicit none
  private
  public :: rc_body_plain

  type :: rc_body_plain
    private
    type(c_ptr) :: p = c_null_ptr
  contains
    procedure :: create
    procedure :: load
    procedure :: set_elastic => body_set_elastic
    procedure :: set_viscoelastic => body_set_viscoelastic
    procedure :: set_moduli => body_set_moduli
    procedure :: prepare => body_prepare
    procedure :: get_kind => body_get_kind
    procedure :: save => body_save
    procedure :: set_traction => body_set_traction
    procedure :: set_body_force => body_set_body_force
    procedure :: set_rotation => body_set_rotation
    procedure :: set_pressure => body_set_pressure
    procedure :: set_springs => body_set_springs
    procedure :: set_contact_faces => body_set_contact_faces
    procedure :: revolve => body_revolve
    procedure :: extrude => body_extrude
    procedure :: set_condensed => body_set_condensed
    procedure :: read_condensed => body_read_condensed
    procedure :: write_condensed => body_write_condensed
    procedure :: read_mesh => body_read_mesh
    procedure :: tag_group => body_tag_group
    procedure :: get_group_count => body_get_group_count
    procedure :: get_group_name => body_get_group_name
    procedure :: set_profile => body_set_profile
    procedure :: set_profile_shape => body_set_profile_shape
    procedure :: read_profile => body_read_profile
    procedure :: add_slice => body_add_slice
    procedure :: read_slices => body_read_slices
    procedure :: add_wave => body_add_wave
    procedure :: write_profile => body_write_profile
    procedure :: extrude_profile => body_extrude_profile
    procedure :: revolve_profile => body_revolve_profile
    procedure :: get_profile_length => body_get_profile_length
    procedure :: get_profile_point => body_get_profile_point
    procedure :: get_size => body_get_size
    procedure :: get_reaction => body_get_reaction
    procedure :: get_stat => body_get_stat
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

  !> A new body; a failure leaves none.
  subroutine create(self, context, kind, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer(rc_int), intent(in) :: kind
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    call self%free()
    status = rollcon_body_create(context%handle(), kind, self%p)
    if (status /= ROLLCON_OK) self%p = c_null_ptr
    call finish(status, context%handle(), 'rc_body%create', stat, errmsg)
  end subroutine

  !> A prepared body from a file that rc_body%save wrote: nothing is assembled or factorised.
  subroutine load(self, context, path, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    type(rc_context), intent(in) :: context
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    call self%free()
    status = rollcon_body_load(context%handle(), c_text(path), self%p)
    if (status /= ROLLCON_OK) self%p = c_null_ptr
    call finish(status, context%handle(), 'rc_body%load', stat, errmsg)
  end subroutine

  !> Gives the reference back; the object lives on while another variable or the library uses it.
  impure elemental subroutine release(self)
    class(rc_body_plain), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_body_release(self%p)
    self%p = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_body_plain), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_body_plain), intent(inout) :: self
    class(rc_body_plain), intent(in) :: other
    type(c_ptr) :: p
    p = other%p
    if (c_associated(p)) then
      if (rollcon_body_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    call self%free()
    self%p = p
  end subroutine

  !> Adds a reference to the body that `id` names (as the FORTRAN 77 layer counts them).
  subroutine from_id(self, id, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    p = rollcon_body_from_id(int(id, rc_int))
    status = rollcon_body_retain(p)
    call self%free()
    if (status == ROLLCON_OK) self%p = p
    call finish(status, c_null_ptr, 'rc_body%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_body_plain), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_body_plain), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_int32(self, name, value, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_int(self%p, c_text(name), int(value, rc_long)), self%p, &
      'rc_body%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_int64(self, name, value, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_int(self%p, c_text(name), value), self%p, &
      'rc_body%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine set_option_real(self, name, value, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(in) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_real(self%p, c_text(name), value), self%p, &
      'rc_body%set', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_int32(self, name, value, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int32_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: wide
    wide = 0
    call finish(rollcon_body_get_int(self%p, c_text(name), wide), self%p, &
      'rc_body%get', stat, errmsg)
    value = int(wide, c_int32_t)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_int64(self, name, value, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    integer(c_int64_t), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_body_get_int(self%p, c_text(name), value), self%p, &
      'rc_body%get', stat, errmsg)
  end subroutine

  !> A setting by name; rc_option_info lists them.
  subroutine get_option_real(self, name, value, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_body_get_real(self%p, c_text(name), value), self%p, &
      'rc_body%get', stat, errmsg)
  end subroutine

  !> Sets an isotropic linear elastic material.
  subroutine body_set_elastic(self, young, poisson, tag, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in) :: young
    real(rc_real), intent(in) :: poisson
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer :: tag_or_standard
    tag_or_standard = 0
    if (present(tag)) tag_or_standard = tag
    call finish(rollcon_body_set_elastic(self%p, int(tag_or_standard, rc_int), young, poisson), self%p, &
      'rc_body%set_elastic', stat, errmsg)
  end subroutine

  !> Lets a material of a half-space or a section relax: at a time t after a strain Young's modulus is E (1 - sum of
  !> ratio (1 - exp(-t / time))), where E is that of rollcon_body_set_elastic. Poisson's ratio does not change. Such
  !> bodies are solved in steady rolling only, at the speed of rollcon_contact_set_rolling: time steps, conformal
  !> contacts, wear, tables and wheels on rails end with ROLLCON_ERR_UNSUPPORTED. The statistic rolling_resistance is
  !> the force that rolling costs.
  subroutine body_set_viscoelastic(self, ratios, times, tag, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: ratios(:)
    real(rc_real), intent(in), contiguous :: times(:)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer :: tag_or_standard
    tag_or_standard = 0
    if (present(tag)) tag_or_standard = tag
    call finish( &
      rollcon_body_set_viscoelastic(self%p, int(tag_or_standard, rc_int), size(ratios, 1, rc_long), ratios, times), &
      self%p, 'rc_body%set_viscoelastic', stat, errmsg)
  end subroutine

  !> Lets a material relax as rollcon_body_set_viscoelastic does, by moduli over frequency instead of terms. They take
  !> the place of Young's modulus; rollcon_body_set_elastic gives Poisson's ratio before. Sections take the moduli as
  !> they are: linear in the logarithm of the frequency between points; beyond them the storage modulus stays, and the
  !> loss modulus falls with the frequency or its inverse. Half-spaces take the Prony series, eight terms a decade, that
  !> is nearest to them. ROLLCON_ERR_ARGUMENT: it is off a modulus by more than 10 %; beyond 2 % the log warns.
  subroutine body_set_moduli(self, frequencies, storage, loss, tag, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: frequencies(:)
    real(rc_real), intent(in), contiguous :: storage(:)
    real(rc_real), intent(in), contiguous :: loss(:)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer :: tag_or_standard
    tag_or_standard = 0
    if (present(tag)) tag_or_standard = tag
    call finish( &
      rollcon_body_set_moduli(self%p, int(tag_or_standard, rc_int), size(frequencies, 1, rc_long), frequencies, storage, loss), &
      self%p, 'rc_body%set_moduli', stat, errmsg)
  end subroutine

  !> Checks that the body is complete and its mesh and supports sound, assembles and factorises its equations, and
  !> freezes it. The call is optional: the first solve does it. Calling it again does nothing. (Finite elements with
  !> many contact faces and no loads of their own are factorised when a frame tells which part of the faces takes part.)
  !> ROLLCON_ERR_MESH names the offending elements or nodes: double nodes, degenerate or repeated elements, neighbours
  !> of opposite orientation, and for elastic bodies open edges, normals that point inwards, more than one outer shell;
  !> for finite elements turned elements, faces that meet without matching, parts that share no face, tagged faces that
  !> are not on the boundary. A body equal to one that is prepared in the same context (mesh, tags, material, supports,
  !> loads, contact faces, options) uses its equations: nothing is assembled again. ROLLCON_ERR_SINGULAR: the supports
  !> leave the body free to move, and the text says how; hold it (three nodes not on a line, or a hub), since what is
  !> held is also what approach and creepage move.
  subroutine body_prepare(self, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_prepare(self%p), self%p, 'rc_body%prepare', stat, errmsg)
  end subroutine

  !> Returns the model given to rollcon_body_create.
  subroutine body_get_kind(self, kind, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    integer(rc_int), intent(out) :: kind
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    kind = 0
    call finish(rollcon_body_get_kind(self%p, kind), self%p, 'rc_body%get_kind', stat, errmsg)
  end subroutine

  !> Writes the body, prepared if it was not, to a file: all that was given, the factors, and the responses to frames
  !> that it has cached (option cache_bytes). The file appears whole or not at all; an older one is replaced. Poses
  !> belong to contacts and are not written. Every library of the same ABI number and format reads it, on any machine of
  !> the same byte order with IEEE numbers.
  subroutine body_save(self, path, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_save(self%p, c_text(path)), self%p, 'rc_body%save', stat, errmsg)
  end subroutine

  !> Prescribes the traction on the faces with a tag; replaces an earlier one. A pressure on the same tag is added to
  !> it. Faces without load or support are free.
  subroutine body_set_traction(self, tag, traction, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(in) :: tag
    real(rc_real), intent(in) :: traction(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_traction(self%p, int(tag, rc_int), traction), self%p, 'rc_body%set_traction', stat, &
      errmsg)
  end subroutine

  !> Prescribes a force per volume, such as weight, on the finite elements with a tag; replaces an earlier one.
  !> ROLLCON_ERR_STATE: a body without volume elements, and at rollcon_body_prepare a tag that no element has.
  subroutine body_set_body_force(self, tag, force, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(in) :: tag
    real(rc_real), intent(in) :: force(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_body_force(self%p, int(tag, rc_int), force), self%p, 'rc_body%set_body_force', stat, &
      errmsg)
  end subroutine

  !> Prescribes the centrifugal forces of a steady rotation on the finite elements with a tag, added to
  !> rollcon_body_set_body_force; replaces an earlier one. The stiffness is that of the body at rest.
  subroutine body_set_rotation(self, tag, density, origin, rate, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(in) :: tag
    real(rc_real), intent(in) :: density
    real(rc_real), intent(in) :: origin(3)
    real(rc_real), intent(in) :: rate(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_rotation(self%p, int(tag, rc_int), density, origin, rate), self%p, &
      'rc_body%set_rotation', stat, errmsg)
  end subroutine

  !> Prescribes a pressure on the faces with a tag, against their outward normals; replaces an earlier one and adds to a
  !> traction on the same tag.
  subroutine body_set_pressure(self, tag, pressure, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(in) :: tag
    real(rc_real), intent(in) :: pressure
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_pressure(self%p, int(tag, rc_int), pressure), self%p, 'rc_body%set_pressure', stat, &
      errmsg)
  end subroutine

  !> Puts the faces with a tag on springs: a rail on its pad, a wheel on the rubber of its tyre. The traction of the
  !> springs is minus the stiffness times the displacement. Springs hold a body as supports do. Faces on springs are no
  !> contact faces unless rollcon_body_set_contact_faces names them. rollcon_body_get_reaction returns the forces on
  !> held nodes, without those of springs.
  subroutine body_set_springs(self, tag, stiffness, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(in) :: tag
    real(rc_real), intent(in) :: stiffness(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_springs(self%p, int(tag, rc_int), stiffness), self%p, 'rc_body%set_springs', stat, &
      errmsg)
  end subroutine

  !> Says which faces may come into contact: gaps are computed and frames laid on them. The standard is all faces that
  !> are neither held nor loaded.
  subroutine body_set_contact_faces(self, tags, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer, intent(in) :: tags(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_contact_faces(self%p, size(tags, 1, rc_long), int(tags, rc_int)), self%p, &
      'rc_body%set_contact_faces', stat, errmsg)
  end subroutine

  !> Turns the plane mesh of a section into a body of revolution: a wheel, a ring, a roller. The section's nodes lie in
  !> a half plane that ends at the axis. Supports, tractions and given displacements are the same all the way round:
  !> their components are along x, y and z where the section lies, and turn with it. A prepared body has the nodes and
  !> faces of the surface that its contact edges sweep.
  subroutine body_revolve(self, origin, axis, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in) :: origin(3)
    real(rc_real), intent(in) :: axis(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_revolve(self%p, origin, axis), self%p, 'rc_body%revolve', stat, errmsg)
  end subroutine

  !> Draws the plane mesh of a section along a line: a rail, a raceway strip. The section's nodes lie in the plane
  !> through the origin at right angles to the line. Supports, tractions and given displacements are the same all along
  !> the line. The contact's load repeats after the period, which is long enough when results do not depend on it. The
  !> surface reaches as far to both sides of the section as the section is wide: the contact must lie there.
  subroutine body_extrude(self, origin, direction, period, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in) :: origin(3)
    real(rc_real), intent(in) :: direction(3)
    real(rc_real), intent(in) :: period
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_extrude(self%p, origin, direction, period), self%p, 'rc_body%extrude', stat, errmsg)
  end subroutine

  !> Gives a body of kind ROLLCON_BODY_CONDENSED its matrix: stiffness or flexibility of all its nodes, in its axes,
  !> rows x, y, z of each node in their order, as another program condensed it. rollcon_body_set_elastic gives the
  !> constants of the half-space between the nodes. Supports hold nodes of a stiffness; a rigid motion that nothing
  !> holds ends rollcon_body_prepare with ROLLCON_ERR_SINGULAR, which names it. ROLLCON_ERR_ARGUMENT names an entry that
  !> is not symmetric (1e-6); preparing also checks that the matrix is definite. A matrix that gives way between
  !> neighbouring nodes as one of a modulus more than 30 times larger or smaller does (other units) makes solves end
  !> with ROLLCON_INACCURATE, and the caveat tells the factor.
  subroutine body_set_condensed(self, form, matrix, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: form
    real(rc_real), intent(in), contiguous :: matrix(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_condensed(self%p, form, size(matrix, 1, rc_long), matrix), self%p, &
      'rc_body%set_condensed', stat, errmsg)
  end subroutine

  !> Reads what rollcon_body_set_condensed takes from a file: MatrixMarket (array or coordinate, general or symmetric),
  !> or a stiffness that Abaqus or CalculiX wrote for a substructure (*SUBSTRUCTURE GENERATE and *SUBSTRUCTURE MATRIX
  !> OUTPUT), whose nodes are found by the numbers that they have in the mesh's file, or are in the order in which the
  !> substructure names them if the body's nodes are from arrays. ROLLCON_ERR_IO names file and line.
  subroutine body_read_condensed(self, form, path, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    integer(rc_int), intent(in) :: form
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_read_condensed(self%p, form, c_text(path)), self%p, 'rc_body%read_condensed', stat, errmsg)
  end subroutine

  !> Writes the stiffness or flexibility of a prepared body with a mesh on the nodes of its contact faces, in the order
  !> of their ids, as a symmetric MatrixMarket file that rollcon_body_read_condensed and other programs read. A comment
  !> lists the nodes' numbers. A flexibility has zeros for components that supports hold; a stiffness then ends with
  !> ROLLCON_ERR_SINGULAR.
  subroutine body_write_condensed(self, form, path, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    integer(rc_int), intent(in) :: form
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_write_condensed(self%p, form, c_text(path)), self%p, 'rc_body%write_condensed', stat, &
      errmsg)
  end subroutine

  !> Takes nodes, elements and names from a file, in place of the whole former mesh: a file of Gmsh if the name ends in
  !> .msh (versions 2 to 2.2 and 4.1, text or binary), of Abaqus or CalculiX if it ends in .inp. Linear and quadratic
  !> tetrahedra, wedges and hexahedra for finite-element bodies, with the surface elements that have a name; triangles
  !> and quadrilaterals for all others, also as faces of volume elements that the surface `part` names. Orders of nodes
  !> are changed to those of rollcon; hexahedra of 27 nodes and wedges of 18 lose those inside their faces. Nodes that
  !> no element has are left out, the others keep the order of the file. Groups are Gmsh's physical groups (nameless
  !> ones: "surface 2", ...), Abaqus's sets and surfaces. An element's tag is its (first) physical group in Gmsh, else
  !> 0: rollcon_body_tag_group. ROLLCON_ERR_IO names the file, the line (in binary files the byte) and what is wrong
  !> there; ROLLCON_ERR_MESH: no element that the body could take. Shapes are checked by rollcon_body_prepare.
  subroutine body_read_mesh(self, path, part, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: path
    character(len=*), intent(in) :: part
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_read_mesh(self%p, c_text(path), c_text(part)), self%p, 'rc_body%read_mesh', stat, errmsg)
  end subroutine

  !> Gives a tag to what the mesh's file has in a group: to volume elements (their material), to surface elements and
  !> faces (loads, contact faces). A group of nodes alone names the faces all of whose nodes it has. Later calls win.
  subroutine body_tag_group(self, group, tag, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: group
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_tag_group(self%p, c_text(group), int(tag, rc_int)), self%p, 'rc_body%tag_group', stat, &
      errmsg)
  end subroutine

  !> Returns how many groups of the mesh's file name something of the body; 0 for a mesh that was not read, and for a
  !> body that was saved and loaded.
  subroutine body_get_group_count(self, n, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    integer, intent(out) :: n
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: n_c
    n_c = 0
    call finish(rollcon_body_get_group_count(self%p, n_c), self%p, 'rc_body%get_group_count', stat, errmsg)
    n = int(n_c)
  end subroutine

  !> Returns the name of a group in the file's spelling.
  subroutine body_get_group_name(self, i, text, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    integer, intent(in) :: i
    character(len=:), allocatable, intent(out) :: text
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable :: buffer(:)
    integer(rc_long) :: needed
    integer(rc_int) :: status
    allocate (buffer(1))
    needed = 0
    status = rollcon_body_get_group_name(self%p, int(i - 1, rc_int), needed, buffer, needed)
    deallocate (buffer)
    allocate (buffer(max(needed, 1_rc_long)))
    buffer(1) = c_null_char
    if (status == ROLLCON_OK) status = rollcon_body_get_group_name(self%p, int(i - 1, rc_int), needed, buffer, needed)
    text = f_text(buffer)
    call finish(status, self%p, 'rc_body%get_group_name', stat, errmsg)
  end subroutine

  !> Sets a profile through points, in either order: a cubic spline in arc length with two derivatives continuous,
  !> broken at kinks (turns of 30 degrees and more, three times as much as beside them). Points nearer to each other
  !> than a thousandth of the usual distance are dropped, and where the path goes back and forth again the two points
  !> are replaced by their mean. The former profile and its place are forgotten. ROLLCON_ERR_ARGUMENT names the point at
  !> which the path turns back.
  subroutine body_set_profile(self, points, filter_length, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: points(:, :)
    real(rc_real), intent(in), optional :: filter_length
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: filter_length_or_standard
    filter_length_or_standard = 0
    if (present(filter_length)) filter_length_or_standard = filter_length
    if (size(points, 1) /= 2) then
      call finish(ROLLCON_ERR_ARGUMENT, self%p, 'rc_body%set_profile', stat, errmsg, &
      'the first extent of points must be 2')
      return
    end if
    call finish(rollcon_body_set_profile(self%p, size(points, 2, rc_long), points, filter_length_or_standard), self%p, &
      'rc_body%set_profile', stat, errmsg)
  end subroutine

  !> Sets a profile in closed form: "line" half_width, slope; "arc" radius, half_width: the circle through (0, 0) about
  !> z = -radius, up to half of it; "arcs" y, z and angle of the start, then length and curvature (0: a line; positive:
  !> from y to z) of each arc, each going on in the direction in which the one before ends; "roller" half_width, relief,
  !> k (0 to 1), edge_radius: z = relief ln(1 - k (y/half_width)^2), logarithmic after Lundberg (k = 1) or Johns and
  !> Gohar (k < 1), up to where it is 45 degrees steep, and beyond quarter circles of the edge's radius (0: none, sharp
  !> ends); relief 0 is a straight roller; "s1002" unit: the wheel, in lengths of which `unit` is a millimetre, the
  !> middle of the tread at (0, 0), z down, the flange at y < 0; "60e1" unit: the head of the rail, upright, its top at
  !> (0, 0), z down. The former profile and its place are forgotten.
  subroutine body_set_profile_shape(self, shape, parameters, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: shape
    real(rc_real), intent(in), contiguous :: parameters(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_profile_shape(self%p, c_text(shape), size(parameters, 1, rc_long), parameters), &
      self%p, 'rc_body%set_profile_shape', stat, errmsg)
  end subroutine

  !> Sets a profile through the points of a file, just as rollcon_body_set_profile does: a file of Simpack if the name
  !> ends in .prr or .prw (its keys are obeyed except for smoothing), of Miniprof if it ends in .ban, .whl or .mpt, else
  !> columns, y and z (docs/profiles.md). Simpack's and Miniprof's numbers are millimetres. ROLLCON_ERR_IO names the
  !> line of a file that cannot be read, ROLLCON_ERR_ARGUMENT that of a point at which the path turns back. z goes where
  !> the file says: mirror it where the file counts upwards.
  subroutine body_read_profile(self, path, unit, mirror, filter_length, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: path
    real(rc_real), intent(in) :: unit
    integer, intent(in), optional :: mirror
    real(rc_real), intent(in), optional :: filter_length
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer :: mirror_or_standard
    real(rc_real) :: filter_length_or_standard
    mirror_or_standard = 0
    if (present(mirror)) mirror_or_standard = mirror
    filter_length_or_standard = 0
    if (present(filter_length)) filter_length_or_standard = filter_length
    call finish( &
      rollcon_body_read_profile(self%p, c_text(path), unit, int(mirror_or_standard, rc_int), filter_length_or_standard), &
      self%p, 'rc_body%read_profile', stat, errmsg)
  end subroutine

  !> Takes the profile as that of one place, a length along the body or an angle round it, and waits for the profile of
  !> the next: a switch, a crossing or a wheel that is out of round is given by several. Each slice is divided at its
  !> features, points that correspond from slice to slice, and between two that neighbours have in common lines of equal
  !> fractions of arc length are joined by cubic splines (option smooth_slices). Beyond the first and last slice a rail
  !> stays as it is there; round a wheel they are periodic. Angles count from the body's z about its axis, for a wheel
  !> about y from below to ahead. One slice is an ordinary profile.
  subroutine body_add_slice(self, u, features, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in) :: u
    real(rc_real), intent(in), contiguous :: features(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_add_slice(self%p, u, size(features, 1, rc_long), features), self%p, 'rc_body%add_slice', &
      stat, errmsg)
  end subroutine

  !> Reads all slices of a rail (.slcs) or wheel (.slcw) from a list. Its places are lengths or angles, and it names the
  !> files of the profiles (docs/profiles.md). The former profile, slices and waves are forgotten.
  subroutine body_read_slices(self, path, mm, unit, mirror, filter_length, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    character(len=*), intent(in) :: path
    real(rc_real), intent(in) :: mm
    real(rc_real), intent(in) :: unit
    integer, intent(in), optional :: mirror
    real(rc_real), intent(in), optional :: filter_length
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer :: mirror_or_standard
    real(rc_real) :: filter_length_or_standard
    mirror_or_standard = 0
    if (present(mirror)) mirror_or_standard = mirror
    filter_length_or_standard = 0
    if (present(filter_length)) filter_length_or_standard = filter_length
    call finish( &
      rollcon_body_read_slices(self%p, c_text(path), mm, unit, int(mirror_or_standard, rc_int), filter_length_or_standard), &
      self%p, 'rc_body%read_slices', stat, errmsg)
  end subroutine

  !> Adds amplitude sin(2 pi u / wavelength + phase) to z of the profile, at the length or angle u: corrugation of a
  !> rail, a polygon of a wheel. Several add up.
  subroutine body_add_wave(self, amplitude, wavelength, phase, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in) :: amplitude
    real(rc_real), intent(in) :: wavelength
    real(rc_real), intent(in) :: phase
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_add_wave(self%p, amplitude, wavelength, phase), self%p, 'rc_body%add_wave', stat, errmsg)
  end subroutine

  !> Writes points of the profile to a file: of Simpack if the name ends in .prr or .prw, else two columns. A profile
  !> through points is the same when read again, one in closed form within 1e-9 of its size where its curvature is
  !> continuous. The file appears whole or not at all.
  subroutine body_write_profile(self, path, unit, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    character(len=*), intent(in) :: path
    real(rc_real), intent(in) :: unit
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_write_profile(self%p, c_text(path), unit), self%p, 'rc_body%write_profile', stat, errmsg)
  end subroutine

  !> Makes the profile, moved along a straight line without end, the surface of the body: x of the profile points along
  !> `along`, z along z_axis, y along z_axis x along.
  subroutine body_extrude_profile(self, origin, along, z_axis, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in) :: origin(3)
    real(rc_real), intent(in) :: along(3)
    real(rc_real), intent(in) :: z_axis(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_extrude_profile(self%p, origin, along, z_axis), self%p, 'rc_body%extrude_profile', stat, &
      errmsg)
  end subroutine

  !> Makes the profile, turned about an axis, the surface of the body: its points lie at y along the axis and at radius
  !> + z away from it. An axis of the opposite direction mirrors it in y.
  subroutine body_revolve_profile(self, origin, axis, radius, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    real(rc_real), intent(in) :: origin(3)
    real(rc_real), intent(in) :: axis(3)
    real(rc_real), intent(in) :: radius
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_revolve_profile(self%p, origin, axis, radius), self%p, 'rc_body%revolve_profile', stat, &
      errmsg)
  end subroutine

  !> Returns the arc length of the profile. It works before rollcon_body_prepare.
  subroutine body_get_profile_length(self, length, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    real(rc_real), intent(out) :: length
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    length = 0
    call finish(rollcon_body_get_profile_length(self%p, length), self%p, 'rc_body%get_profile_length', stat, errmsg)
  end subroutine

  !> Returns point, tangent and curvature of the profile at an arc length, counted from the end where y is less. It
  !> works before rollcon_body_prepare.
  subroutine body_get_profile_point(self, s, point, tangent, curvature, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    real(rc_real), intent(in) :: s
    real(rc_real), intent(out) :: point(2)
    real(rc_real), intent(out) :: tangent(2)
    real(rc_real), intent(out) :: curvature
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    point = 0
    tangent = 0
    curvature = 0
    call finish(rollcon_body_get_profile_point(self%p, s, point, tangent, curvature), self%p, &
      'rc_body%get_profile_point', stat, errmsg)
  end subroutine

  !> Returns the nodes and elements given so far; 0 for bodies without a mesh. It works before rollcon_body_prepare.
  subroutine body_get_size(self, nodes, elements, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    integer, intent(out) :: nodes
    integer, intent(out), optional :: elements
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: nodes_c
    integer(rc_long) :: elements_c
    nodes_c = 0
    elements_c = 0
    call finish(rollcon_body_get_size(self%p, nodes_c, elements_c), self%p, 'rc_body%get_size', stat, errmsg)
    nodes = int(nodes_c)
    if (present(elements)) elements = int(elements_c)
  end subroutine

  !> Returns the resultant of the forces that the supports exert on the body under its own loads and given
  !> displacements, and its moment about the origin of the body's axes. It balances the loads up to the error of the
  !> discretisation: a measure of it.
  subroutine body_get_reaction(self, force, moment, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    real(rc_real), intent(out) :: force(3)
    real(rc_real), intent(out) :: moment(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    force = 0
    moment = 0
    call finish(rollcon_body_get_reaction(self%p, force, moment), self%p, 'rc_body%get_reaction', stat, errmsg)
  end subroutine

  !> Returns one number about a prepared body: unknowns, assemblies, factorisations, condition, seconds, bytes; 0 for
  !> bodies without equations. Names: rollcon_stat_info. Counts are those of the equations, which equal bodies of a
  !> context have in common: "shared" is 1 for a body for which nothing was assembled because an equal one was prepared
  !> before, "loaded" for one from a file.
  subroutine body_get_stat(self, name, value, stat, errmsg)
    class(rc_body_plain), intent(in) :: self
    character(len=*), intent(in) :: name
    real(rc_real), intent(out) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    value = 0
    call finish(rollcon_body_get_stat(self%p, c_text(name), value), self%p, 'rc_body%get_stat', stat, errmsg)
  end subroutine

end module rollcon_body_plain
