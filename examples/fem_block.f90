!> A first body of finite elements in Fortran 2008: a rigid ball rolls over a soft layer on a stiffer base and transmits
!> 60 % of the force at which it would slide. The frame of the contact is a mesh of its own that does not match the
!> block's. Units: mm, N, MPa. fem_block.c and fem_block.py print the same.
program fem_block
  use rollcon
  implicit none
  integer, parameter :: nx = 17, ny = 17, nz = 9  ! nodes of the block along x, y, z, 1 mm apart; its top is z = 0
  integer, parameter :: along = 12                ! elements along each side of the frame, a square on the top
  integer, parameter :: base = 1, tread = 2       ! tags of elements: materials
  integer, parameter :: top = 1                   ! tag of faces
  real(rc_real), parameter :: radius = 200, load = 1500, mu = 0.3_rc_real, speed = 10, half = 5
  type(rc_context) :: context
  type(rc_body) :: block, ball
  type(rc_contact) :: contact
  real(rc_real) :: x(3, nx*ny*nz), force(3), moment(3), approach, creep(3), unknowns
  real(rc_real), allocatable :: t(:, :)
  integer(rc_int), allocatable :: state(:)
  integer :: element(8, (nx - 1)*(ny - 1)), i, j, k, n, nodes, elements, status

  ! Step 1 makes the block: nodes; six layers of elements are the base, two the tread.
  call context%create()
  call block%create(context, ROLLCON_BODY_FEM)
  do k = 1, nz
    do j = 1, ny
      do i = 1, nx
        x(:, node(i, j, k)) = [i - 9, j - 9, k - 9]
      end do
    end do
  end do
  call block%set_nodes(x)
  do k = 1, nz - 1
    do j = 1, ny - 1  ! bottom face counter-clockwise seen from above, then the top face
      do i = 1, nx - 1
        element(:, i + (j - 1)*(nx - 1)) = [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), &
          node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)]
      end do
    end do
    call block%add_elements(ROLLCON_HEX8, element, tag=merge(base, tread, k <= 6))
  end do

  ! Step 2 gives materials by tag, holds the bottom's nodes, and names the faces of contact by the top's nodes.
  call block%set_elastic(1e4_rc_real, 0.3_rc_real, tag=base)
  call block%set_elastic(2e3_rc_real, 0.45_rc_real, tag=tread)
  call block%set_support([(n, n=1, nx*ny)])
  call block%tag_faces_of_nodes([(n, n=1 + nx*ny*(nz - 1), nx*ny*nz)], top)
  call block%set_contact_faces([top])

  ! Step 3 makes the ball, which is rigid, its shape given as a gap, and the frame: 12 x 12 elements laid on the block,
  ! about as large as its faces.
  call ball%create(context, ROLLCON_BODY_RIGID)
  call contact%create(context, block, ball)
  call contact%frame_rectangle(ROLLCON_QUAD4, along, along, -half, half, -half, half)
  call contact%set_gap_quadratic(1/(2*radius), 1/(2*radius), 0.0_rc_real)

  ! Step 4 sets friction, speed and loads: the ball is pressed and driven by forces.
  call contact%set_friction('coulomb', [mu])
  call contact%set_rolling(speed)
  call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, load)
  call contact%prescribe(ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 0.6_rc_real*mu*load)

  ! Step 5 solves: assembles and factorises the block, condenses it to the frame, then iterates.
  call contact%solve(stat=status)
  if (status < 0) error stop 'no solution'

  ! Step 6 reads the results.
  call block%get_size(nodes, elements)
  call block%get_stat('unknowns', unknowns)
  call contact%get_resultant(force, moment)
  call contact%get_motion(approach, creep)
  call contact%get_tractions(t)
  call contact%get_node_states(state)
  call print_integers('status', [status])
  call print_integers('block', [nodes, elements])
  call print_numbers('unknowns', [unknowns])
  call print_numbers('force', force)
  call print_numbers('approach', [approach])
  call print_numbers('creepages', creep)
  call print_numbers('max pressure', [maxval(-t(3, :))])
  call print_integers('open stk slip', [count(state == ROLLCON_OPEN), count(state == ROLLCON_STICK), &
    count(state == ROLLCON_SLIP)])
  call print_numbers('centre', t(:, (size(t, 2) + 1)/2))
  deallocate (t, state)

contains

  integer function node(i, j, k)
    integer, intent(in) :: i, j, k
    node = i + nx*(j - 1 + ny*(k - 1))
  end function

  !> Prints six digits; what is zero up to rounding is printed as zero.
  subroutine print_numbers(name, v)
    character(len=*), intent(in) :: name
    real(rc_real), intent(in) :: v(:)
    character(len=13) :: field(3)
    integer :: m
    do m = 1, size(v)
      if (abs(v(m)) < 5e-7_rc_real) then
        field(m) = '     0.000000'
      else
        write (field(m), '(es13.5)') v(m)
      end if
    end do
    write (*, '(a14, 3a13)') [character(len=14) :: name], field(1:size(v))
  end subroutine

  subroutine print_integers(name, v)
    character(len=*), intent(in) :: name
    integer, intent(in) :: v(:)
    write (*, '(a14, 3i13)') [character(len=14) :: name], v
  end subroutine

end program fem_block
