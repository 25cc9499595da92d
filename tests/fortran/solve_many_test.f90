!> Lists of load cases from the type-bound procedure and from the FORTRAN 77 layer against single solves.
program solve_many_test
  use rollcon
  implicit none
  integer, parameter :: side = 9, nodes = side**2, elements = (side - 1)**2, n = 6
  real(rc_real), parameter :: half_width = 1.3_rc_real, load = 298.6_rc_real
  type(rc_context) :: context
  type(rc_body) :: sphere, plane
  type(rc_contact) :: contact
  real(rc_real) :: x(3, nodes), values(2, n), f(3), m(3), error
  real(rc_real), allocatable :: force(:, :), moment(:, :), approach(:), creep(:, :), slopes(:, :, :), numbers(:, :), t(:, :, :)
  real(rc_real), allocatable :: traction(:, :)
  integer(rc_int), allocatable :: status(:)
  double precision :: v77(2, n), r77(30, n)
  character(len=200) :: text
  integer :: status77(n), nr
  integer(rc_int) :: parameters(2)
  integer :: connectivity(4, elements), i, j, k, e, stat, ierr, failures = 0
  external :: rccase, rclerr

  e = 0
  do j = 0, side - 1
    do i = 0, side - 1
      k = j*side + i + 1
      x(:, k) = [half_width*(2*i - side + 1)/(side - 1), half_width*(2*j - side + 1)/(side - 1), 0.0_rc_real]
      if (i + 1 < side .and. j + 1 < side) then
        e = e + 1
        connectivity(:, e) = [k, k + 1, k + 1 + side, k + side]
      end if
    end do
  end do
  call context%create()
  call context%set_threads(2)
  call sphere%create(context, ROLLCON_BODY_HALFSPACE)
  call sphere%set_elastic(1e4_rc_real, 0.3_rc_real)
  call plane%create(context, ROLLCON_BODY_RIGID)
  call contact%create(context, sphere, plane)
  call contact%set_frame_nodes(x)
  call contact%add_frame_elements(ROLLCON_QUAD4, connectivity)
  call contact%set_gap_quadratic(0.01_rc_real, 0.01_rc_real, 0.0_rc_real)
  call contact%set_friction('coulomb', [0.1_rc_real])
  call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, load)

  parameters = [ROLLCON_NORMAL, ROLLCON_LATERAL]
  do i = 1, n
    values(:, i) = [load*(0.7_rc_real + 0.1_rc_real*i), 1e-3_rc_real*(i - 3)]
  end do
  call contact%solve_many(parameters, values, status=status, force=force, moment=moment, approach=approach, creep=creep, &
    derivatives=slopes, names='iterations max_pressure', statistics=numbers, tractions=t)
  if (any(status /= ROLLCON_OK)) call fail('not every case is solved')
  if (any(shape(slopes) /= [10, 2, n]) .or. any(shape(numbers) /= [2, n]) .or. any(shape(t) /= [3, nodes, n])) &
    call fail('wrong shapes')
  error = 0
  do i = 1, n
    call contact%prescribe(ROLLCON_NORMAL, ROLLCON_BY_FORCE, values(1, i))
    call contact%prescribe(ROLLCON_LATERAL, ROLLCON_BY_MOTION, values(2, i))
    call contact%solve()
    call contact%get_resultant(f, m)
    call contact%get_tractions(traction)
    error = max(error, maxval(abs(force(:, i) - f))/load, maxval(abs(moment(:, i) - m))/load, &
      maxval(abs(t(:, :, i) - traction))/numbers(2, i), abs(creep(2, i) - values(2, i)))
  end do
  write (*, '(a, es8.1, a)') 'off single solves by ', error, ' (bound 1e-8)'
  if (.not. error < 1e-8_rc_real) call fail('not what single solves give')
  error = maxval(abs(slopes(3, 1, :) + 1))
  if (.not. error < 1e-6_rc_real) call fail('the normal force follows its own load')

  ! Only forces, and nothing at all.
  deallocate (force)
  call contact%solve_many(parameters, values, force=force)
  call contact%solve_many(parameters, values(:, 1:0), status=status, force=force, statistics=numbers, names='iterations')
  if (size(status) /= 0 .or. size(force, 2) /= 0) call fail('an empty list has results')
  call contact%solve_many(parameters, values(1:1, :), stat=stat)
  if (stat /= ROLLCON_ERR_ARGUMENT) call fail('values of the wrong shape pass')
  call contact%solve_many(parameters, values, names='iterations', stat=stat)
  if (stat /= ROLLCON_ERR_ARGUMENT) call fail('names without statistics pass')
  call contact%solve_many(parameters, -values, force=force, stat=stat)
  if (stat /= ROLLCON_ERR_ARGUMENT) call fail('a pulling load passes')

  v77 = values
  call contact%solve_many(parameters, values, force=force, moment=moment, approach=approach, creep=creep, derivatives=slopes)
  call rccase(contact%id(), 'NORMAL Lateral', n, v77, 'FORCE MOMENT APPROACH CREEP DERIVATIVES', 30, r77, nr, status77, ierr)
  if (ierr /= 0 .or. nr /= 30 .or. any(status77 /= 0) .or. any(abs(r77(1:3, :) - force) > 0) .or. &
    any(abs(r77(4:6, :) - moment) > 0) .or. any(abs(r77(7, :) - approach) > 0) .or. any(abs(r77(8:10, :) - creep) > 0)) &
    call fail('RCCASE differs')
  if (any(abs(reshape(r77(11:30, :), [10, 2, n]) - slopes) > 0)) call fail('derivatives of RCCASE differ')
  call rccase(contact%id(), 'normal normal', n, v77, 'force', 30, r77, nr, status77, ierr)
  if (ierr /= ROLLCON_ERR_ARGUMENT) call fail('RCCASE takes a parameter twice')
  call rccase(contact%id(), 'normal lateral', n, v77, 'force moment', 5, r77, nr, status77, ierr)
  if (ierr /= ROLLCON_ERR_CAPACITY .or. nr /= 6) call fail('RCCASE tells no need')
  call rclerr(text)
  if (text(:8) /= 'RCCASE: ') call fail('the text is not that of RCCASE: '//text)
  call rccase(0, 'normal', n, v77, 'force', 30, r77, nr, status77, ierr)
  if (ierr /= ROLLCON_ERR_ARGUMENT) call fail('RCCASE takes no contact')
  if (failures > 0) stop 1
  ! A main program's own are not freed at its end.
  if (allocated(force)) deallocate (force)
  if (allocated(moment)) deallocate (moment)
  if (allocated(approach)) deallocate (approach)
  if (allocated(creep)) deallocate (creep)
  if (allocated(slopes)) deallocate (slopes)
  if (allocated(numbers)) deallocate (numbers)
  if (allocated(t)) deallocate (t)
  if (allocated(traction)) deallocate (traction)
  if (allocated(status)) deallocate (status)

contains

  subroutine fail(text)
    character(len=*), intent(in) :: text
    write (*, '(a)') text
    failures = failures + 1
  end subroutine

end program
