"""Wears profiles."""

from __future__ import annotations

from ctypes import byref, c_double
from typing import TYPE_CHECKING

from ._arrays import reals, room
from ._library import call, check, lib

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike


def wear_profile(yz: ArrayLike, rate: ArrayLike, side: int | str, distance: float, most_depth: float,
                 smoothing: float = 0) -> tuple[np.ndarray, float]:
    """Wears points yz[n, 2] of a profile by rate[n], depth per distance, along the normal: returns the worn points,
    and how much of the distance was taken so that none is worn deeper than most_depth. side: BODY_BELOW, the body lies
    at greater z (a rail), or BODY_ABOVE (a wheel). smoothing: waves of that length keep one half."""
    yz, given = reals(yz, 2)
    rate, rates = reals(rate)
    if len(rate) != len(yz):
        raise ValueError(f"{len(yz)} points, but {len(rate)} rates")
    worn, address = room(len(yz), 2)
    taken = c_double()
    check(call(lib.rollcon_wear_profile, len(yz), given, rates, side, distance, most_depth, smoothing, address,
               byref(taken)))
    return worn, taken.value
