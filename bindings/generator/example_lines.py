"""Finds a line that calls a function of C, for its place in docs/api.md: from the programs in examples/ where one
calls it, else made of the names of its arguments."""

import re

STRIPPED = re.compile(r"^(?:must|check)\((.*)\)$")


def statements(text):
    """Returns the statements of a C program on one line each, without comments."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return [" ".join(part.split()) for part in re.split(r"[;{}]", text)]


def calls(text):
    """Returns for each function its shortest call in a program, without what checks its status."""
    found = {}
    for statement in statements(text):
        for name in re.findall(r"\brollcon_\w+(?=\()", statement):
            start = statement.index(name + "(")
            depth, end = 0, start
            for end in range(start + len(name), len(statement)):
                depth += (statement[end] == "(") - (statement[end] == ")")
                if depth == 0:
                    break
            call = statement[start:end + 1]
            if name not in found or len(call) < len(found[name]):
                found[name] = call
    return found


def by_names(function):
    return f"{function.name}({', '.join(('&' if a.out and not a.array else '') + a.name for a in function.args)})"


def lines(functions, programs):
    """Returns for each function (call, name of the program or nothing)."""
    found = {}
    for name, text in programs:
        for function, call in calls(text).items():
            if len(call) <= 100:
                found.setdefault(function, (call, name))
    return {f.name: found.get(f.name, (by_names(f), "")) for f in functions}
