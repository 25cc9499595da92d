"""rollcon for Python: frictional rolling contact by the C library librollcon.

Context, Body, Contact, WheelRail and Table wrap the handles of rollcon.h; each object releases its handle when it
is closed, leaves a `with` block or is collected. Failures raise RollconError. Arrays are numpy
arrays of float64, x[n, 3]; node numbers count from 0. Contiguous arrays are passed without a copy.
"""

from . import _api
from ._api import *  # noqa: F401,F403 - the enumerators: BODY_RIGID, QUAD4, BY_FORCE, ...
from ._library import (RollconError, build_info, has_feature, last_caveat, last_error, library_path,
                       status_string, version, version_string)
from .body import Body
from .contact import Contact
from .context import Context
from .status import Status
from .options import option_table, stat_table
from .stresses import stress_invariants
from .table import Table
from .wear import wear_profile
from .wheelrail import (WheelRail, conicity, contact_points, nonlinearity_parameter,
                        rolling_radii_coefficient)

__version__ = _api.VERSION_TEXT.replace("-", "")  # in the form of PEP 440: 1.0.0rc2
__all__ = [name for name, value in vars(_api).items() if name.isupper() and isinstance(value, int)]
__all__ += ["Body", "Contact", "Context", "RollconError", "Status", "Table", "WheelRail", "build_info", "conicity",
            "contact_points", "has_feature", "last_caveat", "last_error", "library_path", "nonlinearity_parameter",
            "option_table", "rolling_radii_coefficient", "stat_table", "status_string", "stress_invariants",
            "version", "version_string", "wear_profile"]
