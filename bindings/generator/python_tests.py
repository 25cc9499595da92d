"""Writes tests/python/mapping_rows.py: what the test of the Python layer calls, what is written down, what comes
back."""

from generator import samples
from generator.python_plain import Method

OPENING = '''\
# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""Calls of the plain methods: object, method, arguments, function of C, what is written down, results."""

from collections import namedtuple
from itertools import starmap

Row = namedtuple("Row", "object method property arguments function record result")
ROWS = list(starmap(Row, [
'''


def standard(table, default):
    """Returns what the recorder writes for a default."""
    return f"<{default[1:-1]}>" if default.startswith('"') else f"{table.number(default):.10g}"


def row(table, function, absent=False, short=False):
    """Returns one call; in `absent` arrays that may be None are, in `short` what has a default is left out."""
    method = Method(function)
    for arg in function.args[1:]:
        method.take(arg)
    arguments, given, results = {}, {}, []
    for i, arg in enumerate(function.args[1:], 1):
        if arg.base == "char":
            results.append(samples.given_text(function))
        elif arg.name in ("needed", "capacity"):
            pass
        elif arg.out:
            results.append(samples.result(function, i))
        elif arg.array and absent:
            arguments[arg.name], given[i], given[i - 1] = None, "null", "0"
        elif arg.array:
            values = samples.reals(function, i) if arg.base == "real" else samples.integers(function, i)
            width = len(values) // samples.N if arg.shape.count("[") == 2 else 0
            arguments[arg.name] = [values[k:k + width] for k in range(0, len(values), width)] if width else values
        elif arg.base in ("text", "path"):
            arguments[arg.name] = samples.text(i)
        elif not samples.counts(function, arg):
            arguments[arg.name] = samples.real(i) if arg.base == "real" else samples.integer(function, i)
    order = sorted(method.given, key=lambda pair: pair[1] != "")
    if short:
        place = {a.name: i for i, a in enumerate(function.args)}
        given.update((place[name], standard(table, default[1:].replace("_api.", ""))) for name, default in order if default)
        order = [pair for pair in order if not pair[1]]
    values = tuple(arguments[name] for name, _ in order)
    result = tuple(results) if len(results) > 1 else results[0] if results else None
    return (function.group, method.name(), bool(method.options.get("property")), values,
            function.name.removeprefix("rollcon_"), samples.record(function, given), result)


def write(table):
    rows = []
    for function in table.functions:
        if "python" in function.plain:
            rows.append(row(table, function))
            if any(a.array and a.optional and a.base == "real" and not a.out for a in function.args):
                rows.append(row(table, function, absent=True))
            if function.defaults or function.python.get("defaults"):
                rows.append(row(table, function, short=True))
    return OPENING + "".join(f"    {r!r},\n" for r in rows) + "]))\n"
