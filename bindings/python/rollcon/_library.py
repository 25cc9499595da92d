"""Provides the loaded library, the rule for failures, and the life of a handle."""

from __future__ import annotations

import ctypes
import operator
import os

from . import _api
from ._find import load
from .status import Status

library_path, lib = load()


def version() -> int:
    """Returns 10000 major + 100 minor + patch of the library that runs."""
    return lib.rollcon_version()


def version_string() -> str:
    return lib.rollcon_version_string().decode()


def build_info() -> str:
    """Returns licences and options of the library that runs."""
    return lib.rollcon_build_info().decode()


def has_feature(name: str) -> bool:
    return bool(lib.rollcon_has_feature(c_text(name, "name")))


def status_string(status: int | str) -> str:
    return lib.rollcon_status_string(enumerator(status, "status", "status")).decode()


class RollconError(Exception):
    """Is raised when a call failed: `status` (one of ERR_...) and `message`."""

    def __init__(self, status, message):
        super().__init__(f"{_api.STATUS_NAMES.get(status, status)}: {message}")
        self.status = status
        self.message = message


def read_text(get):
    """Reads the text of a getter get(capacity, text, needed); returns (status, text)."""
    needed = ctypes.c_int64(0)
    status = get(0, None, ctypes.byref(needed))
    if status < 0:
        return status, ""
    buffer = ctypes.create_string_buffer(max(needed.value, 1))
    status = get(len(buffer), buffer, ctypes.byref(needed))
    return status, buffer.value.decode(errors="replace") if status >= 0 else ""


def last_error() -> str:
    """Returns the text of the last call that failed in this thread; empty if there was none."""
    return lib.rollcon_last_error().decode(errors="replace")


def last_caveat() -> str:
    """Returns the text of the last call in this thread that returned a status above zero; empty if there was none."""
    return lib.rollcon_last_caveat().decode(errors="replace")


def check(status):
    """Returns a status >= 0; raises RollconError with its text for the rest."""
    if status >= 0:
        return Status(status)
    raise RollconError(status, last_error())


def c_text(text, what):
    """Returns the bytes of a text for C, which ends it at its first NUL."""
    if not isinstance(text, str):
        raise TypeError(f"{what} must be a text, not {text!r}")
    if "\0" in text:
        raise ValueError(f"{what} has a NUL in it: {text!r}")
    return text.encode()


def c_path(path):
    """Returns the bytes of the name of a file: str, bytes or os.PathLike."""
    try:
        name = os.fsencode(path)
    except TypeError:
        raise TypeError(f"path must be the name of a file, not {path!r}") from None
    if b"\0" in name:
        raise ValueError(f"path has a NUL in it: {path!r}")
    return name


def enumerator(value, enumeration, what):
    """Returns the number that a name of an enumeration stands for, "quad4" or "normal"; for "dof" a sum, "x z";
    numbers stay the same."""
    if not isinstance(value, str):
        return value
    words = value.replace("+", " ").replace("|", " ").split()
    if enumeration == "dof" and len(words) > 1:
        return operator.or_(enumerator(words[0], "dof", what), enumerator(" ".join(words[1:]), "dof", what))
    names = {}
    for one in enumeration.split(" or ") if enumeration else ():
        names.update(_api.ENUMERATORS[one])
    if value.lower() not in names:
        allowed = ", ".join(names) if names else "a number"
        raise ValueError(f"{what} is '{value}'; allowed: {allowed}")
    return names[value.lower()]


_RANGE = {ctypes.c_int32: 2**31, ctypes.c_int64: 2**63}


def call(function, *arguments):
    """Calls a C function: takes names of enumerators, integers of any kind, but none that ctypes would cut silently."""
    checked = []
    described = _api.ARGUMENTS[function.__name__]
    for argument, c_type, (name, enumeration) in zip(arguments, function.argtypes, described):
        limit = _RANGE.get(c_type)
        if limit is not None:
            argument = enumerator(argument, enumeration, name)
            try:
                argument = operator.index(argument)
            except TypeError:
                raise TypeError(f"{name} must be an integer, not {argument!r}") from None
            if not -limit <= argument < limit:
                raise OverflowError(f"{name} is {argument}, which does not fit {c_type.__name__}")
        elif c_type is ctypes.c_double:
            try:
                argument = float(argument)
            except (TypeError, ValueError):
                raise TypeError(f"{name} must be a number, not {argument!r}") from None
        checked.append(argument)
    return function(*checked)


def shown(vector):
    """Returns components for a repr; what is zero up to rounding is 0."""
    largest = max(abs(v) for v in vector)
    return " ".join(f"{v if abs(v) > 1e-9 * largest else 0:.5g}" for v in vector)


class Handle:
    """Holds one reference to an object of the library. A copy (copy.copy) is another one to the same object; there
    are no deep copies."""

    _kind = ""

    def __init__(self, value, context=None):
        self._handle = value
        self._context = context  # its log sink must live as long as what was made from it
        self._callbacks = {}  # objects whose addresses C has; copies use them too

    def _about(self):
        """Returns words for repr, on what the object is now."""
        return ""

    def __repr__(self):
        if not getattr(self, "_handle", None):
            return f"<rollcon.{type(self).__name__}, closed>"
        try:
            about = self._about()
        except Exception as error:  # busy, latched, ...: a repr must not fail
            about = str(error)
        return f"<rollcon.{type(self).__name__}{': ' if about else ''}{about}>"

    @property
    def handle(self):
        """Returns the C handle as an integer; None after close()."""
        return self._handle

    @property
    def id(self):
        """Returns the number that the FORTRAN 77 layer uses."""
        return lib.rollcon_id_of(self._handle)

    def close(self):
        """Gives the reference back; does nothing if that was done before."""
        handle, self._handle = getattr(self, "_handle", None), None
        if handle:
            getattr(lib, f"rollcon_{self._kind}_release")(handle)

    def __copy__(self):
        if self._handle:
            self._call("retain")
        other = type(self).__new__(type(self))
        other.__dict__.update(self.__dict__)
        return other

    def __deepcopy__(self, _):
        raise TypeError(f"a {self._kind} cannot be copied deeply; copy.copy is another reference")

    def __reduce_ex__(self, _):
        raise TypeError(f"a {self._kind} cannot be pickled: it lives in this process")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        self.close()

    def _call(self, name, *arguments):
        return check(call(getattr(lib, f"rollcon_{self._kind}_{name}"), self._handle, *arguments))
