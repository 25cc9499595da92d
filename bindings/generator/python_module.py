"""Writes bindings/python/rollcon/_api.py: ctypes declarations."""

import re
import textwrap

NAMES = {"int32": "c_int32", "row": "c_int32", "int64": "c_int64", "real": "c_double",
         "text": "c_char_p", "path": "c_char_p", "char": "c_char_p"}

OPENING = '''\
# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""The C interface of rollcon {version} for ctypes: enumerators, callback types, prototypes.

Handles are c_void_p, arrays are pointers; None passes NULL.
"""

from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int32, c_int64, c_void_p

VERSION = {version_tuple}
VERSION_TEXT = "{version}"
ABI = {abi}
'''

CLOSING = '''

def declare(library):
    """Gives every function of a loaded library its types."""
    for name, (restype, argtypes) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype = restype
        function.argtypes = argtypes
    return library
'''


def ctype(arg):
    if arg.base in ("log_fn", "progress_fn"):
        return arg.base
    base = NAMES.get(arg.base, "c_void_p")
    pointer = (arg.out or arg.array) and arg.base != "char"
    return f"POINTER({base})" if pointer else base


def return_ctype(returns):
    return {"status": "c_int32", "int32": "c_int32", "text": "c_char_p", "path": "c_char_p",
         "row": "c_int32",
            "void": "None"}.get(returns, "c_void_p")


def signature(function):
    types = [ctype(a) for a in function.args]
    line = f'    "{function.name}": ({return_ctype(function.returns)}, [{", ".join(types)}]),'
    if len(line) <= 100:
        return line
    half = (len(types) + 1) // 2
    return (f'    "{function.name}": ({return_ctype(function.returns)}, [\n'
            f'        {", ".join(types[:half])},\n        {", ".join(types[half:])}]),')


def names_of(enum):
    """Returns (name, number): "fem" and "body_fem", "quad4"."""
    words = [name.removeprefix("ROLLCON_").lower() for name, _, _ in enum.values]
    first = {word.split("_")[0] + "_" for word in words}
    common = first.pop() if len(first) == 1 and all("_" in word for word in words) else ""
    numbers = [number for _, number, _ in enum.values]
    short = [(word.removeprefix(common), n) for word, n in zip(words, numbers)]
    return short + ([(word, n) for word, n in zip(words, numbers)] if common else [])


def fill(head, text, tail):
    # No line ends within a name.
    lines = textwrap.wrap(re.sub(r'"[^"]*"', lambda m: m[0].replace(" ", "\0"), text), 90, break_long_words=False)
    lines = [line.replace("\0", " ") for line in lines]
    if len(head + text + tail) <= 100:
        return head + text + tail + "\n"
    return head + "\n" + "".join(f"        {line}\n" for line in lines) + "    " + tail + "\n"


def write(table):
    out = [OPENING.format(version=table.version_text, version_tuple=table.version, abi=table.abi)]
    for enum in table.enums:
        out.append(f"\n# {enum.name}\n")
        for name, number, _ in enum.values:
            out.append(f"{name.removeprefix('ROLLCON_')} = {number}\n")
    out.append("\n")
    for callback in table.callbacks:
        types = ", ".join([return_ctype(callback.returns)] + [ctype(a) for a in callback.args])
        out.append(f"{callback.name.removeprefix('rollcon_')} = CFUNCTYPE({types})\n")
    out.append("\nSTATUS_NAMES = {\n")
    for name, number, _ in table.enums[0].values:
        out.append(f'    {number}: "{name.removeprefix("ROLLCON_")}",\n')
    out.append("}\n\nFUNCTIONS = {\n")
    out += [signature(function) + "\n" for function in table.functions]
    out.append("}\n\n# Names of the values of enumerations, with and without what all of them begin with.\n"
               "ENUMERATORS = {\n")
    for enum in table.enums:
        pairs = ", ".join(f'"{name}": {number}' for name, number in names_of(enum))
        out.append(fill(f'    "{enum.name}": {{', pairs, "},"))
    out.append("}\n\n# Names of arguments and, of enumerators, their enumerations.\nARGUMENTS = {\n")
    for function in table.functions:
        pairs = ", ".join(f'("{a.name}", "{a.enum}")' if not a.out else f'("{a.name}", "")'
                          for a in function.args)
        out.append(fill(f'    "{function.name}": [', pairs, "],"))
    return "".join(out) + "}\n" + CLOSING
