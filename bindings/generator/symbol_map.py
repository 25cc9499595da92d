"""Writes cmake/rollcon.map: the linker version script that exports exactly the API."""


def write(table):
    names = "".join(f"    {f.name};\n" for f in sorted(table.functions, key=lambda f: f.name))
    return ("# Generated from bindings/api.toml by bindings/generate.py; do not edit.\n"
            f"ROLLCON_{table.abi} {{\n  global:\n{names}  local:\n    *;\n}};\n")
