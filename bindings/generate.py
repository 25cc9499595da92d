#!/usr/bin/env python3
"""Writes everything that follows from bindings/api.toml.

    bindings/generate.py            write the files that changed
    bindings/generate.py --check    write nothing; exit status 1 if a file differs
"""

import argparse
import difflib
import sys
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bindings"))

from generator import (c_header, cpp_tables, fortran_module, python_module,  # noqa: E402
                       reference, symbol_map, table)


def outputs(api):
    contract = (ROOT / "bindings/api_contract.md").read_text(encoding="utf-8")
    return {
        "include/rollcon.h": c_header.write(api),
        "src/capi/api_tables.hpp": cpp_tables.write(api),
        "cmake/rollcon.map": symbol_map.write(api),
        "fortran/rollcon_c.f90": fortran_module.write(api),
        "bindings/python/rollcon/_api.py": python_module.write(api),
        "docs/api.md": reference.write(api, contract),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="only compare; 1 if a file differs")
    check = parser.parse_args().check
    api = table.load(ROOT / "bindings/api.toml")
    stale = 0
    for name, text in outputs(api).items():
        path = ROOT / name
        old = path.read_text(encoding="utf-8") if path.exists() else ""
        if old == text:
            continue
        stale += 1
        if check:
            sys.stdout.writelines(difflib.unified_diff(
                old.splitlines(True), text.splitlines(True), name, name + " (regenerated)"))
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            print("wrote", name)
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
