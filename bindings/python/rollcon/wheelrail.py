"""A wheel of a wheelset on its rail."""

import ctypes
from ctypes import byref

from ._library import Handle, call, check, lib
from ._plain import WheelrailPlain
from .contact import Contact


class WheelRail(WheelrailPlain, Handle):
    """Two profiles, dimensions, position and velocity in; patches and forces out.

    side: LEFT or RIGHT ("left", "right"). Patches count from 0.
    """

    _kind = "wheelrail"

    def __init__(self, context, wheel, rail, side):
        made = ctypes.c_void_p()
        check(call(lib.rollcon_wheelrail_create, context.handle, wheel.handle, rail.handle, side,
                   byref(made)))
        super().__init__(made.value, context)

    def contact(self, patch):
        """The Contact of a patch, to be read: body 1 is the wheel, and the next solve changes it."""
        made = ctypes.c_void_p()
        self._call("get_contact", patch, byref(made))
        return Contact._of_handle(made.value, self._context)

    @property
    def contacts(self):
        """Those of all patches of the last solve."""
        return [self.contact(patch) for patch in range(self.patch_count)]
