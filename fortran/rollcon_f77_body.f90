! FORTRAN 77 layer of rollcon, second part: bodies. See rollcon_f77.f90.

!> New body of a kind: 1 finite elements, 2 boundary elements, 3 half-space, 4 rigid.
subroutine rcbody(ictx, kind, ibody, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, kind, ibody, ierr
  type(c_ptr) :: p
  ibody = 0
  ierr = rollcon_body_create(context_of(ictx), narrow(kind), p)
  if (ierr == ROLLCON_OK) ibody = rollcon_id_of(p)
end subroutine

!> Young's modulus and Poisson's ratio; ITAG: of the finite elements that get them.
subroutine rcelas(ibody, itag, young, poiss, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: young, poiss
  ierr = rollcon_body_set_elastic(body_of(ibody), narrow(itag), young, poiss)
end subroutine

!> Checks and freezes a body.
subroutine rcprep(ibody, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  ierr = rollcon_body_prepare(body_of(ibody))
end subroutine

!> Writes a body, prepared if it was not, to the file PATH.
subroutine rcbsav(ibody, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: path
  ierr = rollcon_body_save(body_of(ibody), c_text(path))
end subroutine

!> Prepared body from a file that RCBSAV wrote.
subroutine rcblod(ictx, path, ibody, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ibody, ierr
  character(len=*) :: path
  type(c_ptr) :: p
  ibody = 0
  ierr = rollcon_body_load(context_of(ictx), c_text(path), p)
  if (ierr == ROLLCON_OK) ibody = rollcon_id_of(p)
end subroutine

!> Kind of a body.
subroutine rckind(ibody, kind, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, kind, ierr
  integer(c_int32_t) :: k
  k = 0
  ierr = rollcon_body_get_kind(body_of(ibody), k)
  kind = k
end subroutine

!> Nodes X(LDX,N) of a body, LDX >= 3: the first three rows are used.
subroutine rcbnod(ibody, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ldx, ierr
  double precision :: x(*)
  ierr = ROLLCON_ERR_ARGUMENT
  if (ldx < 3) return
  ierr = rollcon_body_set_nodes(body_of(ibody), int(n, c_int64_t), x, int(ldx, c_int64_t), 1_c_int64_t)
end subroutine

!> Nodes X(LDX,3) of a body, LDX >= N: the first N rows are used.
subroutine rcbndt(ibody, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ldx, ierr
  double precision :: x(*)
  ierr = ROLLCON_ERR_ARGUMENT
  if (ldx < n) return
  ierr = rollcon_body_set_nodes(body_of(ibody), int(n, c_int64_t), x, 1_c_int64_t, int(ldx, c_int64_t))
end subroutine

!> Elements of one type, IC(LDC,N), numbered from 1. Surface elements: normals outwards, ITAG names the faces. Volume elements,
!> of finite-element bodies: ITAG names their material.
subroutine rcbelm(ibody, itype, n, ic, ldc, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itype, n, ldc, itag, ierr
  integer :: ic(max(ldc, 1), *)
  integer(c_int32_t), allocatable :: packed(:, :)
  call pack_77(itype, n, ic, ldc, packed, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_add_elements(body_of(ibody), narrow(itype), int(n, c_int64_t), packed, 1_c_int32_t, narrow(itag))
end subroutine

!> Tags boundary faces of finite elements: face IFAC(I) of volume element IEL(I), both numbered from 1.
subroutine rcbtgf(ibody, n, iel, ifac, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, itag, ierr
  integer :: iel(*), ifac(*)
  integer(c_int32_t), allocatable :: elements(:), faces(:)
  call pack_list_77(n, iel, elements, ierr)
  if (ierr == ROLLCON_OK) call pack_list_77(n, ifac, faces, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_tag_faces(body_of(ibody), int(n, c_int64_t), elements, faces, 1_c_int32_t, narrow(itag))
end subroutine

!> Tags the faces all of whose nodes are among ND(N), numbered from 1.
subroutine rcbtgn(ibody, n, nd, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, itag, ierr
  integer :: nd(*)
  integer(c_int32_t), allocatable :: packed(:)
  call pack_list_77(n, nd, packed, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_tag_faces_of_nodes(body_of(ibody), int(n, c_int64_t), packed, 1_c_int32_t, narrow(itag))
end subroutine

!> Holds the nodes ND(N), numbered from 1, at zero; MASK: sum of 1 (x), 2 (y), 4 (z).
subroutine rchold(ibody, n, nd, mask, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, mask, ierr
  integer :: nd(*)
  double precision, allocatable :: v(:, :)
  integer :: no_room
  ierr = ROLLCON_ERR_ARGUMENT
  if (n < 0) return
  allocate (v(3, n), stat=no_room)
  ierr = ROLLCON_ERR_MEMORY
  if (no_room /= 0) return
  v = 0
  call rcsupp(ibody, n, nd, mask, v, ierr)
end subroutine

!> Holds the nodes ND(N) at the displacements V(3,N).
subroutine rcsupp(ibody, n, nd, mask, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, mask, ierr
  integer :: nd(*)
  double precision :: v(3, *)
  integer(c_int32_t), allocatable :: packed(:)
  call pack_list_77(n, nd, packed, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_set_support(body_of(ibody), int(n, c_int64_t), packed, 1_c_int32_t, narrow(mask), v)
end subroutine

!> Traction T(3) along x y z on the faces with a tag.
subroutine rcbtrc(ibody, itag, t, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: t(3)
  ierr = rollcon_body_set_traction(body_of(ibody), narrow(itag), t)
end subroutine

!> Pressure on the faces with a tag.
subroutine rcbprs(ibody, itag, p, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: p
  ierr = rollcon_body_set_pressure(body_of(ibody), narrow(itag), p)
end subroutine

!> Tags ITAGS(N) of the faces that may come into contact; N = 0: all that are neither held nor loaded.
subroutine rcbfac(ibody, n, itags, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ierr
  integer :: itags(*)
  integer(c_int32_t), allocatable :: packed(:)
  call pack_list_77(n, itags, packed, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_set_contact_faces(body_of(ibody), int(n, c_int64_t), packed)
end subroutine

!> Settings of a body by name: integer, real.
subroutine rcbsti(ibody, name, i, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, i, ierr
  character(len=*) :: name
  ierr = rollcon_body_set_int(body_of(ibody), c_text(name), int(i, c_int64_t))
end subroutine

subroutine rcbstr(ibody, name, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: name
  double precision :: v
  ierr = rollcon_body_set_real(body_of(ibody), c_text(name), v)
end subroutine

subroutine rcbgti(ibody, name, i, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, i, ierr
  character(len=*) :: name
  integer(c_int64_t) :: j
  j = 0
  ierr = rollcon_body_get_int(body_of(ibody), c_text(name), j)
  i = int(j)
end subroutine

subroutine rcbgtr(ibody, name, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: name
  double precision :: v
  ierr = rollcon_body_get_real(body_of(ibody), c_text(name), v)
end subroutine

!> Number of those settings.
subroutine rcbnop(n)
  use rollcon_f77_support
  implicit none
  integer :: n
  n = rollcon_body_option_count()
end subroutine

!> Setting I, from 1: name, type (1 integer, 2 real), range and standard value.
subroutine rcbopi(i, name, itype, xlow, xhigh, xstd, ierr)
  use rollcon_f77_support
  implicit none
  integer :: i, itype, ierr
  character(len=*) :: name
  double precision :: xlow, xhigh, xstd
  character(kind=c_char) :: b(usual_text)
  integer(c_int32_t) :: t
  b(1) = c_null_char
  t = 0
  ierr = rollcon_body_option_info(narrow(i - 1), usual_text, b, t, xlow, xhigh, xstd)
  itype = t
  call give_text(b, name, ierr)
end subroutine

!> What setting I means.
subroutine rcbopd(i, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: i, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: b(:)
  integer(c_int64_t) :: need
  allocate (b(usual_text))
  b(1) = c_null_char
  need = 0
  ierr = rollcon_body_option_doc(narrow(i - 1), usual_text, b, need)
  if (ierr == ROLLCON_ERR_CAPACITY) then
    deallocate (b)
    allocate (b(need))
    ierr = rollcon_body_option_doc(narrow(i - 1), size(b, kind=c_int64_t), b, need)
  end if
  call give_text(b, text, ierr)
end subroutine

!> Nodes and elements of the mesh.
subroutine rcbsiz(ibody, nn, ne, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, nn, ne, ierr
  integer(c_int64_t) :: n, m
  n = 0
  m = 0
  ierr = rollcon_body_get_size(body_of(ibody), n, m)
  nn = int(n)
  ne = int(m)
end subroutine

!> Displacements U(3,MAXN) of a prepared body under its own loads and given displacements.
subroutine rcbdis(ibody, maxn, u, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, maxn, ierr
  double precision :: u(*)
  ierr = rollcon_body_get_displacements(body_of(ibody), int(maxn, c_int64_t), u)
end subroutine

!> Force F(3) of the supports on it and moment XM(3) about the origin.
subroutine rcbrea(ibody, f, xm, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: f(3), xm(3)
  ierr = rollcon_body_get_reaction(body_of(ibody), f, xm)
end subroutine

!> A number about a prepared body, by name.
subroutine rcbsta(ibody, name, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: name
  double precision :: v
  ierr = rollcon_body_get_stat(body_of(ibody), c_text(name), v)
end subroutine

!> Number of those names.
subroutine rcbnst(n)
  use rollcon_f77_support
  implicit none
  integer :: n
  n = rollcon_body_stat_count()
end subroutine

!> Name I, from 1.
subroutine rcbstn(i, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: i, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: b(:)
  integer(c_int64_t) :: need
  allocate (b(usual_text))
  b(1) = c_null_char
  need = 0
  ierr = rollcon_body_stat_name(narrow(i - 1), usual_text, b, need)
  if (ierr == ROLLCON_ERR_CAPACITY) then
    deallocate (b)
    allocate (b(need))
    ierr = rollcon_body_stat_name(narrow(i - 1), size(b, kind=c_int64_t), b, need)
  end if
  call give_text(b, text, ierr)
end subroutine
