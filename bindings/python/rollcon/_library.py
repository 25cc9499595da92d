"""The loaded library, the rule for failures, and the life of a handle."""

import ctypes
import ctypes.util
import operator
import os
import pathlib

from . import _api


def _find():
    """ROLLCON_LIBRARY, else a library next to the package, else what the system's loader knows."""
    named = os.environ.get("ROLLCON_LIBRARY")
    if named:
        return named
    beside = pathlib.Path(__file__).resolve().parent
    for pattern in ("librollcon.so*", "librollcon*.dylib", "rollcon*.dll"):
        for path in sorted(beside.glob(pattern)):
            return str(path)
    found = ctypes.util.find_library("rollcon")
    if not found:
        raise ImportError("librollcon not found: set ROLLCON_LIBRARY to its path")
    return found


library_path = _find()
lib = _api.declare(ctypes.CDLL(library_path))
if lib.rollcon_abi() != _api.ABI:
    raise ImportError(f"{library_path} has ABI {lib.rollcon_abi()}, this package needs {_api.ABI}")


def version():
    """10000 major + 100 minor + patch of the library that runs."""
    return lib.rollcon_version()


def version_string():
    return lib.rollcon_version_string().decode()


def build_info():
    """Licences and options of the library that runs."""
    return lib.rollcon_build_info().decode()


def has_feature(name):
    return bool(lib.rollcon_has_feature(name.encode()))


def status_string(status):
    return lib.rollcon_status_string(status).decode()


class RollconError(Exception):
    """A call failed: `status` (one of ERR_...) and `message`."""

    def __init__(self, status, message):
        super().__init__(f"{_api.STATUS_NAMES.get(status, status)}: {message}")
        self.status = status
        self.message = message


def read_text(get):
    """Text of a getter get(capacity, text, needed); (status, text)."""
    needed = ctypes.c_int64(0)
    status = get(0, None, ctypes.byref(needed))
    if status < 0:
        return status, ""
    buffer = ctypes.create_string_buffer(max(needed.value, 1))
    status = get(len(buffer), buffer, ctypes.byref(needed))
    return status, buffer.value.decode(errors="replace") if status >= 0 else ""


def check(status, context=None):
    """Returns a status >= 0; raises RollconError with the context's text for the rest."""
    if status >= 0:
        return status
    message = ""
    if context is not None and status != _api.ERR_HANDLE:
        message = context.last_error()
    raise RollconError(status, message or status_string(status))


_RANGE = {ctypes.c_int32: 2**31, ctypes.c_int64: 2**63}


def call(function, *arguments):
    """Calls a C function: integers of any kind, but none that ctypes would cut silently."""
    checked = []
    for argument, c_type in zip(arguments, function.argtypes):
        limit = _RANGE.get(c_type)
        if limit is not None:
            argument = operator.index(argument)
            if not -limit <= argument < limit:
                raise OverflowError(f"{argument} does not fit {c_type.__name__}")
        checked.append(argument)
    return function(*checked)


class Handle:
    """One reference to an object of the library."""

    _kind = ""

    def __init__(self, value, context):
        self._handle = value
        self._context = context
        self._release = getattr(lib, f"rollcon_{self._kind}_release")

    @property
    def handle(self):
        """The C handle as an integer; None after close()."""
        return self._handle

    @property
    def id(self):
        """The number that the FORTRAN 77 layer uses."""
        return lib.rollcon_id_of(self._handle)

    def close(self):
        """Gives the reference back; no harm if that was done before."""
        handle, self._handle = getattr(self, "_handle", None), None
        if handle:
            self._release(handle)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        self.close()

    def _call(self, name, *arguments):
        function = getattr(lib, f"rollcon_{self._kind}_{name}")
        return check(call(function, self._handle, *arguments), self._context)
