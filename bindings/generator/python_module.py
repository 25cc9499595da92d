"""bindings/python/rollcon/_api.py: ctypes declarations."""

NAMES = {"int32": "c_int32", "int64": "c_int64", "real": "c_double", "text": "c_char_p",
         "char": "c_char_p"}

OPENING = '''\
# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""The C interface of rollcon {version} for ctypes: enumerators, callback types, prototypes.

Handles are c_void_p, arrays are pointers; None passes NULL.
"""

from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int32, c_int64, c_void_p

VERSION = {version_tuple}
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
    return {"status": "c_int32", "int32": "c_int32", "text": "c_char_p",
            "void": "None"}.get(returns, "c_void_p")


def signature(function):
    types = [ctype(a) for a in function.args]
    line = f'    "{function.name}": ({return_ctype(function.returns)}, [{", ".join(types)}]),'
    if len(line) <= 100:
        return line
    half = (len(types) + 1) // 2
    return (f'    "{function.name}": ({return_ctype(function.returns)}, [\n'
            f'        {", ".join(types[:half])},\n        {", ".join(types[half:])}]),')


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
    return "".join(out) + "}\n" + CLOSING
