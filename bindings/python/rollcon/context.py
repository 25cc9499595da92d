"""Context: log, thread budget, text of the last failure."""

import ctypes

from . import _api
from ._library import Handle, call, check, lib, read_text


class Context(Handle):
    """Owner of log sink, thread budget and the text of the last failure."""

    _kind = "context"

    def __init__(self, threads=None):
        made = ctypes.c_void_p()
        check(lib.rollcon_context_create(_api.ABI, ctypes.byref(made)))
        super().__init__(made.value, None)
        self._sink = None
        if threads is not None:
            self.set_threads(threads)

    def _call(self, name, *arguments):
        return check(call(getattr(lib, f"rollcon_context_{name}"), self._handle, *arguments), self)

    def set_threads(self, n):
        """Threads per solve; 0 leaves the number to OpenMP."""
        self._call("set_threads", n)

    def set_log(self, level, sink=None):
        """Messages up to `level` go to sink(level, text); no sink: to nobody.

        What the sink raises is printed by ctypes and otherwise ignored.
        """
        if sink is None:
            wrapped = _api.log_fn()
        else:
            wrapped = _api.log_fn(lambda lv, text, _: sink(lv, text.decode(errors="replace")))
        self._call("set_log", level, wrapped, None)
        self._sink = wrapped  # C keeps the address

    def last_error(self):
        """Text of the last failure in this context; empty if there was none."""
        return read_text(lambda *a: lib.rollcon_context_get_error(self._handle, *a))[1]
