"""Bodies."""

import ctypes

from ._library import Handle, call, check, lib


class Body(Handle):
    """A body of a kind: BODY_HALFSPACE or BODY_RIGID."""

    _kind = "body"

    def __init__(self, context, kind):
        made = ctypes.c_void_p()
        check(call(lib.rollcon_body_create, context.handle, kind, ctypes.byref(made)), context)
        super().__init__(made.value, context)

    def set_elastic(self, young, poisson, tag=0):
        """Young's modulus > 0 and Poisson's ratio in (-1, 0.5]."""
        self._call("set_elastic", tag, young, poisson)

    def prepare(self):
        """Checks that the body is complete and freezes it; a solve does it if nobody did."""
        self._call("prepare")

    @property
    def kind(self):
        value = ctypes.c_int32()
        self._call("get_kind", ctypes.byref(value))
        return value.value
