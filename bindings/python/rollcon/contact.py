"""Provides pairs of bodies in rolling contact."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_double, c_int64
from typing import TYPE_CHECKING

import numpy as np

from . import _api
from ._arrays import elements, integers, nodes, reals, room, vector
from ._library import Handle, RollconError, c_path, c_text, call, check, enumerator, lib, shown
from ._plain import ContactPlain
from ._settings import Settings

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import ArrayLike

    from .status import Status


HISTORY = "phase iteration residual_normal residual_tangential step nodes_contact nodes_slip seconds error_function"


class Event:
    """Holds what a progress callback may read; it is valid during the callback only."""

    def __init__(self, address):
        self._address = address

    def _read(self, get, key, c_type):
        value = c_type()
        check(get(self._address, key, byref(value)))
        return value.value

    phase = property(lambda self: self._read(lib.rollcon_event_get_int, _api.EVENT_PHASE, c_int64))
    iteration = property(
        lambda self: self._read(lib.rollcon_event_get_int, _api.EVENT_ITERATION, c_int64))
    residual = property(
        lambda self: self._read(lib.rollcon_event_get_real, _api.EVENT_RESIDUAL, c_double))
    seconds = property(
        lambda self: self._read(lib.rollcon_event_get_real, _api.EVENT_SECONDS, c_double))


def progress_function(callback, raised):
    """Returns the function that the library calls; what the callback raises is stored in `raised` and cancels."""

    def call(address, _):
        try:
            return int(bool(callback(Event(address))))
        except BaseException as error:
            raised.append(error)
            return 1
    return _api.progress_fn() if callback is None else _api.progress_fn(call)


class Cases:
    """Holds results of Contact.solve_many, one row per case; NaN where a case has none.

    worst is the call's status. status[n], force[n, 3], moment[n, 3], approach[n], creep[n, 3], and, if asked for,
    derivatives[n, parameters, 10] (of force, moment, approach, creep) and tractions[n, nodes, 3] are arrays;
    cases["iterations"] is a statistic by name.
    """

    def __init__(self, worst, names, arrays):
        self.worst = worst
        self.names = names
        self.__dict__.update(arrays)

    def __getitem__(self, name):
        return self.statistics[:, self.names.index(name)]


def _parameter_name(parameter):
    """Returns the name of a direction or of friction, given as that or as a number."""
    number = enumerator(parameter, "direction or parameter", "parameters")
    for one in ("direction", "parameter"):
        for name, value in _api.ENUMERATORS[one].items():
            if value == number:
                return name
    return str(number)


class Contact(Settings, ContactPlain, Handle):
    """Takes bodies, frame, motion, loads and friction; gives tractions, slip and forces."""

    _kind = "contact"

    def __init__(self, context, body1, body2):
        made = ctypes.c_void_p()
        check(lib.rollcon_contact_create(context.handle, body1.handle, body2.handle, byref(made)))
        self._take(made.value, context)

    def _take(self, handle, context):
        Handle.__init__(self, handle, context)
        self._raised = []  # what a progress callback raised

    @classmethod
    def _of_handle(cls, handle, context):
        """Makes a contact of one that the library made; the reference becomes this object's."""
        contact = cls.__new__(cls)
        contact._take(handle, context)
        return contact

    # ------------------------------------------------------------------ frame, gap and axes

    def frame_nodes(self, x: ArrayLike) -> None:
        """Gives nodes x[n, 3] (or x[n, 2]: z = 0); any strides of float64 pass without a copy."""
        x, layout = nodes(x)
        self._call("frame_nodes", *layout)

    def frame_add_elements(self, element_type: int | str, connectivity: ArrayLike, tag: int = 1,
                           index_base: int = 0) -> None:
        """Adds elements of one type: connectivity[n, nodes per element]."""
        element_type, ids, address = elements(element_type, connectivity)
        self._call("frame_add_elements", element_type, len(ids), address, index_base, tag)

    def set_pose(self, which: int | str, rotation: ArrayLike = ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
                 translation: ArrayLike = (0, 0, 0)) -> None:
        """Says where body 1 or 2 stands: x = rotation @ x_body + translation."""
        (r, pr), (t, pt) = reals(rotation, 3), vector(translation)
        if len(r) != 3:
            raise ValueError(f"expected a rotation of shape (3, 3), got {r.shape}")
        self._call("set_pose", which, pr, pt)

    # ------------------------------------------------------------ motion, loads and friction

    def set_friction(self, mu: ArrayLike, law: str = "coulomb") -> None:
        """Sets the law of friction and its parameters; for Coulomb's, the coefficient."""
        parameters, address = reals(np.atleast_1d(mu))
        self._call("set_friction", c_text(law, "law"), parameters.size, address)

    # ---------------------------------------------------------------------------------- solve

    def set_progress(self, callback: Callable | None) -> None:
        """Sets callback(event), which is called in every iteration; a true result cancels. None removes it.

        An exception that the callback raises cancels the solve, which then raises it.
        """
        wrapped = progress_function(callback, self._raised)
        self._call("set_progress", wrapped, None)
        self._callbacks["progress"] = wrapped

    def set_gap_grid(self, nx: int, x_least: float, x_greatest: float, y_least: float, y_greatest: float,
                     gap: ArrayLike) -> None:
        """Gives a gap on a grid; it may be an array [ny, nx] instead of its lines one after the other."""
        gap = np.asarray(gap, dtype=np.float64)
        if gap.ndim not in (1, 2) or gap.ndim == 2 and gap.shape[1] != nx:
            raise ValueError(f"set_gap_grid: expected gap of shape (ny, {nx}) or (ny * {nx},), got {gap.shape}")
        super().set_gap_grid(nx, x_least, x_greatest, y_least, y_greatest, gap.ravel())

    def solve(self) -> Status:
        """Solves and returns the status: OK, NOT_CONVERGED, NO_CONTACT, CANCELLED, RIM_CONTACT, COARSE,
        INACCURATE, TOO_DEEP."""
        self._raised.clear()
        status = call(lib.rollcon_contact_solve, self._handle)
        if self._raised:
            raise self._raised.pop()
        return check(status)

    def solve_many(self, parameters: str | Sequence[int | str], values: ArrayLike, names: str | Sequence[str] = (),
                   derivatives: bool = False, tractions: bool = False) -> Cases:
        """Solves many load cases on the threads of the context; returns a Cases object.

        values[n, p] replaces what is prescribed in the direction parameters[p], LONGITUDINAL, LATERAL, NORMAL or
        SPIN; FRICTION is a factor on the coefficients ("normal lateral", too). names are statistics wanted, such as
        "iterations" or "friction_power", or one text with blanks between them. An exception that a progress callback
        raises is raised.
        """
        if isinstance(parameters, str):
            parameters = parameters.split()
        parameters = [_parameter_name(p) for p in parameters]
        values = np.ascontiguousarray(values, dtype=np.float64)
        if values.ndim != 2 or values.shape[1] != len(parameters):
            raise ValueError(f"expected values of shape (n, {len(parameters)}), got {values.shape}")
        n, p = values.shape
        # Names are counted as the library counts them.
        names = tuple((names if isinstance(names, str) else " ".join(names)).split())
        shapes = {"force": (3,), "moment": (3,), "approach": (), "creep": (3,), "tilt": (2,)}
        if derivatives:
            shapes["derivatives"] = (p, 10)
        if tractions:
            shapes["tractions"] = (self.size[0], 3)
        widths = [int(np.prod(shape)) for shape in shapes.values()]
        table, address = room(n, sum(widths) + len(names))
        status, status_at = room(n, dtype=np.int32)
        self._raised.clear()
        worst = call(lib.rollcon_contact_solve_many, self._handle, " ".join(parameters).encode(), n,
                     values.ctypes.data_as(ctypes.POINTER(c_double)),
                     c_text(" ".join([*shapes, *names]), "names"), table.shape[1], address, None,
                     status_at)
        if self._raised:
            raise self._raised.pop()
        check(worst)
        columns = np.split(table, np.cumsum(widths), axis=1)
        arrays = {key: np.ascontiguousarray(column).reshape((n, *shape))
                  for (key, shape), column in zip(shapes.items(), columns)}
        if names:
            arrays["statistics"] = columns[-1].copy()
        return Cases(worst, names, {"status": status, **arrays})

    # -------------------------------------------------------------------------------- results

    def tractions(self, axes: int | str = _api.LOCAL) -> np.ndarray:
        """Returns tractions on body 1, [n, 3]."""
        t, address = room(self.size[0], 3)
        self._call("get_tractions", axes, len(t), address)
        return t

    def field(self, field: int | str, axes: int | str = _api.LOCAL) -> np.ndarray:
        """Returns a nodal field, FIELD_...: [n, 3], [n, 2] or [n]."""
        count = self.size[0]
        need = c_int64()
        self._call("get_field", field, axes, 0, None, byref(need))
        v, address = room(need.value)
        self._call("get_field", field, axes, v.size, address, byref(need))
        return v if v.size == count else v.reshape(count, -1)

    def past_get(self) -> np.ndarray:
        """Returns what the next step in time starts from, [n], for past_set of this or another contact."""
        need = c_int64()
        self._call("past_get", 0, None, byref(need))
        past, address = room(need.value)
        self._call("past_get", past.size, address, byref(need))
        return past

    def node_states(self) -> np.ndarray:
        """Returns OPEN, STICK, SLIP or EXCLUDED at each node."""
        status, address = room(self.size[0], dtype=np.int32)
        self._call("get_node_states", status.size, address)
        return status

    def displacements_at(self, which: int | str, xy: ArrayLike) -> np.ndarray:
        """Returns displacements [n, 3] of body 1 or 2 at points xy[n, 2] of the contact surface."""
        xy, points = reals(xy, 2)
        u, address = room(len(xy), 3)
        self._call("get_displacements_at", which, len(xy), points, address)
        return u

    def fields_at(self, which: int | str, xyz: ArrayLike,
                  in_axes: int | str = _api.IN_CONTACT) -> tuple[np.ndarray, np.ndarray]:
        """Returns displacements [n, 3] and stresses [n, 6] (s11, s22, s33, s12, s13, s23) at points xyz[n, 3] inside
        body 1 or 2; points and results are in the axes of the contact (body 1 at n <= 0, body 2 at n >= 0) or of the
        body (IN_BODY)."""
        xyz, points = reals(xyz, 3)
        u, first = room(len(xyz), 3)
        stress, second = room(len(xyz), 6)
        self._call("get_fields_at", which, len(xyz), points, in_axes, first, second)
        return u, stress

    def find_stress(self, which: int | str, measure: str, parameters: ArrayLike = ()) -> tuple[float, np.ndarray]:
        """Returns the largest value of a measure of stress inside a half-space, and its place [3] in the contact's
        axes: "von_mises", "shear", "orthogonal_shear", "dang_van" and "crossland" (weight of the hydrostatic stress),
        or the integral "lundberg_palmgren" (exponents of stress and depth, least depth)."""
        parameters, given = reals(np.atleast_1d(parameters))
        value = c_double()
        place, address = room(3)
        self._call("find_stress", which, c_text(measure, "measure"), parameters.size, given, byref(value), address)
        return value.value, place

    def wear(self, law: str, parameters: ArrayLike, y: ArrayLike) -> tuple[np.ndarray, float]:
        """Returns the depth [points] that a pass of the contact wears off at places y along t2, and the volume per
        length rolled, by a law, "archard" (i, or i1, i2, angle) or "t_gamma" (pairs)."""
        parameters, given = reals(np.atleast_1d(parameters))
        y, places = reals(y)
        depth, address = room(len(y))
        volume = c_double()
        self._call("get_wear", c_text(law, "law"), parameters.size, given, len(y), places, address, byref(volume))
        return depth, volume.value

    def body_displacements(self, which: int | str) -> np.ndarray:
        """Returns displacements [nodes, 3] of all nodes of body 1 or 2, of finite or boundary elements, in its axes."""
        need = c_int64()
        self._call("get_body_displacements", which, 0, None, byref(need))
        u, address = room(need.value // 3, 3)
        self._call("get_body_displacements", which, u.size, address, byref(need))
        return u

    def body_power(self, which: int | str) -> np.ndarray:
        """Returns the power that body 1 or 2, a viscoelastic section, loses in each harmonic of its way, from 0 on."""
        need = c_int64()
        self._call("get_body_power", which, 0, None, byref(need))
        power, address = room(need.value)
        self._call("get_body_power", which, power.size, address, byref(need))
        return power

    def write_body(self, which: int | str, path: str | os.PathLike) -> None:
        """Writes elements of body 1 or 2 with displacements, smoothed stresses and von Mises's stress, as a VTU
        file."""
        self._call("write_body", which, c_path(path))

    def temperatures_at(self, xy: ArrayLike) -> np.ndarray:
        """Returns temperatures [n, 2] of the surfaces of bodies 1 and 2 at points xy[n, 2] of the plane of the axes."""
        xy, points = reals(xy, 2)
        temperature, address = room(len(xy), 2)
        self._call("get_temperatures_at", len(xy), points, address)
        return temperature

    def history(self, columns: str = HISTORY) -> np.ndarray:
        """Returns one row per iteration with the columns asked for, names separated by blanks; all of them: phase,
        iteration, residual_normal, residual_tangential, step, nodes_contact, nodes_slip, seconds, error_function."""
        text, need = c_text(columns, "columns"), c_int64()
        self._call("get_history", text, 0, None, byref(need))
        rows, address = room(need.value, len(columns.split()))
        self._call("get_history", text, len(rows), address, byref(need))
        return rows

    @property
    def force(self) -> np.ndarray:
        """Returns the force [3] on body 1 in the contact's axes: resultant()[0]."""
        return self.resultant()[0]

    @property
    def moment(self) -> np.ndarray:
        """Returns the moment [3] on body 1 about the origin of the contact's axes: resultant()[1]."""
        return self.resultant()[1]

    @property
    def approach(self) -> float:
        """Returns how far the bodies are moved together, given or found: motion()[0]."""
        return self.motion()[0]

    @property
    def creepages(self) -> np.ndarray:
        """Returns longitudinal and lateral creepage and spin [3], given or found: motion()[1]."""
        return self.motion()[1]

    @property
    def pressure(self) -> np.ndarray:
        """Returns the pressure at the nodes [n]: field("pressure")."""
        return self.field("pressure")

    # -------------------------------------------------------------------------------- pictures

    def _about(self):
        nodes, elements = self.size
        if not nodes:
            return "not solved, no frame"
        words = f"{nodes} nodes, {elements} elements"
        try:
            force, _ = self.resultant()
            return f"{words}; force on body 1 {shown(force)}"
        except RollconError:
            return f"{words}; not solved"

    def plot_pressure(self, ax=None, **options):
        """Draws the pressure over the contact; returns the axes of matplotlib. See rollcon.plots."""
        from . import plots
        return plots.pressure(self, ax, **options)

    def plot_tractions(self, ax=None, **options):
        """Draws tangential tractions on body 1 as arrows over where nodes stick and slip."""
        from . import plots
        return plots.tractions(self, ax, **options)

    def plot_section(self, y=None, ax=None):
        """Draws pressure, tractions and the limit of friction along the rolling direction, at y or through the largest
        pressure."""
        from . import plots
        return plots.section(self, y, ax)

    def plot_stress(self, which=1, measure="von_mises", y=None, ax=None):
        """Draws a measure of stress below a half-space in the plane of rolling direction and depth, at y or through the
        place of the largest."""
        from . import plots
        return plots.stress(self, which, measure, y, ax)

    def plot_creep_curve(self, creepages, direction="longitudinal", ax=None):
        """Solves a list of creepages in a direction, or of spins, and draws the forces over them."""
        from . import plots
        return plots.creep_curve(self, creepages, direction, ax)
