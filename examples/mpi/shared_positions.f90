! A vehicle code that runs on several ranks wants the forces of a wheel over its lateral shift. Every rank makes the
! same calls with the same data, solves its share of the positions, and gets all forces.
!
!     mpiexec -n 4 shared_positions
!
! The library must be built with ROLLCON_WITH_MPI=ON.
program shared_positions
  use mpi
  use rollcon
  implicit none
  integer, parameter :: wp = rc_real, n = 25
  type(rc_context) :: context
  type(rc_body) :: body(2)
  type(rc_wheelrail) :: wheel
  character(len=5) :: profile(2) = ['s1002', '60e1 ']
  real(wp) :: position(6, n) = 0, velocity(6, n) = 0
  real(wp), allocatable :: force(:, :)
  integer :: i, rank, ierr

  call MPI_Init(ierr)
  call MPI_Comm_rank(MPI_COMM_WORLD, rank, ierr)
  call context%create()
  call context%set_threads(1)
  call context%set_communicator(MPI_COMM_WORLD)
  do i = 1, 2
    call body(i)%create(context, ROLLCON_BODY_HALFSPACE)
    call body(i)%set_elastic(210e3_wp, 0.28_wp)
    call body(i)%set_profile_shape(trim(profile(i)), [1.0_wp])  ! a millimetre
  end do
  call wheel%create(context, body(1), body(2), ROLLCON_RIGHT)
  call wheel%set_track(1435.0_wp, 14.0_wp, atan(1/40.0_wp))
  call wheel%set_wheelset(1360.0_wp, -70.0_wp, 460.0_wp)
  call wheel%set_friction('coulomb', [0.3_wp])
  call wheel%prescribe_vertical(ROLLCON_BY_FORCE, 80e3_wp)
  position(2, :) = [(0.25_wp*(i - 1), i = 1, n)]
  velocity(1, :) = 20e3_wp
  velocity(6, :) = -20e3_wp/460
  call wheel%solve_many(position, velocity, 'force_x force_y force_z', force)
  if (rank == 0) then
    print '(a)', '   y   Fx, kN   Fy, kN   Fz, kN'
    print '(i4, 3f9.2)', (nint(position(2, i)), force(:, i)/1000, i = 1, n, 8)
  end if
  call MPI_Finalize(ierr)
end program
