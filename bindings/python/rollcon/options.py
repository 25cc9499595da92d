"""Provides the tables of settings and of statistics."""

from __future__ import annotations

import ctypes
from collections import namedtuple

from ._library import check, lib, read_text

Option = namedtuple("Option", "name type low high standard doc")


def _options(count, info, explain):
    rows = []
    for i in range(count()):
        name = ctypes.create_string_buffer(64)
        kind = ctypes.c_int32()
        low, high, standard = ctypes.c_double(), ctypes.c_double(), ctypes.c_double()
        check(info(i, len(name), name, ctypes.byref(kind), ctypes.byref(low), ctypes.byref(high),
                   ctypes.byref(standard)))
        status, doc = read_text(lambda *a: explain(i, *a))
        check(status)
        rows.append(Option(name.value.decode(), kind.value, low.value, high.value, standard.value,
                           doc))
    return rows


def _names(count, name_of):
    names = []
    for i in range(count()):
        status, name = read_text(lambda *a: name_of(i, *a))
        check(status)
        names.append(name)
    return names


def option_table() -> list[Option]:
    """Returns every solver setting: name, type (TYPE_INT, TYPE_REAL, TYPE_STR), range, standard, doc."""
    return _options(lib.rollcon_option_count, lib.rollcon_option_info, lib.rollcon_option_doc)


def body_option_table() -> list[Option]:
    """Returns every setting of a body, in the manner of option_table()."""
    return _options(lib.rollcon_body_option_count, lib.rollcon_body_option_info,
                    lib.rollcon_body_option_doc)


def stat_names() -> list[str]:
    """Returns the names that Contact.stat knows."""
    return _names(lib.rollcon_stat_count, lib.rollcon_stat_name)


def body_stat_names() -> list[str]:
    """Returns the names that Body.stat knows."""
    return _names(lib.rollcon_body_stat_count, lib.rollcon_body_stat_name)


def wheelrail_stat_names() -> list[str]:
    """Returns the names that WheelRail.stat knows."""
    return _names(lib.rollcon_wheelrail_stat_count, lib.rollcon_wheelrail_stat_name)


def wheelrail_patch_stat_names() -> list[str]:
    """Returns the names that WheelRail.patch_stat knows."""
    return _names(lib.rollcon_wheelrail_patch_stat_count, lib.rollcon_wheelrail_patch_stat_name)
