"""Provides creep-force tables."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_int64
from typing import TYPE_CHECKING

import numpy as np

from ._arrays import reals, room
from ._library import Handle, c_path, call, check, lib
from ._plain import TablePlain
from .contact import progress_function

if TYPE_CHECKING:
    import os
    from collections.abc import Callable

    from numpy.typing import ArrayLike

    from .contact import Contact
    from .context import Context
    from .status import Status


class Table(TablePlain, Handle):
    """Gives forces and spin moment of Hertzian steady rolling in about a microsecond, from solved cases.

    Table(context) has no samples: set it, then make() it. Table.standard(context) is the one that comes with the
    library, Table.load(context, path) one that was saved.
    """

    _kind = "table"

    def __init__(self, context, _made=None):
        if _made is None:
            _made = ctypes.c_void_p()
            check(lib.rollcon_table_create(context.handle, byref(_made)))
        super().__init__(_made.value, context)
        self._raised = []  # what a progress callback raised

    @classmethod
    def standard(cls, context: Context) -> Table:
        """Returns the table of steel on steel, Poisson's ratios 0.24 to 0.34, ratios of semi-axes 1/25 to 25."""
        made = ctypes.c_void_p()
        check(lib.rollcon_table_standard(context.handle, byref(made)))
        return cls(context, made)

    @classmethod
    def load(cls, context: Context, path: str | os.PathLike) -> Table:
        """Loads a table that save() wrote."""
        made = ctypes.c_void_p()
        check(lib.rollcon_table_load(context.handle, c_path(path), byref(made)))
        return cls(context, made)

    def set_progress(self, callback: Callable | None) -> None:
        """Sets callback(event), which is called about ten times a second while make() works; a true result cancels,
        and so does an exception that it raises, which make() then raises. None removes it."""
        wrapped = progress_function(callback, self._raised)
        self._call("set_progress", wrapped, None)
        self._callbacks["progress"] = wrapped

    def make(self, part: int = 0, parts: int = 1) -> Status:
        """Solves a part of the samples; returns the status: OK or CANCELLED."""
        self._raised.clear()
        status = call(lib.rollcon_table_make, self._handle, part, parts)
        if self._raised:
            raise self._raised.pop()
        return check(status)

    @property
    def samples(self) -> np.ndarray:
        """Returns all samples; NaN where one is not solved yet."""
        count = c_int64()
        self._call("get_samples", 0, None, byref(count))
        samples, at = room(count.value)
        if count.value:
            self._call("get_samples", count.value, at, byref(count))
        return samples

    def evaluate(self, inputs: ArrayLike, derivatives: bool = False) -> np.ndarray | tuple[np.ndarray, np.ndarray]:
        """Returns forces and moment [3], or [n, 3], of inputs [9] or [n, 9]: shear, poisson, friction, a, b, load,
        longitudinal and lateral creepage, spin. With derivatives it also returns those [3, 9] or [n, 3, 9] by the
        inputs."""
        given = np.asarray(inputs, dtype=float)
        one = given.ndim == 1
        given, given_at = reals(given.reshape(-1, 9), 9)
        n = len(given)
        results, results_at = room(n, 3)
        if not derivatives:
            self._call("evaluate", n, given_at, results_at)
            return results[0] if one else results
        by, by_at = room(n, 3, 9)
        self._call("evaluate_derivatives", n, given_at, results_at, by_at)
        return (results[0], by[0]) if one else (results, by)

    def evaluate_contact(self, contact: Contact, friction: float | None = None) -> np.ndarray:
        """Returns forces along t1 and t2 and moment about n [3] of a solved contact, by the Hertzian contact that
        stands for it; friction None: the contact's own."""
        results, results_at = room(3)
        self._call("evaluate_contact", contact.handle, -1.0 if friction is None else float(friction), results_at)
        return results
