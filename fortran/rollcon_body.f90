!> Provides what the generated type rc_body_plain of bodies does not have. Vectors are xyz by columns: x(3,n); node
!> numbers count from 1. Every call takes `stat` (absent: a failure prints its message and stops) and `errmsg` (set on
!> failure).
module rollcon_body
  use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
  use rollcon_body_plain
  implicit none
  private
  public :: rc_body

  type, extends(rc_body_plain) :: rc_body
  contains
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
    procedure, private :: set_node_tractions_int32
    procedure, private :: set_node_tractions_int64
    generic :: set_node_tractions => set_node_tractions_int32, set_node_tractions_int64
    procedure :: copy => copy_body
    procedure :: get_group_nodes
    procedure :: get_displacements
    procedure :: get_node_stresses
    procedure :: get_point_stresses
    procedure :: get_fields_at
    procedure :: write_vtu => write_body
  end type

contains

  !> Gives nodes, x(3,n), of the surface or, for finite elements, of the volume; forgets elements, tags, supports, loads
  !> and contact faces.
  subroutine set_nodes(self, x, stat, errmsg)
    class(rc_body), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    if (size(x, 1) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_body%set_nodes', stat, errmsg, 'the first extent of x must be 3')
      return
    end if
    call finish(rollcon_body_set_nodes(self%handle(), size(x, 2, rc_long), x, 3_rc_long, 1_rc_long), self%handle(), &
      'rc_body%set_nodes', stat, errmsg)
  end subroutine

  !> Gives nodes in the order x(n,3).
  subroutine set_nodes_by_component(self, x, stat, errmsg)
    class(rc_body), intent(inout) :: self
    real(rc_real), intent(in), contiguous :: x(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_long) :: n
    if (size(x, 2) /= 3) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_body%set_nodes_by_component', stat, errmsg, &
        'the second extent of x must be 3')
      return
    end if
    n = size(x, 1, rc_long)
    call finish(rollcon_body_set_nodes(self%handle(), n, x, 1_rc_long, n), self%handle(), &
      'rc_body%set_nodes_by_component', stat, errmsg)
  end subroutine

  !> Adds elements of one type: nodes(nodes per element, n), numbered from 1. Surface elements (ROLLCON_TRI3, ...),
  !> normals outwards: tag 1 if absent. Finite elements take volume elements (ROLLCON_TET4, ...), whose tag (0 if
  !> absent) names their material, and surface elements, which give their tag to the boundary faces with the same nodes.
  subroutine add_elements_int32(self, type, nodes, tag, stat, errmsg)
    class(rc_body), intent(inout) :: self
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
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_body%add_elements', stat, errmsg, &
        'the first extent of nodes must be the number of nodes of one element')
      return
    end if
    call finish(rollcon_body_add_elements(self%handle(), type, size(nodes, 2, rc_long), nodes, 1_rc_int, t), self%handle(), &
      'rc_body%add_elements', stat, errmsg)
  end subroutine

  subroutine add_elements_int64(self, type, nodes, tag, stat, errmsg)
    class(rc_body), intent(inout) :: self
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
    class(rc_body), intent(inout) :: self
    integer(c_int32_t), intent(in), contiguous :: elements(:), faces(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: none(1)
    if (size(elements) /= size(faces)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_body%tag_faces', stat, errmsg, &
        'the extents of elements and faces must be the same')
      return
    end if
    if (size(elements) == 0) then  ! an empty array may have no address
      none = 0
      call finish(rollcon_body_tag_faces(self%handle(), 0_rc_long, none, none, 1_rc_int, int(tag, rc_int)), &
        self%handle(), 'rc_body%tag_faces', stat, errmsg)
      return
    end if
    call finish(rollcon_body_tag_faces(self%handle(), size(elements, kind=rc_long), elements, faces, 1_rc_int, int(tag, rc_int)), &
      self%handle(), 'rc_body%tag_faces', stat, errmsg)
  end subroutine

  subroutine tag_faces_int64(self, elements, faces, tag, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer(c_int64_t), intent(in) :: elements(:), faces(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%tag_faces_int32(narrow_ids(elements), narrow_ids(faces), tag, stat, errmsg)
  end subroutine

  !> Tags the faces all of whose nodes, numbered from 1, are given: boundary faces of finite elements, or the surface elements
  !> added so far.
  subroutine tag_faces_of_nodes_int32(self, nodes, tag, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer(c_int32_t), intent(in), contiguous :: nodes(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: none(1)
    if (size(nodes) == 0) then  ! an empty array may have no address
      none = 0
      call finish(rollcon_body_tag_faces_of_nodes(self%handle(), 0_rc_long, none, 1_rc_int, int(tag, rc_int)), &
        self%handle(), 'rc_body%tag_faces_of_nodes', stat, errmsg)
      return
    end if
    call finish(rollcon_body_tag_faces_of_nodes(self%handle(), size(nodes, kind=rc_long), nodes, 1_rc_int, int(tag, rc_int)), &
      self%handle(), 'rc_body%tag_faces_of_nodes', stat, errmsg)
  end subroutine

  subroutine tag_faces_of_nodes_int64(self, nodes, tag, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer(c_int64_t), intent(in) :: nodes(:)
    integer, intent(in) :: tag
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%tag_faces_of_nodes_int32(narrow_ids(nodes), tag, stat, errmsg)
  end subroutine

  !> Holds displacement components of nodes, numbered from 1, at values(3,n) (zero if absent). The argument dof_mask is
  !> a sum of ROLLCON_DOF_X, DOF_Y, DOF_Z (all if absent).
  subroutine set_support_int32(self, nodes, dof_mask, values, stat, errmsg)
    class(rc_body), intent(inout) :: self
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
        call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_body%set_support', stat, errmsg, &
          'the extents of values must be 3 and the number of nodes')
        return
      end if
      v(:, :) = values
    end if
    call finish(rollcon_body_set_support(self%handle(), size(nodes, kind=rc_long), nodes, 1_rc_int, mask, v), self%handle(), &
      'rc_body%set_support', stat, errmsg)
  end subroutine

  subroutine set_support_int64(self, nodes, dof_mask, values, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer(c_int64_t), intent(in) :: nodes(:)
    integer(rc_int), intent(in), optional :: dof_mask
    real(rc_real), intent(in), optional :: values(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%set_support_int32(narrow_ids(nodes), dof_mask, values, stat, errmsg)
  end subroutine

  !> Gives tractions(3,n) at nodes, numbered from 1, of the faces with a tag, linear or quadratic between them like the
  !> faces, added to the tag's traction and pressure. With a direction, along(3), they have components along its part in
  !> the surface, across, and along the outward normal; else x y z.
  subroutine set_node_tractions_int32(self, tag, nodes, tractions, along, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer, intent(in) :: tag
    integer(c_int32_t), intent(in), contiguous :: nodes(:)
    real(rc_real), intent(in), contiguous :: tractions(:, :)
    real(rc_real), intent(in), optional :: along(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real) :: direction(3)
    direction = 0
    if (present(along)) direction = along
    if (size(tractions, 1) /= 3 .or. size(tractions, 2) /= size(nodes)) then
      call finish(ROLLCON_ERR_ARGUMENT, self%handle(), 'rc_body%set_node_tractions', stat, errmsg, &
        'the extents of tractions must be 3 and the number of nodes')
      return
    end if
    call finish(rollcon_body_set_node_tractions(self%handle(), int(tag, rc_int), size(nodes, kind=rc_long), nodes, 1_rc_int, &
      direction, tractions), self%handle(), 'rc_body%set_node_tractions', stat, errmsg)
  end subroutine

  subroutine set_node_tractions_int64(self, tag, nodes, tractions, along, stat, errmsg)
    class(rc_body), intent(inout) :: self
    integer, intent(in) :: tag
    integer(c_int64_t), intent(in) :: nodes(:)
    real(rc_real), intent(in), contiguous :: tractions(:, :)
    real(rc_real), intent(in), optional :: along(3)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    call self%set_node_tractions_int32(tag, narrow_ids(nodes), tractions, along, stat, errmsg)
  end subroutine

  !> Makes another body that was given the same, not prepared. With other loads alone it takes the equations of this one
  !> and their factors when it is prepared: a load case.
  subroutine copy_body(self, other, stat, errmsg)
    class(rc_body), intent(in) :: self
    class(rc_body), intent(inout) :: other
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    integer :: kept
    call other%free()
    p = c_null_ptr
    status = rollcon_body_copy(self%handle(), p)
    if (status == ROLLCON_OK) then
      call other%from_id(int(rollcon_id_of(p)), kept)  ! a reference of its own
      call rollcon_body_release(p)
    end if
    call finish(status, self%handle(), 'rc_body%copy', stat, errmsg)
  end subroutine

  !> Returns the nodes of all that a group of the mesh's file has, ascending; call it after read_mesh.
  subroutine get_group_nodes(self, group, nodes, stat, errmsg)
    class(rc_body), intent(in) :: self
    character(len=*), intent(in) :: group
    integer(rc_int), allocatable, intent(out) :: nodes(:)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status, none(1)
    integer(rc_long) :: n
    n = 0
    status = rollcon_body_get_group_nodes(self%handle(), c_text(group), 1_rc_int, 0_rc_long, none, n)
    allocate (nodes(n))
    nodes = 0
    if (status == ROLLCON_OK .and. n > 0) &
      status = rollcon_body_get_group_nodes(self%handle(), c_text(group), 1_rc_int, n, nodes, n)
    call finish(status, self%handle(), 'rc_body%get_group_nodes', stat, errmsg)
  end subroutine

  !> Returns displacements u(3,n) of a prepared body under its own loads and given displacements, with no contact
  !> acting.
  subroutine get_displacements(self, u, stat, errmsg)
    class(rc_body), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    integer(rc_long) :: n, m
    n = 0
    m = 0
    status = rollcon_body_get_size(self%handle(), n, m)
    allocate (u(3, n))
    u = 0
    if (status == ROLLCON_OK) status = rollcon_body_get_displacements(self%handle(), n, u)
    call finish(status, self%handle(), 'rc_body%get_displacements', stat, errmsg)
  end subroutine

  !> Returns smoothed stresses stress(6,n) (s11, s22, s33, s12, s13, s23) of finite elements under displacements u(3,n)
  !> of their nodes, or under the body's own loads.
  subroutine get_node_stresses(self, stress, u, stat, errmsg)
    class(rc_body), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: stress(:, :)
    real(rc_real), intent(in), contiguous, optional :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real), allocatable :: moved(:, :)
    integer(rc_int) :: status
    if (.not. three_rows(self, u, 'rc_body%get_node_stresses', stat, errmsg)) return
    status = nodal(self, u, moved)
    allocate (stress(6, size(moved, 2)))
    stress = 0
    if (status == ROLLCON_OK) &
      status = rollcon_body_get_node_stresses(self%handle(), size(moved, 2, rc_long), moved, stress)
    call finish(status, self%handle(), 'rc_body%get_node_stresses', stat, errmsg)
  end subroutine

  !> Returns stresses stress(6,n) at the integration points of all finite elements, and the points' places xyz(3,n).
  subroutine get_point_stresses(self, stress, xyz, u, stat, errmsg)
    class(rc_body), intent(in) :: self
    real(rc_real), allocatable, intent(out) :: stress(:, :), xyz(:, :)
    real(rc_real), intent(in), contiguous, optional :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real), allocatable :: moved(:, :)
    real(rc_real) :: none(1), neither(1)
    integer(rc_long) :: points
    integer(rc_int) :: status
    if (.not. three_rows(self, u, 'rc_body%get_point_stresses', stat, errmsg)) return
    status = nodal(self, u, moved)
    points = 0
    if (status == ROLLCON_OK) &
      status = rollcon_body_get_point_stresses(self%handle(), size(moved, 2, rc_long), moved, 0_rc_long, none, neither, points)
    allocate (stress(6, points), xyz(3, points))
    stress = 0
    xyz = 0
    if (status == ROLLCON_OK) &
      status = rollcon_body_get_point_stresses(self%handle(), size(moved, 2, rc_long), moved, points, stress, xyz, points)
    call finish(status, self%handle(), 'rc_body%get_point_stresses', stat, errmsg)
  end subroutine

  !> Returns displacements displacement(3,n) and stresses stress(6,n) at points xyz(3,n) inside finite elements, or
  !> boundary elements under their own loads.
  subroutine get_fields_at(self, xyz, displacement, stress, u, stat, errmsg)
    class(rc_body), intent(in) :: self
    real(rc_real), intent(in), contiguous :: xyz(:, :)
    real(rc_real), allocatable, intent(out) :: displacement(:, :), stress(:, :)
    real(rc_real), intent(in), contiguous, optional :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real), allocatable :: moved(:, :)
    integer(rc_int) :: status
    if (.not. three_rows(self, xyz, 'rc_body%get_fields_at', stat, errmsg)) return
    if (.not. three_rows(self, u, 'rc_body%get_fields_at', stat, errmsg)) return
    status = nodal(self, u, moved)
    allocate (displacement(3, size(xyz, 2)), stress(6, size(xyz, 2)))
    displacement = 0
    stress = 0
    if (status == ROLLCON_OK) &
      status = rollcon_body_get_fields_at(self%handle(), size(moved, 2, rc_long), moved, size(xyz, 2, rc_long), xyz, &
      displacement, stress)
    call finish(status, self%handle(), 'rc_body%get_fields_at', stat, errmsg)
  end subroutine

  !> Writes elements with displacements, smoothed stresses and von Mises's stress, as a VTU file.
  subroutine write_body(self, path, u, stat, errmsg)
    class(rc_body), intent(in) :: self
    character(len=*), intent(in) :: path
    real(rc_real), intent(in), contiguous, optional :: u(:, :)
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    real(rc_real), allocatable :: moved(:, :)
    integer(rc_int) :: status
    if (.not. three_rows(self, u, 'rc_body%write_vtu', stat, errmsg)) return
    status = nodal(self, u, moved)
    if (status == ROLLCON_OK) status = rollcon_body_write(self%handle(), c_text(path), size(moved, 2, rc_long), moved)
    call finish(status, self%handle(), 'rc_body%write_vtu', stat, errmsg)
  end subroutine

  !> Takes the displacements that are given, or the body's own.
  function nodal(self, u, moved) result(status)
    class(rc_body), intent(in) :: self
    real(rc_real), intent(in), optional :: u(:, :)
    real(rc_real), allocatable, intent(out) :: moved(:, :)
    integer(rc_int) :: status
    integer :: state
    status = ROLLCON_OK
    if (present(u)) then
      moved = u
    else
      call self%get_displacements(moved, state)
      status = int(state, rc_int)
    end if
  end function

  !> Refuses arrays that are not of three rows.
  function three_rows(self, x, who, stat, errmsg) result(good)
    class(rc_body), intent(in) :: self
    real(rc_real), intent(in), optional :: x(:, :)
    character(len=*), intent(in) :: who
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    logical :: good
    good = .true.
    if (present(x)) good = size(x, 1) == 3
    if (.not. good) call finish(ROLLCON_ERR_ARGUMENT, self%handle(), who, stat, errmsg, &
      'the first extent of an array of points or displacements must be 3')
  end function

end module rollcon_body
