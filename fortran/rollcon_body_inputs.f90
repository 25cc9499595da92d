!> The first half of a body: its life, material, mesh, supports and loads. rc_body (module rollcon_body) adds settings,
!> preparation and results; programs use that type. A variable is one reference to the object, as for `rc_context`.
!>
!> Vectors are xyz by columns: x(3,n); node numbers count from 1. Every call takes `stat` and `errmsg` as those of
!> `rc_contact` do.
module rollcon_body_inputs
  use, intrinsic :: iso_c_binding, only: c_associated, c_int32_t, c_int64_t, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_context
  implicit none
  private
  public :: rc_body_inputs

  type :: rc_body_inputs
    private
    type(c_ptr) :: p = c_null_ptr
    type(c_ptr) :: context = c_null_ptr  ! a reference of its own, for the texts of failures
  contains
    procedure :: create
    procedure :: load
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
    procedure :: owner
    procedure :: set_elastic
    procedure :: set_nodes
    procedure :: set_nodes_by_component
    procedure, private :: add_elements_int32
    procedure, private :: add_elements_int64
    generic :: add_elements => add_elements_int32, add_elements_int64
    procedure, private :: tag_faces_int32
    procedure, private :: tag_faces_int64
    generic :: tag_faces => tag_faces_int32, tag_faces_int64
    procedure, private :: tag_faces_of_nodes_int32
    procedure, private :: tag_faces_of_nodes_int64
    generic :: tag_faces_of_nodes => tag_faces_of_nodes_int32, tag_faces_of_nodes_int64
    procedure, private :: set_support_int32
    procedure, private :: set_support_int64
    generic :: set_support => set_support_int32, set_support_int64
    procedure :: set_traction
    procedure :: set_pressure
    procedure :: set_contact_faces
    procedure, private :: assign
    generic :: assignment(=) => assign
    final :: finalize
  end type

contains

  !> kind: ROLLCON_BODY_FEM, ROLLCON_BODY_BEM, ROLLCON_BODY_HALFSPACE or ROLLCON_BODY_RIGID.
  subroutine create(self, context, kind, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer(rc_int), intent(in) :: kind
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    type(c_ptr) :: ctx
    call self%free()
    ctx = context%handle()
    status = rollcon_body_create(ctx, kind, self%p)
    if (status /= ROLLCON_OK) then
      self%p = c_null_ptr
    else if (rollcon_context_retain(ctx) == ROLLCON_OK) then
      self%context = ctx
    end if
    call finish(status, ctx, 'rc_body%create', stat, errmsg)
  end subroutine

  !> A prepared body from a file that rc_body%save wrote: nothing is assembled or factorised.
  subroutine load(self, context, path, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    type(rc_context), intent(in) :: context
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    type(c_ptr) :: ctx
    call self%free()
    ctx = context%handle()
    status = rollcon_body_load(ctx, c_text(path), self%p)
    if (status /= ROLLCON_OK) then
      self%p = c_null_ptr
    else if (rollcon_context_retain(ctx) == ROLLCON_OK) then
      self%context = ctx
    end if
    call finish(status, ctx, 'rc_body%load', stat, errmsg)
  end subroutine

  !> Gives the reference back; the object lives on while a contact or another variable uses it.
  impure elemental subroutine release(self)
    class(rc_body_inputs), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_body_release(self%p)
    if (c_associated(self%context)) call rollcon_context_release(self%context)
    self%p = c_null_ptr
    self%context = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_body_inputs), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_body_inputs), intent(inout) :: self
    class(rc_body_inputs), intent(in) :: other
    type(c_ptr) :: p, context
    p = other%p
    context = other%context
    if (c_associated(p)) then
      if (rollcon_body_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    if (c_associated(context)) then
      if (rollcon_context_retain(context) /= ROLLCON_OK) context = c_null_ptr
    end if
    call self%free()
    self%p = p
    self%context = context
  end subroutine

  !> Adds a reference to the body that `id` names; texts of failures come from `context`.
  subroutine from_id(self, context, id, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    type(rc_context), intent(in) :: context
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p, ctx
    integer(rc_int) :: status
    p = rollcon_body_from_id(int(id, rc_int))
    ctx = context%handle()
    status = rollcon_body_retain(p)
    call self%free()
    if (status == ROLLCON_OK) then
      self%p = p
      if (c_associated(ctx)) then
        if (rollcon_context_retain(ctx) == ROLLCON_OK) self%context = ctx
      end if
    end if
    call finish(status, c_null_ptr, 'rc_body%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_body_inputs), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_body_inputs), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function

  !> The C handle of the context that holds the texts of failures.
  function owner(self) result(context)
    class(rc_body_inputs), intent(in) :: self
    type(c_ptr) :: context
    context = self%context
  end function

  !> Young's modulus > 0 and Poisson's ratio in (-1, 0.5]. Tag: of the finite elements that get them, 0 if absent; other
  !> bodies have one material and ignore it.
  subroutine set_elastic(self, young, poisson, tag, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    real(rc_real), intent(in) :: young, poisson
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: t
    t = 0
    if (present(tag)) t = int(tag, rc_int)
    call finish(rollcon_body_set_elastic(self%p, t, young, poisson), self%context, 'rc_body%set_elastic', stat, errmsg)
  end subroutine

  !> Nodes, x(3,n), of the surface or, of finite elements, of the volume; forgets elements, tags, supports, loads and contact
  !> faces.
  subroutine set_nodes(self, x, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(x, 1) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_body%set_nodes', stat, errmsg, 'the first extent of x must be 3')
      return
    end if
    call finish(rollcon_body_set_nodes(self%p, size(x, 2, rc_long), x, 3_rc_long, 1_rc_long), self%context, &
      'rc_body%set_nodes', stat, errmsg)
  end subroutine

  !> The same, x(n,3).
  subroutine set_nodes_by_component(self, x, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: n
    if (size(x, 2) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_body%set_nodes_by_component', stat, errmsg, &
        'the second extent of x must be 3')
      return
    end if
    n = size(x, 1, rc_long)
    call finish(rollcon_body_set_nodes(self%p, n, x, 1_rc_long, n), self%context, 'rc_body%set_nodes_by_component', stat, errmsg)
  end subroutine

  !> Elements of one type: nodes(nodes per element, n), numbered from 1. Surface elements (ROLLCON_TRI3, ...), normals outwards:
  !> tag 1 if absent. Finite elements take volume elements (ROLLCON_TET4, ...), whose tag (0 if absent) names their material, and
  !> surface elements, which give their tag to the boundary faces with the same nodes.
  subroutine add_elements_int32(self, type, nodes, tag, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(rc_int), intent(in) :: type
    integer(c_int32_t), intent(in), contiguous :: nodes(:, :)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: t
    t = 1
    if (is_volume_type(type)) t = 0
    if (present(tag)) t = int(tag, rc_int)
    if (nodes_of(type) /= 0 .and. size(nodes, 1) /= nodes_of(type)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_body%add_elements', stat, errmsg, &
        'the first extent of nodes must be the number of nodes of one element')
      return
    end if
    call finish(rollcon_body_add_elements(self%p, type, size(nodes, 2, rc_long), nodes, 1_rc_int, t), self%context, &
      'rc_body%add_elements', stat, errmsg)
  end subroutine

  subroutine add_elements_int64(self, type, nodes, tag, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(rc_int), intent(in) :: type
    integer(c_int64_t), intent(in) :: nodes(:, :)
    integer, intent(in), optional :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%add_elements_int32(type, narrow_ids(nodes), tag, stat, errmsg)
  end subroutine

  !> Tags boundary faces of finite elements: face faces(i) of volume element elements(i), both numbered from 1, elements in the
  !> order in which they were added. Boundary faces that no call names have tag 0; later calls win.
  subroutine tag_faces_int32(self, elements, faces, tag, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(c_int32_t), intent(in), contiguous :: elements(:), faces(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: none(1)
    if (size(elements) /= size(faces)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_body%tag_faces', stat, errmsg, &
        'the extents of elements and faces must be the same')
      return
    end if
    if (size(elements) == 0) then  ! an empty array may have no address
      none = 0
      call finish(rollcon_body_tag_faces(self%p, 0_rc_long, none, none, 1_rc_int, int(tag, rc_int)), &
        self%context, 'rc_body%tag_faces', stat, errmsg)
      return
    end if
    call finish(rollcon_body_tag_faces(self%p, size(elements, kind=rc_long), elements, faces, 1_rc_int, int(tag, rc_int)), &
      self%context, 'rc_body%tag_faces', stat, errmsg)
  end subroutine

  subroutine tag_faces_int64(self, elements, faces, tag, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(c_int64_t), intent(in) :: elements(:), faces(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%tag_faces_int32(narrow_ids(elements), narrow_ids(faces), tag, stat, errmsg)
  end subroutine

  !> Tags the faces all of whose nodes, numbered from 1, are given: boundary faces of finite elements, or the surface elements
  !> added so far.
  subroutine tag_faces_of_nodes_int32(self, nodes, tag, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(c_int32_t), intent(in), contiguous :: nodes(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: none(1)
    if (size(nodes) == 0) then  ! an empty array may have no address
      none = 0
      call finish(rollcon_body_tag_faces_of_nodes(self%p, 0_rc_long, none, 1_rc_int, int(tag, rc_int)), &
        self%context, 'rc_body%tag_faces_of_nodes', stat, errmsg)
      return
    end if
    call finish(rollcon_body_tag_faces_of_nodes(self%p, size(nodes, kind=rc_long), nodes, 1_rc_int, int(tag, rc_int)), &
      self%context, 'rc_body%tag_faces_of_nodes', stat, errmsg)
  end subroutine

  subroutine tag_faces_of_nodes_int64(self, nodes, tag, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(c_int64_t), intent(in) :: nodes(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%tag_faces_of_nodes_int32(narrow_ids(nodes), tag, stat, errmsg)
  end subroutine

  !> Holds displacement components of nodes, numbered from 1, at values(3,n) (zero if absent). dof_mask: sum of
  !> ROLLCON_DOF_X, DOF_Y, DOF_Z (all if absent).
  subroutine set_support_int32(self, nodes, dof_mask, values, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(c_int32_t), intent(in), contiguous :: nodes(:)
    integer(rc_int), intent(in), optional :: dof_mask
    real(rc_real), intent(in), optional :: values(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real), allocatable :: v(:, :)
    integer(rc_int) :: mask
    mask = ROLLCON_DOF_XYZ
    if (present(dof_mask)) mask = dof_mask
    allocate (v(3, size(nodes)))
    v = 0
    if (present(values)) then
      if (size(values, 1) /= 3 .or. size(values, 2) /= size(nodes)) then
        call finish(ROLLCON_ERR_ARGUMENT, self%context, 'rc_body%set_support', stat, errmsg, &
          'the extents of values must be 3 and the number of nodes')
        return
      end if
      v(:, :) = values
    end if
    call finish(rollcon_body_set_support(self%p, size(nodes, kind=rc_long), nodes, 1_rc_int, mask, v), self%context, &
      'rc_body%set_support', stat, errmsg)
  end subroutine

  subroutine set_support_int64(self, nodes, dof_mask, values, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer(c_int64_t), intent(in) :: nodes(:)
    integer(rc_int), intent(in), optional :: dof_mask
    real(rc_real), intent(in), optional :: values(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%set_support_int32(narrow_ids(nodes), dof_mask, values, stat, errmsg)
  end subroutine

  !> Traction along x y z on the faces with a tag.
  subroutine set_traction(self, tag, traction, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer, intent(in) :: tag
    real(rc_real), intent(in) :: traction(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_traction(self%p, int(tag, rc_int), traction), self%context, 'rc_body%set_traction', stat, errmsg)
  end subroutine

  !> Pressure against the outward normals of the faces with a tag.
  subroutine set_pressure(self, tag, pressure, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer, intent(in) :: tag
    real(rc_real), intent(in) :: pressure
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_pressure(self%p, int(tag, rc_int), pressure), self%context, 'rc_body%set_pressure', stat, errmsg)
  end subroutine

  !> Tags of the faces that may come into contact; none: all that are neither held nor loaded.
  subroutine set_contact_faces(self, tags, stat, errmsg)
    class(rc_body_inputs), intent(inout) :: self
    integer, intent(in) :: tags(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call finish(rollcon_body_set_contact_faces(self%p, size(tags, kind=rc_long), int(tags, rc_int)), self%context, &
      'rc_body%set_contact_faces', stat, errmsg)
  end subroutine

end module rollcon_body_inputs
