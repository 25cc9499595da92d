"""Computes what yield criteria need of stresses."""

from __future__ import annotations

from typing import TYPE_CHECKING
from ._arrays import reals, room
from ._library import check, lib

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike


def stress_invariants(stress: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns the principal stresses [n, 3], the largest first, von Mises's stress [n] and the largest shear stress
    [n] of stresses [n, 6]: s11, s22, s33, s12, s13, s23."""
    stress, given = reals(stress, 6)
    principal, first = room(len(stress), 3)
    von_mises, second = room(len(stress))
    shear, third = room(len(stress))
    check(lib.rollcon_stress_invariants(len(stress), given, first, second, third))
    return principal, von_mises, shear
