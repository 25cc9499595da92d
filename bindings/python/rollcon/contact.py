"""A pair of bodies in rolling contact."""

import ctypes
from ctypes import POINTER, byref, c_double, c_int32, c_int64

import numpy as np

from . import _api
from ._library import Handle, check, lib, read_text

_NODES = {_api.TRI3: 3, _api.TRI6: 6, _api.QUAD4: 4, _api.QUAD8: 8, _api.QUAD9: 9}


def _reals(values, columns=None):
    """A contiguous float64 array and its address; a copy only where the argument is not one."""
    array = np.ascontiguousarray(values, dtype=np.float64)
    if columns is not None and (array.ndim != 2 or array.shape[1] != columns):
        raise ValueError(f"expected an array of shape (n, {columns}), got {array.shape}")
    if columns is None and array.ndim != 1:
        raise ValueError(f"expected an array of one dimension, got shape {array.shape}")
    return array, array.ctypes.data_as(POINTER(c_double))


def _vector(values):
    array, address = _reals(values)
    if array.size != 3:
        raise ValueError(f"expected 3 components, got {array.size}")
    return array, address


def _room(*shape, dtype=np.float64):
    array = np.zeros(shape, dtype=dtype)
    c_type = c_double if dtype is np.float64 else c_int32
    return array, array.ctypes.data_as(POINTER(c_type))


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


class Contact(Handle):
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
        x = np.require(x, np.float64, "A")
        if x.ndim == 2 and x.shape[1] == 2:
            x = np.column_stack([x, np.zeros(len(x))])
        if x.ndim != 2 or x.shape[1] != 3:
            raise ValueError(f"expected an array of shape (n, 3), got {x.shape}")
        if any(s <= 0 or s % x.itemsize for s in x.strides):
            x = np.ascontiguousarray(x).copy()
        self._call("set_frame_nodes", x.shape[0], x.ctypes.data_as(POINTER(c_double)),
                   x.strides[0] // x.itemsize, x.strides[1] // x.itemsize)

    def add_frame_elements(self, element_type, connectivity, tag=1, index_base=0):
        """Elements of one type: connectivity[n, nodes per element]."""
        nodes = np.asarray(connectivity)
        if not np.issubdtype(nodes.dtype, np.integer):
            raise ValueError("connectivity must be integers")
        if nodes.ndim != 2 or nodes.shape[1] != _NODES.get(element_type, nodes.shape[1]):
            raise ValueError(f"connectivity of shape {nodes.shape} does not fit the element type")
        if nodes.size and not -2**31 <= nodes.min() <= nodes.max() < 2**31:
            raise ValueError("node ids must fit 32 bits")
        nodes = np.ascontiguousarray(nodes, dtype=np.int32)
        self._call("add_frame_elements", element_type, len(nodes),
                   nodes.ctypes.data_as(POINTER(c_int32)), index_base, tag)

    def set_axes(self, origin, rolling, normal):
        """Origin, rolling direction t1, outward normal n of body 1; t2 = n x t1."""
        (o, po), (r, pr), (n, pn) = _vector(origin), _vector(rolling), _vector(normal)
        self._call("set_axes", po, pr, pn)

    def set_gap(self, gap):
        """Gap of the undeformed bodies at each node."""
        gap, address = _reals(gap)
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
        slip, address = _reals(slip, 2)
        self._call("set_creep_field", len(slip), address)

    def prescribe(self, direction, how, value):
        """LONGITUDINAL, LATERAL, NORMAL or SPIN, BY_MOTION or BY_FORCE."""
        self._call("prescribe", direction, how, value)

    def set_friction(self, mu, law="coulomb"):
        """Law of friction and its parameters; for Coulomb's, the coefficient."""
        parameters, address = _reals(np.atleast_1d(mu))
        self._call("set_friction", law.encode(), parameters.size, address)

    def set_friction_field(self, mu):
        """Coefficient of friction at each node; None removes it."""
        if mu is None:
            self._call("set_friction_field", 0, None)
            return
        mu, address = _reals(mu)
        self._call("set_friction_field", mu.size, address)

    # -------------------------------------------------------------------------------- options

    def set(self, name, value):
        """A solver setting by name (option_table() lists them): int, float or str by its type."""
        if isinstance(value, str):
            self._call("set_str", name.encode(), value.encode())
        elif isinstance(value, (bool, int, np.integer)):
            self._call("set_int", name.encode(), int(value))
        else:
            self._call("set_real", name.encode(), float(value))

    def get(self, name):
        """Value of a solver setting."""
        types = (("int", c_int64), ("real", c_double))
        for kind, c_type in types:
            value = c_type()
            status = getattr(lib, f"rollcon_contact_get_{kind}")(self._handle, name.encode(),
                                                                 byref(value))
            if status >= 0:
                return value.value
            if status != _api.ERR_OPTION:
                check(status, self._context)
        status, text = read_text(
            lambda *a: lib.rollcon_contact_get_str(self._handle, name.encode(), *a))
        check(status, self._context)
        return text

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
        """Solves and returns the status: OK, NOT_CONVERGED, NO_CONTACT, CANCELLED, RIM_CONTACT."""
        self._raised.clear()
        status = lib.rollcon_contact_solve(self._handle)
        if self._raised:
            raise self._raised.pop()
        return check(status, self._context)

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
        nodes, elements = c_int64(), c_int64()
        self._call("get_size", byref(nodes), byref(elements))
        return nodes.value, elements.value

    def tractions(self, axes=_api.LOCAL):
        """Tractions on body 1, [n, 3]."""
        t, address = _room(self.size[0], 3)
        self._call("get_tractions", axes, len(t), address)
        return t

    def field(self, field, axes=_api.LOCAL):
        """A nodal field, FIELD_...: [n, 3], [n, 2] or [n]."""
        nodes = self.size[0]
        need = c_int64()
        self._call("get_field", field, axes, 0, None, byref(need))
        v, address = _room(need.value)
        self._call("get_field", field, axes, v.size, address, byref(need))
        return v if v.size == nodes else v.reshape(nodes, -1)

    def node_status(self):
        """OPEN, STICK, SLIP or EXCLUDED at each node."""
        status, address = _room(self.size[0], dtype=np.int32)
        self._call("get_status", status.size, address)
        return status

    def resultant(self, axes=_api.LOCAL):
        """(force, moment) on body 1 about the axes' origin."""
        (force, pf), (moment, pm) = _room(3), _room(3)
        self._call("get_resultant", axes, pf, pm)
        return force, moment

    def motion(self):
        """(approach, [longitudinal, lateral, spin]), given or found."""
        approach = c_double()
        creep, address = _room(3)
        self._call("get_motion", byref(approach), address)
        return approach.value, creep

    def displacements_at(self, body, xy):
        """Displacements [n, 3] of body 1 or 2 at points xy[n, 2] of the contact surface."""
        xy, points = _reals(xy, 2)
        u, address = _room(len(xy), 3)
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
        rows, address = _room(need.value, 8)
        self._call("get_history", len(rows), address, byref(need))
        return rows

    def plan(self):
        """How the last solve was done, as text."""
        status, text = read_text(lambda *a: lib.rollcon_contact_get_plan(self._handle, *a))
        check(status, self._context)
        return text

    def write(self, path):
        """Frame and results as a VTU file."""
        self._call("write", str(path).encode())
