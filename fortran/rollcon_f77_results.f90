! FORTRAN 77 layer of rollcon, third part: solver settings, the solve and its results. See rollcon_f77.f90.

!> Solver settings by name: integer, real, text.
subroutine rcseti(icon, name, i, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, i, ierr
  character(len=*) :: name
  ierr = rollcon_contact_set_int(contact_of(icon), c_text(name), int(i, c_int64_t))
end subroutine

subroutine rcsetr(icon, name, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name
  double precision :: v
  ierr = rollcon_contact_set_real(contact_of(icon), c_text(name), v)
end subroutine

subroutine rcsets(icon, name, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name, text
  ierr = rollcon_contact_set_str(contact_of(icon), c_text(name), c_text(text))
end subroutine

subroutine rcgeti(icon, name, i, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, i, ierr
  character(len=*) :: name
  integer(c_int64_t) :: j
  j = 0
  ierr = rollcon_contact_get_int(contact_of(icon), c_text(name), j)
  i = int(j)
end subroutine

subroutine rcgetr(icon, name, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name
  double precision :: v
  ierr = rollcon_contact_get_real(contact_of(icon), c_text(name), v)
end subroutine

subroutine rcgets(icon, name, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name, text
  character(kind=c_char), allocatable :: b(:)
  integer(c_int64_t) :: need
  allocate (b(usual_text))
  b(1) = c_null_char
  need = 0
  ierr = rollcon_contact_get_str(contact_of(icon), c_text(name), usual_text, b, need)
  if (ierr == ROLLCON_ERR_CAPACITY) then
    deallocate (b)
    allocate (b(need))
    ierr = rollcon_contact_get_str(contact_of(icon), c_text(name), size(b, kind=c_int64_t), b, need)
  end if
  call give_text(b, text, ierr)
end subroutine

!> Number of solver settings.
subroutine rcnopt(n)
  use rollcon_f77_support
  implicit none
  integer :: n
  n = rollcon_option_count()
end subroutine

!> Setting I, from 1: name, type (1 integer, 2 real, 3 text), range and standard value.
subroutine rcopti(i, name, itype, xlow, xhigh, xstd, ierr)
  use rollcon_f77_support
  implicit none
  integer :: i, itype, ierr
  character(len=*) :: name
  double precision :: xlow, xhigh, xstd
  character(kind=c_char) :: b(usual_text)
  integer(c_int32_t) :: t
  b(1) = c_null_char
  t = 0
  ierr = rollcon_option_info(narrow(i - 1), usual_text, b, t, xlow, xhigh, xstd)
  itype = t
  call give_text(b, name, ierr)
end subroutine

!> What setting I means.
subroutine rcoptd(i, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: i, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: b(:)
  integer(c_int64_t) :: need
  allocate (b(usual_text))
  b(1) = c_null_char
  need = 0
  ierr = rollcon_option_doc(narrow(i - 1), usual_text, b, need)
  if (ierr == ROLLCON_ERR_CAPACITY) then
    deallocate (b)
    allocate (b(need))
    ierr = rollcon_option_doc(narrow(i - 1), size(b, kind=c_int64_t), b, need)
  end if
  call give_text(b, text, ierr)
end subroutine

!> WATCH(IPHASE, ITER, RESID, SECS, ICANCL) is called in every iteration; ICANCL = 1 cancels the solve.
subroutine rcprog(icon, watch, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  procedure(progress_77) :: watch
  type(box), pointer :: b
  b => box_of(icon)
  b%progress => watch
  ierr = rollcon_contact_set_progress(contact_of(icon), c_funloc(call_progress), c_loc(b))
end subroutine

!> No more calls of a WATCH routine.
subroutine rcnopr(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_set_progress(contact_of(icon), c_null_funptr, c_null_ptr)
end subroutine

!> Makes the running solve return 3 (cancelled).
subroutine rcstop(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_request_cancel(contact_of(icon))
end subroutine

!> Solves.
subroutine rcsolv(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_solve(contact_of(icon))
end subroutine

!> Solves NC load cases: V(NP,NC) replaces what is prescribed in the directions IPAR(NP), 5 being a factor on friction. ISTAT(NC),
!> F(3,NC), XM(3,NC), APPR(NC), CREEP(3,NC).
subroutine rcmany(icon, np, ipar, nc, v, istat, f, xm, appr, creep, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, np, nc, ierr
  integer :: ipar(*), istat(*)
  double precision :: v(*), f(*), xm(*), appr(*), creep(*)
  call solve_many_77(contact_of(icon), np, ipar, nc, v, istat, f, xm, appr, creep, c_null_ptr, ierr)
end subroutine

!> As RCMANY; D(10,NP,NC) gets the derivatives of F, XM, APPR and CREEP by each parameter's value.
subroutine rcmand(icon, np, ipar, nc, v, istat, f, xm, appr, creep, d, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, np, nc, ierr
  integer :: ipar(*), istat(*)
  double precision :: v(*), f(*), xm(*), appr(*), creep(*)
  double precision, target :: d(*)
  call solve_many_77(contact_of(icon), np, ipar, nc, v, istat, f, xm, appr, creep, c_loc(d), ierr)
end subroutine

!> Forgets the last solution.
subroutine rcrset(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_reset(contact_of(icon))
end subroutine

!> Nodes and elements of the frame.
subroutine rcsize(icon, nn, ne, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, nn, ne, ierr
  integer(c_int64_t) :: n, m
  n = 0
  m = 0
  ierr = rollcon_contact_get_size(contact_of(icon), n, m)
  nn = int(n)
  ne = int(m)
end subroutine

!> Tractions on body 1, T(3,MAXN); IAXES 0 local, 1 global.
subroutine rctrac(icon, iaxes, maxn, t, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iaxes, maxn, ierr
  double precision :: t(*)
  ierr = rollcon_contact_get_tractions(contact_of(icon), narrow(iaxes), int(maxn, c_int64_t), t)
end subroutine

!> Field IFIELD: NV values, node after node; NV is set if MAXV is too small, too.
subroutine rcfeld(icon, ifield, iaxes, maxv, v, nv, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ifield, iaxes, maxv, nv, ierr
  double precision :: v(*)
  integer(c_int64_t) :: n
  n = 0
  ierr = rollcon_contact_get_field(contact_of(icon), narrow(ifield), narrow(iaxes), int(maxv, c_int64_t), v, n)
  nv = int(n)
end subroutine

!> State of each node: 0 open, 1 stick, 2 slip, 3 in no element.
subroutine rcnsta(icon, maxn, istat, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, maxn, ierr
  integer :: istat(*)
  integer(c_int32_t), allocatable :: s(:)
  integer(c_int64_t) :: n, m
  n = 0
  m = 0
  ierr = rollcon_contact_get_size(contact_of(icon), n, m)
  if (ierr /= ROLLCON_OK) return
  allocate (s(n))
  ierr = rollcon_contact_get_status(contact_of(icon), min(n, int(maxn, c_int64_t)), s)
  if (ierr == ROLLCON_OK) istat(1:n) = s
end subroutine

!> Force F(3) and moment XM(3) on body 1.
subroutine rcresu(icon, iaxes, f, xm, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iaxes, ierr
  double precision :: f(3), xm(3)
  ierr = rollcon_contact_get_resultant(contact_of(icon), narrow(iaxes), f, xm)
end subroutine

!> Approach, and creepages and spin in CREEP(3).
subroutine rcmotn(icon, appr, creep, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: appr, creep(3)
  ierr = rollcon_contact_get_motion(contact_of(icon), appr, creep)
end subroutine

!> Derivatives of local force F and moment XM, approach and creepages by the value prescribed in a direction (IPAR 1 to 4)
!> or by a factor on every friction coefficient (5).
subroutine rcsens(icon, ipar, f, xm, appr, creep, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ipar, ierr
  double precision :: f(3), xm(3), appr, creep(3)
  ierr = rollcon_contact_get_sensitivity(contact_of(icon), narrow(ipar), f, xm, appr, creep)
end subroutine

!> Displacements U(3,N) of body 1 or 2 (not a handle) at points XY(2,N).
subroutine rcdisp(icon, ibody, n, xy, u, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ibody, n, ierr
  double precision :: xy(*), u(*)
  ierr = rollcon_contact_get_displacements_at(contact_of(icon), narrow(ibody), int(n, c_int64_t), xy, u)
end subroutine

!> A number about the last solve, by name.
subroutine rcstat(icon, name, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name
  double precision :: v
  ierr = rollcon_contact_get_stat(contact_of(icon), c_text(name), v)
end subroutine

!> Number of those names.
subroutine rcnstt(n)
  use rollcon_f77_support
  implicit none
  integer :: n
  n = rollcon_stat_count()
end subroutine

!> Name I, from 1.
subroutine rcstnm(i, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: i, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: b(:)
  integer(c_int64_t) :: need
  allocate (b(usual_text))
  b(1) = c_null_char
  need = 0
  ierr = rollcon_stat_name(narrow(i - 1), usual_text, b, need)
  if (ierr == ROLLCON_ERR_CAPACITY) then
    deallocate (b)
    allocate (b(need))
    ierr = rollcon_stat_name(narrow(i - 1), size(b, kind=c_int64_t), b, need)
  end if
  call give_text(b, text, ierr)
end subroutine

!> Iterations of the last solve, ROWS(8,MAXR); NR is set if MAXR is too small, too.
subroutine rchist(icon, maxr, rows, nr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, maxr, nr, ierr
  double precision :: rows(*)
  integer(c_int64_t) :: n
  n = 0
  ierr = rollcon_contact_get_history(contact_of(icon), int(maxr, c_int64_t), rows, n)
  nr = int(n)
end subroutine

!> Error function of every row of RCHIST, PSI(MAXR), and the seconds since the solve began, SECS(MAXR); NR is set if MAXR is
!> too small, too.
subroutine rcerrf(icon, maxr, psi, secs, nr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, maxr, nr, ierr
  double precision :: psi(*), secs(*)
  integer(c_int64_t) :: n
  n = 0
  ierr = rollcon_contact_get_error_function(contact_of(icon), int(maxr, c_int64_t), psi, secs, n)
  nr = int(n)
end subroutine

!> How the last solve was done.
subroutine rcplan(icon, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: b(:)
  integer(c_int64_t) :: need
  allocate (b(usual_text))
  b(1) = c_null_char
  need = 0
  ierr = rollcon_contact_get_plan(contact_of(icon), usual_text, b, need)
  if (ierr == ROLLCON_ERR_CAPACITY) then
    deallocate (b)
    allocate (b(need))
    ierr = rollcon_contact_get_plan(contact_of(icon), size(b, kind=c_int64_t), b, need)
  end if
  call give_text(b, text, ierr)
end subroutine

!> Writes frame and results as a VTU file.
subroutine rcwrit(icon, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: path
  ierr = rollcon_contact_write(contact_of(icon), c_text(path))
end subroutine
