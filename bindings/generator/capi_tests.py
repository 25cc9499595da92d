"""Writes tests/capi/every_call.hpp: one call of every function that has an object, for what holds for all of them."""

from generator.table import HANDLES

OPENING = """\
#pragma once
/// Generated from bindings/api.toml by bindings/generate.py; do not edit.
/// One call of every function with an object: check(name, whether any thread may call it at any
/// time, status). Their other arguments are harmless and no more.

#include <rollcon_layers.h>

#include <cstdint>

namespace capi_test {

// clang-format off
struct HarmlessArguments {
  double reals[64] = {1}, out[64] = {};
  std::int32_t integers[64] = {}, states[64] = {}, kind = 0;
  std::int64_t n = 0;
  char text[64] = "";
{handles}};
"""


def value(arg):
    """Returns a harmless argument."""
    if arg.base in HANDLES:
        return f"&a.{arg.base}" if arg.out else "nullptr"
    if arg.base in ("log_fn", "progress_fn", "user"):
        return "nullptr"
    if arg.base in ("text", "path"):
        return '"never_written"'
    if arg.base == "char":
        return "a.text"
    if arg.array or (arg.out and arg.base == "real"):
        return {"real": "a.out" if arg.out else "a.reals", "int32": "a.states" if arg.out else "a.integers"}[arg.base]
    if arg.out:
        return "&a.kind" if arg.base == "int32" else "&a.n"
    return "1"


def write(table):
    members = "".join(f"  rollcon_{h}* {h} = nullptr;\n" for h in HANDLES if h != "context")
    out = [OPENING.replace("{handles}", members)]
    for kind in HANDLES:
        out.append("template <class Check>\n"
                   f"void with_each_{kind}_call(const void* handle, Check&& check) {{\n"
                   f"  auto* object = static_cast<rollcon_{kind}*>(const_cast<void*>(handle));\n"
                   "  HarmlessArguments a;\n")
        for function in table.functions:
            first = function.args[0] if function.args else None
            if function.returns != "status" or not first or first.base != kind or first.out:
                continue
            words = ", ".join(["object"] + [value(arg) for arg in function.args[1:]])
            at_any_time = "true" if function.threads.startswith("any") else "false"
            out.append(f'  check("{function.name}", {at_any_time},\n        {function.name}({words}));\n')
        out.append("}\n")
    out.append("// clang-format on\n\n}  // namespace capi_test\n")
    return "\n".join(out).replace("\n\n  check", "\n  check").replace(";\n\n}", ";\n}")
