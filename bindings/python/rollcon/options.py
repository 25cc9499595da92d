"""Provides the tables of settings and of statistics."""

from __future__ import annotations

import ctypes
from collections import namedtuple

from ._library import check, enumerator, lib

Option = namedtuple("Option", "name type low high standard doc")
Stat = namedtuple("Stat", "name doc inside")


def _rows(count, info, kind, *results):
    """Yields name, doc and other results of each row of the table of a kind."""
    kind = enumerator(kind, "kind of object", "kind")
    for i in range(count(kind)):
        need = ctypes.c_int64()
        check(info(kind, i, 0, None, None, ctypes.byref(need), *(None for _ in results)))
        texts = [ctypes.create_string_buffer(need.value) for _ in range(2)]
        values = [result() for result in results]
        check(info(kind, i, need.value, *texts, None, *(ctypes.byref(value) for value in values)))
        yield [text.value.decode() for text in texts] + [value.value for value in values]


def option_table(kind: int | str = "contact") -> list[Option]:
    """Returns every setting of a kind of object ("body", "contact", ...): name, type (TYPE_INT, TYPE_REAL, TYPE_STR),
    range, standard, doc."""
    real = ctypes.c_double
    return [Option(name, *values, doc) for name, doc, *values in
            _rows(lib.rollcon_option_count, lib.rollcon_option_info, kind, ctypes.c_int32, real, real, real)]


def stat_table(kind: int | str = "contact") -> list[Stat]:
    """Returns every statistic of a kind of object ("body", "contact", "wheelrail", "patch"): name, doc, and inside:
    1 if it counts work inside the library, which is promised to nobody."""
    return [Stat(*row) for row in _rows(lib.rollcon_stat_count, lib.rollcon_stat_info, kind, ctypes.c_int32)]
