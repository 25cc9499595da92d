"""Finds the library."""

from __future__ import annotations

import ctypes
import os
import pathlib
import sys

from . import _api

NAMES = {"darwin": (f"librollcon.{_api.ABI}.dylib", "librollcon.dylib"), "win32": ("rollcon.dll",)}.get(
    sys.platform, (f"librollcon.so.{_api.ABI}", "librollcon.so"))

HELP = f"""rollcon finds no library {NAMES[0]}. It looked {{places}}.
What helps, whichever is nearest:
  - install a wheel that carries it: pip install PATH-TO-THE-SOURCES
  - say where it is: ROLLCON_LIBRARY=/path/to/{NAMES[-1]}
  - tell the loader: LD_LIBRARY_PATH=PREFIX/lib, or ldconfig after an installation to a standard place"""


def _files_of(folder):
    return [folder / name for name in NAMES if (folder / name).is_file()]


def candidates():
    """Yields pairs of a path and words for it: next to the package, in the prefix that it is installed in or the
    build folder of its source tree, where the system's loader looks."""
    here = pathlib.Path(__file__).resolve().parent
    found = [(path, "next to the package") for path in _files_of(here)]
    # The library is in one of the folders above PREFIX/lib/python3/dist-packages/rollcon, PREFIX/lib/TRIPLET/...
    for folder in list(here.parents)[1:4]:
        found += [(path, "in the prefix of the package") for path in
                  _files_of(folder) + [p for sub in sorted(folder.glob("*-linux-gnu*")) for p in _files_of(sub)]]
    source = here.parents[2]
    if (source / "bindings" / "api.toml").is_file():
        for folder in [source / "build", *sorted((source / "build").glob("*"))]:
            found += [(path, "in a build folder of the source tree") for path in _files_of(folder)]
    return [(str(path), where) for path, where in found] + [(name, "by the loader") for name in NAMES]


def _checked(path, where):
    """Returns the library with its functions' types; ImportError says what is wrong with it."""
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"cannot load librollcon, {where} as '{path}': {error}") from error
    if not hasattr(library, "rollcon_abi"):
        raise ImportError(f"'{path}', {where}, is not librollcon")
    if library.rollcon_abi() != _api.ABI:
        raise ImportError(f"'{path}', {where}, has ABI {library.rollcon_abi()}, this package needs "
                          f"{_api.ABI}: take both from one version of rollcon")
    try:
        return _api.declare(library)
    except AttributeError as error:
        raise ImportError(f"'{path}', {where}, is older than this package: {error}") from error


def load():
    """Returns path and library: that of ROLLCON_LIBRARY, which must serve, or the first that does."""
    named = os.environ.get("ROLLCON_LIBRARY")
    if named:
        return named, _checked(named, "named by ROLLCON_LIBRARY")
    failures = []
    for path, where in candidates():
        try:
            return path, _checked(path, where)
        except ImportError as error:
            if where != "by the loader" or "cannot open" not in str(error):
                failures.append(f"  - {error}")
    places = "next to the package, in the folders above it, and where the loader looks"
    raise ImportError("\n".join([HELP.format(places=places)] + (["What it found and could not use:"] + failures
                                                                  if failures else [])))
