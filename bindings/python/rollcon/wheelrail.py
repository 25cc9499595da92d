"""Provides wheels of a wheelset on their rails."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_int64
from typing import TYPE_CHECKING

import numpy as np

from ._arrays import reals, room
from ._library import Handle, RollconError, c_text, call, check, lib, shown
from ._plain import WheelrailPlain
from ._settings import Settings
from .contact import Contact

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .table import Table


_TOUCH = ("y", "z", "angle", "wheel_y", "radius")
_POINTS = " ".join(["z roll radius_difference", *(f"{side}_{name}" for side in ("left", "right") for name in _TOUCH)])
_TOTALS = "force_x force_y force_z moment_x moment_y moment_z z vertical_force friction_power"


class Touch:
    """Says where a wheel touches, over the shifts: y, z and angle in the track, wheel_y on the wheel's profile,
    rolling_radius; [n] each."""

    def __init__(self, table):
        self.y, self.z, self.angle, self.wheel_y, self.rolling_radius = table.T.copy()


class Positions:
    """Holds results of WheelRail.solve_many: worst, the call's status; status[n]; force[n, 3] and moment[n, 3] on
    the wheel in the track, z, vertical_force, friction_power, [n] each; NaN where there are none."""

    def __init__(self, worst, status, totals):
        self.worst, self.status = worst, status
        self.force, self.moment = totals[:, :3].copy(), totals[:, 3:6].copy()
        self.z, self.vertical_force, self.friction_power = totals[:, 6:].T.copy()


class Wear:
    """Holds results of WheelRail.find_wear: worst, the call's status; status[n]; wheel and rail, depths [points] per
    pass; volumes [2] of wheel and rail per length rolled."""

    def __init__(self, worst, status, wheel, rail, volumes):
        self.worst, self.status, self.wheel, self.rail, self.volumes = worst, status, wheel, rail, volumes


class ContactPoints:
    """Holds results of contact_points: shift, z and roll of the wheelset, its rolling-radius difference (right less
    left), [n] each; left and right, a Touch each."""

    def __init__(self, shift, table):
        self.shift = shift
        self.z, self.roll, self.difference = table[:, :3].T.copy()
        self.left, self.right = Touch(table[:, 3:8]), Touch(table[:, 8:])


def contact_points(left: WheelRail, right: WheelRail, shift: ArrayLike) -> ContactPoints:
    """Finds where both wheels of a rigid wheelset touch rigid rails over its lateral shift[n]; returns
    a ContactPoints. The wheelset does not yaw, and rolls until both wheels touch.

    left: the WheelRail on the left, with track and wheelset set.
    right: the WheelRail on the right.
    shift: y of the wheelset's centre."""
    shift, shift_at = reals(shift)
    table, table_at = room(len(shift), 13)
    left._call("find_contact_points", right.handle, len(shift), shift_at, c_text(_POINTS, "columns"), table_at)
    return ContactPoints(shift, table)


def conicity(left: WheelRail, right: WheelRail, amplitude: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns the equivalent conicity of EN 15302 for each amplitude[n], and the wavelength of the motion.

    left: the WheelRail on the left, with track and wheelset set.
    right: the WheelRail on the right.
    amplitude: half the distance between the turning points of the motion."""
    amplitude, amplitude_at = reals(amplitude)
    found, found_at = room(len(amplitude))
    wavelength, wavelength_at = room(len(amplitude))
    left._call("find_conicity", right.handle, len(amplitude), amplitude_at, found_at, wavelength_at)
    return found, wavelength


def nonlinearity_parameter(left: WheelRail, right: WheelRail, millimetre: float = 1.0) -> float:
    """Returns the nonlinearity parameter of EN 15302:2021, in 1/length: how much equivalent conicity grows from an
    amplitude of 2 mm to one of 4 mm, over 2 mm.

    left: the WheelRail on the left, with track and wheelset set.
    right: the WheelRail on the right.
    millimetre: the length of a millimetre in the caller's unit; 0.001 if that is the metre."""
    found, _ = conicity(left, right, [2 * millimetre, 4 * millimetre])
    return (found[1] - found[0]) / (2 * millimetre)


def rolling_radii_coefficient(left: WheelRail, right: WheelRail, shift: float, curve: float) -> float:
    """Returns the rolling radii coefficient of EN 15302:2021: the difference of rolling radii that a wheelset has,
    divided by the one with which it rolls round a curve without slip. At 1 and above the wheelset can steer.

    left: the WheelRail on the left, with track and wheelset set.
    right: the WheelRail on the right, on the outer rail.
    shift: the wheelset's shift to the outside at the height of the rails, up to which the standard goes.
    curve: radius of the track's middle."""
    centre = shift
    for _ in range(4):
        points = contact_points(left, right, [centre])
        radius = 0.5 * (points.left.rolling_radius[0] + points.right.rolling_radius[0])
        centre = shift + radius * np.sin(points.roll[0])
    return points.difference[0] * curve / (radius * (points.right.y[0] - points.left.y[0]))


class WheelRail(Settings, WheelrailPlain, Handle):
    """Takes two profiles, dimensions, position and velocity; gives patches and forces.

    side: LEFT or RIGHT ("left", "right"). Patches count from 0.
    """

    _kind = "wheelrail"

    def __init__(self, context, wheel, rail, side):
        made = ctypes.c_void_p()
        check(call(lib.rollcon_wheelrail_create, context.handle, wheel.handle, rail.handle, side,
                   byref(made)))
        super().__init__(made.value, context)

    @classmethod
    def _of_handle(cls, handle, context):
        wheelrail = cls.__new__(cls)
        Handle.__init__(wheelrail, handle, context)
        return wheelrail

    def set_friction(self, mu: ArrayLike, law: str = "coulomb") -> None:
        """Sets the law of friction and its parameters; for Coulomb's, the coefficient."""
        parameters, address = reals(np.ravel(mu))
        self._call("set_friction", c_text(law, "law"), parameters.size, address)

    def set_table(self, table: Table | None) -> None:
        """Takes forces along the surfaces from a Table from now on; None ends it. Contacts of patches then have
        pressures alone."""
        self._call("set_table", table and table.handle)

    def copy(self) -> WheelRail:
        """Returns another WheelRail with the same bodies, inputs and last solution: both go on alike."""
        made = ctypes.c_void_p()
        self._call("copy", byref(made))
        return WheelRail._of_handle(made.value, self._context)

    def solve_many(self, positions: ArrayLike, velocities: ArrayLike) -> Positions:
        """Solves positions[n, 6] with velocities[n, 6] on the threads of the context, each by itself from nothing;
        returns a Positions."""
        positions, positions_at = reals(positions, 6)
        velocities, velocities_at = reals(velocities, 6)
        if len(positions) != len(velocities):
            raise ValueError(f"{len(positions)} positions, but {len(velocities)} velocities")
        totals, totals_at = room(len(positions), 9)
        status, status_at = room(len(positions), dtype=np.int32)
        worst = self._call("solve_many", len(positions), positions_at, velocities_at, c_text(_TOTALS, "columns"), totals_at,
                           status_at)
        return Positions(worst, status, totals)

    def find_wear(self, positions: ArrayLike, velocities: ArrayLike, law: str, parameters: ArrayLike,
                  points: int, weights: ArrayLike | None = None) -> Wear:
        """Returns what a spectrum of positions[n, 6] with velocities[n, 6] and weights[n] (None: alike) wears off
        both profiles per pass, at points at equal arc lengths, as a Wear. See Contact.wear()."""
        positions, positions_at = reals(positions, 6)
        velocities, velocities_at = reals(velocities, 6)
        if len(positions) != len(velocities):
            raise ValueError(f"{len(positions)} positions, but {len(velocities)} velocities")
        weights, weights_at = (None, None) if weights is None else reals(weights)
        if weights is not None and len(weights) != len(positions):
            raise ValueError(f"{len(positions)} positions, but {len(weights)} weights")
        parameters, given = reals(np.atleast_1d(parameters))
        wheel, wheel_at = room(points)
        rail, rail_at = room(points)
        volumes, volumes_at = room(2)
        status, status_at = room(len(positions), dtype=np.int32)
        worst = self._call("find_wear", len(positions), positions_at, velocities_at, weights_at,
                           c_text(law, "law"), parameters.size, given, points, wheel_at, rail_at, volumes_at,
                           status_at)
        return Wear(worst, status, wheel, rail, volumes)

    def past_get(self) -> np.ndarray:
        """Returns what the next step in time starts from, [n], for past_set of this or another wheel."""
        need = c_int64()
        self._call("past_get", 0, None, byref(need))
        past, address = room(need.value)
        self._call("past_get", past.size, address, byref(need))
        return past

    def contact(self, patch: int) -> Contact:
        """Returns the Contact of a patch, to be read: body 1 is the wheel, and the next solve changes it."""
        made = ctypes.c_void_p()
        self._call("get_contact", patch, byref(made))
        return Contact._of_handle(made.value, self._context)

    @property
    def contacts(self) -> list[Contact]:
        """Returns the contacts of all patches of the last solve."""
        return [self.contact(patch) for patch in range(self.patch_count)]

    def _about(self):
        try:
            force, _ = self.resultant()
        except RollconError:
            return "not solved"
        count = self.patch_count
        return f"{count} patch{'es' if count != 1 else ''}, force on the wheel {shown(force)}"

    def plot_patches(self, ax=None):
        """Draws wheel and rail where they touch, and the pressures; returns the axes of matplotlib. See
        rollcon.plots."""
        from . import plots
        return plots.patches(self, ax)

    def plot_passage(self, positions, velocities, ax=None):
        """Solves positions[n, 6] with velocities in their order, and draws the rail from above with the patches, and
        the forces over x; returns two axes of matplotlib. See rollcon.plots.passage."""
        from . import plots
        return plots.passage(self, positions, velocities, ax)
