"""The tables of solver settings and of statistics."""

import ctypes
from collections import namedtuple

from ._library import check, lib, read_text

Option = namedtuple("Option", "name type low high standard doc")


def option_table():
    """Every solver setting: name, type (TYPE_INT, TYPE_REAL, TYPE_STR), range, standard, doc."""
    rows = []
    for i in range(lib.rollcon_option_count()):
        name = ctypes.create_string_buffer(64)
        kind = ctypes.c_int32()
        low, high, standard = ctypes.c_double(), ctypes.c_double(), ctypes.c_double()
        check(lib.rollcon_option_info(i, len(name), name, ctypes.byref(kind), ctypes.byref(low),
                                      ctypes.byref(high), ctypes.byref(standard)))
        status, doc = read_text(lambda *a: lib.rollcon_option_doc(i, *a))
        check(status)
        rows.append(Option(name.value.decode(), kind.value, low.value, high.value, standard.value,
                           doc))
    return rows


def stat_names():
    """Names that Contact.stat knows."""
    names = []
    for i in range(lib.rollcon_stat_count()):
        status, name = read_text(lambda *a: lib.rollcon_stat_name(i, *a))
        check(status)
        names.append(name)
    return names
