"""Provides the context: log, thread budget, latch."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING

from . import _api
from ._library import Handle, check, lib
from ._plain import ContextPlain

if TYPE_CHECKING:
    from collections.abc import Callable


class Context(ContextPlain, Handle):
    """Owns log sink, thread budget and the latch."""

    _kind = "context"

    def __init__(self, threads=None):
        made = ctypes.c_void_p()
        check(lib.rollcon_context_create(_api.ABI, ctypes.byref(made)))
        super().__init__(made.value)
        if threads is not None:
            self.set_threads(threads)

    def set_log(self, level: int | str, sink: Callable[[int, str], None] | None = None) -> None:
        """Sends messages up to `level` to sink(level, text); without a sink, to nobody.

        An exception that the sink raises is printed by ctypes and otherwise ignored.
        """
        if sink is None:
            wrapped = _api.log_fn()
        else:
            wrapped = _api.log_fn(lambda lv, text, _: sink(lv, text.decode(errors="replace")))
        self._call("set_log", level, wrapped, None)
        self._callbacks["log"] = wrapped
