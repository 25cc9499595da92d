!> Finite-element bodies from Fortran 2008: statuses of their mesh and tags, and a pressed block of two materials; built with
!> trapping of invalid operations, divisions by zero and overflows, which no call may trigger in the caller.
module finite_element_cases
  use rollcon
  implicit none
  private
  public :: run

  real(rc_real), parameter :: zero = 0.0_rc_real, one = 1.0_rc_real
  integer, parameter :: top = 2  !< face of a hexahedron

  type(rc_context) :: context
  type(rc_body) :: plane
  real(rc_real) :: x(3, 27)
  integer :: hexahedra(8, 8)
  integer :: failures = 0, checks = 0

contains

  subroutine expect(status, wanted, what)
    integer, intent(in) :: status
    integer(rc_int), intent(in) :: wanted
    character(len=*), intent(in) :: what
    checks = checks + 1
    if (status == wanted) return
    failures = failures + 1
    write (*, '(a, i0, a, i0, 2a)') 'status ', status, ' instead of ', wanted, ': ', what
  end subroutine

  subroutine demand(ok, what)
    logical, intent(in) :: ok
    character(len=*), intent(in) :: what
    checks = checks + 1
    if (ok) return
    failures = failures + 1
    write (*, '(2a)') 'wrong: ', what
  end subroutine

  !> The unit cube in 2 x 2 x 2 hexahedra; the last index of nodes and elements runs along z.
  subroutine make_box()
    integer :: i, j, k, n, e
    integer, parameter :: corner(8) = [0, 1, 4, 3, 9, 10, 13, 12]
    n = 0
    do k = 0, 2
      do j = 0, 2
        do i = 0, 2
          n = n + 1
          x(:, n) = 0.5_rc_real*[i, j, k]
        end do
      end do
    end do
    e = 0
    do k = 0, 1
      do j = 0, 1
        do i = 0, 1
          e = e + 1
          hexahedra(:, e) = 1 + i + 3*j + 9*k + corner
        end do
      end do
    end do
  end subroutine

  !> Lower half of modulus 200, upper one of 100, no lateral contraction.
  subroutine make_block(b)
    type(rc_body), intent(inout) :: b
    integer :: i
    call b%create(context, ROLLCON_BODY_FEM)
    call b%set_nodes(x)
    call b%add_elements(ROLLCON_HEX8, hexahedra(:, 1:4), 1)
    call b%add_elements(ROLLCON_HEX8, hexahedra(:, 5:8), 2)
    call b%set_elastic(200.0_rc_real, zero, 1)
    call b%set_elastic(100.0_rc_real, zero, 2)
    call b%set_support([(i, i=1, 9)], ROLLCON_DOF_Z)
    call b%set_support([1], ROLLCON_DOF_X + ROLLCON_DOF_Y)
    call b%set_support([3], ROLLCON_DOF_Y)
    call b%set('between_nodes', 1)
  end subroutine

  !> A flat rigid punch without friction: springs in series, 0.03/(0.5/200 + 0.5/100) = 4.
  subroutine press(b, what)
    type(rc_body), intent(in) :: b
    character(len=*), intent(in) :: what
    real(rc_real), parameter :: bound = 4e-9_rc_real
    type(rc_contact) :: c
    real(rc_real) :: force(3), moment(3), error
    integer :: n, m, stat
    call c%create(context, b, plane)
    call c%frame_from_body(1, 6)
    call c%get_size(n, m)
    call demand(n == 9 .and. m == 4, 'size of the frame, '//what)
    call c%set_axes([0.5_rc_real, 0.5_rc_real, one], [one, zero, zero], [zero, zero, one])
    call c%set_gap_quadratic(zero, zero, zero)
    call c%set_friction('coulomb', [zero])
    call c%prescribe(ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.03_rc_real)
    call c%solve(stat)
    call expect(stat, ROLLCON_OK, 'pressing the block, '//what)
    call c%get_resultant(force, moment)
    error = maxval(abs(force - [zero, zero, -4.0_rc_real]))
    write (*, '(2a, es9.2, a, es9.2)') what, ': error of the force ', error, ', bound ', bound
    call demand(error <= bound, 'force on a block of two materials, '//what)
  end subroutine

  subroutine blocks()
    type(rc_body) :: b
    real(rc_real) :: value
    integer(rc_long) :: wide(9)
    integer :: i, n, m
    call make_block(b)
    call b%tag_faces([5, 6, 7, 8], [top, top, top, top], 6)
    call press(b, 'faces by element')
    call b%get_size(n, m)
    call demand(n == 27 .and. m == 8, 'size of the body')
    call b%get_stat('condensed_unknowns', value)
    call demand(value > 0, 'condensed unknowns')
    call make_block(b)
    wide = [(int(i, rc_long), i=19, 27)]
    call b%tag_faces_of_nodes(wide, 6)
    call press(b, 'faces by nodes')
    call make_block(b)
    call b%tag_faces(wide(:4) - 14, spread(int(top, rc_long), 1, 4), 6)
    call press(b, 'faces by element, long integers')
  end subroutine

  !> Without tags: elements and material have tag 0, surface elements 1.
  subroutine one_material()
    type(rc_body) :: b
    real(rc_real) :: force(3), moment(3)
    integer :: i
    call b%create(context, ROLLCON_BODY_FEM)
    call b%set_elastic(200.0_rc_real, 0.3_rc_real)
    call b%set_nodes(x)
    call b%add_elements(ROLLCON_HEX8, hexahedra)
    call b%add_elements(ROLLCON_QUAD4, reshape([19, 20, 23, 22], [4, 1]))
    call b%set_support([(i, i=1, 9)])
    call b%set_pressure(1, 5.0_rc_real)
    call b%prepare()
    call b%get_reaction(force, moment)
    call demand(maxval(abs(force - [zero, zero, 1.25_rc_real])) < 1e-12_rc_real, 'pressure on a quarter of the top')
  end subroutine

  subroutine statuses()
    type(rc_body) :: b, boundary
    integer :: stat, i
    integer(rc_long) :: far(1)
    integer :: bad(8, 1)
    integer(rc_int), parameter :: other(5) = [ROLLCON_TET10, ROLLCON_WEDGE6, ROLLCON_WEDGE15, ROLLCON_HEX20, 305_rc_int]
    character(len=400) :: message
    call b%create(context, ROLLCON_BODY_FEM)
    call b%add_elements(ROLLCON_HEX8, hexahedra, stat=stat)
    call expect(stat, ROLLCON_ERR_STATE, 'elements before nodes')
    call b%set_nodes(x)
    call b%tag_faces([1], [top], 6, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'faces before elements')
    call b%tag_faces_of_nodes([1], 6, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'faces of nodes before elements')
    bad = hexahedra(:, 8:8)
    bad(7, 1) = 28
    call b%add_elements(ROLLCON_HEX8, bad, stat=stat, errmsg=message)
    call expect(stat, ROLLCON_ERR_MESH, 'id beyond the last node')
    call demand(index(message, 'node 7 of element 1') > 0, 'message counts from 1: '//trim(message))
    call b%add_elements(ROLLCON_TET4, hexahedra, stat=stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'eight nodes per tetrahedron')
    do i = 1, 5
      call b%add_elements(other(i), hexahedra, stat=stat)
      call expect(stat, ROLLCON_ERR_ARGUMENT, 'eight nodes of other elements')
    end do
    call b%add_elements(ROLLCON_HEX8, hexahedra, 3)
    call b%tag_faces([1, 2], [top], 6, stat, message)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'two elements and one face')
    call demand(index(message, 'tag_faces') > 0, 'message names the call: '//trim(message))
    call b%tag_faces([9], [top], 6, stat)
    call expect(stat, ROLLCON_ERR_MESH, 'element beyond the last')
    call b%tag_faces([8], [7], 6, stat, message)
    call expect(stat, ROLLCON_ERR_MESH, 'seventh face of a hexahedron')
    call demand(index(message, '1 to 6') > 0, 'message names the range: '//trim(message))
    far = 4294967304_rc_long
    call b%tag_faces(far, [int(top, rc_long)], 6, stat)
    call expect(stat, ROLLCON_ERR_MESH, 'element beyond 32 bits')
    call b%tag_faces_of_nodes(far, 6, stat)
    call expect(stat, ROLLCON_ERR_MESH, 'node beyond 32 bits')
    call b%tag_faces_of_nodes([1, 28], 6, stat)
    call expect(stat, ROLLCON_ERR_MESH, 'node beyond the last')
    call b%tag_faces([integer ::], [integer ::], 6, stat)
    call expect(stat, ROLLCON_OK, 'no faces')
    call b%set_support([(i, i=1, 9)])
    call b%set_elastic(200.0_rc_real, 0.5_rc_real)
    call b%prepare(stat, message)
    call expect(stat, ROLLCON_ERR_STATE, 'material of another tag')
    call demand(index(message, 'element 1 (counting from 1) has tag 3') > 0, 'message names element and tag: '//trim(message))
    call b%set_elastic(200.0_rc_real, 0.5_rc_real, 3)
    call b%prepare(stat)
    call expect(stat, ROLLCON_ERR_UNSUPPORTED, 'incompressible finite elements')
    call b%set_elastic(200.0_rc_real, 0.3_rc_real, 3)
    call b%tag_faces([1], [top], 6)
    call b%prepare(stat, message)
    call expect(stat, ROLLCON_ERR_MESH, 'a face inside the body')
    call demand(index(message, 'face 2 of element 1') > 0, 'message names the face: '//trim(message))
    call b%set_nodes(x)
    call b%add_elements(ROLLCON_HEX8, hexahedra, 3)
    call b%set_support([(i, i=1, 9)])
    call b%prepare(stat)
    call expect(stat, ROLLCON_OK, 'the mended body')
    call b%tag_faces([8], [top], 6, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'faces of a prepared body')

    if (.not. rc_has_feature('bem')) return
    call boundary%create(context, ROLLCON_BODY_BEM)
    call boundary%tag_faces([1], [top], 6, stat)
    call expect(stat, ROLLCON_ERR_STATE, 'faces of elements of a boundary-element body')
    call boundary%set_nodes(x)
    call boundary%add_elements(ROLLCON_HEX8, hexahedra, 1, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'hexahedra in a boundary-element body')
    call boundary%add_elements(ROLLCON_QUAD4, reshape([1, 4, 5, 2], [4, 1]))
    call boundary%tag_faces_of_nodes([1, 2, 4, 5], 9)
    call boundary%set_pressure(1, one, stat)
    call expect(stat, ROLLCON_ERR_ARGUMENT, 'no face has the old tag')
    call boundary%set_pressure(9, one, stat)
    call expect(stat, ROLLCON_OK, 'the face has the new tag')
  end subroutine

  subroutine run()
    if (.not. rc_has_feature('fem')) then
      write (*, '(a)') 'this build has no finite elements'
      return
    end if
    call make_box()
    call context%create()
    call context%set_threads(1)
    call plane%create(context, ROLLCON_BODY_RIGID)
    call statuses()
    call one_material()
    call blocks()
    write (*, '(i0, a, i0, a)') checks, ' checks, ', failures, ' failures'
    if (failures > 0) error stop 1
  end subroutine

end module finite_element_cases

program finite_elements_test
  use finite_element_cases, only: run
  implicit none
  call run()
end program finite_elements_test
