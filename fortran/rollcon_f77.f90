! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.
!
! FORTRAN 77 layer of rollcon 1.0.0-rc2: plain external subroutines. Name mangling, integer width and hidden CHARACTER
! lengths are those of the compiler and the options that build this file, which must be the caller's. Handles are
! INTEGERs > 0, the last argument is always IERR, the status. README.md lists the names beside those of rollcon.h.

!> Returns the version of the library.
subroutine rcvers(iversion, iabi, text)
  use rollcon_f77_support
  implicit none
  integer :: iversion, iabi
  character(len=*) :: text
  iversion = rollcon_version()
  iabi = rollcon_abi()
  text = f_text_at(rollcon_version_string())
end subroutine

!> Returns the licences that this build carries and how it was built, as one line of text.
subroutine rcinfo(text)
  use rollcon_f77_support
  implicit none
  character(len=*) :: text
  text = f_text_at(rollcon_build_info())
end subroutine

!> Returns 1 if this build has the feature, 0 if not or if the name is unknown or NULL.
subroutine rchas(name, ihas)
  use rollcon_f77_support
  implicit none
  integer :: ihas
  character(len=*) :: name
  ihas = rollcon_has_feature(c_name(name))
end subroutine

!> Returns one line of text for a status.
subroutine rcstex(istatus, text)
  use rollcon_f77_support
  implicit none
  integer :: istatus
  character(len=*) :: text
  text = f_text_at(rollcon_status_string(narrow(istatus)))
end subroutine

!> Returns the text of the last call that failed in this thread.
subroutine rclerr(text)
  use rollcon_f77_support
  implicit none
  character(len=*) :: text
  text = names_77(f_text_at(rollcon_last_error()))
end subroutine

!> Returns the text of the last call in this thread that returned a status above zero.
subroutine rclcav(text)
  use rollcon_f77_support
  implicit none
  character(len=*) :: text
  text = names_77(f_text_at(rollcon_last_caveat()))
end subroutine

!> Makes a context.
subroutine rcinit(ictx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ierr
  type(c_ptr) :: p
  ictx = 0
  ierr = rollcon_context_create(ROLLCON_HEADER_ABI, p)
  if (ierr == ROLLCON_OK) ictx = rollcon_id_of(p)
end subroutine

!> Drops a reference. The handle becomes 0.
subroutine rcfree(ih, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ih, ierr
  ierr = ROLLCON_OK
  if (ih == 0) return
  select case (kind_of(ih))
  case (of_context)
    call rollcon_context_release(context_of(ih))
    ih = 0
  case (of_body)
    call rollcon_body_release(body_of(ih))
    ih = 0
  case (of_contact)
    call rollcon_contact_release(contact_of(ih))
    ih = 0
  case (of_wheelrail)
    call rollcon_wheelrail_release(wheelrail_of(ih))
    ih = 0
  case (of_table)
    call rollcon_table_release(table_of(ih))
    ih = 0
  case default
    call no_handle('RCFREE', ih, ierr)
  end select
end subroutine

!> Sets the log sink.
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

!> Sets the most threads that each solve, each preparation of a body and each list of cases, positions or samples.
subroutine rcthrd(ictx, n, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, n, ierr
  ierr = rollcon_context_set_threads(context_of(ictx), narrow(n))
end subroutine

!> Lets the ranks of an MPI program share work.
subroutine rccomm(ictx, icommunicator, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, icommunicator, ierr
  ierr = rollcon_context_set_communicator(context_of(ictx), narrow(icommunicator))
end subroutine

!> Turns the latch on or off, for programs that check once, at the end.
subroutine rcltch(ictx, ion, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ion, ierr
  ierr = rollcon_context_set_latch(context_of(ictx), narrow(ion))
end subroutine

!> Returns the first failure since the latch was set, whose text becomes the last error.
subroutine rcchek(ictx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ierr
  ierr = rollcon_context_check(context_of(ictx))
end subroutine

!> Makes a body.
subroutine rcbody(ictx, kind, ibody, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, kind, ibody, ierr
  type(c_ptr) :: p
  ibody = 0
  ierr = rollcon_body_create(context_of(ictx), narrow(kind), p)
  if (ierr == ROLLCON_OK) ibody = rollcon_id_of(p)
end subroutine

!> Sets an isotropic linear elastic material.
subroutine rcelas(ibody, itag, young, poisson, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: young, poisson
  ierr = rollcon_body_set_elastic(body_of(ibody), narrow(itag), young, poisson)
end subroutine

!> Lets a material of a half-space or a section relax.
subroutine rcvisc(ibody, itag, n, ratios, times, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, n, ierr
  double precision :: ratios(*), times(*)
  ierr = rollcon_body_set_viscoelastic(body_of(ibody), narrow(itag), int(n, c_int64_t), ratios, times)
end subroutine

!> Lets a material relax as rollcon_body_set_viscoelastic does, by moduli over frequency instead of terms.
subroutine rcmodu(ibody, itag, n, frequencies, storage, xloss, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, n, ierr
  double precision :: frequencies(*), storage(*), xloss(*)
  ierr = rollcon_body_set_moduli(body_of(ibody), narrow(itag), int(n, c_int64_t), frequencies, storage, xloss)
end subroutine

!> Checks that the body is complete and its mesh and supports sound, assembles and factorises its equations, and .
subroutine rcprep(ibody, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  ierr = rollcon_body_prepare(body_of(ibody))
end subroutine

!> Returns the model given to rollcon_body_create.
subroutine rckind(ibody, kind, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, kind, ierr
  integer(c_int32_t) :: kind_c
  kind_c = 0
  ierr = rollcon_body_get_kind(body_of(ibody), kind_c)
  kind = int(kind_c)
end subroutine

!> Writes the body, prepared if it was not, to a file.
subroutine rcbsav(ibody, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: path
  ierr = rollcon_body_save(body_of(ibody), c_text(path))
end subroutine

!> Makes a prepared body from a file of rollcon_body_save.
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

!> Makes another body that was given the same and is not prepared, from one that is or is not.
subroutine rcbcpy(ibody, icopy, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, icopy, ierr
  type(c_ptr) :: p
  icopy = 0
  ierr = rollcon_body_copy(body_of(ibody), p)
  if (ierr == ROLLCON_OK) icopy = rollcon_id_of(p)
end subroutine

!> Sets the nodes and forgets elements, supports, loads and contact faces.
subroutine rcbnod(ibody, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ldx, ierr
  double precision :: x(*)
  if (ldx < 3) then
    call refuse(body_of(ibody), 'RCBNOD: LDX is', ldx, '; allowed: 3 or more', ierr)
    return
  end if
  ierr = rollcon_body_set_nodes(body_of(ibody), int(n, c_int64_t), x, int(ldx, c_int64_t), 1_c_int64_t)
end subroutine

!> Sets the nodes and forgets elements, supports, loads and contact faces.
subroutine rcbndt(ibody, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ldx, ierr
  double precision :: x(*)
  if (ldx < n) then
    call refuse(body_of(ibody), 'RCBNDT: LDX is', ldx, '; allowed: N or more', ierr)
    return
  end if
  ierr = rollcon_body_set_nodes(body_of(ibody), int(n, c_int64_t), x, 1_c_int64_t, int(ldx, c_int64_t))
end subroutine

!> Adds elements of one type.
subroutine rcbelm(ibody, itype, n, ic, ldc, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itype, n, ic(*), ldc, itag, ierr
  integer(c_int32_t), allocatable :: packed(:, :)
  call pack_77(body_of(ibody), 'RCBELM', itype, n, ic, ldc, packed, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_add_elements(body_of(ibody), narrow(itype), int(n, c_int64_t), packed, 1_c_int32_t, &
    narrow(itag))
end subroutine

!> Gives a tag to boundary faces of finite elements, by element and face.
subroutine rcbtgf(ibody, n, ielements, ifaces, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ielements(*), ifaces(*), itag, ierr
  integer(c_int32_t), allocatable :: packed_elements(:)
  integer(c_int32_t), allocatable :: packed_faces(:)
  call pack_list_77(body_of(ibody), 'RCBTGF', n, ielements, packed_elements, ierr)
  if (ierr /= ROLLCON_OK) return
  call pack_list_77(body_of(ibody), 'RCBTGF', n, ifaces, packed_faces, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_tag_faces(body_of(ibody), int(n, c_int64_t), packed_elements, packed_faces, 1_c_int32_t, &
    narrow(itag))
end subroutine

!> Gives a tag to the faces all of whose nodes are given, midside nodes too.
subroutine rcbtgn(ibody, n, nodes, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, nodes(*), itag, ierr
  integer(c_int32_t), allocatable :: packed_nodes(:)
  call pack_list_77(body_of(ibody), 'RCBTGN', n, nodes, packed_nodes, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_tag_faces_of_nodes(body_of(ibody), int(n, c_int64_t), packed_nodes, 1_c_int32_t, narrow(itag))
end subroutine

!> Holds displacement components of nodes, at zero or at given values.
subroutine rcsupp(ibody, n, nodes, idof_mask, values, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, nodes(*), idof_mask, ierr
  double precision :: values(*)
  integer(c_int32_t), allocatable :: packed_nodes(:)
  call pack_list_77(body_of(ibody), 'RCSUPP', n, nodes, packed_nodes, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_set_support(body_of(ibody), int(n, c_int64_t), packed_nodes, 1_c_int32_t, narrow(idof_mask), &
    values)
end subroutine

!> Holds displacement components of nodes, at zero or at given values.
subroutine rchold(ibody, n, nodes, idof_mask, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, nodes(*), idof_mask, ierr
  integer(c_int32_t), allocatable :: packed_nodes(:)
  double precision, allocatable :: values(:)
  integer :: no_room
  call pack_list_77(body_of(ibody), 'RCHOLD', n, nodes, packed_nodes, ierr)
  if (ierr /= ROLLCON_OK) return
  if (n < 0) then
    call refuse(body_of(ibody), 'RCHOLD: N is', n, '; allowed: 0 or more', ierr)
    return
  end if
  allocate (values(n*3), stat=no_room)
  if (no_room /= 0) then
    call no_memory(body_of(ibody), 'RCHOLD', ierr)
    return
  end if
  values = 0
  ierr = rollcon_body_set_support(body_of(ibody), int(n, c_int64_t), packed_nodes, 1_c_int32_t, narrow(idof_mask), &
    values)
end subroutine

!> Prescribes the traction on the faces with a tag.
subroutine rcbtrc(ibody, itag, traction, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: traction(3)
  ierr = rollcon_body_set_traction(body_of(ibody), narrow(itag), traction)
end subroutine

!> Prescribes a force per volume, such as weight, on the finite elements with a tag.
subroutine rcbfor(ibody, itag, force, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: force(3)
  ierr = rollcon_body_set_body_force(body_of(ibody), narrow(itag), force)
end subroutine

!> Prescribes the centrifugal forces of a steady rotation on the finite elements with a tag, added to rollcon_bod.
subroutine rcbrot(ibody, itag, density, origin, rate, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: density, origin(3), rate(3)
  ierr = rollcon_body_set_rotation(body_of(ibody), narrow(itag), density, origin, rate)
end subroutine

!> Prescribes a pressure on the faces with a tag, against their outward normals.
subroutine rcbprs(ibody, itag, pressure, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: pressure
  ierr = rollcon_body_set_pressure(body_of(ibody), narrow(itag), pressure)
end subroutine

!> Puts the faces with a tag on springs.
subroutine rcbspr(ibody, itag, stiffness, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  double precision :: stiffness(3)
  ierr = rollcon_body_set_springs(body_of(ibody), narrow(itag), stiffness)
end subroutine

!> Prescribes tractions at nodes of the faces with a tag, interpolated by the faces' shape functions, zero at nod.
subroutine rcbtrn(ibody, itag, n, nodes, along, tractions, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, n, nodes(*), ierr
  double precision :: along(3), tractions(*)
  integer(c_int32_t), allocatable :: packed_nodes(:)
  call pack_list_77(body_of(ibody), 'RCBTRN', n, nodes, packed_nodes, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_set_node_tractions(body_of(ibody), narrow(itag), int(n, c_int64_t), packed_nodes, &
    1_c_int32_t, along, tractions)
end subroutine

!> Says which faces may come into contact.
subroutine rcbfac(ibody, n, itags, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, itags(*), ierr
  integer(c_int32_t), allocatable :: packed_tags(:)
  call pack_list_77(body_of(ibody), 'RCBFAC', n, itags, packed_tags, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_body_set_contact_faces(body_of(ibody), int(n, c_int64_t), packed_tags)
end subroutine

!> Turns the plane mesh of a section into a body of revolution.
subroutine rcbrvl(ibody, origin, axis, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: origin(3), axis(3)
  ierr = rollcon_body_revolve(body_of(ibody), origin, axis)
end subroutine

!> Draws the plane mesh of a section along a line.
subroutine rcbxtr(ibody, origin, direction, period, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: origin(3), direction(3), period
  ierr = rollcon_body_extrude(body_of(ibody), origin, direction, period)
end subroutine

!> Gives a body of kind ROLLCON_BODY_CONDENSED its matrix.
subroutine rcbcnd(ibody, iform, n, xmatrix, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, iform, n, ierr
  double precision :: xmatrix(*)
  ierr = rollcon_body_set_condensed(body_of(ibody), narrow(iform), int(n, c_int64_t), xmatrix)
end subroutine

!> Reads what rollcon_body_set_condensed takes from a file.
subroutine rcbcrd(ibody, iform, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, iform, ierr
  character(len=*) :: path
  ierr = rollcon_body_read_condensed(body_of(ibody), narrow(iform), c_text(path))
end subroutine

!> Writes the stiffness or flexibility of a prepared body with a mesh on the nodes of its contact faces, in the o.
subroutine rcbcwr(ibody, iform, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, iform, ierr
  character(len=*) :: path
  ierr = rollcon_body_write_condensed(body_of(ibody), narrow(iform), c_text(path))
end subroutine

!> Takes nodes, elements and names from a file, in place of the whole former mesh.
subroutine rcbmsh(ibody, path, part, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: path, part
  ierr = rollcon_body_read_mesh(body_of(ibody), c_text(path), c_name(part))
end subroutine

!> Gives a tag to what the mesh's file has in a group.
subroutine rcbtgr(ibody, group, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, itag, ierr
  character(len=*) :: group
  ierr = rollcon_body_tag_group(body_of(ibody), c_name(group), narrow(itag))
end subroutine

!> Returns how many groups of the mesh's file name something of the body.
subroutine rcbngr(ibody, n, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ierr
  integer(c_int32_t) :: n_c
  n_c = 0
  ierr = rollcon_body_get_group_count(body_of(ibody), n_c)
  n = int(n_c)
end subroutine

!> Returns the name of a group in the file's spelling.
subroutine rcbgnm(ibody, i, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, i, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: buffer(:)
  integer(c_int64_t) :: capacity, needed
  allocate (buffer(1))
  capacity = 0
  needed = 1
  ierr = rollcon_body_get_group_name(body_of(ibody), narrow(i - 1), capacity, buffer, needed)
  deallocate (buffer)
  capacity = max(needed, 1_c_int64_t)
  allocate (buffer(capacity))
  buffer(1) = c_null_char
  if (ierr == ROLLCON_OK) then
    ierr = rollcon_body_get_group_name(body_of(ibody), narrow(i - 1), capacity, buffer, needed)
  end if
  call give_text(body_of(ibody), 'RCBGNM', buffer, text, ierr)
end subroutine

!> Returns the nodes of all that a group has, ascending, for rollcon_body_set_support and rollcon_body_tag_faces_.
subroutine rcbgnd(ibody, group, maxn, nodes, nn, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, maxn, nodes(*), nn, ierr
  character(len=*) :: group
  integer(c_int32_t), allocatable :: whole(:)
  integer(c_int64_t) :: room, elements
  integer(c_int64_t) :: n_nodes_c
  room = 0
  elements = 0
  ierr = rollcon_body_get_size(body_of(ibody), room, elements)
  room = min(room, int(maxn, c_int64_t))
  call room_77(body_of(ibody), 'RCBGND', int(room), whole, ierr)
  if (ierr /= ROLLCON_OK) return
  n_nodes_c = 0
  ierr = rollcon_body_get_group_nodes(body_of(ibody), c_name(group), 1_c_int32_t, room, whole, n_nodes_c)
  call give_integers(whole, nodes)
  nn = int(n_nodes_c)
end subroutine

!> Sets an integer option.
subroutine rcbsti(ibody, name, ivalue, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ivalue, ierr
  character(len=*) :: name
  ierr = rollcon_body_set_int(body_of(ibody), c_name(name), int(ivalue, c_int64_t))
end subroutine

!> Sets a real option.
subroutine rcbstr(ibody, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_body_set_real(body_of(ibody), c_name(name), value)
end subroutine

!> Returns the value of an integer option.
subroutine rcbgti(ibody, name, ivalue, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ivalue, ierr
  character(len=*) :: name
  integer(c_int64_t) :: value_c
  value_c = 0
  ierr = rollcon_body_get_int(body_of(ibody), c_name(name), value_c)
  ivalue = int(value_c)
end subroutine

!> Returns the value of a real option.
subroutine rcbgtr(ibody, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_body_get_real(body_of(ibody), c_name(name), value)
end subroutine

!> Sets a profile through points, in either order.
subroutine rcbpro(ibody, n, points, filter_length, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ierr
  double precision :: points(*), filter_length
  ierr = rollcon_body_set_profile(body_of(ibody), int(n, c_int64_t), points, filter_length)
end subroutine

!> Sets a profile in closed form.
subroutine rcbpsh(ibody, shape, n, par, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ierr
  character(len=*) :: shape
  double precision :: par(*)
  ierr = rollcon_body_set_profile_shape(body_of(ibody), c_name(shape), int(n, c_int64_t), par)
end subroutine

!> Sets a profile through the points of a file, just as rollcon_body_set_profile does.
subroutine rcbprd(ibody, path, unit, mirror, filter_length, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, mirror, ierr
  character(len=*) :: path
  double precision :: unit, filter_length
  ierr = rollcon_body_read_profile(body_of(ibody), c_text(path), unit, narrow(mirror), filter_length)
end subroutine

!> Takes the profile as that of one place, a length along the body or an angle round it, and waits for the profil.
subroutine rcbsli(ibody, u, n, features, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, n, ierr
  double precision :: u, features(*)
  ierr = rollcon_body_add_slice(body_of(ibody), u, int(n, c_int64_t), features)
end subroutine

!> Reads all slices of a rail (.slcs) or wheel (.slcw) from a list.
subroutine rcbslr(ibody, path, xmm, unit, mirror, filter_length, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, mirror, ierr
  character(len=*) :: path
  double precision :: xmm, unit, filter_length
  ierr = rollcon_body_read_slices(body_of(ibody), c_text(path), xmm, unit, narrow(mirror), filter_length)
end subroutine

!> Adds amplitude sin(2 pi u / wavelength + phase) to z of the profile, at the length or angle u.
subroutine rcbwav(ibody, amplitude, wavelength, phase, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: amplitude, wavelength, phase
  ierr = rollcon_body_add_wave(body_of(ibody), amplitude, wavelength, phase)
end subroutine

!> Writes points of the profile to a file.
subroutine rcbpwr(ibody, path, unit, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: path
  double precision :: unit
  ierr = rollcon_body_write_profile(body_of(ibody), c_text(path), unit)
end subroutine

!> Makes the profile, moved along a straight line without end, the surface of the body.
subroutine rcbext(ibody, origin, along, z_axis, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: origin(3), along(3), z_axis(3)
  ierr = rollcon_body_extrude_profile(body_of(ibody), origin, along, z_axis)
end subroutine

!> Makes the profile, turned about an axis, the surface of the body.
subroutine rcbrev(ibody, origin, axis, radius, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: origin(3), axis(3), radius
  ierr = rollcon_body_revolve_profile(body_of(ibody), origin, axis, radius)
end subroutine

!> Returns the arc length of the profile.
subroutine rcbple(ibody, xlength, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: xlength
  ierr = rollcon_body_get_profile_length(body_of(ibody), xlength)
end subroutine

!> Returns point, tangent and curvature of the profile at an arc length, counted from the end where y is less.
subroutine rcbppt(ibody, s, point, tangent, curvature, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: s, point(2), tangent(2), curvature
  ierr = rollcon_body_get_profile_point(body_of(ibody), s, point, tangent, curvature)
end subroutine

!> Returns the nodes and elements given so far.
subroutine rcbsiz(ibody, nodes, ielements, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, nodes, ielements, ierr
  integer(c_int64_t) :: nodes_c
  integer(c_int64_t) :: elements_c
  nodes_c = 0
  elements_c = 0
  ierr = rollcon_body_get_size(body_of(ibody), nodes_c, elements_c)
  nodes = int(nodes_c)
  ielements = int(elements_c)
end subroutine

!> Returns the displacement of every node under the body's own loads and given displacements.
subroutine rcbdis(ibody, maxn, u, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, maxn, ierr
  double precision :: u(*)
  ierr = rollcon_body_get_displacements(body_of(ibody), int(maxn, c_int64_t), u)
end subroutine

!> Returns smoothed stresses at all nodes of a body of finite elements under given displacements of its nodes, or.
subroutine rcbnds(ibody, nodes, u, stress, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, nodes, ierr
  double precision :: u(*), stress(*)
  ierr = rollcon_body_get_node_stresses(body_of(ibody), int(nodes, c_int64_t), u, stress)
end subroutine

!> Returns stresses at the integration points of all finite elements, element by element, with which the elements.
subroutine rcbpts(ibody, nodes, u, maxn, stress, xyz, nr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, nodes, maxn, nr, ierr
  double precision :: u(*), stress(*), xyz(*)
  integer(c_int64_t) :: n_rows_c
  n_rows_c = 0
  ierr = rollcon_body_get_point_stresses(body_of(ibody), int(nodes, c_int64_t), u, int(maxn, c_int64_t), stress, &
    xyz, n_rows_c)
  nr = int(n_rows_c)
end subroutine

!> Returns displacements and stresses at any points inside a body.
subroutine rcbfld(ibody, nodes, u, n, xyz, displacement, stress, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, nodes, n, ierr
  double precision :: u(*), xyz(*), displacement(*), stress(*)
  ierr = rollcon_body_get_fields_at(body_of(ibody), int(nodes, c_int64_t), u, int(n, c_int64_t), xyz, displacement, &
    stress)
end subroutine

!> Writes the elements of a body of finite or boundary elements with displacements, smoothed stresses (xx, yy, zz.
subroutine rcbwri(ibody, path, nodes, u, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, nodes, ierr
  character(len=*) :: path
  double precision :: u(*)
  ierr = rollcon_body_write(body_of(ibody), c_text(path), int(nodes, c_int64_t), u)
end subroutine

!> Returns the resultant of the forces that the supports exert on the body under its own loads and given displace.
subroutine rcbrea(ibody, force, xmoment, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  double precision :: force(3), xmoment(3)
  ierr = rollcon_body_get_reaction(body_of(ibody), force, xmoment)
end subroutine

!> Returns one number about a prepared body.
subroutine rcbsta(ibody, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ibody, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_body_get_stat(body_of(ibody), c_name(name), value)
end subroutine

!> Makes a contact of two bodies.
subroutine rcpair(ictx, ibody1, ibody2, icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, ibody1, ibody2, icon, ierr
  type(c_ptr) :: p
  icon = 0
  ierr = rollcon_contact_create(context_of(ictx), body_of(ibody1), body_of(ibody2), p)
  if (ierr == ROLLCON_OK) icon = rollcon_id_of(p)
end subroutine

!> Sets the nodes of the frame and forgets its elements, the gap array and the creep and friction fields.
subroutine rcnode(icon, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ldx, ierr
  double precision :: x(*)
  if (ldx < 3) then
    call refuse(contact_of(icon), 'RCNODE: LDX is', ldx, '; allowed: 3 or more', ierr)
    return
  end if
  ierr = rollcon_contact_frame_nodes(contact_of(icon), int(n, c_int64_t), x, int(ldx, c_int64_t), 1_c_int64_t)
end subroutine

!> Sets the nodes of the frame and forgets its elements, the gap array and the creep and friction fields.
subroutine rcnodt(icon, n, x, ldx, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ldx, ierr
  double precision :: x(*)
  if (ldx < n) then
    call refuse(contact_of(icon), 'RCNODT: LDX is', ldx, '; allowed: N or more', ierr)
    return
  end if
  ierr = rollcon_contact_frame_nodes(contact_of(icon), int(n, c_int64_t), x, 1_c_int64_t, int(ldx, c_int64_t))
end subroutine

!> Adds elements of one type to the frame.
subroutine rcelem(icon, itype, n, ic, ldc, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, itype, n, ic(*), ldc, itag, ierr
  integer(c_int32_t), allocatable :: packed(:, :)
  call pack_77(contact_of(icon), 'RCELEM', itype, n, ic, ldc, packed, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_contact_frame_add_elements(contact_of(icon), narrow(itype), int(n, c_int64_t), packed, &
    1_c_int32_t, narrow(itag))
end subroutine

!> Makes the surface elements of a mesh file the frame.
subroutine rcfmsh(icon, path, part, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: path, part
  ierr = rollcon_contact_frame_from_file(contact_of(icon), c_text(path), c_name(part))
end subroutine

!> Makes the faces of a body that carry a tag the frame.
subroutine rcfram(icon, iwhich, itag, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, itag, ierr
  ierr = rollcon_contact_frame_from_body(contact_of(icon), narrow(iwhich), narrow(itag))
end subroutine

!> Makes a rectangle in the present plane of the axes the frame.
subroutine rcfrec(icon, itype, nx, ny, x_least, x_greatest, y_least, y_greatest, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, itype, nx, ny, ierr
  double precision :: x_least, x_greatest, y_least, y_greatest
  ierr = rollcon_contact_frame_rectangle(contact_of(icon), narrow(itype), narrow(nx), narrow(ny), x_least, &
    x_greatest, y_least, y_greatest)
end subroutine

!> Makes an ellipse in the present plane of the axes the frame.
subroutine rcfell(icon, ialong, iacross, a, b, angle, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ialong, iacross, ierr
  double precision :: a, b, angle
  ierr = rollcon_contact_frame_ellipse(contact_of(icon), narrow(ialong), narrow(iacross), a, b, angle)
end subroutine

!> Makes strips along the rolling direction the frame.
subroutine rcfstr(icon, ialong, n, xlines, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ialong, n, ierr
  double precision :: xlines(*)
  ierr = rollcon_contact_frame_strips(contact_of(icon), narrow(ialong), int(n, c_int64_t), xlines)
end subroutine

!> Leaves the frame to the library, which is the state of a new contact.
subroutine rcfaut(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_frame_automatic(contact_of(icon))
end subroutine

!> Says where a body with a mesh stands.
subroutine rcpose(icon, iwhich, rotation, translation, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, ierr
  double precision :: rotation(3, 3), translation(3)
  ierr = rollcon_contact_set_pose(contact_of(icon), narrow(iwhich), transpose(rotation), translation)
end subroutine

!> Sets the axes.
subroutine rcaxes(icon, origin, rolling, xnormal, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: origin(3), rolling(3), xnormal(3)
  ierr = rollcon_contact_set_axes(contact_of(icon), origin, rolling, xnormal)
end subroutine

!> Sets the gap of the undeformed bodies at approach 0, node by node.
subroutine rcgap(icon, n, gap, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: gap(*)
  ierr = rollcon_contact_set_gap(contact_of(icon), int(n, c_int64_t), gap)
end subroutine

!> Sets the gap of the undeformed bodies at approach 0 to h = a x^2 + b y^2 + c x y in the axes (t1, t2).
subroutine rcgapq(icon, a, b, c, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: a, b, c
  ierr = rollcon_contact_set_gap_quadratic(contact_of(icon), a, b, c)
end subroutine

!> Sets the gap of the undeformed bodies at approach 0 by its values on a regular grid in the axes (t1, t2).
subroutine rcgapg(icon, nx, x_least, x_greatest, y_least, y_greatest, n, gap, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, nx, n, ierr
  double precision :: x_least, x_greatest, y_least, y_greatest, gap(*)
  ierr = rollcon_contact_set_gap_grid(contact_of(icon), narrow(nx), x_least, x_greatest, y_least, y_greatest, &
    int(n, c_int64_t), gap)
end subroutine

!> Sets the speed V at which the contact travels over both surfaces along +t1 (omega R for a wheel).
subroutine rcroll(icon, speed, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: speed
  ierr = rollcon_contact_set_rolling(contact_of(icon), speed)
end subroutine

!> Prescribes creepages and spin by motion.
subroutine rccrp(icon, xlongitudinal, xlateral, spin, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: xlongitudinal, xlateral, spin
  ierr = rollcon_contact_set_creep(contact_of(icon), xlongitudinal, xlateral, spin)
end subroutine

!> Makes every solve from now on a step in time of length dt.
subroutine rcstep(icon, kind, dt, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, kind, ierr
  double precision :: dt
  ierr = rollcon_contact_set_step(contact_of(icon), narrow(kind), dt)
end subroutine

!> Says how a body or the contact itself moves.
subroutine rcvel(icon, iwhich, velocity, angular_velocity, point, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, ierr
  double precision :: velocity(3), angular_velocity(3), point(3)
  ierr = rollcon_contact_set_velocity(contact_of(icon), narrow(iwhich), velocity, angular_velocity, point)
end subroutine

!> Adds a rigid slip velocity given node by node to that of creepages and spin.
subroutine rccrpf(icon, n, slip, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: slip(*)
  ierr = rollcon_contact_set_creep_field(contact_of(icon), int(n, c_int64_t), slip)
end subroutine

!> Prescribes one direction by motion or by force.
subroutine rcpres(icon, idirection, ihow, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, idirection, ihow, ierr
  double precision :: value
  ierr = rollcon_contact_prescribe(contact_of(icon), narrow(idirection), narrow(ihow), value)
end subroutine

!> Sets the law of friction for the whole frame.
subroutine rcfric(icon, law, n, par, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  character(len=*) :: law
  double precision :: par(*)
  ierr = rollcon_contact_set_friction(contact_of(icon), c_name(law), narrow(n), par)
end subroutine

!> Gives friction that falls with the slip speed a memory.
subroutine rcfrim(icon, xlength, xleast_speed, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: xlength, xleast_speed
  ierr = rollcon_contact_set_friction_memory(contact_of(icon), xlength, xleast_speed)
end subroutine

!> Puts a thin layer between the bodies that gives way along the surface in proportion to the tangential traction.
subroutine rclayr(icon, flexibility, stress, hardening, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: flexibility, stress, hardening
  ierr = rollcon_contact_set_layer(contact_of(icon), flexibility, stress, hardening)
end subroutine

!> Sets friction coefficients along t2, linear between points and constant beyond them, for frames of any maker.
subroutine rcfria(icon, n, points, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: points(*)
  ierr = rollcon_contact_set_friction_across(contact_of(icon), int(n, c_int64_t), points)
end subroutine

!> Says what a body does with heat, for the surface temperatures of a solution (rollcon_contact_get_temperatures_.
subroutine rcheat(icon, iwhich, conductivity, heat_capacity, temperature, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, ierr
  double precision :: conductivity, heat_capacity, temperature
  ierr = rollcon_contact_set_heat(contact_of(icon), narrow(iwhich), conductivity, heat_capacity, temperature)
end subroutine

!> Sets the friction coefficient node by node, in place of that of rollcon_contact_set_friction.
subroutine rcfrif(icon, n, xmu, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: xmu(*)
  ierr = rollcon_contact_set_friction_field(contact_of(icon), int(n, c_int64_t), xmu)
end subroutine

!> Sets an integer option.
subroutine rcseti(icon, name, ivalue, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ivalue, ierr
  character(len=*) :: name
  ierr = rollcon_contact_set_int(contact_of(icon), c_name(name), int(ivalue, c_int64_t))
end subroutine

!> Sets a real option.
subroutine rcsetr(icon, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_contact_set_real(contact_of(icon), c_name(name), value)
end subroutine

!> Sets a text option.
subroutine rcsets(icon, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name, value
  ierr = rollcon_contact_set_str(contact_of(icon), c_name(name), c_name(value))
end subroutine

!> Returns the value of an integer option.
subroutine rcgeti(icon, name, ivalue, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ivalue, ierr
  character(len=*) :: name
  integer(c_int64_t) :: value_c
  value_c = 0
  ierr = rollcon_contact_get_int(contact_of(icon), c_name(name), value_c)
  ivalue = int(value_c)
end subroutine

!> Returns the value of a real option.
subroutine rcgetr(icon, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_contact_get_real(contact_of(icon), c_name(name), value)
end subroutine

!> Returns the value of a text option.
subroutine rcgets(icon, name, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name, text
  character(kind=c_char), allocatable :: buffer(:)
  integer(c_int64_t) :: capacity, needed
  allocate (buffer(1))
  capacity = 0
  needed = 1
  ierr = rollcon_contact_get_str(contact_of(icon), c_name(name), capacity, buffer, needed)
  deallocate (buffer)
  capacity = max(needed, 1_c_int64_t)
  allocate (buffer(capacity))
  buffer(1) = c_null_char
  if (ierr == ROLLCON_OK) then
    ierr = rollcon_contact_get_str(contact_of(icon), c_name(name), capacity, buffer, needed)
  end if
  call give_text(contact_of(icon), 'RCGETS', buffer, text, ierr)
end subroutine

!> Chooses one of the published solution procedures in place of the library's own iteration, by options and value.
subroutine rcproc(icon, procedure, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: procedure
  ierr = rollcon_contact_set_procedure(contact_of(icon), c_name(procedure))
end subroutine

!> Sets the callback that is called once per iteration, and about every tenth of a second while bodies and operat.
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

!> Sets the callback that is called once per iteration, and about every tenth of a second while bodies and operat.
subroutine rcnopr(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_set_progress(contact_of(icon), c_null_funptr, c_null_ptr)
end subroutine

!> Asks a running solve to stop (an atomic store).
subroutine rcstop(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_request_cancel(contact_of(icon))
end subroutine

!> Solves the steady rolling contact.
subroutine rcsolv(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_solve(contact_of(icon))
end subroutine

!> Solves the scene for many load cases, each with some of what is prescribed replaced, on the threads of the con.
subroutine rccase(icon, par, nc, values, columns, maxn, results, nres, istatus, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, nc, maxn, nres, istatus(*), ierr
  character(len=*) :: par, columns
  double precision :: values(*), results(*)
  integer(c_int64_t) :: n_results_c
  integer(c_int32_t), allocatable :: whole(:)
  n_results_c = 0
  call room_77(contact_of(icon), 'RCCASE', nc, whole, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_contact_solve_many(contact_of(icon), c_name(par), int(nc, c_int64_t), values, c_name(columns), &
    int(maxn, c_int64_t), results, n_results_c, whole)
  nres = int(n_results_c)
  call give_integers(whole, istatus)
end subroutine

!> Lets the next solve start from where the last step did, as if that had not been, for a host that tries loads o.
subroutine rcrept(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_repeat_step(contact_of(icon))
end subroutine

!> Returns what the next step starts from, as numbers.
subroutine rcspst(icon, maxn, past, nv, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, maxn, nv, ierr
  double precision :: past(*)
  integer(c_int64_t) :: n_values_c
  n_values_c = 0
  ierr = rollcon_contact_past_get(contact_of(icon), int(maxn, c_int64_t), past, n_values_c)
  nv = int(n_values_c)
end subroutine

!> Lets the next step start from what rollcon_contact_past_get gave.
subroutine rcrpst(icon, n, past, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: past(*)
  ierr = rollcon_contact_past_set(contact_of(icon), int(n, c_int64_t), past)
end subroutine

!> Forgets the solution, the warm start, the iteration log and what was before a time step (bodies are at rest).
subroutine rcrset(icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  ierr = rollcon_contact_reset(contact_of(icon))
end subroutine

!> Returns the nodes and elements of the frame.
subroutine rcsize(icon, nodes, ielements, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, nodes, ielements, ierr
  integer(c_int64_t) :: nodes_c
  integer(c_int64_t) :: elements_c
  nodes_c = 0
  elements_c = 0
  ierr = rollcon_contact_get_size(contact_of(icon), nodes_c, elements_c)
  nodes = int(nodes_c)
  ielements = int(elements_c)
end subroutine

!> Returns tractions on body 1 at the nodes.
subroutine rctrac(icon, iaxes, maxn, t, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iaxes, maxn, ierr
  double precision :: t(*)
  ierr = rollcon_contact_get_tractions(contact_of(icon), narrow(iaxes), int(maxn, c_int64_t), t)
end subroutine

!> Returns a nodal field.
subroutine rcfeld(icon, ifield, iaxes, maxn, v, nv, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ifield, iaxes, maxn, nv, ierr
  double precision :: v(*)
  integer(c_int64_t) :: n_values_c
  n_values_c = 0
  ierr = rollcon_contact_get_field(contact_of(icon), narrow(ifield), narrow(iaxes), int(maxn, c_int64_t), v, &
    n_values_c)
  nv = int(n_values_c)
end subroutine

!> Returns the state of each node.
subroutine rcnsta(icon, maxn, istatus, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, maxn, istatus(*), ierr
  integer(c_int32_t), allocatable :: whole(:)
  integer(c_int64_t) :: room, elements
  room = 0
  elements = 0
  ierr = rollcon_contact_get_size(contact_of(icon), room, elements)
  room = min(room, int(maxn, c_int64_t))
  call room_77(contact_of(icon), 'RCNSTA', int(room), whole, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_contact_get_node_states(contact_of(icon), room, whole)
  call give_integers(whole, istatus)
end subroutine

!> Returns the resultant force on body 1 and its moment about the origin of the axes.
subroutine rcresu(icon, iaxes, force, xmoment, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iaxes, ierr
  double precision :: force(3), xmoment(3)
  ierr = rollcon_contact_get_resultant(contact_of(icon), narrow(iaxes), force, xmoment)
end subroutine

!> Returns approach, creepages and spin, given or found for prescribed forces.
subroutine rcmotn(icon, approach, creep, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: approach, creep(3)
  ierr = rollcon_contact_get_motion(contact_of(icon), approach, creep)
end subroutine

!> Returns rotations of body 1 against body 2 about t1 and t2, given or found for prescribed moments (rollcon_con.
subroutine rctilt(icon, tilt, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: tilt(2)
  ierr = rollcon_contact_get_tilt(contact_of(icon), tilt)
end subroutine

!> Returns the derivatives of what rollcon_contact_get_resultant (local axes) and rollcon_contact_get_motion give.
subroutine rcsens(icon, iparameter, force, xmoment, approach, creep, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iparameter, ierr
  double precision :: force(3), xmoment(3), approach, creep(3)
  ierr = rollcon_contact_get_sensitivity(contact_of(icon), narrow(iparameter), force, xmoment, approach, creep)
end subroutine

!> Returns the elastic displacement of a body at any points of the contact surface, on the frame or off it, in lo.
subroutine rcdisp(icon, iwhich, n, xy, u, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, n, ierr
  double precision :: xy(*), u(*)
  ierr = rollcon_contact_get_displacements_at(contact_of(icon), narrow(iwhich), int(n, c_int64_t), xy, u)
end subroutine

!> Returns displacements and stresses at any points inside a body, or on its surface, under the tractions of the .
subroutine rcflds(icon, iwhich, n, xyz, in_axes, u, stress, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, n, in_axes, ierr
  double precision :: xyz(*), u(*), stress(*)
  ierr = rollcon_contact_get_fields_at(contact_of(icon), narrow(iwhich), int(n, c_int64_t), xyz, narrow(in_axes), &
    u, stress)
end subroutine

!> Searches a half-space under the last solve for the largest value of a measure of stress, and says where it is.
subroutine rcpeak(icon, iwhich, measure, n, par, value, place, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, n, ierr
  character(len=*) :: measure
  double precision :: par(*), value, place(3)
  ierr = rollcon_contact_find_stress(contact_of(icon), narrow(iwhich), c_name(measure), narrow(n), par, value, &
    place)
end subroutine

!> Returns displacements of all nodes of a body of finite or boundary elements under the tractions of the last so.
subroutine rcbodu(icon, iwhich, maxn, u, nv, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, maxn, nv, ierr
  double precision :: u(*)
  integer(c_int64_t) :: n_values_c
  n_values_c = 0
  ierr = rollcon_contact_get_body_displacements(contact_of(icon), narrow(iwhich), int(maxn, c_int64_t), u, &
    n_values_c)
  nv = int(n_values_c)
end subroutine

!> Returns the power that a viscoelastic section loses in each harmonic of its way under the tractions of the las.
subroutine rcbpow(icon, iwhich, maxn, power, nv, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, maxn, nv, ierr
  double precision :: power(*)
  integer(c_int64_t) :: n_values_c
  n_values_c = 0
  ierr = rollcon_contact_get_body_power(contact_of(icon), narrow(iwhich), int(maxn, c_int64_t), power, n_values_c)
  nv = int(n_values_c)
end subroutine

!> Writes the elements of a body of finite or boundary elements, or a block of a half-space around the contact, t.
subroutine rcwbod(icon, iwhich, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, ierr
  character(len=*) :: path
  ierr = rollcon_contact_write_body(contact_of(icon), narrow(iwhich), c_text(path))
end subroutine

!> Writes what the contact does to a body with a mesh as forces on the body's own nodes, in its axes.
subroutine rcwlds(icon, iwhich, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, iwhich, ierr
  character(len=*) :: path
  ierr = rollcon_contact_write_loads(contact_of(icon), narrow(iwhich), c_text(path))
end subroutine

!> Returns temperatures of the surfaces of both bodies at any points of the plane of the axes by the frictional h.
subroutine rctmps(icon, n, xy, temperature, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ierr
  double precision :: xy(*), temperature(*)
  ierr = rollcon_contact_get_temperatures_at(contact_of(icon), int(n, c_int64_t), xy, temperature)
end subroutine

!> Returns the railways' index of surface-initiated rolling contact fatigue of wheels, after Ekberg, Kabo and And.
subroutine rcfati(icon, shear_yield, xindex, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: shear_yield, xindex
  ierr = rollcon_contact_get_fatigue_index(contact_of(icon), shear_yield, xindex)
end subroutine

!> Returns the Hertzian contact that stands for this one, in the form of inputs of rollcon_table_evaluate.
subroutine rcelli(icon, xinputs, center, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  double precision :: xinputs(9), center(2)
  ierr = rollcon_contact_get_equivalent_ellipse(contact_of(icon), xinputs, center)
end subroutine

!> Returns the depth that one pass of the contact wears off, along t2.
subroutine rcwear(icon, law, n, par, ipoints, y, depth, volume, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, n, ipoints, ierr
  character(len=*) :: law
  double precision :: par(*), y(*), depth(*), volume
  ierr = rollcon_contact_get_wear(contact_of(icon), c_name(law), narrow(n), par, int(ipoints, c_int64_t), y, depth, &
    volume)
end subroutine

!> Moves points of a profile into their body by what wears off over a distance.
subroutine rcwpro(ipoints, yz, rate, iside, distance, xmost_depth, smoothing, worn, taken, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ipoints, iside, ierr
  double precision :: yz(*), rate(*), distance, xmost_depth, smoothing, worn(*), taken
  ierr = rollcon_wear_profile(int(ipoints, c_int64_t), yz, rate, narrow(iside), distance, xmost_depth, smoothing, &
    worn, taken)
end subroutine

!> Returns principal stresses, von Mises's stress and the largest shear stress of n stresses, which may come from.
subroutine rcsinv(n, stress, principal, von_mises, shear, ierr)
  use rollcon_f77_support
  implicit none
  integer :: n, ierr
  double precision :: stress(*), principal(*), von_mises(*), shear(*)
  ierr = rollcon_stress_invariants(int(n, c_int64_t), stress, principal, von_mises, shear)
end subroutine

!> Returns one number about the last solve.
subroutine rcstat(icon, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_contact_get_stat(contact_of(icon), c_name(name), value)
end subroutine

!> Returns the iterations of the last solve, one row each, with the columns asked for.
subroutine rchist(icon, columns, maxn, rows, nr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, maxn, nr, ierr
  character(len=*) :: columns
  double precision :: rows(*)
  integer(c_int64_t) :: n_rows_c
  n_rows_c = 0
  ierr = rollcon_contact_get_history(contact_of(icon), c_name(columns), int(maxn, c_int64_t), rows, n_rows_c)
  nr = int(n_rows_c)
end subroutine

!> Returns how the last solve was done (sizes, schemes, linear solver and why), as text for people.
subroutine rcplan(icon, text, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: text
  character(kind=c_char), allocatable :: buffer(:)
  integer(c_int64_t) :: capacity, needed
  allocate (buffer(1))
  capacity = 0
  needed = 1
  ierr = rollcon_contact_get_plan(contact_of(icon), capacity, buffer, needed)
  deallocate (buffer)
  capacity = max(needed, 1_c_int64_t)
  allocate (buffer(capacity))
  buffer(1) = c_null_char
  if (ierr == ROLLCON_OK) then
    ierr = rollcon_contact_get_plan(contact_of(icon), capacity, buffer, needed)
  end if
  call give_text(contact_of(icon), 'RCPLAN', buffer, text, ierr)
end subroutine

!> Writes frame and fields, in global axes, as a VTU file for ParaView and meshio.
subroutine rcwrit(icon, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: icon, ierr
  character(len=*) :: path
  ierr = rollcon_contact_write(contact_of(icon), c_text(path))
end subroutine

!> Makes a wheel on its rail.
subroutine rcwhel(ictx, iwheel, irail, iside, iwr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, iwheel, irail, iside, iwr, ierr
  type(c_ptr) :: p
  iwr = 0
  ierr = rollcon_wheelrail_create(context_of(ictx), body_of(iwheel), body_of(irail), narrow(iside), p)
  if (ierr == ROLLCON_OK) iwr = rollcon_id_of(p)
end subroutine

!> Says where the rails lie.
subroutine rcwtrk(iwr, gauge, gauge_height, cant, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: gauge, gauge_height, cant
  ierr = rollcon_wheelrail_set_track(wheelrail_of(iwr), gauge, gauge_height, cant)
end subroutine

!> Sets the dimensions of the wheelset.
subroutine rcwset(iwr, back_to_back, flange_back, radius, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: back_to_back, flange_back, radius
  ierr = rollcon_wheelrail_set_wheelset(wheelrail_of(iwr), back_to_back, flange_back, radius)
end subroutine

!> Places the rail by the origin of its profile in the track, in place of rollcon_wheelrail_set_track.
subroutine rcwplr(iwr, y, z, cant, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: y, z, cant
  ierr = rollcon_wheelrail_place_rail(wheelrail_of(iwr), y, z, cant)
end subroutine

!> Makes the rail a roller of a test rig.
subroutine rcwrol(iwr, radius, rate, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: radius, rate
  ierr = rollcon_wheelrail_set_roller(wheelrail_of(iwr), radius, rate)
end subroutine

!> Makes every solve from now on a step in time of length dt.
subroutine rcwtim(iwr, kind, dt, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, kind, ierr
  double precision :: dt
  ierr = rollcon_wheelrail_set_step(wheelrail_of(iwr), narrow(kind), dt)
end subroutine

!> Takes the last step back.
subroutine rcwrep(iwr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  ierr = rollcon_wheelrail_repeat_step(wheelrail_of(iwr))
end subroutine

!> Copies what the next step in time starts from to an array of the caller's, as numbers.
subroutine rcwsps(iwr, maxn, past, nv, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, maxn, nv, ierr
  double precision :: past(*)
  integer(c_int64_t) :: n_values_c
  n_values_c = 0
  ierr = rollcon_wheelrail_past_get(wheelrail_of(iwr), int(maxn, c_int64_t), past, n_values_c)
  nv = int(n_values_c)
end subroutine

!> Lets the next step start from numbers that rollcon_wheelrail_past_get gave.
subroutine rcwrps(iwr, n, past, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, n, ierr
  double precision :: past(*)
  ierr = rollcon_wheelrail_past_set(wheelrail_of(iwr), int(n, c_int64_t), past)
end subroutine

!> Says where on the wheel's profile the radius of rollcon_wheelrail_set_wheelset is measured, after that call, w.
subroutine rcwtap(iwr, y, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: y
  ierr = rollcon_wheelrail_set_tape_circle(wheelrail_of(iwr), y)
end subroutine

!> Displaces the wheel in the axes of the wheelset, which bends, and says how that changes.
subroutine rcwflx(iwr, displacement, rate, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: displacement(6), rate(6)
  ierr = rollcon_wheelrail_set_flexibility(wheelrail_of(iwr), displacement, rate)
end subroutine

!> Puts the rail on springs along y and z of the track.
subroutine rcwspr(iwr, stiffness, force, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: stiffness(2), force(2)
  ierr = rollcon_wheelrail_set_rail_springs(wheelrail_of(iwr), stiffness, force)
end subroutine

!> Sets the deviation of the rail from its place in the track and how it changes.
subroutine rcwdev(iwr, deviation, rate, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: deviation(3), rate(3)
  ierr = rollcon_wheelrail_set_rail_deviation(wheelrail_of(iwr), deviation, rate)
end subroutine

!> Sets the position of the wheelset.
subroutine rcwpos(iwr, position, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: position(6)
  ierr = rollcon_wheelrail_set_position(wheelrail_of(iwr), position)
end subroutine

!> Sets the velocity of the wheelset.
subroutine rcwvel(iwr, velocity, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: velocity(6)
  ierr = rollcon_wheelrail_set_velocity(wheelrail_of(iwr), velocity)
end subroutine

!> Prescribes the height of the wheelset by motion, from its position (standard), or by the vertical force.
subroutine rcwvrt(iwr, ihow, force, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ihow, ierr
  double precision :: force
  ierr = rollcon_wheelrail_prescribe_vertical(wheelrail_of(iwr), narrow(ihow), force)
end subroutine

!> Prescribes the pitch rate by motion, from the velocity (standard), or the force on the wheel along the wheelse.
subroutine rcwpll(iwr, ihow, force, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ihow, ierr
  double precision :: force
  ierr = rollcon_wheelrail_prescribe_longitudinal(wheelrail_of(iwr), narrow(ihow), force)
end subroutine

!> Sets the law of friction.
subroutine rcwfri(iwr, law, n, par, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, n, ierr
  character(len=*) :: law
  double precision :: par(*)
  ierr = rollcon_wheelrail_set_friction(wheelrail_of(iwr), c_name(law), narrow(n), par)
end subroutine

!> Sets a law whose parameters follow the inclination of the rail's surface, linear between points and constant b.
subroutine rcwlba(iwr, law, ipoints, n, par, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ipoints, n, ierr
  character(len=*) :: law
  double precision :: par(*)
  ierr = rollcon_wheelrail_set_law_by_angle(wheelrail_of(iwr), c_name(law), narrow(ipoints), narrow(n), par)
end subroutine

!> Gives friction that falls with the slip speed a memory, as for a contact.
subroutine rcwfrm(iwr, xlength, xleast_speed, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: xlength, xleast_speed
  ierr = rollcon_wheelrail_set_friction_memory(wheelrail_of(iwr), xlength, xleast_speed)
end subroutine

!> Puts a thin layer between wheel and rail, as between the bodies of a contact.
subroutine rcwlay(iwr, flexibility, stress, hardening, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  double precision :: flexibility, stress, hardening
  ierr = rollcon_wheelrail_set_layer(wheelrail_of(iwr), flexibility, stress, hardening)
end subroutine

!> Says what wheel or rail does with heat, for the temperatures of the contacts of patches (rollcon_contact_get_t.
subroutine rcwhea(iwr, iwhich, conductivity, heat_capacity, temperature, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, iwhich, ierr
  double precision :: conductivity, heat_capacity, temperature
  ierr = rollcon_wheelrail_set_heat(wheelrail_of(iwr), narrow(iwhich), conductivity, heat_capacity, temperature)
end subroutine

!> Looks forces along the surfaces and spin moments up in a creep-force table from now on, for an ellipse that ha.
subroutine rcwtab(iwr, itab, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, itab, ierr
  ierr = rollcon_wheelrail_set_table(wheelrail_of(iwr), table_of(itab))
end subroutine

!> Finds the patches and solves each as a steady rolling contact, from the last solution where there is one.
subroutine rcwslv(iwr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  ierr = rollcon_wheelrail_solve(wheelrail_of(iwr))
end subroutine

!> Asks a running rollcon_wheelrail_solve or rollcon_wheelrail_solve_many to stop (an atomic store) before its ne.
subroutine rcwstp(iwr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  ierr = rollcon_wheelrail_request_cancel(wheelrail_of(iwr))
end subroutine

!> Solves many positions on the threads of the context, each by itself from nothing, as after rollcon_wheelrail_r.
subroutine rcwmny(iwr, n, positions, velocities, columns, totals, istatus, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, n, istatus(*), ierr
  double precision :: positions(*), velocities(*), totals(*)
  character(len=*) :: columns
  integer(c_int32_t), allocatable :: whole(:)
  call room_77(wheelrail_of(iwr), 'RCWMNY', n, whole, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_wheelrail_solve_many(wheelrail_of(iwr), int(n, c_int64_t), positions, velocities, c_name(columns), &
    totals, whole)
  call give_integers(whole, istatus)
end subroutine

!> Finds the wear of wheel and rail by a spectrum of positions.
subroutine rcwfwr(iwr, nc, positions, velocities, weights, law, n, par, ipoints, wheel, rail, volumes, istatus, &
  ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, nc, n, ipoints, istatus(*), ierr
  double precision :: positions(*), velocities(*), weights(*), par(*), wheel(*), rail(*), volumes(2)
  character(len=*) :: law
  integer(c_int32_t), allocatable :: whole(:)
  call room_77(wheelrail_of(iwr), 'RCWFWR', nc, whole, ierr)
  if (ierr /= ROLLCON_OK) return
  ierr = rollcon_wheelrail_find_wear(wheelrail_of(iwr), int(nc, c_int64_t), positions, velocities, weights, &
    c_name(law), narrow(n), par, int(ipoints, c_int64_t), wheel, rail, volumes, whole)
  call give_integers(whole, istatus)
end subroutine

!> Takes a snapshot of what is set and of the last solution, kept at a place within the wheel, for rollcon_wheelr.
subroutine rcwsav(iwr, iplace, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, iplace, ierr
  ierr = rollcon_wheelrail_snapshot(wheelrail_of(iwr), narrow(iplace))
end subroutine

!> Goes back to a snapshot.
subroutine rcwbck(iwr, iplace, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, iplace, ierr
  ierr = rollcon_wheelrail_rollback(wheelrail_of(iwr), narrow(iplace))
end subroutine

!> Makes another wheel on its rail with the same bodies, inputs and last solution, and no snapshots.
subroutine rcwcpy(iwr, icopy, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, icopy, ierr
  type(c_ptr) :: p
  icopy = 0
  ierr = rollcon_wheelrail_copy(wheelrail_of(iwr), p)
  if (ierr == ROLLCON_OK) icopy = rollcon_id_of(p)
end subroutine

!> Forgets the solution, the warm starts and what was before a step in time (bodies are at rest).
subroutine rcwrst(iwr, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  ierr = rollcon_wheelrail_reset(wheelrail_of(iwr))
end subroutine

!> Sets an integer option.
subroutine rcwsti(iwr, name, ivalue, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ivalue, ierr
  character(len=*) :: name
  ierr = rollcon_wheelrail_set_int(wheelrail_of(iwr), c_name(name), int(ivalue, c_int64_t))
end subroutine

!> Sets a real option.
subroutine rcwstr(iwr, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_wheelrail_set_real(wheelrail_of(iwr), c_name(name), value)
end subroutine

!> Returns the value of an integer option.
subroutine rcwgti(iwr, name, ivalue, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ivalue, ierr
  character(len=*) :: name
  integer(c_int64_t) :: value_c
  value_c = 0
  ierr = rollcon_wheelrail_get_int(wheelrail_of(iwr), c_name(name), value_c)
  ivalue = int(value_c)
end subroutine

!> Returns the value of a real option.
subroutine rcwgtr(iwr, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_wheelrail_get_real(wheelrail_of(iwr), c_name(name), value)
end subroutine

!> Returns the number of patches, from 0.
subroutine rcwnpa(iwr, ipatches, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ipatches, ierr
  integer(c_int64_t) :: patches_c
  patches_c = 0
  ierr = rollcon_wheelrail_get_patch_count(wheelrail_of(iwr), patches_c)
  ipatches = int(patches_c)
end subroutine

!> Returns the force of all patches on the wheel and its moment about the wheelset's centre.
subroutine rcwres(iwr, iaxes, force, xmoment, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, iaxes, ierr
  double precision :: force(3), xmoment(3)
  ierr = rollcon_wheelrail_get_resultant(wheelrail_of(iwr), narrow(iaxes), force, xmoment)
end subroutine

!> Returns the derivatives of the totals of the last solve by one entry of its position or velocity.
subroutine rcwder(iwr, ientry, force, xmoment, z, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ientry, ierr
  double precision :: force(3), xmoment(3), z
  ierr = rollcon_wheelrail_get_derivative(wheelrail_of(iwr), narrow(ientry), force, xmoment, z)
end subroutine

!> Returns one number about the last solve.
subroutine rcwsta(iwr, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_wheelrail_get_stat(wheelrail_of(iwr), c_name(name), value)
end subroutine

!> Returns where a point of the wheel's or the rail's profile stood in the last solve, in the track, for pictures.
subroutine rcwppt(iwr, iwhich, share, point, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, iwhich, ierr
  double precision :: share, point(2)
  ierr = rollcon_wheelrail_get_profile_point(wheelrail_of(iwr), narrow(iwhich), share, point)
end subroutine

!> Returns one number about a patch.
subroutine rcwpst(iwr, ipatch, name, value, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ipatch, ierr
  character(len=*) :: name
  double precision :: value
  ierr = rollcon_wheelrail_get_patch_stat(wheelrail_of(iwr), narrow(ipatch - 1), c_name(name), value)
end subroutine

!> Returns origin and axes of the contact of a patch (rollcon_wheelrail_get_contact) in the track.
subroutine rcwpax(iwr, ipatch, origin, axes, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ipatch, ierr
  double precision :: origin(3), axes(9)
  ierr = rollcon_wheelrail_get_patch_axes(wheelrail_of(iwr), narrow(ipatch - 1), origin, axes)
end subroutine

!> Returns the contact of a patch.
subroutine rcwcon(iwr, ipatch, icon, ierr)
  use rollcon_f77_support
  implicit none
  integer :: iwr, ipatch, icon, ierr
  type(c_ptr) :: p
  icon = 0
  ierr = rollcon_wheelrail_get_contact(wheelrail_of(iwr), narrow(ipatch - 1), p)
  if (ierr == ROLLCON_OK) icon = rollcon_id_of(p)
end subroutine

!> Finds where both wheels of a wheelset touch over its lateral shift, without yaw.
subroutine rcwpts(ileft, iright, n, shift, columns, points, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ileft, iright, n, ierr
  double precision :: shift(*), points(*)
  character(len=*) :: columns
  ierr = rollcon_wheelrail_find_contact_points(wheelrail_of(ileft), wheelrail_of(iright), int(n, c_int64_t), shift, &
    c_name(columns), points)
end subroutine

!> Finds the equivalent conicities of EN 15302.
subroutine rcwcnc(ileft, iright, n, amplitude, conicity, wavelength, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ileft, iright, n, ierr
  double precision :: amplitude(*), conicity(*), wavelength(*)
  ierr = rollcon_wheelrail_find_conicity(wheelrail_of(ileft), wheelrail_of(iright), int(n, c_int64_t), amplitude, &
    conicity, wavelength)
end subroutine

!> Returns the number of options of a kind of object.
subroutine rcnopt(kind, n)
  use rollcon_f77_support
  implicit none
  integer :: kind, n
  n = rollcon_option_count(narrow(kind))
end subroutine

!> Returns a row of the table of options.
subroutine rcopti(kind, i, name, doc, itype, xlow, high, standard, ierr)
  use rollcon_f77_support
  implicit none
  integer :: kind, i, itype, ierr
  character(len=*) :: name, doc
  double precision :: xlow, high, standard
  integer(c_int32_t) :: type_c
  character(kind=c_char), allocatable :: buffer_name(:), buffer_doc(:)
  integer(c_int64_t) :: capacity, needed
  allocate (buffer_name(1), buffer_doc(1))
  capacity = 0
  needed = 1
  type_c = 0
  ierr = rollcon_option_info(narrow(kind), narrow(i - 1), capacity, buffer_name, buffer_doc, needed, type_c, xlow, &
    high, standard)
  deallocate (buffer_name, buffer_doc)
  capacity = max(needed, 1_c_int64_t)
  allocate (buffer_name(capacity), buffer_doc(capacity))
  buffer_name(1) = c_null_char
  buffer_doc(1) = c_null_char
  if (ierr == ROLLCON_OK) then
    ierr = rollcon_option_info(narrow(kind), narrow(i - 1), capacity, buffer_name, buffer_doc, needed, type_c, xlow, &
      high, standard)
  end if
  itype = int(type_c)
  call give_text(c_null_ptr, 'RCOPTI', buffer_name, name, ierr)
  call give_text(c_null_ptr, 'RCOPTI', buffer_doc, doc, ierr)
end subroutine

!> Returns the number of statistics of a kind of object.
subroutine rcnstt(kind, n)
  use rollcon_f77_support
  implicit none
  integer :: kind, n
  n = rollcon_stat_count(narrow(kind))
end subroutine

!> Returns a row of the table of statistics.
subroutine rcstti(kind, i, name, doc, inside, ierr)
  use rollcon_f77_support
  implicit none
  integer :: kind, i, inside, ierr
  character(len=*) :: name, doc
  integer(c_int32_t) :: inside_c
  character(kind=c_char), allocatable :: buffer_name(:), buffer_doc(:)
  integer(c_int64_t) :: capacity, needed
  allocate (buffer_name(1), buffer_doc(1))
  capacity = 0
  needed = 1
  inside_c = 0
  ierr = rollcon_stat_info(narrow(kind), narrow(i - 1), capacity, buffer_name, buffer_doc, needed, inside_c)
  deallocate (buffer_name, buffer_doc)
  capacity = max(needed, 1_c_int64_t)
  allocate (buffer_name(capacity), buffer_doc(capacity))
  buffer_name(1) = c_null_char
  buffer_doc(1) = c_null_char
  if (ierr == ROLLCON_OK) then
    ierr = rollcon_stat_info(narrow(kind), narrow(i - 1), capacity, buffer_name, buffer_doc, needed, inside_c)
  end if
  inside = int(inside_c)
  call give_text(c_null_ptr, 'RCSTTI', buffer_name, name, ierr)
  call give_text(c_null_ptr, 'RCSTTI', buffer_doc, doc, ierr)
end subroutine

!> Adds a reference.
subroutine rckeep(ih, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ih, ierr
  select case (kind_of(ih))
  case (of_context)
    ierr = rollcon_context_retain(context_of(ih))
  case (of_body)
    ierr = rollcon_body_retain(body_of(ih))
  case (of_contact)
    ierr = rollcon_contact_retain(contact_of(ih))
  case (of_wheelrail)
    ierr = rollcon_wheelrail_retain(wheelrail_of(ih))
  case (of_table)
    ierr = rollcon_table_retain(table_of(ih))
  case default
    call no_handle('RCKEEP', ih, ierr)
  end select
end subroutine

!> Makes a table without samples.
subroutine rctabl(ictx, itab, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, itab, ierr
  type(c_ptr) :: p
  itab = 0
  ierr = rollcon_table_create(context_of(ictx), p)
  if (ierr == ROLLCON_OK) itab = rollcon_id_of(p)
end subroutine

!> Makes a table from a file of rollcon_table_save.
subroutine rctlod(ictx, path, itab, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, itab, ierr
  character(len=*) :: path
  type(c_ptr) :: p
  itab = 0
  ierr = rollcon_table_load(context_of(ictx), c_text(path), p)
  if (ierr == ROLLCON_OK) itab = rollcon_id_of(p)
end subroutine

!> Makes the table that comes with the library.
subroutine rctstd(ictx, itab, ierr)
  use rollcon_f77_support
  implicit none
  integer :: ictx, itab, ierr
  type(c_ptr) :: p
  itab = 0
  ierr = rollcon_table_standard(context_of(ictx), p)
  if (ierr == ROLLCON_OK) itab = rollcon_id_of(p)
end subroutine

!> Sets which ratios a / b of semi-axes the table has.
subroutine rctrat(itab, intervals, xleast, greatest, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, intervals, ierr
  double precision :: xleast, greatest
  ierr = rollcon_table_set_ratios(table_of(itab), narrow(intervals), xleast, greatest)
end subroutine

!> Sets how fine the table is in the creepages.
subroutine rctres(itab, magnitudes, iangles, idirections, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, magnitudes, iangles, idirections, ierr
  ierr = rollcon_table_set_resolution(table_of(itab), narrow(magnitudes), narrow(iangles), narrow(idirections))
end subroutine

!> Sets the coarser of the two frames of strips on which samples of circles are solved.
subroutine rctfrm(itab, ialong, iacross, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, ialong, iacross, ierr
  ierr = rollcon_table_set_frame(table_of(itab), narrow(ialong), narrow(iacross))
end subroutine

!> Makes it a table of bodies of equal elastic constants, which a new one is, and sets its Poisson's ratios.
subroutine rctpoi(itab, n, poissons, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, n, ierr
  double precision :: poissons(*)
  ierr = rollcon_table_set_poissons(table_of(itab), int(n, c_int64_t), poissons)
end subroutine

!> Makes it a table of two bodies whose elastic constants differ, one of which may be rigid.
subroutine rctbod(itab, youngs, poissons, n, frictions, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, n, ierr
  double precision :: youngs(2), poissons(2), frictions(*)
  ierr = rollcon_table_set_bodies(table_of(itab), youngs, poissons, int(n, c_int64_t), frictions)
end subroutine

!> Sets the callback that rollcon_table_make calls about ten times a second (ROLLCON_PHASE_COMPLIANCE, the iterat.
subroutine rctprg(itab, watch, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, ierr
  procedure(progress_77) :: watch
  type(box), pointer :: b
  b => box_of(itab)
  b%progress => watch
  ierr = rollcon_table_set_progress(table_of(itab), c_funloc(call_progress), c_loc(b))
end subroutine

!> Sets the callback that rollcon_table_make calls about ten times a second (ROLLCON_PHASE_COMPLIANCE, the iterat.
subroutine rctnop(itab, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, ierr
  ierr = rollcon_table_set_progress(table_of(itab), c_null_funptr, c_null_ptr)
end subroutine

!> Asks a running rollcon_table_make to stop.
subroutine rctstp(itab, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, ierr
  ierr = rollcon_table_request_cancel(table_of(itab))
end subroutine

!> Solves the samples of a part of the table that are not there yet, over the context's threads.
subroutine rctmak(itab, ipart, iparts, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, ipart, iparts, ierr
  ierr = rollcon_table_make(table_of(itab), narrow(ipart), narrow(iparts))
end subroutine

!> Returns all samples.
subroutine rctgsm(itab, maxn, samples, icount, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, maxn, icount, ierr
  double precision :: samples(*)
  integer(c_int64_t) :: count_c
  count_c = 0
  ierr = rollcon_table_get_samples(table_of(itab), int(maxn, c_int64_t), samples, count_c)
  icount = int(count_c)
end subroutine

!> Adds the samples that another table of the same settings has (rollcon_table_get_samples).
subroutine rctasm(itab, n, samples, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, n, ierr
  double precision :: samples(*)
  ierr = rollcon_table_add_samples(table_of(itab), int(n, c_int64_t), samples)
end subroutine

!> Writes the table, with what wheels found to calibrate ellipses, to a file, whole or not at all.
subroutine rctsav(itab, path, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, ierr
  character(len=*) :: path
  ierr = rollcon_table_save(table_of(itab), c_text(path))
end subroutine

!> Returns forces and spin moments on body 1 of n contacts, by the signs of rollcon_contact_get_resultant.
subroutine rcteva(itab, n, xinputs, results, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, n, ierr
  double precision :: xinputs(*), results(*)
  ierr = rollcon_table_evaluate(table_of(itab), int(n, c_int64_t), xinputs, results)
end subroutine

!> Does what rollcon_table_evaluate does, and returns derivatives by all inputs, which are continuous.
subroutine rctevd(itab, n, xinputs, results, derivatives, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, n, ierr
  double precision :: xinputs(*), results(*), derivatives(*)
  ierr = rollcon_table_evaluate_derivatives(table_of(itab), int(n, c_int64_t), xinputs, results, derivatives)
end subroutine

!> Returns tangential forces and spin moment on body 1 of a solved contact, from the Hertzian contact that stands.
subroutine rctcon(itab, icon, friction, results, ierr)
  use rollcon_f77_support
  implicit none
  integer :: itab, icon, ierr
  double precision :: friction, results(3)
  ierr = rollcon_table_evaluate_contact(table_of(itab), contact_of(icon), friction, results)
end subroutine
