# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""The plain methods of the classes: one call of the library each."""

from __future__ import annotations

from ctypes import byref, c_double, c_int32, c_int64
from typing import TYPE_CHECKING

from . import _api
from ._arrays import integer_list, reals, room, vector
from ._library import c_path, c_text, check, lib, read_text

if TYPE_CHECKING:
    from os import PathLike

    from numpy import ndarray
    from numpy.typing import ArrayLike


class ContextPlain:

    def set_threads(self, n: int) -> None:
        """Sets the most threads that each solve, each preparation of a body and each list of
        cases, positions or samples in this context may use. Many parts use fewer: the BLAS has
        one thread on frames of less than 2000 nodes and where operators are not dense, sparse
        factorisations have one and that of the BLAS, each case of a list has one, and inside a
        parallel region of the caller everything has one.

        n: 0 to 4096; 0 (standard): as many as OpenMP would use.
        """
        self._call("set_threads", n)

    def set_communicator(self, communicator: int) -> None:
        """Lets the ranks of an MPI program share work. All ranks of the communicator make the
        same calls with the same data. From then on solve_many(), solve_many(), find_wear() and
        make() are joint calls of all ranks, on this context and on all that is made from it: each
        rank solves its share, and every rank gets all results and statuses, the same to the bit
        as on one rank. So is prepare() of finite elements with option factor_ranks, which all
        ranks factorise together. A failure on one rank is a failure on all of them, and the text
        names the rank. The cases left to a rank that is asked to stop are cancelled. This call
        itself is a joint call of all ranks. Calls that are not named here are each rank's own.
        The communicator remains the caller's, who frees it after the context. ERR_STATE: MPI does
        not run. ERR_UNSUPPORTED: the build is without MPI (rollcon_has_feature "mpi").

        communicator: its Fortran handle: MPI_Comm_c2f(communicator) in C, communicator%MPI_VAL in
          mpi_f08.
        """
        self._call("set_communicator", communicator)

    def set_latch(self, on: int = 1) -> None:
        """Turns the latch on or off, for programs that check once, at the end. While the latch is
        on, the first call that fails on the context or on what was made from it is remembered,
        and every later one does nothing and returns the same status, with the same last error.
        Release, retain, request_cancel(), kind() and the calls of this latch work on. Outputs of
        calls that do nothing keep the values that they had, handles to be made are None. Calls
        that have no live handle belong to no context.

        on: 1: on, 0: off (standard); either forgets what was remembered.
        """
        self._call("set_latch", on)

    def check(self) -> int:
        """Returns the first failure since the latch was set, whose text becomes the last error;
        without one the first status > 0 (a solve that did not converge, ...); without either, or
        with the latch off, OK. Any negative status may be returned.
        """
        return self._call("check")


class BodyPlain:

    def set_elastic(self, young: float, poisson: float, tag: int = 0) -> None:
        """Sets an isotropic linear elastic material.

        tag: finite elements: tag of the volume elements that get the material; half-spaces and
          boundary-element bodies, of one material, ignore it.
        young: Young's modulus E > 0, force/length^2.
        poisson: Poisson's ratio, -1 < nu <= 0.5; finite elements take up to 0.4999999, TET4 and
          WEDGE6 up to 0.45 (ERR_UNSUPPORTED from rollcon_body_prepare).
        """
        self._call("set_elastic", tag, young, poisson)

    def set_viscoelastic(self, ratios: ArrayLike, times: ArrayLike, tag: int = 0) -> None:
        """Lets a material of a half-space or a section relax: at a time t after a strain Young's
        modulus is E (1 - sum of ratio (1 - exp(-t / time))), where E is that of set_elastic().
        Poisson's ratio does not change. Such bodies are solved in steady rolling only, at the
        speed of set_rolling(): time steps, conformal contacts, wear, tables and wheels on rails
        end with ERR_UNSUPPORTED. The statistic rolling_resistance is the force that rolling
        costs.

        tag: sections: tag of the elements; half-spaces, of one material, ignore it.
        ratios: part of E that each term loses, 0 <= ratio < 1; their sum is less than 1 - 1e-6.
        times: relaxation time of each term, > 0.
        """
        ratios, ratios_at = reals(ratios)
        times, times_at = reals(times)
        self._call("set_viscoelastic", tag, len(ratios), ratios_at, times_at)

    def set_moduli(self, frequencies: ArrayLike, storage: ArrayLike, loss: ArrayLike,
                   tag: int = 0) -> None:
        """Lets a material relax as set_viscoelastic() does, by moduli over frequency instead of
        terms. They take the place of Young's modulus; set_elastic() gives Poisson's ratio before.
        Sections take the moduli as they are: linear in the logarithm of the frequency between
        points; beyond them the storage modulus stays, and the loss modulus falls with the
        frequency or its inverse. Half-spaces take the Prony series, eight terms a decade, that is
        nearest to them. ERR_ARGUMENT: it is off a modulus by more than 10 %; beyond 2 % the log
        warns.

        tag: sections: tag of the elements; half-spaces, of one material, ignore it.
        frequencies: angular frequencies, > 0 and ascending, radians per time.
        storage: storage modulus at each, > 0, force/length^2.
        loss: loss modulus at each, >= 0, force/length^2.
        """
        frequencies, frequencies_at = reals(frequencies)
        storage, storage_at = reals(storage)
        loss, loss_at = reals(loss)
        self._call("set_moduli", tag, len(frequencies), frequencies_at, storage_at, loss_at)

    def prepare(self) -> None:
        """Checks that the body is complete and its mesh and supports sound, assembles and
        factorises its equations, and freezes it. The call is optional: the first solve does it.
        Calling it again does nothing. (Finite elements with many contact faces and no loads of
        their own are factorised when a frame tells which part of the faces takes part.) ERR_MESH
        names the offending elements or nodes: double nodes, degenerate or repeated elements,
        neighbours of opposite orientation, and for elastic bodies open edges, normals that point
        inwards, more than one outer shell; for finite elements turned elements, faces that meet
        without matching, parts that share no face, tagged faces that are not on the boundary. A
        body equal to one that is prepared in the same context (mesh, tags, material, supports,
        loads, contact faces, options) uses its equations: nothing is assembled again.
        ERR_SINGULAR: the supports leave the body free to move, and the text says how; hold it
        (three nodes not on a line, or a hub), since what is held is also what approach and
        creepage move.
        """
        self._call("prepare")

    @property
    def kind(self) -> int:
        """Returns the model given to create()."""
        kind = c_int32()
        self._call("get_kind", byref(kind))
        return kind.value

    def save(self, path: str | PathLike) -> None:
        """Writes the body, prepared if it was not, to a file: all that was given, the factors,
        and the responses to frames that it has cached (option cache_bytes). The file appears
        whole or not at all; an older one is replaced. Poses belong to contacts and are not
        written. Every library of the same ABI number and format reads it, on any machine of the
        same byte order with IEEE numbers.

        path: name of the file.
        """
        self._call("save", c_path(path))

    def set_traction(self, tag: int, traction: ArrayLike) -> None:
        """Prescribes the traction on the faces with a tag; replaces an earlier one. A pressure on
        the same tag is added to it. Faces without load or support are free.

        tag: of some face (else ERR_ARGUMENT).
        traction: force/length^2 along x y z, -1e100 to 1e100.
        """
        traction, traction_at = vector(traction)
        self._call("set_traction", tag, traction_at)

    def set_body_force(self, tag: int, force: ArrayLike) -> None:
        """Prescribes a force per volume, such as weight, on the finite elements with a tag;
        replaces an earlier one. ERR_STATE: a body without volume elements, and at prepare() a tag
        that no element has.

        tag: of volume elements.
        force: force/length^3 along x y z: density times acceleration; -1e100 to 1e100.
        """
        force, force_at = vector(force)
        self._call("set_body_force", tag, force_at)

    def set_rotation(self, tag: int, density: float, origin: ArrayLike, rate: ArrayLike) -> None:
        """Prescribes the centrifugal forces of a steady rotation on the finite elements with a
        tag, added to set_body_force(); replaces an earlier one. The stiffness is that of the body
        at rest.

        tag: of volume elements.
        density: mass/length^3, 0 to 1e100.
        origin: on the axis of rotation, length.
        rate: along the axis, radian/time.
        """
        origin, origin_at = vector(origin)
        rate, rate_at = vector(rate)
        self._call("set_rotation", tag, density, origin_at, rate_at)

    def set_pressure(self, tag: int, pressure: float) -> None:
        """Prescribes a pressure on the faces with a tag, against their outward normals; replaces
        an earlier one and adds to a traction on the same tag.

        tag: of some face (else ERR_ARGUMENT).
        pressure: force/length^2, -1e100 to 1e100; > 0 compresses.
        """
        self._call("set_pressure", tag, pressure)

    def set_springs(self, tag: int, stiffness: ArrayLike) -> None:
        """Puts the faces with a tag on springs: a rail on its pad, a wheel on the rubber of its
        tyre. The traction of the springs is minus the stiffness times the displacement. Springs
        hold a body as supports do. Faces on springs are no contact faces unless
        set_contact_faces() names them. reaction() returns the forces on held nodes, without those
        of springs.

        tag: of some face (else ERR_ARGUMENT).
        stiffness: along x, y and z, force/length^3, 0 to 1e100.
        """
        stiffness, stiffness_at = vector(stiffness)
        self._call("set_springs", tag, stiffness_at)

    def set_contact_faces(self, tags: ArrayLike) -> None:
        """Says which faces may come into contact: gaps are computed and frames laid on them. The
        standard is all faces that are neither held nor loaded.

        tags: each of some face (else ERR_ARGUMENT).
        """
        tags, tags_at = integer_list(tags, "tags")
        self._call("set_contact_faces", len(tags), tags_at)

    def revolve(self, origin: ArrayLike, axis: ArrayLike) -> None:
        """Turns the plane mesh of a section into a body of revolution: a wheel, a ring, a roller.
        The section's nodes lie in a half plane that ends at the axis. Supports, tractions and
        given displacements are the same all the way round: their components are along x, y and z
        where the section lies, and turn with it. A prepared body has the nodes and faces of the
        surface that its contact edges sweep.

        origin: point of the axis, length.
        axis: direction, of any length but 0.
        """
        origin, origin_at = vector(origin)
        axis, axis_at = vector(axis)
        self._call("revolve", origin_at, axis_at)

    def extrude(self, origin: ArrayLike, direction: ArrayLike, period: float) -> None:
        """Draws the plane mesh of a section along a line: a rail, a raceway strip. The section's
        nodes lie in the plane through the origin at right angles to the line. Supports, tractions
        and given displacements are the same all along the line. The contact's load repeats after
        the period, which is long enough when results do not depend on it. The surface reaches as
        far to both sides of the section as the section is wide: the contact must lie there.

        origin: a point in the section's plane, length.
        direction: of the line, of any length but 0.
        period: length after which all repeats, > 0.
        """
        origin, origin_at = vector(origin)
        direction, direction_at = vector(direction)
        self._call("extrude", origin_at, direction_at, period)

    def read_condensed(self, form: int | str, path: str | PathLike) -> None:
        """Reads what set_condensed() takes from a file: MatrixMarket (array or coordinate,
        general or symmetric), or a stiffness that Abaqus or CalculiX wrote for a substructure
        (*SUBSTRUCTURE GENERATE and *SUBSTRUCTURE MATRIX OUTPUT), whose nodes are found by the
        numbers that they have in the mesh's file, or are in the order in which the substructure
        names them if the body's nodes are from arrays. ERR_IO names file and line.

        form: STIFFNESS or FLEXIBILITY.
        path: name of the file.
        """
        self._call("read_condensed", form, c_path(path))

    def write_condensed(self, form: int | str, path: str | PathLike) -> None:
        """Writes the stiffness or flexibility of a prepared body with a mesh on the nodes of its
        contact faces, in the order of their ids, as a symmetric MatrixMarket file that
        read_condensed() and other programs read. A comment lists the nodes' numbers. A
        flexibility has zeros for components that supports hold; a stiffness then ends with
        ERR_SINGULAR.

        form: STIFFNESS or FLEXIBILITY.
        path: name of the file; an existing one is replaced.
        """
        self._call("write_condensed", form, c_path(path))

    def read_mesh(self, path: str | PathLike, part: str = "") -> None:
        """Takes nodes, elements and names from a file, in place of the whole former mesh: a file
        of Gmsh if the name ends in .msh (versions 2 to 2.2 and 4.1, text or binary), of Abaqus or
        CalculiX if it ends in .inp. Linear and quadratic tetrahedra, wedges and hexahedra for
        finite-element bodies, with the surface elements that have a name; triangles and
        quadrilaterals for all others, also as faces of volume elements that the surface `part`
        names. Orders of nodes are changed to those of rollcon; hexahedra of 27 nodes and wedges
        of 18 lose those inside their faces. Nodes that no element has are left out, the others
        keep the order of the file. Groups are Gmsh's physical groups (nameless ones: "surface 2",
        ...), Abaqus's sets and surfaces. An element's tag is its (first) physical group in Gmsh,
        else 0: tag_group(). ERR_IO names the file, the line (in binary files the byte) and what
        is wrong there; ERR_MESH: no element that the body could take. Shapes are checked by
        prepare().

        path: name of the file, which ends in .msh or .inp.
        part: name of a group (in any case): only its elements; "": those of the whole file.
        """
        self._call("read_mesh", c_path(path), c_text(part, "part"))

    def tag_group(self, group: str, tag: int) -> None:
        """Gives a tag to what the mesh's file has in a group: to volume elements (their
        material), to surface elements and faces (loads, contact faces). A group of nodes alone
        names the faces all of whose nodes it has. Later calls win.

        group: name, in any case; ERR_ARGUMENT lists those that there are.
        tag: that of rollcon_body_add_elements.
        """
        self._call("tag_group", c_text(group, "group"), tag)

    def group_count(self) -> int:
        """Returns how many groups of the mesh's file name something of the body; 0 for a mesh
        that was not read, and for a body that was saved and loaded.
        """
        n = c_int32()
        self._call("get_group_count", byref(n))
        return n.value

    def group_name(self, i: int) -> str:
        """Returns the name of a group in the file's spelling.

        i: 0 to rollcon_body_get_group_count - 1.
        """
        status, text = read_text(lambda *a: lib.rollcon_body_get_group_name(self._handle, i, *a))
        check(status)
        return text

    def set_profile(self, points: ArrayLike, filter_length: float = 0) -> None:
        """Sets a profile through points, in either order: a cubic spline in arc length with two
        derivatives continuous, broken at kinks (turns of 30 degrees and more, three times as much
        as beside them). Points nearer to each other than a thousandth of the usual distance are
        dropped, and where the path goes back and forth again the two points are replaced by their
        mean. The former profile and its place are forgotten. ERR_ARGUMENT names the point at
        which the path turns back.

        points: y and z of each, length.
        filter_length: 0: through the points; else they are smoothed before: waves of this length
          to one half, shorter ones to nothing, longer ones stay; at most the length of the
          profile.
        """
        points, points_at = reals(points, 2)
        self._call("set_profile", len(points), points_at, filter_length)

    def set_profile_shape(self, shape: str, parameters: ArrayLike) -> None:
        """Sets a profile in closed form: "line" half_width, slope; "arc" radius, half_width: the
        circle through (0, 0) about z = -radius, up to half of it; "arcs" y, z and angle of the
        start, then length and curvature (0: a line; positive: from y to z) of each arc, each
        going on in the direction in which the one before ends; "roller" half_width, relief, k (0
        to 1), edge_radius: z = relief ln(1 - k (y/half_width)^2), logarithmic after Lundberg (k =
        1) or Johns and Gohar (k < 1), up to where it is 45 degrees steep, and beyond quarter
        circles of the edge's radius (0: none, sharp ends); relief 0 is a straight roller; "s1002"
        unit: the wheel, in lengths of which `unit` is a millimetre, the middle of the tread at
        (0, 0), z down, the flange at y < 0; "60e1" unit: the head of the rail, upright, its top
        at (0, 0), z down. The former profile and its place are forgotten.

        shape: line, arc, arcs, roller, s1002 or 60e1.
        parameters: of the shape, in its order; radian, length.
        """
        parameters, parameters_at = reals(parameters)
        self._call("set_profile_shape", c_text(shape, "shape"), len(parameters), parameters_at)

    def read_profile(self, path: str | PathLike, unit: float, mirror: int = 0,
                     filter_length: float = 0) -> None:
        """Sets a profile through the points of a file, just as set_profile() does: a file of
        Simpack if the name ends in .prr or .prw (its keys are obeyed except for smoothing), of
        Miniprof if it ends in .ban, .whl or .mpt, else columns, y and z (docs/profiles.md).
        Simpack's and Miniprof's numbers are millimetres. ERR_IO names the line of a file that
        cannot be read, ERR_ARGUMENT that of a point at which the path turns back. z goes where
        the file says: mirror it where the file counts upwards.

        path: name of the file.
        unit: factor on its numbers: length of a millimetre, > 0.
        mirror: 0: no; 1: in y, 2: in z, 3: in both; 4: in z only if the shape shows that z counts
          upwards; 5: as 4, and in y.
        filter_length: that of rollcon_body_set_profile, length.
        """
        self._call("read_profile", c_path(path), unit, mirror, filter_length)

    def add_slice(self, u: float, features: ArrayLike) -> None:
        """Takes the profile as that of one place, a length along the body or an angle round it,
        and waits for the profile of the next: a switch, a crossing or a wheel that is out of
        round is given by several. Each slice is divided at its features, points that correspond
        from slice to slice, and between two that neighbours have in common lines of equal
        fractions of arc length are joined by cubic splines (option smooth_slices). Beyond the
        first and last slice a rail stays as it is there; round a wheel they are periodic. Angles
        count from the body's z about its axis, for a wheel about y from below to ahead. One slice
        is an ordinary profile.

        u: place of the slice, length or radian; none is there yet.
        features: arc lengths from the end where y is less, ascending; < 0: this slice does not
          have it; beyond the end: the end. What lies before the first and behind the last is left
          out.
        """
        features, features_at = reals(features)
        self._call("add_slice", u, len(features), features_at)

    def read_slices(self, path: str | PathLike, mm: float, unit: float, mirror: int = 0,
                    filter_length: float = 0) -> None:
        """Reads all slices of a rail (.slcs) or wheel (.slcw) from a list. Its places are lengths
        or angles, and it names the files of the profiles (docs/profiles.md). The former profile,
        slices and waves are forgotten.

        path: name of the list.
        mm: length of a millimetre, in which the list counts places and features, > 0.
        unit: factor on the profiles' numbers: that of rollcon_body_read_profile.
        mirror: 0: no; 1: in y, 2: in z, 3: in both.
        filter_length: that of rollcon_body_set_profile, length.
        """
        self._call("read_slices", c_path(path), mm, unit, mirror, filter_length)

    def add_wave(self, amplitude: float, wavelength: float, phase: float) -> None:
        """Adds amplitude sin(2 pi u / wavelength + phase) to z of the profile, at the length or
        angle u: corrugation of a rail, a polygon of a wheel. Several add up.

        amplitude: length.
        wavelength: length along a rail; round a wheel an angle, 2 pi over a whole number.
        phase: radian.
        """
        self._call("add_wave", amplitude, wavelength, phase)

    def write_profile(self, path: str | PathLike, unit: float) -> None:
        """Writes points of the profile to a file: of Simpack if the name ends in .prr or .prw,
        else two columns. A profile through points is the same when read again, one in closed form
        within 1e-9 of its size where its curvature is continuous. The file appears whole or not
        at all.

        path: name of the file.
        unit: divides its numbers: length of a millimetre, > 0.
        """
        self._call("write_profile", c_path(path), unit)

    def extrude_profile(self, origin: ArrayLike, along: ArrayLike, z_axis: ArrayLike) -> None:
        """Makes the profile, moved along a straight line without end, the surface of the body: x
        of the profile points along `along`, z along z_axis, y along z_axis x along.

        origin: where the profile's point (0, 0) lies, length.
        along: direction, of any length but 0.
        z_axis: direction, not parallel to along; what is normal to it counts.
        """
        origin, origin_at = vector(origin)
        along, along_at = vector(along)
        z_axis, z_axis_at = vector(z_axis)
        self._call("extrude_profile", origin_at, along_at, z_axis_at)

    def revolve_profile(self, origin: ArrayLike, axis: ArrayLike, radius: float) -> None:
        """Makes the profile, turned about an axis, the surface of the body: its points lie at y
        along the axis and at radius + z away from it. An axis of the opposite direction mirrors
        it in y.

        origin: point of the axis at which y is 0, length.
        axis: direction of y, of any length but 0.
        radius: radius at z = 0, length; radius + z >= 0 all along the profile.
        """
        origin, origin_at = vector(origin)
        axis, axis_at = vector(axis)
        self._call("revolve_profile", origin_at, axis_at, radius)

    def profile_length(self) -> float:
        """Returns the arc length of the profile. It works before prepare()."""
        length = c_double()
        self._call("get_profile_length", byref(length))
        return length.value

    def profile_point(self, s: float) -> tuple[ndarray, ndarray, float]:
        """Returns point, tangent and curvature of the profile at an arc length, counted from the
        end where y is less. It works before prepare().

        s: 0 to rollcon_body_get_profile_length, length.
        point: y and z, length.
        tangent: y and z of the unit vector in the direction of greater arc length.
        """
        point, point_at = room(2)
        tangent, tangent_at = room(2)
        curvature = c_double()
        self._call("get_profile_point", s, point_at, tangent_at, byref(curvature))
        return point, tangent, curvature.value

    @property
    def size(self) -> tuple[int, int]:
        """Returns the nodes and elements given so far; 0 for bodies without a mesh. It works
        before prepare().
        """
        nodes = c_int64()
        elements = c_int64()
        self._call("get_size", byref(nodes), byref(elements))
        return nodes.value, elements.value

    def reaction(self) -> tuple[ndarray, ndarray]:
        """Returns the resultant of the forces that the supports exert on the body under its own
        loads and given displacements, and its moment about the origin of the body's axes. It
        balances the loads up to the error of the discretisation: a measure of it.

        force: force.
        moment: force x length.
        """
        force, force_at = room(3)
        moment, moment_at = room(3)
        self._call("get_reaction", force_at, moment_at)
        return force, moment

    def stat(self, name: str) -> float:
        """Returns one number about a prepared body: unknowns, assemblies, factorisations,
        condition, seconds, bytes; 0 for bodies without equations. Names: rollcon_stat_info.
        Counts are those of the equations, which equal bodies of a context have in common:
        "shared" is 1 for a body for which nothing was assembled because an equal one was prepared
        before, "loaded" for one from a file.
        """
        value = c_double()
        self._call("get_stat", c_text(name, "name"), byref(value))
        return value.value


class ContactPlain:

    def frame_from_file(self, path: str | PathLike, part: str = "") -> None:
        """Makes the surface elements of a mesh file the frame; replaces frame and all that was
        given for its nodes. The files are those of read_mesh(). Tags of elements are Gmsh's
        physical groups, else 0.

        path: name of the file, which ends in .msh or .inp.
        part: name of a group (in any case): only its elements; "": those of the whole file.
        """
        self._call("frame_from_file", c_path(path), c_text(part, "part"))

    def frame_from_body(self, which: int | str, tag: int) -> None:
        """Makes the faces of a body that carry a tag the frame: replaces nodes and elements of
        the frame and forgets the gap array and the creep and friction fields. Its nodes are those
        of the faces, in the order of their ids in the body, and follow the body's pose. For
        finite-element bodies with tri6 among these faces (tet10, the ends of wedge15) they are
        the corners alone, and the frame's elements linear: size() tells how many. Faces of body 2
        are turned over, so that the frame's normals point out of body 1.

        which: BODY1 or BODY2, prepared or not.
        tag: of some element of it (else ERR_ARGUMENT).
        """
        self._call("frame_from_body", which, tag)

    def frame_rectangle(self, type: int | str, nx: int, ny: int, x_least: float, x_greatest: float,
                        y_least: float, y_greatest: float) -> None:
        """Makes a rectangle in the present plane of the axes the frame: nx by ny elements of one
        size. Replaces nodes and elements of the frame and forgets the gap array and the creep and
        friction fields. Nodes come line by line along t1, from the least y. Linear quadrilaterals
        make a regular frame, which half-spaces solve by fast Fourier transforms.

        type: TRI3, TRI6, QUAD4, QUAD8 or QUAD9.
        nx: elements along t1, 1 to 30000.
        ny: elements along t2, 1 to 30000.
        x_least: along t1 from the origin of the axes, length.
        x_greatest: > x_least.
        y_least: along t2 from the origin of the axes, length.
        y_greatest: > y_least.
        """
        self._call("frame_rectangle", type, nx, ny, x_least, x_greatest, y_least, y_greatest)

    def frame_ellipse(self, along: int, across: int, a: float, b: float, angle: float = 0) -> None:
        """Makes an ellipse in the present plane of the axes the frame: strips along the rolling
        direction, like those of frame_strips(), on lines that lie closer towards the sides. It is
        meant to be the contact itself.

        along: elements along each strip, 2 to 10000.
        across: strips, 2 to 10000.
        a: semi-axis at `angle` from t1, length, > 0.
        b: the other semi-axis, length, > 0.
        angle: radian, from t1 towards t2.
        """
        self._call("frame_ellipse", along, across, a, b, angle)

    def frame_strips(self, along: int, lines: ArrayLike) -> None:
        """Makes strips along the rolling direction the frame: what the contact covers of lines at
        ascending y. Each has along + 1 nodes from end to end, close together near the ends, where
        tractions grow like the square root of the distance. Nodes come line by line. Replaces the
        frame just as frame_rectangle() does. Nodes on the outline carry no traction (EXCLUDED):
        bodies that overlap there are reported as RIM_CONTACT.

        along: elements along each strip, 2 to 10000.
        lines: y of each line, ascending, and the least and greatest x that the contact covers of
          it, the first less than the second (equal on the first and the last line, if it is a
          point), length.
        """
        lines, lines_at = reals(lines, 3)
        self._call("frame_strips", along, len(lines), lines_at)

    def frame_automatic(self) -> None:
        """Leaves the frame to the library, which is the state of a new contact: solves then find
        the contact from the gap (of the bodies' meshes and profiles, set_gap_quadratic(),
        set_gap_grid()) and from load or approach, and lay strips on it whose ends are found with
        the pressures, finer ones until the option frame_accuracy is met or INACCURATE says that
        it was not. Friction forces, spin moment and creepages under Coulomb's law, and their
        sensitivities, are extrapolated from two counts of strips. Where strips do not fit, two
        frames are fitted to the edge of each patch, and forces, moment, approach, creepages,
        their sensitivities and the statistics contact_area and error_estimate are extrapolated
        from both. Nodes and fields are those of the finest frame, which the next solve may
        replace. The error is that of the frame: what a body's own mesh adds is not counted.
        """
        self._call("frame_automatic")

    def set_axes(self, origin: ArrayLike, rolling: ArrayLike, normal: ArrayLike) -> None:
        """Sets the axes: n along `normal`, t1 along the projection of `rolling` on the tangent
        plane, t2 = n x t1. Vectors need not have unit length. Creepages, spin and moments belong
        to the origin.

        origin: length.
        rolling: rolling direction, not parallel to normal.
        normal: outward normal of body 1.
        """
        origin, origin_at = vector(origin)
        rolling, rolling_at = vector(rolling)
        normal, normal_at = vector(normal)
        self._call("set_axes", origin_at, rolling_at, normal_at)

    def set_gap(self, gap: ArrayLike) -> None:
        """Sets the gap of the undeformed bodies at approach 0, node by node; replaces a quadratic
        gap. Where a body has a mesh or a profile and no gap is given, it is measured along the
        frame's normals between the surfaces; a body without either is then the plane through the
        origin of the axes. These normals are level along the rolling direction (tractions()): a
        gap along the surface's own would be longer by half the square of the angle between them.

        gap: length.
        """
        gap, gap_at = reals(gap)
        self._call("set_gap", len(gap), gap_at)

    def set_gap_quadratic(self, a: float, b: float, c: float = 0.0) -> None:
        """Sets the gap of the undeformed bodies at approach 0 to h = a x^2 + b y^2 + c x y in the
        axes (t1, t2); replaces a gap array.

        a: 1/length; 1/(2 R) for a sphere.
        b: 1/length.
        c: 1/length.
        """
        self._call("set_gap_quadratic", a, b, c)

    def set_gap_grid(self, nx: int, x_least: float, x_greatest: float, y_least: float,
                     y_greatest: float, gap: ArrayLike) -> None:
        """Sets the gap of the undeformed bodies at approach 0 by its values on a regular grid in
        the axes (t1, t2): between the points it is bicubic, with continuous slopes. Values that
        are +infinity say that a body is not there: the contact ends at the cells beside them, and
        there only (frame_automatic()); the grid's own rim is no such edge. Replaces a gap array
        or a quadratic gap. A frame must lie within the cells that have a gap.

        nx: points along t1 of each line, 2 or more.
        x_least: x of the first point of a line, length.
        x_greatest: x of the last point, length.
        y_least: y of the first line, length.
        y_greatest: y of the last line, length.
        gap: line by line, length.
        """
        gap, gap_at = reals(gap)
        self._call("set_gap_grid", nx, x_least, x_greatest, y_least, y_greatest, len(gap), gap_at)

    def set_rolling(self, speed: float) -> None:
        """Sets the speed V at which the contact travels over both surfaces along +t1 (omega R for
        a wheel). Forgets the velocity of the contact (set_velocity()).

        speed: V > 0, length/time.
        """
        self._call("set_rolling", speed)

    def set_creep(self, longitudinal: float = 0.0, lateral: float = 0.0, spin: float = 0.0) -> None:
        """Prescribes creepages and spin by motion: rigid slip c = V (longitudinal - spin y,
        lateral + spin x) of body 1 relative to body 2. The call stands for three calls of
        prescribe(), and forgets the velocities of set_velocity().

        longitudinal: creepage along t1, dimensionless.
        lateral: creepage along t2, dimensionless.
        spin: 1/length.
        """
        self._call("set_creep", longitudinal, lateral, spin)

    def set_step(self, kind: int | str, dt: float = 0.0) -> None:
        """Makes every solve from now on a step in time of length dt; STEADY makes it a steady
        state again. ROLLING_STEP: the contact rolls on by V dt, creepages and spin mean what they
        mean in steady rolling. SHIFT_STEP: no rolling; what is prescribed as creepages is the
        shift of body 1 against body 2 in this step (longitudinal and lateral, length) and its
        turn (spin, radians), and so it is in what motion() returns; velocities and creep fields
        count by dt. Loads, motions, approach, friction and gap may change from step to step. The
        first step starts from the steady state solved last, or from rest where there is none
        (reset()); a step that fails does not change the one before. A frame that follows its
        contact takes the past along (half-spaces and rigid bodies; meshed bodies: ERR_STATE from
        the solve).

        kind: STEADY, ROLLING_STEP or SHIFT_STEP.
        dt: > 0, time; ignored if the kind is STEADY.
        """
        self._call("set_step", kind, dt)

    def set_velocity(self, which: int | str, velocity: ArrayLike, angular_velocity: ArrayLike,
                     point: ArrayLike) -> None:
        """Says how a body or the contact itself moves: its point at x has the velocity v + omega
        x (x - point). Creepages and spin then follow from the velocities of both bodies; motion()
        returns them after a solve. Where bodies have profiles or meshes the relative velocity is
        taken between their surfaces, node by node: rolling radius and spin vary over the contact.
        The speed V follows from the velocity of the contact, less the mean of both bodies'; where
        that is not given it is the one set by set_rolling(); one of the two is needed. A body
        whose velocity is not given is at rest. What was set last counts: set_creep() forgets all
        velocities, prescribe() replaces one creepage or the spin and leaves the rest of the slip.

        which: BODY1, BODY2 or CONTACT_ITSELF.
        velocity: velocity of its point at `point`, length/time.
        angular_velocity: 1/time.
        point: in space, length.
        """
        velocity, velocity_at = vector(velocity)
        angular_velocity, angular_velocity_at = vector(angular_velocity)
        point, point_at = vector(point)
        self._call("set_velocity", which, velocity_at, angular_velocity_at, point_at)

    def set_creep_field(self, slip: ArrayLike | None) -> None:
        """Adds a rigid slip velocity given node by node to that of creepages and spin. On a
        curved frame its components are along the local axes of each node.

        slip: velocity along t1 and t2, length/time.
        """
        if slip is None:
            slip = ()
            slip_at = None
        else:
            slip, slip_at = reals(slip, 2)
        self._call("set_creep_field", len(slip), slip_at)

    def prescribe(self, direction: int | str, how: int | str, value: float) -> None:
        """Prescribes one direction by motion or by force; the other quantity is found by the
        solve. Forces act on body 1. A tilt turns body 1 against body 2 about t1 or t2 through the
        origin: at (x, y) of a flat frame it takes (tilt 1) y - (tilt 2) x from the gap. Its
        moment is that of the contact's tractions on body 1 about the same axis: a load F that
        presses body 1 at (x, y) asks for the moments -F y (tilt 1) and F x (tilt 2). The standard
        is all by motion, 0.

        direction: LONGITUDINAL, LATERAL, NORMAL, SPIN, TILT_1 or TILT_2.
        how: BY_MOTION or BY_FORCE.
        value: motion: creepage, spin (1/length), approach (length), tilt (radian, small); force:
          force, moment about the axis through the origin, and for NORMAL the compressive load >=
          0.
        """
        self._call("prescribe", direction, how, value)

    def set_friction_memory(self, length: float, least_speed: float) -> None:
        """Gives friction that falls with the slip speed a memory: for a particle of the surface d
        mu/dt = -max(s, s0)/dc (mu - mu_s(s)), where mu_s is what the law without memory says;
        where surfaces come into contact mu is that at rest. Coefficients then follow the whole
        solution and are found by solves with given ones (statistics friction_rounds and
        friction_change). The memory holds for whatever law is set, if it falls, else the solve
        ends with ERR_STATE. It is for steady rolling only (steps in time: ERR_UNSUPPORTED from
        the solve), and there are no sensitivities (ERR_UNSUPPORTED).

        length: dc, length of slip, >= 0; 0: no memory.
        least_speed: s0 >= 0, slip speed, length/time.
        """
        self._call("set_friction_memory", length, least_speed)

    def set_layer(self, flexibility: float, stress: float = 0, hardening: float = 0) -> None:
        """Puts a thin layer between the bodies that gives way along the surface in proportion to
        the tangential traction at each point, in series with both: thickness over shear modulus.
        The displacements of the bodies do not contain it, slip does. The monolithic system
        (set_procedure()) does not take it (ERR_UNSUPPORTED at the solve). With a yield stress the
        layer, which may be stiff (flexibility 0), flows along the surface under a traction of
        stress + hardening times the flow since the surfaces came into contact. Where that is less
        than friction it bounds the traction, and what friction would call slip is flow. It flows
        with the laws "coulomb", "temperature", and those that fall with a memory; others end with
        ERR_UNSUPPORTED at the solve. The flow is found by solves with given coefficients, as with
        set_friction_memory(): for steady rolling only, without sensitivities.

        flexibility: thickness over shear modulus, length^3/force, >= 0.
        stress: >= 0, force/length^2; 0: never flows, and with flexibility 0 there is no layer.
        hardening: force/length^3; negative: softening.
        """
        self._call("set_layer", flexibility, stress, hardening)

    def set_friction_across(self, points: ArrayLike | None) -> None:
        """Sets friction coefficients along t2, linear between points and constant beyond them,
        for frames of any maker: they replace the (greatest) coefficient of set_friction(), where
        set_friction_field() gives none.

        points: y along t2 from the origin of the axes, ascending, length, and mu >= 0.
        """
        if points is None:
            points = ()
            points_at = None
        else:
            points, points_at = reals(points, 2)
        self._call("set_friction_across", len(points), points_at)

    def set_heat(self, which: int | str, conductivity: float, heat_capacity: float,
                 temperature: float) -> None:
        """Says what a body does with heat, for the surface temperatures of a solution
        (temperatures_at(), FIELD_TEMPERATURE) and for friction that depends on them. The call is
        needed for both bodies; one of them may take up no heat.

        which: BODY1 or BODY2.
        conductivity: >= 0, power/(length temperature).
        heat_capacity: >= 0, energy/(volume temperature): density times specific heat.
        temperature: temperature far from the contact.
        """
        self._call("set_heat", which, conductivity, heat_capacity, temperature)

    def set_friction_field(self, mu: ArrayLike | None) -> None:
        """Sets the friction coefficient node by node, in place of that of set_friction().

        mu: >= 0.
        """
        if mu is None:
            mu = ()
            mu_at = None
        else:
            mu, mu_at = reals(mu)
        self._call("set_friction_field", len(mu), mu_at)

    def set_procedure(self, procedure: str) -> None:
        """Chooses one of the published solution procedures in place of the library's own
        iteration, by options and values: "system=monolithic jacobian=reduced"; what is not named
        has its standard value, and "" is the library's own. rollcon_option_info lists them
        (OF_PROCEDURE). Combinations that make no sense are ERR_OPTION when a solve begins, builds
        without the procedures ERR_UNSUPPORTED.

        procedure: option=value, separated by blanks.
        """
        self._call("set_procedure", c_text(procedure, "procedure"))

    def request_cancel(self) -> None:
        """Asks a running solve to stop (an atomic store): at its next iteration, or, while bodies
        and operators are prepared, within moments; only a sparse factorisation runs to its end.
        The solve returns CANCELLED; the contact stays usable. What was cancelled during its
        preparation has no results, and the next solve prepares it anew.
        """
        self._call("request_cancel")

    def repeat_step(self) -> None:
        """Lets the next solve start from where the last step did, as if that had not been, for a
        host that tries loads or motions again before it goes on. It works once after each step.
        """
        self._call("repeat_step")

    def past_set(self, past: ArrayLike) -> None:
        """Lets the next step start from what past_get() gave. Prepares bodies and frame where
        nothing was solved yet. Numbers of another frame, or that were changed, are refused and do
        not change the past; results of the last solve are gone.

        past: what rollcon_contact_past_get gave.
        """
        past, past_at = reals(past)
        self._call("past_set", len(past), past_at)

    def reset(self) -> None:
        """Forgets the solution, the warm start, the iteration log and what was before a time step
        (bodies are at rest); keeps the scene and all that was computed for the frame.
        """
        self._call("reset")

    @property
    def size(self) -> tuple[int, int]:
        """Returns the nodes and elements of the frame. It works before a solve."""
        nodes = c_int64()
        elements = c_int64()
        self._call("get_size", byref(nodes), byref(elements))
        return nodes.value, elements.value

    def resultant(self, axes: int | str = _api.LOCAL) -> tuple[ndarray, ndarray]:
        """Returns the resultant force on body 1 and its moment about the origin of the axes.

        axes: LOCAL or GLOBAL.
        force: force.
        moment: force x length.
        """
        force, force_at = room(3)
        moment, moment_at = room(3)
        self._call("get_resultant", axes, force_at, moment_at)
        return force, moment

    def motion(self) -> tuple[float, ndarray]:
        """Returns approach, creepages and spin, given or found for prescribed forces.

        creep: longitudinal, lateral (dimensionless), spin (1/length).
        """
        approach = c_double()
        creep, creep_at = room(3)
        self._call("get_motion", byref(approach), creep_at)
        return approach.value, creep

    def tilt(self) -> ndarray:
        """Returns rotations of body 1 against body 2 about t1 and t2, given or found for
        prescribed moments (prescribe()).

        tilt: radian.
        """
        tilt, tilt_at = room(2)
        self._call("get_tilt", tilt_at)
        return tilt

    def sensitivity(self, parameter: int | str) -> tuple[ndarray, ndarray, float, ndarray]:
        """Returns the derivatives of what resultant() (local axes) and motion() give, by one
        parameter. A direction stands for the value last solved with there: creepage, spin or
        approach where the motion was prescribed; force, spin moment or compressive load where the
        force was; motions that were found then change with it. FRICTION stands for a factor, now
        1, on every friction coefficient: for d/dmu of a uniform mu divide by mu. They are those
        of Newton's system at the solution, the state of every node held: at most one
        factorisation for all parameters (one more for NORMAL where pressures stand alone) and one
        right side each; kept until the next solve. After NO_CONTACT only a prescribed motion's
        derivative by itself is not 0. ERR_STATE: no solution, one that did not converge, or the
        parameter is a tangential force or spin moment without friction. ERR_SINGULAR: a load at
        the limit of friction. ERR_UNSUPPORTED: friction follows the whole solution (of
        temperature, with a memory, of a layer that flows).

        parameter: LONGITUDINAL, LATERAL, NORMAL, SPIN, FRICTION, TILT_1 or TILT_2.
        force: derivative of the force on body 1, local axes.
        moment: derivative of its moment about the origin, local axes.
        creep: derivatives of longitudinal and lateral creepage and spin.
        """
        force, force_at = room(3)
        moment, moment_at = room(3)
        approach = c_double()
        creep, creep_at = room(3)
        self._call("get_sensitivity", parameter, force_at, moment_at, byref(approach), creep_at)
        return force, moment, approach.value, creep

    def write_loads(self, which: int | str, path: str | PathLike) -> None:
        """Writes what the contact does to a body with a mesh as forces on the body's own nodes,
        in its axes: the integrals of the last solve's tractions times the nodes' shape functions.
        A name that ends in .inp gets *CLOAD cards of Abaqus and CalculiX, of components that are
        not zero; one that ends in .mtx a MatrixMarket vector of x, y, z of each node in the order
        of the body. Nodes have the numbers of the file that the mesh was read from; of arrays the
        first is 1. The sums of force and moment are those of the contact (resultant(); the second
        body takes the opposite): a frame and curved faces under it are not one surface, and what
        is missing is spread linearly over the loaded nodes. The file tells the resultant about
        the origin of the body's axes, and by how much that moved the forces. Forces of the body's
        own loads and supports are not among them. ERR_UNSUPPORTED: a body without a mesh, or a
        build without finite elements.

        which: BODY1 or BODY2.
        path: name of the file, which ends in .inp or .mtx; an existing one is replaced.
        """
        self._call("write_loads", which, c_path(path))

    def fatigue_index(self, shear_yield: float) -> float:
        """Returns the railways' index of surface-initiated rolling contact fatigue of wheels,
        after Ekberg, Kabo and Andersson (bearings: find_stress()), FI = sqrt(F1^2 + F2^2)/Fn - 2
        A k/(3 Fn), with the area A in contact (statistic contact_area; pi a b for an ellipse) and
        the yield stress k in shear; positive where fatigue is to be expected. ERR_STATE: no
        solution, or no normal force. The wear number T-gamma, force times creepage, is the
        statistic t_gamma.

        shear_yield: k, force/length^2, above 0.
        """
        index = c_double()
        self._call("get_fatigue_index", shear_yield, byref(index))
        return index.value

    def equivalent_ellipse(self) -> tuple[ndarray, ndarray]:
        """Returns the Hertzian contact that stands for this one, in the form of inputs of
        evaluate(). The ellipse has the area in contact (statistic contact_area) and, along over
        across, the second moments of the pressures. Load, creepages and spin are those of the
        solution, the latter by least squares weighted with pressure about its centre; the
        solution needs no friction. Friction is the mean over the pressure, for falling laws at
        the speed of the rigid slip; inputs[2] may be replaced. Elastic constants: mean values of
        1/G and nu/G; where pressure strains one body more than the other, the longitudinal
        creepage has the mean difference of these strains on top. A moment about the contact's
        origin has center[0] F2 - center[1] F1 more than one about the centre. ERR_STATE: no
        solution, no load, several patches far apart, or a shift; ERR_UNSUPPORTED: a body has a
        mesh, a layer is between the bodies, or friction depends on the direction.

        inputs: shear modulus, Poisson's ratio, friction, semi-axes along and across the rolling
          direction, load, longitudinal and lateral creepage, spin.
        center: along t1 and t2.
        """
        inputs, inputs_at = room(9)
        center, center_at = room(2)
        self._call("get_equivalent_ellipse", inputs_at, center_at)
        return inputs, center

    def stat(self, name: str) -> float:
        """Returns one number about the last solve: residuals, error estimates, iterations, areas,
        power, seconds, bytes. Names: rollcon_stat_info; meanings: docs/theory.md, section 8. An
        error estimate is computed when one of its numbers is asked for, at about the price of a
        solve.
        """
        value = c_double()
        self._call("get_stat", c_text(name, "name"), byref(value))
        return value.value

    def plan(self) -> str:
        """Returns how the last solve was done (sizes, schemes, linear solver and why), as text
        for people.
        """
        status, text = read_text(lambda *a: lib.rollcon_contact_get_plan(self._handle, *a))
        check(status)
        return text

    def write(self, path: str | PathLike) -> None:
        """Writes frame and fields, in global axes, as a VTU file for ParaView and meshio. A field
        beyond the range of double precision is ERR_NONFINITE; nothing is written.

        path: name of the file; an existing one is replaced.
        """
        self._call("write", c_path(path))


class WheelrailPlain:

    def set_track(self, gauge: float, gauge_height: float, cant: float) -> None:
        """Says where the rails lie: each is canted, its top is at z = 0, and its gauge side is
        half the gauge from the middle of the track.

        gauge: > 0, length.
        gauge_height: below the top of the rails, where the gauge is measured; length; 0 places
          the rail by its profile's origin: half the gauge from the middle, z = 0.
        cant: of each rail towards the middle of the track, radian, -0.5 to 0.5; 0 if the profile
          is canted already.
        """
        self._call("set_track", gauge, gauge_height, cant)

    def set_wheelset(self, back_to_back: float, flange_back: float, radius: float) -> None:
        """Sets the dimensions of the wheelset.

        back_to_back: distance between the backs of the flanges, > 0, length.
        flange_back: y of the flange's back in the profile of the wheel, length.
        radius: radius at the profile's z = 0, > 0, length; radius + z > 0 all along the profile.
        """
        self._call("set_wheelset", back_to_back, flange_back, radius)

    def place_rail(self, y: float, z: float, cant: float) -> None:
        """Places the rail by the origin of its profile in the track, in place of set_track().
        Deviations of the rail roll about this origin then.

        y: distance of the origin from the middle of the track, > 0 towards the side of the rail,
          length.
        z: of the origin, length.
        cant: inwards, -0.5 to 0.5, radian; about the origin.
        """
        self._call("place_rail", y, z, cant)

    def set_roller(self, radius: float, rate: float) -> None:
        """Makes the rail a roller of a test rig: its profile turns about an axis along y, one
        radius below the top of the rail, or below the origin of a rail that is placed by its
        origin (place_rail()). The contact moves over the roller at the rate times the radius plus
        the forward speed of the wheelset, which is 0 on a rig. Entry 0 of the position is the
        distance of the wheelset from the place above the axis, length. ERR_ARGUMENT: the track
        has a cant. The solve refuses profiles that vary, tables, conformal contacts and sections
        (ERR_UNSUPPORTED).

        radius: of the roller, > 0, length; more than its profile is deep; 0: a rail (standard).
        rate: at which the roller turns about y, 1/time; > 0 where wheels on it roll forward.
        """
        self._call("set_roller", radius, rate)

    def set_step(self, kind: int | str, dt: float = 0.0) -> None:
        """Makes every solve from now on a step in time of length dt; STEADY makes it a steady
        state again. ROLLING_STEP: the wheel rolls on as its velocity says. SHIFT_STEP: nothing
        rolls, velocities times dt are shifts, and the forward speed may be 0. Patches carry their
        tractions from step to step and hand them on by place where they move, part or merge. The
        first step starts from the steady state that was solved last, or from rest if there is
        none; for rest call reset(). A step that fails keeps the state before it. The solve
        refuses sections, tables and conformal contacts, and calls with lists of positions refuse
        steps (ERR_UNSUPPORTED).

        kind: STEADY, ROLLING_STEP or SHIFT_STEP.
        dt: > 0, time; ignored if the kind is STEADY.
        """
        self._call("set_step", kind, dt)

    def repeat_step(self) -> None:
        """Takes the last step back: the next solve starts from where that step started. This is
        possible once after each step that succeeded (else ERR_STATE).
        """
        self._call("repeat_step")

    def past_set(self, past: ArrayLike) -> None:
        """Lets the next step start from numbers that past_get() gave; they are copied. Track and
        wheelset must be set (ERR_STATE). ERR_ARGUMENT: the numbers were changed, or belong to the
        other side or to other elastic constants; the past stays as it was. The results of the
        last solve are gone.

        past: what rollcon_wheelrail_past_get gave.
        """
        past, past_at = reals(past)
        self._call("past_set", len(past), past_at)

    def set_tape_circle(self, y: float) -> None:
        """Says where on the wheel's profile the radius of set_wheelset() is measured, after that
        call, which takes it where the profile has z = 0.

        y: of the tape circle in the profile, length.
        """
        self._call("set_tape_circle", y)

    def set_flexibility(self, displacement: ArrayLike, rate: ArrayLike) -> None:
        """Displaces the wheel in the axes of the wheelset, which bends, and says how that
        changes. The wheel is displaced at the origin of its profile below the axle, and turned
        there. The standard is 0.

        displacement: along x, y, z, length; about x, z, y (roll, yaw, pitch), radian; roll and
          yaw -0.5 to 0.5.
        rate: rates of these, length/time and 1/time.
        """
        displacement, displacement_at = vector(displacement, 6)
        rate, rate_at = vector(rate, 6)
        self._call("set_flexibility", displacement_at, rate_at)

    def set_rail_springs(self, stiffness: ArrayLike, force: ArrayLike) -> None:
        """Puts the rail on springs along y and z of the track: beside its deviation it gives way
        until stiffness times deflection is the force of the wheel on it plus the force given
        here. Statistics rail_deflection_y and _z are what was found.

        stiffness: along y and z, force/length, > 0, or 0: rigid (standard).
        force: on the rail beside that of the wheel, along y and z.
        """
        stiffness, stiffness_at = vector(stiffness, 2)
        force, force_at = vector(force, 2)
        self._call("set_rail_springs", stiffness_at, force_at)

    def set_rail_deviation(self, deviation: ArrayLike, rate: ArrayLike) -> None:
        """Sets the deviation of the rail from its place in the track and how it changes:
        irregularities, and rails that give way. The standard is 0.

        deviation: along y and z, length; roll, radian, about the point where the gauge is
          measured, at the height of the rails' top, -0.5 to 0.5.
        rate: rates of these, length/time and 1/time.
        """
        deviation, deviation_at = vector(deviation)
        rate, rate_at = vector(rate)
        self._call("set_rail_deviation", deviation_at, rate_at)

    def set_position(self, position: ArrayLike) -> None:
        """Sets the position of the wheelset. z = 0 is where the tread's datum of a centred
        wheelset is at the height of the rails' top; z is not used where a vertical force is
        prescribed (statistic "z" is what was found), except as the start of the search.

        position: of the wheelset's centre: x, y, z, length; roll, yaw and pitch, radian; roll and
          yaw -0.5 to 0.5.
        """
        position, position_at = vector(position, 6)
        self._call("set_position", position_at)

    def set_velocity(self, velocity: ArrayLike) -> None:
        """Sets the velocity of the wheelset.

        velocity: rates of the position, length/time and 1/time; the forward speed, the first, is
          not 0 but on a roller or in a shift; the pitch rate of a wheel that rolls forward is
          negative.
        """
        velocity, velocity_at = vector(velocity, 6)
        self._call("set_velocity", velocity_at)

    def prescribe_vertical(self, how: int | str, force: float = 0) -> None:
        """Prescribes the height of the wheelset by motion, from its position (standard), or by
        the vertical force; z is then found by the solve.

        how: BY_MOTION or BY_FORCE.
        force: force of this wheel on its rail, along z of the track, >= 0; ignored by motion.
        """
        self._call("prescribe_vertical", how, force)

    def prescribe_longitudinal(self, how: int | str, force: float = 0) -> None:
        """Prescribes the pitch rate by motion, from the velocity (standard), or the force on the
        wheel along the wheelset's x; the pitch rate is then found by the solve, from that of the
        velocity on (statistic "pitch_rate").

        how: BY_MOTION or BY_FORCE.
        force: on the wheel, forwards; ignored by motion.
        """
        self._call("prescribe_longitudinal", how, force)

    def set_law_by_angle(self, law: str, points: int, parameters: ArrayLike) -> None:
        """Sets a law whose parameters follow the inclination of the rail's surface, linear
        between points and constant beyond them: lubricated gauge faces under dry heads. The
        inclination is atan dz/dy of a right rail with y to the right and z down, its cant
        included, its deviation not: negative on the gauge face; left rails are mirrored, so that
        one table serves both. The greatest coefficient follows the inclination across a patch,
        the form of the law is that at the reference of the patch.

        law: a name of a law (rollcon_contact_set_friction).
        points: 1 to 1000.
        parameters: for each point its angle, ascending, radian, and then the parameters of the
          law there.
        """
        parameters, parameters_at = reals(parameters)
        self._call("set_law_by_angle", c_text(law, "law"), points, len(parameters), parameters_at)

    def set_friction_memory(self, length: float, least_speed: float) -> None:
        """Gives friction that falls with the slip speed a memory, as for a contact.

        length: length of slip, >= 0; 0: no memory.
        least_speed: >= 0, slip speed, length/time.
        """
        self._call("set_friction_memory", length, least_speed)

    def set_layer(self, flexibility: float, stress: float = 0, hardening: float = 0) -> None:
        """Puts a thin layer between wheel and rail, as between the bodies of a contact.

        flexibility: thickness over shear modulus, length^3/force, >= 0.
        stress: >= 0, force/length^2; 0: never flows, and with flexibility 0 there is no layer.
        hardening: force/length^3; negative: softening.
        """
        self._call("set_layer", flexibility, stress, hardening)

    def set_heat(self, which: int | str, conductivity: float, heat_capacity: float,
                 temperature: float) -> None:
        """Says what wheel or rail does with heat, for the temperatures of the contacts of patches
        (temperatures_at()) and for friction that depends on them. The call is needed for both.

        which: WHEEL or RAIL.
        conductivity: >= 0, power/(length temperature).
        heat_capacity: >= 0, energy/(volume temperature): density times specific heat.
        temperature: temperature far from the contact.
        """
        self._call("set_heat", which, conductivity, heat_capacity, temperature)

    def solve(self) -> int:
        """Finds the patches and solves each as a steady rolling contact, from the last solution
        where there is one. The status is the worst of the patches' in the order that holds for
        all calls. RIM_CONTACT: a patch ends at the end of a profile, or is not within its frame;
        NO_CONTACT: the wheel is lifted; the log has the numbers. ERR_STATE names the call that is
        missing. ERR_ARGUMENT: with this z wheel and rail overlap by more than a tenth of the
        wheel's radius. ERR_LOAD: with this y no height brings the wheel on the rail, or no
        overlap up to a tenth of the radius carries the vertical force. ERR_MESH: a conformal
        patch (option conformal) turns by more than 60 degrees to a side.
        """
        return self._call("solve")

    def request_cancel(self) -> None:
        """Asks a running solve() or solve_many() to stop (an atomic store) before its next patch,
        height or position. It returns CANCELLED; the wheel stays usable.
        """
        self._call("request_cancel")

    def snapshot(self, place: int) -> None:
        """Takes a snapshot of what is set and of the last solution, kept at a place within the
        wheel, for rollback(), because integrators step back. Nothing is allocated where as much
        was kept before.

        place: 0 to 15.
        """
        self._call("snapshot", place)

    def rollback(self, place: int) -> None:
        """Goes back to a snapshot: inputs, results, and later solves are as if nothing had been
        done since, to the last bit. ERR_STATE: there is no snapshot at this place, or track or
        wheelset have been set since. The snapshot stays. Contacts of patches that were new since
        then are no longer those of this wheel.

        place: 0 to 15.
        """
        self._call("rollback", place)

    def reset(self) -> None:
        """Forgets the solution, the warm starts and what was before a step in time (bodies are at
        rest); keeps what was set and all that was computed for the frames.
        """
        self._call("reset")

    @property
    def patch_count(self) -> int:
        """Returns the number of patches, from 0."""
        patches = c_int64()
        self._call("get_patch_count", byref(patches))
        return patches.value

    def resultant(self, axes: int | str = _api.IN_TRACK) -> tuple[ndarray, ndarray]:
        """Returns the force of all patches on the wheel and its moment about the wheelset's
        centre.

        axes: IN_TRACK or IN_WHEELSET.
        force: force.
        moment: force x length.
        """
        force, force_at = room(3)
        moment, moment_at = room(3)
        self._call("get_resultant", axes, force_at, moment_at)
        return force, moment

    def derivative(self, entry: int) -> tuple[ndarray, ndarray, float]:
        """Returns the derivatives of the totals of the last solve by one entry of its position or
        velocity: those of what resultant() gives in the track, and derivatives of the wheelset's
        z. Where the height was found from a vertical force, that force stays and z follows; entry
        2 has none then. They are those of Newton's systems at the solutions of the patches, whose
        axes and strips move; with a creep-force table, on conformal frames, with laws other than
        Coulomb's and with a layer, central differences of solves. The first call finds all twelve
        and keeps them until the next solve. ERR_STATE: no solution, or one that did not converge.
        ERR_SINGULAR: a patch begins or ends here.

        entry: 0 to 5: of the position (rollcon_wheelrail_set_position); 6 to 11: of the velocity.
        force: derivative of the force on the wheel.
        moment: derivative of its moment about the wheelset's centre, which moves along.
        """
        force, force_at = room(3)
        moment, moment_at = room(3)
        z = c_double()
        self._call("get_derivative", entry, force_at, moment_at, byref(z))
        return force, moment, z.value

    def stat(self, name: str) -> float:
        """Returns one number about the last solve: height, vertical force, frictional power,
        counts. Names: rollcon_stat_info; meanings: docs/wheelrail.md.
        """
        value = c_double()
        self._call("get_stat", c_text(name, "name"), byref(value))
        return value.value

    def profile_point(self, which: int | str, share: float) -> ndarray:
        """Returns where a point of the wheel's or the rail's profile stood in the last solve, in
        the track, for pictures. The wheel's profile is that in the plane of its axle, below it;
        of profiles that vary, the section there.

        which: WHEEL or RAIL.
        share: fraction of the length of that body's profile, 0 to 1, from the end where y is
          less.
        point: y and z, length.
        """
        point, point_at = room(2)
        self._call("get_profile_point", which, share, point_at)
        return point

    def patch_stat(self, patch: int, name: str) -> float:
        """Returns one number about a patch: position, angle, rolling radius, creepages, forces,
        status. Names: rollcon_stat_info; meanings: docs/wheelrail.md.

        patch: 0 to rollcon_wheelrail_get_patch_count - 1.
        """
        value = c_double()
        self._call("get_patch_stat", patch, c_text(name, "name"), byref(value))
        return value.value

    def patch_axes(self, patch: int) -> tuple[ndarray, ndarray]:
        """Returns origin and axes of the contact of a patch (contact()) in the track: a node at
        (x, y, z) of the contact is at origin + x t1 + y t2 + z n. The axes of a left wheel are a
        mirror image: a left-handed triple.

        patch: 0 to rollcon_wheelrail_get_patch_count - 1.
        origin: the middle of its overlap; x counts from the wheelset's, as in the statistic,
          length.
        axes: unit vectors t1 (the rolling direction), t2 (across), n (into the rail).
        """
        origin, origin_at = room(3)
        axes, axes_at = room(9)
        self._call("get_patch_axes", patch, origin_at, axes_at)
        return origin, axes


class TablePlain:

    def set_ratios(self, intervals: int, least: float, greatest: float) -> None:
        """Sets which ratios a / b of semi-axes the table has. Call it before the first sample
        (else ERR_STATE).

        intervals: intervals of the logarithm of the ratio, 4 to 100.
        least: 0.01 or more.
        greatest: more than the least, at most 100.
        """
        self._call("set_ratios", intervals, least, greatest)

    def set_resolution(self, magnitudes: int, angles: int, directions: int) -> None:
        """Sets how fine the table is in the creepages. Call it before the first sample (else
        ERR_STATE).

        magnitudes: intervals from none to vast creepages, 4 to 100.
        angles: intervals from pure spin to none, 4 to 100.
        directions: directions of the translational creepage in half a turn, even, 4 to 32.
        """
        self._call("set_resolution", magnitudes, angles, directions)

    def set_frame(self, along: int, across: int) -> None:
        """Sets the coarser of the two frames of strips on which samples of circles are solved;
        those of longer ellipses have more cells along their length and fewer across. Call it
        before the first sample (else ERR_STATE).

        along: elements along each strip, 6 to 100; the finer frame has twice as many.
        across: strips, 4 to 100; the finer frame has twice as many.
        """
        self._call("set_frame", along, across)

    def set_poissons(self, poissons: ArrayLike) -> None:
        """Makes it a table of bodies of equal elastic constants, which a new one is, and sets its
        Poisson's ratios; it is linear between two and beyond them (by twice their distance and at
        most 0.04, up to 0.5), cubic between more. Call it before the first sample (else
        ERR_STATE).

        poissons: ascending, -1 to 0.5.
        """
        poissons, poissons_at = reals(poissons)
        self._call("set_poissons", len(poissons), poissons_at)

    def set_bodies(self, youngs: ArrayLike, poissons: ArrayLike, frictions: ArrayLike) -> None:
        """Makes it a table of two bodies whose elastic constants differ, one of which may be
        rigid: wheel on rail of another metal, rubber on steel. Forces of such bodies depend on
        friction by itself: the table has coefficients of friction, is linear in the logarithm of
        two and cubic in that of more, and has none beyond. evaluate() then takes as shear and
        poisson the mean values of the bodies (equivalent_ellipse()), and creepages without the
        strain under the pressure. Each coefficient of friction takes as long as two to three
        Poisson's ratios of like bodies. Bodies whose (1 - 2 nu)/(2 G) are the same make a table
        of like bodies. Call it before the first sample (else ERR_STATE).

        youngs: Young's moduli of bodies 1 and 2, in any unit; 0: rigid, not both.
        poissons: -1 to 0.5; ignored for a rigid body.
        frictions: coefficients of friction, ascending, above 0 to 10.
        """
        youngs, youngs_at = vector(youngs, 2)
        poissons, poissons_at = vector(poissons, 2)
        frictions, frictions_at = reals(frictions)
        self._call("set_bodies", youngs_at, poissons_at, len(frictions), frictions_at)

    def request_cancel(self) -> None:
        """Asks a running make() to stop: it returns CANCELLED within a few solves. What was
        solved stays, and the next call goes on.
        """
        self._call("request_cancel")

    def add_samples(self, samples: ArrayLike) -> None:
        """Adds the samples that another table of the same settings has (samples()); NaN adds
        none. With the last sample the table is made.
        """
        samples, samples_at = reals(samples)
        self._call("add_samples", len(samples), samples_at)

    def save(self, path: str | PathLike) -> None:
        """Writes the table, with what wheels found to calibrate ellipses, to a file, whole or not
        at all; an older one is replaced. ERR_STATE: the table is not made yet.

        path: name of the file.
        """
        self._call("save", c_path(path))
