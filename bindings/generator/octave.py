"""Writes bindings/octave: the calls of the MEX gateway (rollcon_calls.c) and, for each, a function of the package
+rollcon with its help. Callbacks are left out, and what MATLAB and Octave do themselves: references, ids."""

import re
import textwrap

from generator.python_module import names_of
from generator.table import HANDLES

OPENING = """\
/* Generated from bindings/api.toml by bindings/generate.py; do not edit. */
#include "gateway.h"

/* clang-format off */
"""
BY_HAND = {"contact_solve_many": (["contact", "parameters", "values", "columns"], ["results", "status"])}
LEFT_OUT = re.compile(r"_retain$|_from_id$|_set_log$|_set_progress$|^event_|^id_of$|^report$|^abi$")
NEEDS = {"needed", "n_values", "n_rows", "n_nodes", "count", "n_results"}


def offered(table):
    return [f for f in table.functions if not LEFT_OUT.search(verb_of(f))]


def verb_of(function):
    return function.name.removeprefix("rollcon_")


def c_name(enum):
    return "names_of_" + re.sub(r"\W", "_", enum)


def constant(table, value):
    return re.sub(r"^(?=[A-Z])", "ROLLCON_", value)


class Call:
    """Is one call while it is written."""

    def __init__(self, table, function):
        self.table, self.function = table, function
        self.before, self.asked, self.words, self.after = [], [], [], []
        self.inputs, self.outputs = [], []  # names; of inputs with whether they may be left out
        self.n = False
        args = function.args
        self.text = [a for a in args if a.base == "char"]
        self.need = next((a.name for a in args if a.name in NEEDS and a.out and a.base == "int64"), None)
        self.has_capacity = any(a.name == "capacity" for a in args)
        for arg in args:
            self.take(arg)

    def default(self, arg):
        f = self.function
        value = f.python.get("defaults", {}).get(arg.name, f.defaults.get(arg.name))
        return None if value is None else value if value.startswith('"') else constant(self.table, value)

    def given(self, arg, kind, taken):
        default = self.default(arg)
        self.inputs.append((arg, default is not None or (arg.array and arg.optional)))
        if default is not None:
            taken = f"has_more(self) ? {taken} : {default}"
        self.before.append(f"const {kind}{arg.name} = {taken};")
        self.words.append(arg.name)

    def take(self, arg):
        if arg.out:
            return self.take_out(arg)
        name = arg.name
        rows = len(re.findall(r"\[", arg.shape))
        if name == "header_abi":
            self.words.append("ROLLCON_ABI")
        elif name == "index_base":
            self.words.append("1")
        elif name == "node_stride":
            self.words.append("1")
        elif name == "component_stride":
            self.words.append("n")
        elif name == "capacity":
            self.words.append("capacity")
        elif name == "n" and any(a.shape.startswith("[n") for a in self.function.args):
            self.words.append("n" if not self.only_optional() else "n < 0 ? 0 : n")
            self.n = True
        elif arg.base in HANDLES:
            self.inputs.append((arg, False))
            self.before.append(f'rollcon_{arg.base} *{name} = rollcon_{arg.base}_from_id(take_handle(self, "{name}"));')
            self.words.append(name)
        elif arg.base in ("text", "path"):
            self.given(arg, "char *", f'take_text(self, "{name}")')
        elif arg.shape == "[n*3]":
            self.given(arg, "double *", f'take_columns(self, "{name}", &n)')
        elif arg.shape == "[n][nodes of the type]":
            self.given(arg, "int32_t *", f'take_integers(self, "{name}", &n, nodes_of_type(type))')
        elif arg.array and arg.base == "int32":
            self.given(arg, "int32_t *", f'take_integers(self, "{name}", &n, 0)')
        elif arg.array:
            parts = re.findall(r"\[(.+?)\]", arg.shape)
            count = "&n" if parts[0] == "n" else f"&{name}_rows"
            if parts[0] != "n":
                self.before.append(f"int64_t {name}_rows = {parts[0]};")
            width = int(parts[1]) if rows == 2 else 0
            self.given(arg, "double *", f'take_reals(self, "{name}", {count}, {width}, {int(arg.optional)})')
        elif arg.enum and arg.base == "int32" and " or " not in arg.enum:
            sum_ = int(arg.enum == "dof")
            self.given(arg, "int32_t ", f'take_enumerator(self, "{name}", {c_name(arg.enum)}, {sum_})')
        elif arg.enum and arg.base == "int32":
            self.given(arg, "int32_t ", f'take_enumerator(self, "{name}", {c_name(arg.enum)}, 0)')
        elif arg.base == "row":
            self.given(arg, "int32_t ", f'(int32_t)take_integer(self, "{name}") - 1')
        elif arg.base == "real":
            self.given(arg, "double ", f'take_real(self, "{name}")')
        elif arg.base == "int64":
            self.given(arg, "int64_t ", f'take_integer(self, "{name}")')
        else:
            self.given(arg, "int32_t ", f'take_enumerator(self, "{name}", no_names, 0)')

    def only_optional(self):
        arrays = [a for a in self.function.args if a.shape.startswith("[n]") and not a.out]
        return bool(arrays) and all(a.optional for a in arrays)

    def take_out(self, arg):
        name = arg.name
        if arg.base in HANDLES:
            self.before.append(f"rollcon_{arg.base} *{name} = NULL;")
            self.words.append("&" + name)
            self.after.append(f"give_real(self, rollcon_id_of({name}));")
            self.outputs.append(name)
        elif arg.base == "char":
            self.words.append(name + "_buffer")
            self.after.append(f"give_text(self, {name}_buffer);")
            self.outputs.append(name)
        elif name == self.need:
            self.words.append("&need")
        elif arg.array:
            kind = "double" if arg.base == "real" else "int32_t"
            parts = re.findall(r"\[(.+?)\]", arg.shape)
            rows = {"n": "n", "capacity": "capacity"}.get(parts[0], "1")
            width = "1" if parts[0] in ("n", "capacity") else parts[0]
            for part in parts[1:]:
                part = "count_words(columns)" if part == "columns" else part
                width = part if width == "1" else f"{width} * {part}"
            self.before.append(f"{kind} *{name} = NULL;")
            self.asked.append(f"{name} = room({rows} * ({width}), sizeof *{name});")
            self.words.append(name)
            if kind == "double" and verb_of(self.function) == "contact_get_field":
                give = f"give_reals(self, {name}, nodes > 0 ? nodes : 0, nodes > 0 ? capacity / nodes : 0)"
            elif kind == "double":
                give = f"give_reals(self, {name}, {rows}, {width})"
            else:
                give = f"give_integers(self, {name}, {rows}, 0)"  # index_base is 1
            self.after.append(give + ";")
            self.outputs.append(name)
        else:
            kind = {"real": "double", "int32": "int32_t", "row": "int32_t", "int64": "int64_t"}[arg.base]
            self.before.append(f"{kind} {name} = 0;")
            self.words.append("&" + name)
            self.after.append(f"give_real(self, (double){name});")
            self.outputs.append(name)

    def room_for_results(self):
        """Writes the lines that find the capacity."""
        f = self.function
        if not self.has_capacity:
            return [], []
        lines = ["int64_t capacity = 0;"]
        asking = []
        if self.need:
            lines.append("int64_t need = 0;")
            asking += [f"rc = {self.call()};", "if (rc < 0) finish(self, rc);", "capacity = need;"]
        elif self.text:
            asking.append("capacity = 256;")
        else:
            asking.append(f"rollcon_{f.group}_get_size({f.args[0].name}, &capacity, NULL);")
        if verb_of(f) == "contact_get_field":
            lines.append("int64_t nodes = 0;")
            asking.append("rollcon_contact_get_size(contact, &nodes, NULL);")
        if self.text:
            lines += [f"char *{a.name}_buffer = NULL;" for a in self.text]
            asking += [f"{a.name}_buffer = room(capacity, 1);" for a in self.text]
        return lines, asking

    def call(self):
        return f"{self.function.name}({', '.join(self.words)})"

    def solves(self):
        return "NOT_CONVERGED" in self.function.errors and not self.outputs

    def write(self):
        f = self.function
        lines, asking = self.room_for_results()
        head = (["int64_t n = -1;"] if self.n else []) + lines
        # Declarations that take an argument stand in the order of arguments.
        body = head + self.before + ["no_more(self);"]
        if f.returns == "void":
            body.append(self.call() + ";")
        elif f.returns == "int32":
            body.append(f"give_real(self, {self.call()});")
        elif f.returns == "text":
            body.append(f"give_text(self, {self.call()});")
        else:
            body = ["int32_t rc = 0;"] + body + asking + self.asked
            body.append(f"rc = {self.call()};")
            body.append("if (rc < 0) finish(self, rc);")
            body += self.after
            if self.solves():
                body.append("give_real(self, rc);")
            body.append("finish(self, rc);")
        return f"static void call_{verb_of(f)}(call *self) {{\n" + "".join(f"  {line}\n" for line in body) + "}\n\n"

    def results(self):
        if self.function.returns in ("int32", "text"):
            return ["text" if self.function.returns == "text" else "value"]
        return self.outputs or (["status"] if self.solves() else [])


def calls_file(table):
    out = [OPENING, "static const enumerator no_names[] = {{NULL, 0}};\n"]
    used = {a.enum for f in offered(table) for a in f.args if a.enum and a.base == "int32" and not a.out}
    for enum in sorted(used):
        pairs = {}
        for one in table.enums:
            if one.name in enum.split(" or "):
                pairs.update(names_of(one))
        rows = "".join(f'  {{"{name}", {number}}},\n' for name, number in pairs.items())
        out.append(f"static const enumerator {c_name(enum)}[] = {{\n{rows}  {{NULL, 0}}}};\n")
    out.append("\n")
    rows = ""
    for function in offered(table):
        verb = verb_of(function)
        if verb in BY_HAND:
            most = len(BY_HAND[verb][1])
        else:
            call = Call(table, function)
            out.append(call.write())
            most = max(1, len(call.results()))
        rows += f'  {{"{verb}", call_{verb}, {most}}},\n'
    out.append(f"const entry calls[] = {{\n{rows}}};\nconst int number_of_calls = sizeof calls / sizeof calls[0];\n")
    return "".join(out)


def described(arg, optional):
    kind = {"real": "real", "text": "text", "path": "name of a file"}.get(arg.base, arg.base)
    size = re.sub(r"nodes of the type", "nodes", arg.shape).replace("[n*3]", "[n][3]").replace("][", ",")
    enum = f", name or number: {arg.enum}" if arg.enum else ""
    head = f"{arg.name}{size.replace('[', '(').replace(']', ')')}"
    left_out = ", may be left out" if optional else ""
    return f"{head} ({kind}{enum}{left_out})" + (f": {plain(arg.doc)}" if arg.doc else "")


def plain(text):
    """Puts a text of the table in the words of this layer."""
    text = re.sub(r"\brollcon_(\w+)", r"rollcon.\1", text)
    text = text.replace("NULL", "[]").replace("0 or 1: id of the first node", "")
    return re.sub(r"\bROLLCON_", "", text)


def comment(text):
    return "".join(f"% {line}\n" for line in textwrap.wrap(" ".join(text.split()), 100, break_on_hyphens=False))


def function_file(table, function):
    verb = verb_of(function)
    if verb in BY_HAND:
        inputs, outputs = BY_HAND[verb]
        arguments = [(next(a for a in function.args if a.name == name), False) for name in inputs]
    else:
        call = Call(table, function)
        arguments, outputs = call.inputs, call.results()
    left = f"[{', '.join(outputs)}] = " if len(outputs) > 1 else f"{outputs[0]} = " if outputs else ""
    head = f"{left}rollcon.{verb}({', '.join(a.name for a, _ in arguments)})"
    lines = textwrap.wrap(f"{verb.upper()}  {head}", 100, subsequent_indent="    ")
    text = "".join(f"% {line}\n" for line in lines) + "%\n" + comment(plain(function.doc))
    if arguments:
        text += "%\n" + "".join(comment("  " + described(a, o)).replace("% ", "%   ") for a, o in arguments)
    docs = {a.name: a for a in function.args if a.out}
    results = [docs[name] for name in outputs if name in docs and docs[name].doc]
    if results:
        text += "% Results:\n" + "".join(comment(f"{a.name}: {plain(a.doc)}").replace("% ", "%   ") for a in results)
    count = max(1, len(outputs))
    return (f"function varargout = {verb}(varargin)\n{text}%\n"
            "% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.\n"
            f"% Generated from bindings/api.toml; do not edit.\n"
            + ("[varargout{1:max(nargout, 1)}] = rollcon_mex('" if outputs and count else "rollcon_mex('")
            + f"{verb}', varargin{{:}});\nend\n")


def files(table):
    made = {"bindings/octave/rollcon_calls.c": calls_file(table)}
    for function in offered(table):
        made[f"bindings/octave/+rollcon/{verb_of(function)}.m"] = function_file(table, function)
    return made
