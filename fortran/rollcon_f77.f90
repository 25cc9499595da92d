! FORTRAN 77 layer of rollcon, first part: contexts and what a caller gives for a contact.
!
! Plain external subroutines: name mangling, integer width and hidden CHARACTER lengths are those of the compiler and the
! options that build this file, which must be the caller's. Handles are INTEGERs > 0, the last argument is always IERR, the
! status. README.md lists the names beside those of rollcon.h.

!> New context.
subroutine rcinit(ictx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ierr
  type(c_ptr) :: p
  ictx = 0
  ierr = rollcon_context_create(ROLLCON_HEADER_ABI, p)
  if (ierr == ROLLCON_OK) ictx = rollcon_id_of(p)
end subroutine

!> Drops a reference to a context, body or contact and sets the handle to 0; 0 is allowed.
subroutine rcfree(ih, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ih, ierr
  ierr = ROLLCON_OK
  if (ih == 0) return
  ! retaining first tells a live handle from a dead one, which release would ignore
  ierr = rollcon_contact_retain(contact_of(ih))
  if (ierr == ROLLCON_OK) then
    call rollcon_contact_release(contact_of(ih))
    call rollcon_contact_release(contact_of(ih))
    ih = 0
    return
  end if
  ierr = rollcon_body_retain(body_of(ih))
  if (ierr == ROLLCON_OK) then
    call rollcon_body_release(body_of(ih))
    call rollcon_body_release(body_of(ih))
    ih = 0
    return
  end if
  ierr = rollcon_context_retain(context_of(ih))
  if (ierr == ROLLCON_OK) then
    call rollcon_context_release(context_of(ih))
    call rollcon_context_release(context_of(ih))
    ih = 0
  end if
end subroutine

!> Adds a reference to a context, body or contact.
subroutine rckeep(ih, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ih, ierr
  ierr = rollcon_contact_retain(contact_of(ih))
  if (ierr == ROLLCON_ERR_HANDLE) ierr = rollcon_body_retain(body_of(ih))
  if (ierr == ROLLCON_ERR_HANDLE) ierr = rollcon_context_retain(context_of(ih))
end subroutine

!> Threads per solve; 0 leaves the number to OpenMP.
subroutine rcthrd(ictx, n, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, n, ierr
  ierr = rollcon_context_set_threads(context_of(ictx), narrow(n))
end subroutine

!> Messages up to LEVEL go to the subroutine SINK(LEVEL, TEXT); LEVEL 0 turns the log off.
subroutine rclog(ictx, level, sink, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, level, ierr
  procedure(log_77) :: sink
  type(box), pointer :: b
  b => box_of(ictx)
  b%log => sink
  ierr = rollcon_context_set_log(context_of(ictx), narrow(level), c_funloc(call_log), c_loc(b))
end subroutine

!> Message of the last failure in a context.
subroutine rcemsg(ictx, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: b(:)
  integer(c_int64_t) :: need
  allocate (b(usual_text))
  b(1) = c_null_char
  need = 0
  ierr = rollcon_context_get_error(context_of(ictx), usual_text, b, need)
  if (ierr == ROLLCON_ERR_CAPACITY) then
    deallocate (b)
    allocate (b(need))
    ierr = rollcon_context_get_error(context_of(ictx), size(b, kind=c_int64_t), b, need)
  end if
  call give_text(b, text, ierr)
end subroutine

!> One line of text for a status.
subroutine rcstex(istat, text)
  use rollcon_f77_support
  implicit none
  integer :: istat
  character(len=*) :: text
  text = f_text_at(rollcon_status_string(narrow(istat)))
end subroutine

!> Version as a number, the binary interface, and the version as text.
subroutine rcvers(iver, iabi, text)
  use rollcon_f77_support
  implicit none
  integer :: iver, iabi
  character(len=*) :: text
  iver = rollcon_version()
  iabi = rollcon_abi()
  text = f_text_at(rollcon_version_string())
end subroutine

!> Licences and options of the library that runs.
subroutine rcinfo(text)
  use rollcon_f77_support
  implicit none
  character(len=*) :: text
  text = f_text_at(rollcon_build_info())
end subroutine

!> IHAS = 1 if the library has the feature, else 0.
subroutine rchas(name, ihas)
  use rollcon_f77_support
  implicit none
  character(len=*) :: name
  integer :: ihas
  ihas = rollcon_has_feature(c_text(name))
end subroutine

!> New contact of two bodies.
subroutine rcpair(ictx, ibody1, ibody2, icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ibody1, ibody2, icon, ierr
  type(c_ptr) :: p
  icon = 0
  ierr = rollcon_contact_create(context_of(ictx), body_of(ibody1), body_of(ibody2), p)
  if (ierr == ROLLCON_OK) icon = rollcon_id_of(p)
end subroutine

!> Nodes X(LDX,N), LDX >= 3: the first three rows are used.
subroutine rcnode(icon, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ldx, ierr
  double precision :: x(*)
  ierr = ROLLCON_ERR_ARGUMENT
  if (ldx < 3) return
  ierr = rollcon_contact_set_frame_nodes(contact_of(icon), int(n, c_int64_t), x, int(ldx, c_int64_t), 1_c_int64_t)
end subroutine

!> Nodes X(LDX,3), LDX >= N: the first N rows are used.
subroutine rcnodt(icon, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ldx, ierr
  double precision :: x(*)
  ierr = ROLLCON_ERR_ARGUMENT
  if (ldx < n) return
  ierr = rollcon_contact_set_frame_nodes(contact_of(icon), int(n, c_int64_t), x, 1_c_int64_t, int(ldx, c_int64_t))
end subroutine

!> Elements of one type, IC(LDC,N), numbered from 1; the first rows of IC are used, as many as the element has nodes.
subroutine rcelem(icon, itype, n, ic, ldc, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, itype, n, ldc, itag, ierr
  integer :: ic(max(ldc, 1), *)
  integer(c_int32_t), allocatable :: packed(:, :)
  call pack_77(itype, n, ic, ldc, packed, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_contact_add_frame_elements(contact_of(icon), narrow(itype), int(n, c_int64_t), packed, 1_c_int32_t, narrow(itag))
end subroutine

!> The faces of body IWHICH (1 or 2, not a handle) that carry a tag become the frame.
subroutine rcfram(icon, iwhich, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, itag, ierr
  ierr = rollcon_contact_frame_from_body(contact_of(icon), narrow(iwhich), narrow(itag))
end subroutine

!> Where body IWHICH (1 or 2) stands: X(I) = sum over J of ROT(I,J)*XB(J) + TRANS(I).
subroutine rcpose(icon, iwhich, rot, trans, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, ierr
  double precision :: rot(3, 3), trans(3)
  ierr = rollcon_contact_set_pose(contact_of(icon), narrow(iwhich), transpose(rot), trans)
end subroutine

!> Origin, rolling direction and outward normal of body 1.
subroutine rcaxes(icon, orig, roll, xnorm, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: orig(3), roll(3), xnorm(3)
  ierr = rollcon_contact_set_axes(contact_of(icon), orig, roll, xnorm)
end subroutine

!> Gap at each node.
subroutine rcgap(icon, n, gap, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: gap(*)
  ierr = rollcon_contact_set_gap(contact_of(icon), int(n, c_int64_t), gap)
end subroutine

!> Gap A*X**2 + B*Y**2 + C*X*Y.
subroutine rcgapq(icon, a, b, c, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: a, b, c
  ierr = rollcon_contact_set_gap_quadratic(contact_of(icon), a, b, c)
end subroutine

!> Rolling speed.
subroutine rcroll(icon, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: v
  ierr = rollcon_contact_set_rolling(contact_of(icon), v)
end subroutine

!> Longitudinal and lateral creepage and spin, by motion.
subroutine rccrp(icon, cksi, ceta, cphi, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: cksi, ceta, cphi
  ierr = rollcon_contact_set_creep(contact_of(icon), cksi, ceta, cphi)
end subroutine

!> Rigid slip velocity SLIP(2,N) at each node; N = 0 removes it.
subroutine rccrpf(icon, n, slip, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: slip(*)
  ierr = rollcon_contact_set_creep_field(contact_of(icon), int(n, c_int64_t), slip)
end subroutine

!> One direction (1 longitudinal, 2 lateral, 3 normal, 4 spin), by motion (1) or by force (2).
subroutine rcpres(icon, idir, ihow, v, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, idir, ihow, ierr
  double precision :: v
  ierr = rollcon_contact_prescribe(contact_of(icon), narrow(idir), narrow(ihow), v)
end subroutine

!> Friction law and its parameters: 'coulomb', 1, MU.
subroutine rcfric(icon, law, n, par, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  character(len=*) :: law
  double precision :: par(*)
  ierr = rollcon_contact_set_friction(contact_of(icon), c_text(law), narrow(n), par)
end subroutine

!> Coefficient of friction at each node; N = 0 removes it.
subroutine rcfrif(icon, n, xmu, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: xmu(*)
  ierr = rollcon_contact_set_friction_field(contact_of(icon), int(n, c_int64_t), xmu)
end subroutine
