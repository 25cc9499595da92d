"""Gives what the generated tests of the layers pass for each argument, what the recorder writes down then, and what
it gives."""

import re

from generator import recorder
from generator.table import HANDLES

N = 2  # entries of arrays of n
CAPACITY = 6  # numbers that fit, where the caller of a layer says so
ELEMENT_TYPE, ELEMENT_NODES = 203, 3
SIZES = {"nodes": 3, "elements": 2, "n_rows": 2, "n_values": 6, "n_nodes": 3}  # sizes of tests/bindings/record.h
SECOND = {"body2", "rail"}  # handles that are the second of their kind; others are the first


def counts(function, arg):
    """Says whether the argument is the extent of an array."""
    return arg.name in ("n", "nodes", "points", "n_cases") and any(a.shape.startswith(f"[{arg.name}]") or a.shape.startswith("[n*")
                                              for a in function.args)


def integer(function, position):
    arg = function.args[position]
    if arg.enum == "element type":
        return ELEMENT_TYPE
    return N if counts(function, arg) else 10 * position + 1


def real(position):
    return position + 0.5


def text(position):
    return f"text {position}"


def extent(arg):
    total = 1
    for part in re.findall(r"\[(.+?)\]", arg.shape):
        total *= {"n": N, "nodes": N, "points": N, "n_cases": N, "n*3": 3 * N, "capacity": CAPACITY, "nodes of the type": ELEMENT_NODES, "columns": 2}.get(part) or int(part)
    return total


def reals(function, position):
    return [position + (k + 1) / 8 for k in range(extent(function.args[position]))]


def integers(function, position):
    return [10 * position + k + 1 for k in range(extent(function.args[position]))]


def listed(values):
    return "[" + " ".join(f"{v:.10g}" for v in values) + "]"


def written(function, position, given=None):
    """Returns what the recorder writes for an argument; `given` replaces the sample."""
    arg = function.args[position]
    if not recorder.recording(arg):
        return []
    if given is not None:
        return [given]
    if arg.out:
        return ["room"]
    if arg.array:
        return [listed(reals(function, position) if arg.base == "real" else integers(function, position))]
    if arg.base in HANDLES:
        return [arg.base + ("2" if arg.name in SECOND else "1")]
    if arg.base in ("text", "path"):
        return [f"<{text(position)}>"]
    if arg.name == "capacity":
        return [str(capacity(function))]
    return [f"{real(position):.10g}" if arg.base == "real" else str(integer(function, position))]


def given_text(function):
    return "text of " + function.name.removeprefix("rollcon_")


def capacity(function, numbers=CAPACITY):
    """Returns the room that a layer makes, for texts what they need."""
    return len(given_text(function)) + 1 if any(a.base == "char" for a in function.args) else numbers


def record(function, given=()):
    """Returns the whole line; `given` has positions and what is written there."""
    given = dict(given)
    return " ".join(word for i in range(len(function.args)) for word in written(function, i, given.get(i)))


def result(function, position):
    """Returns what comes out of a result that is no text: a number or a list."""
    arg = function.args[position]
    half = 0.5 if arg.base == "real" else 0
    if arg.array:
        return [100 * position + k + half for k in range(extent(arg))]
    return SIZES.get(arg.name, 100 * position) if arg.base == "int64" else 100 * position + half
