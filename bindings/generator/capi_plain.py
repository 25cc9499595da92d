"""Writes src/capi/plain.cpp: the C functions that hand their arguments to one method of the object."""

from generator.c_header import c_type, declaration, return_type

OPENING = """\
/// Generated from bindings/api.toml by bindings/generate.py; do not edit.
/// The functions that hand their arguments to one method of their object.

#include "bodies/body.hpp"
#include "capi/guard.hpp"
#include "capi/results.hpp"
#include "contact/contact.hpp"
#include "support/input_checks.hpp"
#include "tables/force_table.hpp"
#include "wheelrail/wheel_rail.hpp"

using namespace rollcon;
using namespace rollcon::capi;

// clang-format off
"""

GUARDS = {"context": "with_object(__func__, Kind::context, context, [&](Object& self) {{\n{}  }});",
          "body": "with_body(__func__, body, [&](Body& self) {{\n{}  }});",
          "contact": "with_contact(__func__, contact, [&](Contact& self) {{\n{}  }});",
          "wheelrail": "with_wheelrail(__func__, wheelrail, [&](WheelRail& self) {{\n{}  }});",
          "table": "with_table(__func__, table, [&](ForceTable& self) {{\n{}  }});"}


SHARED = "return with_shared(__func__, Kind::{0}, {0}, [&](Object& self) {{\n{1}  }});"


def statement(function):
    """Returns what is done with the object."""
    given = [a for a in function.args[1:] if not a.out and a.name != "capacity"]
    call = f"self.{function.calls}({', '.join(a.name for a in given)})"
    results = [a for a in function.args[1:] if a.out]
    if not results:
        # Only a solve has more to say than that it did not fail.
        return ("return " if "NOT_CONVERGED" in function.errors else "") + call + ";"
    if results[0].base == "char":
        return f"copy_text({call}, capacity, {results[0].name}, {results[1].name});"
    if len(results) > 1 or results[0].array:
        raise ValueError(f"{function.name}: no plain function for the C layer")
    return f'require_pointer({results[0].name}, "{results[0].name}"); *{results[0].name} = {call};'


def body(function):
    """Returns what a function does, or nothing if it is written by hand."""
    kind = function.group
    if function.name.endswith("_retain"):
        return f"return retain(__func__, Kind::{kind}, {kind});"
    if function.name.endswith("_release"):
        return f"release(Kind::{kind}, {kind});"
    if function.name.endswith("_from_id"):
        return f"return static_cast<rollcon_{kind}*>(const_cast<void*>(HandleTable::from_id(id)));"
    if "capi" not in function.plain:
        return ""
    lines = "".join(f"    {line};\n" for line in statement(function).rstrip(";").split("; "))
    if function.threads.startswith("any"):
        return SHARED.format(kind, lines.replace("self.", f"self.{kind}->"))
    return "return " + GUARDS[kind].format(lines)


def write(table):
    out = [OPENING]
    for function in table.functions:
        if body(function):
            head = declaration(return_type(function.returns) + function.name, function.args)
            out.append(f"\n{head[:-1]} {{\n  {body(function)}\n}}\n")
    return "".join(out) + "\n// clang-format on\n"
