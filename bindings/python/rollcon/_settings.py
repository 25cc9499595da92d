"""Provides settings by name, of contacts, bodies and wheels on rails."""

from __future__ import annotations

from ctypes import byref, c_double, c_int64

import numpy as np

from . import _api
from ._library import c_text, call, check, lib, read_text
from .options import option_table

_types = {}  # types of the settings of each kind of object, by name


def _type_of(kind, name):
    """Returns TYPE_INT, ...; for an unknown setting TYPE_INT, for which the library finds the words."""
    if kind not in _types:
        _types[kind] = {row.name: row.type for row in option_table(kind)}
    return _types[kind].get(name, _api.TYPE_INT)


class Settings:
    """Gives a Handle the methods set and get."""

    def set(self, name: str, value: bool | float | str) -> None:
        """Sets a setting by name (option_table() lists them): int, float or str by its type."""
        text = c_text(name, "name")
        if isinstance(value, str):
            if not hasattr(lib, f"rollcon_{self._kind}_set_str"):
                raise TypeError(f"no setting of a {self._kind} is a text")
            self._call("set_str", text, c_text(value, "value"))
        elif isinstance(value, (bool, int, np.integer)) and _type_of(self._kind, name) != _api.TYPE_REAL:
            self._call("set_int", text, int(value))
        else:
            self._call("set_real", text, value)

    def get(self, name: str) -> int | float | str:
        """Returns the value of a setting."""
        text, kind = c_text(name, "name"), _type_of(self._kind, name)
        if kind == _api.TYPE_STR:
            get = getattr(lib, f"rollcon_{self._kind}_get_str")
            status, value = read_text(lambda *a: call(get, self._handle, text, *a))
            check(status)
            return value
        value = c_int64() if kind == _api.TYPE_INT else c_double()
        self._call("get_int" if kind == _api.TYPE_INT else "get_real", text, byref(value))
        return value.value
