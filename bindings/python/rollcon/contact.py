"""A pair of bodies in rolling contact."""

import ctypes
from ctypes import byref, c_double, c_int64

import numpy as np

from . import _api
from ._arrays import elements, integers, nodes, reals, room, vector
from ._library import Handle, call, check, lib, read_text
from ._settings import Settings


class Event:
    """What a progress callback may read; valid during the callback only."""

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


class Cases:
    """Results of Contact.solve_many, one row per case; NaN where a case has none.

    worst: the call's status. status[n], force[n, 3], moment[n, 3], approach[n], creep[n, 3], and if
    asked for derivatives[n, parameters, 10] (of force, moment, approach, creep), tractions[n,
    nodes, 3]; cases["iterations"] is a statistic by name.
    """

    def __init__(self, worst, names, arrays):
        self.worst = worst
        self.names = names
        self.__dict__.update(arrays)

    def __getitem__(self, name):
        return self.statistics[:, self.names.index(name)]


class Contact(Settings, Handle):
    """Bodies, frame, motion, loads and friction in; tractions, slip and forces out."""

    _kind = "contact"

    def __init__(self, context, body1, body2):
        made = ctypes.c_void_p()
        check(lib.rollcon_contact_create(context.handle, body1.handle, body2.handle, byref(made)),
              context)
        super().__init__(made.value, context)
        self._progress = None
        self._raised = []  # what a progress callback raised

    # ------------------------------------------------------------------ frame, gap and axes

    def set_frame_nodes(self, x):
        """Nodes x[n, 3] (or x[n, 2]: z = 0); any strides of float64 pass without a copy."""
        x, layout = nodes(x)
        self._call("set_frame_nodes", *layout)

    def add_frame_elements(self, element_type, connectivity, tag=1, index_base=0):
        """Elements of one type: connectivity[n, nodes per element]."""
        ids, address = elements(element_type, connectivity)
        self._call("add_frame_elements", element_type, len(ids), address, index_base, tag)

    def frame_from_body(self, which, tag):
        """Makes the faces of body 1 or 2 that carry a tag the frame."""
        self._call("frame_from_body", which, tag)

    def set_pose(self, which, rotation=((1, 0, 0), (0, 1, 0), (0, 0, 1)), translation=(0, 0, 0)):
        """Where body 1 or 2 stands: x = rotation @ x_body + translation."""
        (r, pr), (t, pt) = reals(rotation, 3), vector(translation)
        if len(r) != 3:
            raise ValueError(f"expected a rotation of shape (3, 3), got {r.shape}")
        self._call("set_pose", which, pr, pt)

    def set_axes(self, origin, rolling, normal):
        """Origin, rolling direction t1, outward normal n of body 1; t2 = n x t1."""
        (o, po), (r, pr), (n, pn) = vector(origin), vector(rolling), vector(normal)
        self._call("set_axes", po, pr, pn)

    def set_gap(self, gap):
        """Gap of the undeformed bodies at each node."""
        gap, address = reals(gap)
        self._call("set_gap", gap.size, address)

    def set_gap_quadratic(self, a, b, c=0.0):
        """Gap a x^2 + b y^2 + c x y."""
        self._call("set_gap_quadratic", a, b, c)

    # ------------------------------------------------------------ motion, loads and friction

    def set_rolling(self, speed):
        self._call("set_rolling", speed)

    def set_creep(self, longitudinal=0.0, lateral=0.0, spin=0.0):
        """Creepages and spin of body 1 relative to body 2, all by motion."""
        self._call("set_creep", longitudinal, lateral, spin)

    def set_creep_field(self, slip):
        """Rigid slip velocity slip[n, 2], added to creepages and spin; None removes it."""
        if slip is None:
            self._call("set_creep_field", 0, None)
            return
        slip, address = reals(slip, 2)
        self._call("set_creep_field", len(slip), address)

    def prescribe(self, direction, how, value):
        """LONGITUDINAL, LATERAL, NORMAL or SPIN, BY_MOTION or BY_FORCE."""
        self._call("prescribe", direction, how, value)

    def set_friction(self, mu, law="coulomb"):
        """Law of friction and its parameters; for Coulomb's, the coefficient."""
        parameters, address = reals(np.atleast_1d(mu))
        self._call("set_friction", law.encode(), parameters.size, address)

    def set_friction_field(self, mu):
        """Coefficient of friction at each node; None removes it."""
        if mu is None:
            self._call("set_friction_field", 0, None)
            return
        mu, address = reals(mu)
        self._call("set_friction_field", mu.size, address)

    # ---------------------------------------------------------------------------------- solve

    def set_progress(self, callback):
        """callback(event) is called in every iteration; a true result cancels. None removes it.

        What the callback raises cancels the solve, which then raises it.
        """
        raised = self._raised

        def call(address, _):
            try:
                return int(bool(callback(Event(address))))
            except BaseException as error:
                raised.append(error)
                return 1
        wrapped = _api.progress_fn() if callback is None else _api.progress_fn(call)
        self._call("set_progress", wrapped, None)
        self._progress = wrapped  # C keeps the address

    def solve(self):
        """Solves and returns the status: OK, NOT_CONVERGED, NO_CONTACT, CANCELLED, RIM_CONTACT, COARSE."""
        self._raised.clear()
        status = lib.rollcon_contact_solve(self._handle)
        if self._raised:
            raise self._raised.pop()
        return check(status, self._context)

    def solve_many(self, parameters, values, names=(), derivatives=False, tractions=False):
        """Solves many load cases on the threads of the context; a Cases object.

        values[n, p] replaces what is prescribed in the direction parameters[p], LONGITUDINAL,
        LATERAL, NORMAL or SPIN; FRICTION: a factor on the coefficients. names: statistics wanted,
        such as "iterations" or "friction_power", or one text with blanks between them. What a
        progress callback raises is raised.
        """
        ids, ids_address = integers(parameters, "parameters")
        if ids.ndim != 1:
            raise ValueError(f"expected a list of parameters, got shape {ids.shape}")
        values = np.ascontiguousarray(values, dtype=np.float64)
        if values.ndim != 2 or values.shape[1] != ids.size:
            raise ValueError(f"expected values of shape (n, {ids.size}), got {values.shape}")
        n = len(values)
        # As the library counts them.
        names = (names if isinstance(names, str) else " ".join(names)).split()
        nodes = self.size[0] if tractions else 0
        shapes = {"status": (n,), "force": (n, 3), "moment": (n, 3), "approach": (n,),
                  "creep": (n, 3)}
        if derivatives:
            shapes["derivatives"] = (n, ids.size, 10)
        if len(names) > 0:
            shapes["statistics"] = (n, len(names))
        if tractions:
            shapes["tractions"] = (n, nodes, 3)
        made = {key: room(*shape, dtype=np.int32 if key == "status" else np.float64)
                for key, shape in shapes.items()}
        outputs = [made[key][1] if key in made else None
                   for key in ("status", "force", "moment", "approach", "creep", "derivatives",
                               "statistics", "tractions")]
        self._raised.clear()
        worst = call(lib.rollcon_contact_solve_many, self._handle, ids.size, ids_address, n,
                     values.ctypes.data_as(ctypes.POINTER(c_double)),
                     " ".join(names).encode() or None, nodes, *outputs)
        if self._raised:
            raise self._raised.pop()
        check(worst, self._context)
        return Cases(worst, tuple(names), {key: array for key, (array, _) in made.items()})

    def request_cancel(self):
        """Makes the running solve return CANCELLED; from any thread."""
        self._call("request_cancel")

    def reset(self):
        """Forgets the last solution; keeps the scene."""
        self._call("reset")

    # -------------------------------------------------------------------------------- results

    @property
    def size(self):
        """(nodes, elements) of the frame."""
        n, m = c_int64(), c_int64()
        self._call("get_size", byref(n), byref(m))
        return n.value, m.value

    def tractions(self, axes=_api.LOCAL):
        """Tractions on body 1, [n, 3]."""
        t, address = room(self.size[0], 3)
        self._call("get_tractions", axes, len(t), address)
        return t

    def field(self, field, axes=_api.LOCAL):
        """A nodal field, FIELD_...: [n, 3], [n, 2] or [n]."""
        count = self.size[0]
        need = c_int64()
        self._call("get_field", field, axes, 0, None, byref(need))
        v, address = room(need.value)
        self._call("get_field", field, axes, v.size, address, byref(need))
        return v if v.size == count else v.reshape(count, -1)

    def node_status(self):
        """OPEN, STICK, SLIP or EXCLUDED at each node."""
        status, address = room(self.size[0], dtype=np.int32)
        self._call("get_status", status.size, address)
        return status

    def resultant(self, axes=_api.LOCAL):
        """(force, moment) on body 1 about the axes' origin."""
        (force, pf), (moment, pm) = room(3), room(3)
        self._call("get_resultant", axes, pf, pm)
        return force, moment

    def motion(self):
        """(approach, [longitudinal, lateral, spin]), given or found."""
        approach = c_double()
        creep, address = room(3)
        self._call("get_motion", byref(approach), address)
        return approach.value, creep

    def sensitivity(self, parameter):
        """Derivatives (force, moment, approach, creep) of what resultant() and motion() give.

        By the value prescribed in a direction, LONGITUDINAL, LATERAL, NORMAL or SPIN, or, FRICTION,
        by a factor on every friction coefficient."""
        (force, pf), (moment, pm), (creep, pc) = room(3), room(3), room(3)
        approach = c_double()
        self._call("get_sensitivity", parameter, pf, pm, byref(approach), pc)
        return force, moment, approach.value, creep

    def displacements_at(self, body, xy):
        """Displacements [n, 3] of body 1 or 2 at points xy[n, 2] of the contact surface."""
        xy, points = reals(xy, 2)
        u, address = room(len(xy), 3)
        self._call("get_displacements_at", body, len(xy), points, address)
        return u

    def stat(self, name):
        """A number about the last solve; stat_names() lists them."""
        value = c_double()
        self._call("get_stat", name.encode(), byref(value))
        return value.value

    def history(self):
        """One row per iteration: phase, iteration, normal residual, tangential residual, step
        length, nodes in contact, nodes in slip, seconds."""
        need = c_int64()
        self._call("get_history", 0, None, byref(need))
        rows, address = room(need.value, 8)
        self._call("get_history", len(rows), address, byref(need))
        return rows

    def error_function(self):
        """Error function of every row of history(), and seconds since the solve began: one row
        (psi, seconds) per iteration."""
        need = c_int64()
        self._call("get_error_function", 0, None, None, byref(need))
        columns, psi = room(2, need.value)
        if need.value > 0:
            seconds = columns[1].ctypes.data_as(type(psi))
            self._call("get_error_function", need.value, psi, seconds, byref(need))
        return columns.T

    def plan(self):
        """How the last solve was done, as text."""
        status, text = read_text(lambda *a: lib.rollcon_contact_get_plan(self._handle, *a))
        check(status, self._context)
        return text

    def write(self, path):
        """Frame and results as a VTU file."""
        self._call("write", str(path).encode())
