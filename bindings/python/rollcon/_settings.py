"""Settings by name, of contacts and of bodies."""

from ctypes import byref, c_double, c_int64

import numpy as np

from . import _api
from ._library import check, lib, read_text


class Settings:
    """Gives a Handle the methods set and get."""

    def set(self, name, value):
        """A setting by name (option_table() and body_option_table() list them): int, float or str
        by its type."""
        if isinstance(value, str):
            if not hasattr(lib, f"rollcon_{self._kind}_set_str"):
                raise TypeError(f"no setting of a {self._kind} is a text")
            self._call("set_str", name.encode(), value.encode())
        elif isinstance(value, (bool, int, np.integer)):
            self._call("set_int", name.encode(), int(value))
        else:
            self._call("set_real", name.encode(), float(value))

    def get(self, name):
        """Value of a setting."""
        status = _api.OK
        for kind, c_type in (("int", c_int64), ("real", c_double)):
            value = c_type()
            status = getattr(lib, f"rollcon_{self._kind}_get_{kind}")(self._handle, name.encode(),
                                                                      byref(value))
            if status >= 0:
                return value.value
            if status != _api.ERR_OPTION:
                check(status, self._context)
        get_text = getattr(lib, f"rollcon_{self._kind}_get_str", None)
        if get_text is None:
            check(status, self._context)
        status, text = read_text(lambda *a: get_text(self._handle, name.encode(), *a))
        check(status, self._context)
        return text
