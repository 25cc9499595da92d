"""Writes tests/fortran/mapping_test.f90 and mapping_77_test.f90, which test each generated procedure of the two
Fortran layers.

It is called with a value of its own for every argument, against what the recorder writes down and gives; then it
must pass on a failure.
"""

import re

from generator import samples
from generator.fortran_77 import HANDLES, dummy_name, routines

WIDTH = 118
NOTE = "! Generated from bindings/api.toml by bindings/generate.py; do not edit.\n"
FAILED = "ROLLCON_ERR_STATE"

HEAD_2008 = NOTE + """\
!> The plain procedures of the types: every argument in its place.
program mapping_test
  use mapping
  use mapping_by_hand, only: mapped_by_hand
  use rollcon
  implicit none
  call begin()
"""

HEAD_77 = NOTE + """\
!> The subroutines of the FORTRAN 77 layer: every argument in its place.
program mapping_77_test
  use mapping
  use mapping_77_by_hand, only: mapped_by_hand
  implicit none
  call begin_77()
"""


def broken(head, words, tail=""):
    """Breaks a call over as many lines as it takes."""
    lines, line = [], head + "("
    words = [part for word in words for part in word.split(", ")]
    for i, word in enumerate(words):
        word += ", " if i + 1 < len(words) else ")" + tail
        if len(line) + len(word) > WIDTH - 6:
            lines.append(line.rstrip() + " &")
            line = "  "
        line += word
    return cut_texts(lines + [line if words else line + ")" + tail])


def cut_texts(lines):
    """Continues texts that no line holds in the next one."""
    out = []
    for line in lines:
        while len(line) > WIDTH:
            out.append(line[:WIDTH - 10] + "&")
            line = "&" + line[WIDTH - 10:]
        out.append(line)
    return out


def literal(value, suffix):
    if isinstance(value, list):
        return "[" + ", ".join(literal(v, suffix) for v in value) + "]"
    return f"{value}{suffix}" if isinstance(value, float) else str(value)


def matrix(values, rows, columns, suffix):
    """Writes a matrix by rows, like mathematics does."""
    return f"reshape({literal(values, suffix)}, [{rows}, {columns}], order=[2, 1])"


class Outs:
    """Holds variables for results, and what must be in them."""

    def __init__(self, real, integer):
        self.real, self.integer = real, integer
        self.declared, self.checks = [], []

    def take(self, function, position, name, kind=""):
        arg = function.args[position]
        if arg.base == "char":
            self.declared.append(f"{kind} :: {name}")
            self.checks.append(f"call gave_text('{name}', {name}, '{samples.given_text(function)}')")
            return name
        extent = f"({samples.extent(arg)})" if arg.array else ""
        self.declared.append(f"{self.real if arg.base == 'real' else kind or self.integer} :: {name}{extent}")
        whole = name if arg.array else f"[{name}]"
        value = samples.result(function, position)
        first = value[0] if arg.array else value
        if arg.base == "real":
            self.checks.append(f"call gave_reals('{name}', {whole}, {first}_rc_real)")
        else:
            self.checks.append(f"call gave_integers('{name}', int({whole}), {first})")
        return name


def procedure(name, outs, calls):
    """Writes one subroutine of a test: each call with what is then written down; the last one again, failing."""
    body = list(dict.fromkeys(outs.declared)) + ["integer :: stat", "character(len=80) :: message"]
    for lines, check in calls:
        body += ["call answers(ROLLCON_OK)"] + lines + check
    body += outs.checks + [f"call answers({FAILED})", "message = ''"] + calls[-1][0]
    return [f"  subroutine {name}()"] + ["    " + line for line in body]


def test_2008(function, table):
    """Tests a plain procedure, first with its defaults left out."""
    outs = Outs("real(rc_real)", "integer")
    words, late, left_out, from_0 = [], [], {}, {}
    for i, arg in enumerate(function.args[1:], 1):
        place = late if arg.name in function.defaults else words
        if arg.name in function.defaults:
            left_out[i] = f"{table.number(function.defaults[arg.name]):.10g}"
        if arg.name in ("capacity", "needed") or samples.counts(function, arg):
            continue
        if arg.out:
            kind = "integer(rc_int)" if arg.enum else "character(len=:), allocatable" if arg.base == "char" else ""
            words.append(outs.take(function, i, arg.name, kind))
        elif arg.array and arg.shape.count("[") == 2:
            rows, columns = arg.shape.strip("[]").split("][")
            values = samples.reals(function, i)
            words.append(matrix(values, rows, columns, "_rc_real") if rows != "n"
                         else f"reshape({literal(values, '_rc_real')}, [{columns}, {samples.N}])")
        elif arg.array:
            values = samples.reals(function, i) if arg.base == "real" else samples.integers(function, i)
            place.append(literal(values, "_rc_real"))
        elif arg.base in ("text", "path"):
            place.append(f"'{samples.text(i)}'")
        elif arg.base == "real":
            place.append(literal(samples.real(i), "_rc_real"))
        elif arg.base == "row":
            place.append(str(10 * i + 1))
            left_out[i] = from_0[i] = str(10 * i)
        else:
            place.append(f"{samples.integer(function, i)}{'_rc_int' if arg.enum else ''}")
    what = f"call {function.group}%{function.fortran}"
    verb = function.name.removeprefix("rollcon_")
    calls = []
    for given, end in (left_out, ["stat=stat", "errmsg=message"]), (from_0, late + ["stat", "message"]):
        if given != from_0 or end[0] != "stat=stat":
            told = broken("call told", [f"'{verb}'", f"'{samples.record(function, given)}'", "stat"])
            calls.append((broken(what, words + end), told))
    return procedure(function.verb, outs, calls) + [
        f"    call failed('{verb}', stat, message)", "  end subroutine", ""]


def write_2008(table):
    plain = [f for f in table.functions if "fortran" in f.plain and f.group != "context"]
    names, text = [], []
    for function in plain:
        name = f"{function.group}_{function.verb}"
        names.append(f"  call {name}()")
        lines = test_2008(function, table)
        text += [f"  subroutine {name}()"] + lines[1:]
    end = ["  call mapped_by_hand()", "  call done('')", "contains", ""]
    return HEAD_2008 + "\n".join(names + end + text) + "end program\n"


class Call77:
    """Is the call of one FORTRAN 77 subroutine, by the rules at the head of fortran_77.py."""

    def __init__(self, name, function):
        self.name, self.function = name, function
        self.variant = function.f77.index(name) == 1
        self.text = any(a.base == "char" for a in function.args)
        self.words, self.given, self.before = [], {}, []
        self.outs = Outs("double precision", "integer")

    def take(self, i, arg):
        function, name = self.function, dummy_name(arg)
        if arg.base in samples.HANDLES:
            self.take_handle(i, arg, name)
        elif arg.name == "header_abi":
            self.given[i] = "1"
        elif arg.name == "index_base":
            self.given[i] = "1"
        elif arg.name == "component_stride" or arg.name == "needed":
            pass
        elif arg.name == "node_stride":
            self.words.append(str(samples.N if self.variant else 4))
        elif arg.name == "capacity" and self.text:
            self.given[i] = str(samples.capacity(function))
        elif arg.out:
            kind = "character(len=60)" if arg.base == "char" else ""
            self.words.append(self.outs.take(function, i, name, kind))
        elif arg.array:
            self.take_array(i, arg, name)
        elif arg.name == "capacity":
            self.words.append(str(samples.CAPACITY))
            if any(a.base == "int32" and a.out and a.array for a in function.args):
                self.given[i] = str(samples.SIZES["nodes"])  # no more room than there are nodes
        elif arg.base == "row":
            self.words.append(str(10 * i + 1))
            self.given[i] = str(10 * i)
        elif arg.base in ("text", "path"):
            self.words.append(f"'{samples.text(i)}'")
        elif arg.base == "real":
            self.words.append(literal(samples.real(i), "d0"))
        else:
            self.words.append(str(samples.integer(function, i)))

    def take_handle(self, i, arg, name):
        if arg.out:
            self.words.append("ih")
            self.outs.declared.append("integer :: ih")
            self.outs.checks.append(f"call gave_kind(ih, {samples.HANDLES[arg.base]})")
        else:
            self.words.append(HANDLES[arg.base] + ("2" if arg.name in samples.SECOND else ""))

    def take_array(self, i, arg, name):
        function = self.function
        if arg.optional and self.variant:
            self.given[i] = samples.listed([0] * samples.extent(arg))
        elif arg.shape == "[n*3]":
            values = samples.reals(function, i)
            self.outs.declared.append(f"double precision :: xyz({'2, 3' if self.variant else '4, 2'})")
            part = "" if self.variant else "(:3, :)"
            self.before += ["xyz = -1", f"xyz{part} = " + (
                matrix(values, 2, 3, "d0") if self.variant else f"reshape({literal(values, 'd0')}, [3, 2])")]
            self.words.append("xyz")
        elif "nodes of the type" in arg.shape:
            values = literal(samples.integers(function, i), "")
            self.outs.declared.append("integer :: ids(4, 2)")
            self.before += ["ids = -1", f"ids(:3, :) = reshape({values}, [3, 2])"]
            self.words += ["ids", "4"]
        elif arg.base == "int32":
            self.words.append(literal(samples.integers(function, i), ""))
        elif arg.shape == "[3][3]":
            self.words.append(matrix(samples.reals(function, i), 3, 3, "d0"))
        else:
            self.words.append(literal(samples.reals(function, i), "d0"))

    def write(self):
        for i, arg in enumerate(self.function.args):
            self.take(i, arg)
        # The room for numbers is larger than what is there, or as large: the rest is not looked at.
        verb = self.function.name.removeprefix("rollcon_")
        told = broken("call told", [f"'{verb}'", f"'{samples.record(self.function, self.given)}'", "stat"])
        if any(a.base == "int32" and a.out and a.array and a.shape == "[capacity]" for a in self.function.args):
            self.outs.checks = [re.sub(r"int\((istatus|nodes)\)", r"int(\1(:3))", c) for c in self.outs.checks]
        call = self.before + broken(f"call {self.name.lower()}", self.words + ["stat"])
        message = ["    call rclerr(message)", f"    call failed('{verb}', stat, message)", "  end subroutine", ""]
        return procedure(f"test_{self.name.lower()}", self.outs, [(call, told)]) + message


def write_77(table):
    names, text = [], []
    for name, functions, _, _ in routines(table):
        function = functions[0]
        callbacks = any(a.base in ("log_fn", "progress_fn") for a in function.args)
        if function.returns != "status" or len(functions) > 1 or callbacks or name == "RCCASE":
            continue  # by hand
        names.append(f"  call test_{name.lower()}()")
        text += Call77(name, function).write()
    end = ["  call mapped_by_hand()", "  call done('')", "contains", ""]
    return HEAD_77 + "\n".join(names + end + text) + "end program\n"
