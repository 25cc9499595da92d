"""Reads bindings/api.toml into plain objects and checks it."""

import re
import tomllib
from dataclasses import dataclass

SCALARS = {"int32", "int64", "real", "row"}
TEXTS = {"text", "path", "char"}
# Handles begin with these numbers by kind (src/capi/handle_table.hpp).
HANDLES = {"context": 1, "body": 2, "contact": 3, "wheelrail": 4, "table": 5}
OPAQUE = set(HANDLES) | {"event", "handle"}
OTHERS = {"log_fn", "progress_fn", "user"}
RETURNS = {"status", "int32", "text", "void"} | set(HANDLES)
THREADS = {
    "any": "any thread at any time.",
    "object": "one thread at a time per object; a second one gets ROLLCON_ERR_BUSY.",
}
ARGUMENT = re.compile(r"(const |out )?(\w+)(?::([\w ]+))?(\[.+\])?(\?)?$")
LAYERS = {"capi", "fortran", "python"}


@dataclass
class Argument:
    name: str
    base: str
    out: bool
    const: bool
    shape: str  # "[n][3]", or "" for a scalar
    optional: bool
    doc: str
    enum: str  # name of the enumeration whose values an int32 takes, or ""

    @property
    def array(self):
        return bool(self.shape)


@dataclass
class Function:
    name: str  # with the prefix rollcon_
    returns: str
    doc: str
    args: list
    errors: list
    ownership: str
    threads: str
    source: str
    group: str  # "body", "contact", ...: the first word of the name
    f77: list  # names in the FORTRAN 77 layer; the second is that of a variant, see fortran_77.py
    plain: set  # layers in which the function is generated: "capi", "fortran", "python"
    calls: str  # what the C layer calls on the object; standard: the method of this name
    defaults: dict  # arguments that Fortran and Python may leave out, at the end
    python: dict  # "name", "property", "defaults" in Python
    fortran: str  # name of the type-bound procedure

    @property
    def verb(self):
        """Returns the name without prefix and kind of object."""
        return self.name.removeprefix("rollcon_").removeprefix(self.group + "_")


@dataclass
class Callback:
    name: str
    returns: str
    doc: str
    args: list


@dataclass
class Enum:
    name: str
    doc: str
    values: list  # (name with prefix, number, doc)


@dataclass
class Group:
    title: str
    doc: str
    functions: list
    header: str  # file in include/ that declares them


@dataclass
class Table:
    version: tuple
    prerelease: str
    abi: int
    features: list  # (name, built, doc)
    enums: list
    callbacks: list
    groups: list

    @property
    def functions(self):
        return [f for group in self.groups for f in group.functions]

    def number(self, value):
        """Returns what a default stands for, a number or the name of an enumerator."""
        names = {name: number for enum in self.enums for name, number, _ in enum.values}
        return float(names.get("ROLLCON_" + value, value))

    @property
    def version_text(self):
        return ".".join(str(part) for part in self.version) + ("-" + self.prerelease if self.prerelease else "")


def parse_argument(row, where):
    match = ARGUMENT.match(row[1])
    if not match:
        raise ValueError(f"{where}: cannot read the type '{row[1]}'")
    prefix, base, enum, shape, optional = match.groups()
    if base not in SCALARS | TEXTS | OPAQUE | OTHERS:
        raise ValueError(f"{where}: unknown type '{base}'")
    if base == "char" and not shape:
        raise ValueError(f"{where}: char needs a shape")
    return Argument(row[0], base, prefix == "out ", prefix == "const " or base == "handle",
                    shape or "", bool(optional), row[2] if len(row) > 2 else "", enum or "")


def parse_arguments(rows, where):
    args = [parse_argument(row, f"{where}, {row[0]}") for row in rows]
    names = [a.name.lower() for a in args]
    if len(set(names)) != len(names):
        raise ValueError(f"{where}: repeated argument")
    return args


def parse_function(entry, statuses):
    where = entry["name"]
    unknown = set(entry) - {"name", "returns", "doc", "args", "errors", "ownership", "threads",
                            "source", "f77", "plain", "calls", "defaults", "python", "fortran"}
    if unknown:
        raise ValueError(f"{where}: unknown keys {sorted(unknown)}")
    returns = entry.get("returns", "status")
    errors = entry.get("errors", [])
    if returns not in RETURNS:
        raise ValueError(f"{where}: unknown return type '{returns}'")
    if (returns == "status") != bool(errors):
        raise ValueError(f"{where}: functions with a status, and only those, list their errors")
    for name in errors:
        if name not in statuses:
            raise ValueError(f"{where}: unknown status {name}")
    threads = THREADS[entry.get("threads", "object")]
    return Function("rollcon_" + where, returns, entry["doc"],
                    parse_arguments(entry.get("args", []), where), errors,
                    entry.get("ownership", ""), threads, entry.get("source", ""),
                    where.split("_")[0], *layers(entry, where))


def check_common_errors(function):
    """Checks what the header says once: which statuses every function with a handle may return."""
    if function.returns != "status":
        return
    handle = bool(function.args) and function.args[0].base in OPAQUE and not function.args[0].out
    alone = handle and not function.threads.startswith("any")
    for name, due in (("ERR_ARGUMENT", True), ("ERR_HANDLE", handle), ("ERR_BUSY", alone)):
        if (name in function.errors) != due:
            raise ValueError(f"{function.name}: {name} must{'' if due else ' not'} be listed")


def layers(entry, where):
    """Checks what concerns the layers over the C interface."""
    f77 = entry.get("f77", [])
    f77 = [f77] if isinstance(f77, str) else f77
    plain = set(entry.get("plain", []))
    if plain - LAYERS:
        raise ValueError(f"{where}: unknown layers {sorted(plain - LAYERS)}")
    verb = where.split("_", 1)[-1]
    python = entry.get("python", {})
    if set(python) - {"name", "property", "defaults"}:
        raise ValueError(f"{where}: unknown keys for Python")
    return (f77, plain, entry.get("calls", verb), entry.get("defaults", {}), python,
            entry.get("fortran", verb))


def parse_enum(entry):
    values = [("ROLLCON_" + name, number, doc) for name, number, doc in entry["values"]]
    numbers = [number for _, number, _ in values]
    if len(set(numbers)) != len(numbers):
        raise ValueError(f"enum {entry['name']}: repeated number")
    return Enum(entry["name"], entry["doc"], values)


def load(path):
    with open(path, "rb") as stream:
        raw = tomllib.load(stream)
    enums = [parse_enum(entry) for entry in raw["enum"]]
    statuses = {name.removeprefix("ROLLCON_") for name, _, _ in enums[0].values}
    callbacks = [Callback("rollcon_" + c["name"], c["returns"], c["doc"],
                          parse_arguments(c["args"], c["name"])) for c in raw["callback"]]
    groups = [Group(g["title"], g["doc"], [parse_function(f, statuses) for f in g["function"]],
                    g.get("header", "rollcon.h"))
              for g in raw["group"]]
    features = [(f["name"], f["built"], f["doc"]) for f in raw["feature"]]
    table = Table(tuple(raw["library"]["version"]), raw["library"]["prerelease"], raw["library"]["abi"], features,
                  enums, callbacks, groups)
    for function in table.functions:
        check_common_errors(function)
    known = {enum.name for enum in enums}
    for function in table.functions:
        for arg in function.args:
            for enum in filter(None, arg.enum.split(" or ")):
                if enum not in known:
                    raise ValueError(f"{function.name}: unknown enumeration '{enum}'")
    names = [f.name for f in table.functions] + [v[0] for e in enums for v in e.values]
    if len({name.lower() for name in names}) != len(names):
        raise ValueError("two names differ by case only: Fortran cannot tell them apart")
    return table
