"""Writes tests/bindings/recorded_calls.c: every function of the headers, written down instead of done (see record.h
there).

`arguments` says what each writes, and so what the tests of the layers expect.
"""

import re

from generator.c_header import declaration, return_type
from generator.table import HANDLES

OPENING = """\
/* Generated from bindings/api.toml by bindings/generate.py; do not edit. */
#include "record.h"
#include "rollcon_layers.h"

/* clang-format off */
"""

# Other calls ask for the size of these results before they make room.
COUNTS = {"nodes": "RECORD_NODES", "elements": "RECORD_ELEMENTS", "n_rows": "RECORD_ROWS",
          "n_values": "RECORD_VALUES", "n_nodes": "RECORD_NODES", "n_results": "capacity"}


def size(arg):
    """Returns the entries of an array, in C."""
    words = {"nodes of the type": "record_nodes_of(type)", "parameters": "record_words(parameters)",
             "columns": "record_words(columns)"}
    return " * ".join(words.get(part, part) for part in re.findall(r"\[(.+?)\]", arg.shape))


def recording(arg):
    """Returns the statement that writes one argument down."""
    if arg.shape == "[n*3]":
        return f"record_nodes({arg.name}, n, node_stride, component_stride)"
    if arg.name in ("node_stride", "component_stride"):
        return ""
    if arg.out:
        return f"record_room({arg.name})"
    if arg.array:
        return f"record_{'reals' if arg.base == 'real' else 'integers'}({arg.name}, {size(arg)})"
    if arg.base in ("text", "path"):
        return f"record_text({arg.name})"
    if arg.base == "real":
        return f"record_real({arg.name})"
    if arg.base in ("int32", "int64", "row"):
        return f"record_integer({arg.name})"
    if arg.base == "event":
        return f"record_integer((intptr_t){arg.name})"
    if arg.base in ("log_fn", "progress_fn"):  # called at once: what it answers is written down
        return {"log_fn": 'if (fn) fn(2, "a message", user)',
                "progress_fn": "const int64_t told = fn ? fn((const rollcon_event*)7, user) : 0"}[arg.base]
    if arg.base == "user":
        return ""  # the callback gets it
    return f"record_handle({arg.name})"


def giving(function, position):
    """Returns the statement that gives the result at a position."""
    arg = function.args[position]
    number = f"recorded_{function.name}"
    if arg.base in HANDLES:
        return f"if ({arg.name}) *{arg.name} = (rollcon_{arg.base}*)give_handle({HANDLES[arg.base]})"
    if arg.base == "char":
        need = "needed" if any(a.name == "needed" for a in function.args) else "0"
        return f"give_text({arg.name}, capacity, {need}, {number})"
    if arg.name == "needed":
        return ""
    if arg.name in COUNTS and arg.base == "int64":
        return f"give_count({arg.name}, {COUNTS[arg.name]})"
    if arg.base == "real":
        return f"give_reals({arg.name}, {size(arg) or 1}, {position})"
    if arg.base == "int64":
        return f"give_integer64({arg.name}, {position})"
    return f"give_integer32({arg.name}, {size(arg) or 1}, {position})"


def returned(function):
    """Returns what a function returns."""
    if function.returns == "status":
        return "return record_end();"
    if function.returns == "void":
        return ""
    if function.name == "rollcon_abi":
        return "return ROLLCON_ABI;"  # the layers ask
    if function.name == "rollcon_id_of":
        return "return (int32_t)(intptr_t)handle;"
    if function.name == "rollcon_report":
        return "return status;"
    if function.returns in HANDLES:
        return f"return (rollcon_{function.returns}*)(intptr_t)id;"
    if function.returns == "text":
        return f'return "text of {function.name.removeprefix("rollcon_")}";'
    return "return RECORD_COUNT;"


def write(table):
    names = [f.name.removeprefix("rollcon_") for f in table.functions]
    out = [OPENING, "const char* const recorded_names[] = {\n" + "".join(f'  "{n}",\n' for n in names) + "};\n",
           f"const int recorded_number = {len(names)};\n",
           "enum {\n" + "".join(f"  recorded_rollcon_{n},\n" for n in names) + "};\n"]
    for function in table.functions:
        head = declaration(return_type(function.returns) + function.name, function.args)[:-1]
        begin = [f"record_begin(recorded_{function.name})"]
        lines = begin + [recording(a) for a in function.args]
        for i, arg in enumerate(function.args):  # a callback calls others, whose lines come between
            if arg.base in ("log_fn", "progress_fn"):
                told = "told" if arg.base == "progress_fn" else "0"
                lines = [recording(arg)] + begin + [recording(a) for a in function.args[:i]]
                lines += [f"if (fn) record_integer({told}); else record_room(0)"]
        lines += [giving(function, i) for i, a in enumerate(function.args) if a.out]
        body = "".join(f"  {line};\n" for line in lines if line)
        last = returned(function)
        out.append(f"{head} {{\n{body}" + (f"  {last}\n" if last else "") + "}\n")
    return "\n".join(out)
