"""Writes bindings/python/rollcon/_plain.py: the methods that hand their arguments to one C function."""

import re
import textwrap

from generator.table import HANDLES

OPENING = '''\
# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""The plain methods of the classes: one call of the library each."""

from __future__ import annotations

from ctypes import byref, c_double, c_int32, c_int64
from typing import TYPE_CHECKING

from . import _api
from ._arrays import integer_list, reals, room, vector
from ._library import c_path, c_text, check, lib, read_text

if TYPE_CHECKING:
    from os import PathLike

    from numpy import ndarray
    from numpy.typing import ArrayLike
'''

HINTS = {"real": "float", "text": "str", "path": "str | PathLike"}
C_TYPES = {"int32": "c_int32", "int64": "c_int64", "real": "c_double"}


class Method:
    """Is one method while it is written."""

    def __init__(self, function):
        self.function = function
        self.options = function.python
        self.given, self.before, self.call, self.results = [], [], [], []
        self.hints, self.made = {}, []  # types of parameters, by name; of results
        self.text = False

    def name(self):
        verb = self.function.verb
        return self.options.get("name", verb.removeprefix("get_"))

    def parameter(self, name):
        default = self.options.get("defaults", {}).get(name, self.function.defaults.get(name))
        if default is None:
            self.given.append((name, ""))
        else:
            default = re.sub(r"^([A-Z])", r"_api.\1", default)
            self.given.append((name, f"={default}"))

    def counted(self):
        return next((a for a in self.function.args if a.shape.startswith("[n]") and not a.out), None)

    def take(self, arg):
        if arg.base == "char":
            self.text = True
        elif self.text:
            pass  # the need of the text
        elif arg.out:
            self.take_result(arg)
        elif arg.array:
            self.take_array(arg)
        elif arg.name == "n" and self.counted():
            name = self.counted().name
            self.call.append(f"len({name})")
        elif arg.name != "capacity":
            self.parameter(arg.name)
            self.hints[arg.name] = "int | str" if arg.enum else HINTS.get(arg.base, "int")
            self.call.append({"text": f"c_text({arg.name}, \"{arg.name}\")",
                              "path": f"c_path({arg.name})"}.get(arg.base, arg.name))

    def take_array(self, arg):
        self.parameter(arg.name)
        self.hints[arg.name] = "ArrayLike | None" if arg.optional and arg.base == "real" else "ArrayLike"
        at = f"{arg.name}_at"
        parts = re.findall(r"\[(.+?)\]", arg.shape)
        if parts == ["3"]:
            make = f"vector({arg.name})"
        elif len(parts) == 1 and parts[0].isdigit():
            make = f"vector({arg.name}, {parts[0]})"
        elif arg.base == "int32":
            make = f"integer_list({arg.name}, \"{arg.name}\")"
        else:
            make = f"reals({arg.name}{', ' + parts[1] if len(parts) == 2 else ''})"
        if arg.optional and arg.base == "real":
            self.before += [f"if {arg.name} is None:", f"    {arg.name} = ()", f"    {at} = None", "else:",
                            f"    {arg.name}, {at} = {make}"]
        else:
            self.before.append(f"{arg.name}, {at} = {make}")
        self.call.append(at)

    def take_result(self, arg):
        if arg.array:
            extents = ", ".join(re.findall(r"\[(.+?)\]", arg.shape))
            self.before.append(f"{arg.name}, {arg.name}_at = room({extents})")
            self.call.append(f"{arg.name}_at")
            self.results.append(arg.name)
            self.made.append("ndarray")
        else:
            self.before.append(f"{arg.name} = {C_TYPES[arg.base]}()")
            self.call.append(f"byref({arg.name})")
            self.results.append(f"{arg.name}.value")
            self.made.append("float" if arg.base == "real" else "int")

    def heading(self, parameters):
        made = self.made or (["int"] if "NOT_CONVERGED" in self.function.errors else ["None"])
        result = "str" if self.text else made[0] if len(made) == 1 else f"tuple[{', '.join(made)}]"
        start = f"    def {self.name()}("
        # No line ends within a parameter, nor before the arrow, where the parenthesis is closed.
        end = f")\0->\0{result}:".replace(", ", ",\0")
        lines = textwrap.wrap(start + ", ".join(["self"] + [p.replace(" ", "\0") for p in parameters]) + end, 100,
                              subsequent_indent=" " * len(start), break_on_hyphens=False)
        return [line.replace("\0", " ") for line in lines]

    def doc(self):
        """Puts the documentation in Python's words: names of Python, None for NULL."""
        text = " ".join(self.function.doc.split()).replace("ROLLCON_", "").replace("NULL", "None")
        text = re.sub(rf"rollcon_(?:{'|'.join(HANDLES)})_(?:get_)?(\w+)", r"\1()", text)
        notes = [f"{a.name}: {a.doc}." for a in self.function.args[1:]
                 if a.doc and (a.name in dict(self.given) or a.name in self.results)]
        notes = [re.sub("; NULL only with n = 0", "", n).replace("ROLLCON_", "") for n in notes]
        lines = textwrap.wrap(f'"""{text}', 90)
        for note in notes:
            lines += ([""] if note == notes[0] else []) + textwrap.wrap(note, 90, subsequent_indent="  ")
        if len(lines) == 1 and len(lines[0]) < 88:
            return [lines[0] + '"""']
        return lines + ['"""']

    def write(self):
        for arg in self.function.args[1:]:
            self.take(arg)
        given = sorted(self.given, key=lambda pair: pair[1] != "")
        lines = ["    @property"] if self.options.get("property") else []
        lines += self.heading([f"{n}: {self.hints[n]}" + d.replace("=", " = ") for n, d in given])
        body = self.doc() + self.before
        if self.text:
            inner = ", ".join(["self._handle"] + self.call + ["*a"])
            body += [f"status, text = read_text(lambda *a: lib.{self.function.name}({inner}))",
                     "check(status)", "return text"]
        else:
            call = ", ".join([f"\"{self.function.verb}\""] + self.call)
            caveats = "NOT_CONVERGED" in self.function.errors
            body.append(("return " if caveats else "") + f"self._call({call})")
            if self.results:
                body.append("return " + ", ".join(self.results))
        return lines + ["        " + line if line else "" for line in body]


def write(table):
    out = [OPENING]
    for kind in HANDLES:
        plain = [f for f in table.functions if "python" in f.plain and f.group == kind]
        out.append(f"\n\nclass {kind.capitalize()}Plain:\n")
        out += ["\n" + "\n".join(Method(f).write()) + "\n" for f in plain]
    return "".join(out)
