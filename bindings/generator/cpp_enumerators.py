"""Writes src/capi/enumerators.cpp: that the enumerators inside the library are those of the header."""

import re

OPENING = """\
/// Generated from bindings/api.toml by bindings/generate.py; do not edit.
/// Asserts that the enumerators inside the library are those of the header; this file can only fail to compile.

#include "bodies/body.hpp"
#include "contact/contact.hpp"
#include "mesh/volume_type.hpp"
#include "rollcon.h"

namespace rollcon {

template <class E>
constexpr bool same(E inside, int outside) {
  return static_cast<int>(inside) == outside;
}

// clang-format off
"""

# Enumerations of the table and those inside that have all their values.
INSIDE = {"status": ["Status"], "body kind": ["BodyKind"], "element type": ["ElementType"],
          "direction": ["Direction", "Parameter"], "parameter": ["Parameter"], "how": ["How"], "axes": ["InAxes"],
          "field": ["Field"], "node status": ["NodeStatus"], "step": ["StepKind"], "log level": ["LogLevel"],
          "option type": ["SettingType"], "phase": ["Phase"]}
NAMES = {"TYPE_INT": "integer", "TYPE_STR": "text"}


def inside(name):
    """Returns the name inside: ROLLCON_FIELD_SLIP is slip, ROLLCON_TILT_1 tilt1."""
    name = name.removeprefix("ROLLCON_")
    short = re.sub(r"^(BODY|FIELD|LOG|TYPE|PHASE)_|_STEP$", "", name).lower()
    return NAMES.get(name, re.sub(r"_(?=\d)", "", short))


def write(table):
    out = [OPENING]
    for enum in table.enums:
        for kind in INSIDE.get(enum.name, []):
            for name, number, _ in enum.values:
                one = "VolumeType" if kind == "ElementType" and number >= 300 else kind
                out.append(f"static_assert(same({one}::{inside(name)}, {name}));\n")
    return "".join(out) + "// clang-format on\n\n}  // namespace rollcon\n"
