#!/usr/bin/env python3
"""Checks that comments begin with their subject or a verb, so that none needs the line above it to be understood.

check_comments.py [PATH ...]: prints file and line of each comment of the sources (or of PATH alone, exempt or not)
that begins with one of the words below, and ends with 1 if there is one. Files that are generated are left out.
"""
import ast
import io
import pathlib
import re
import sys
import tokenize

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ["src", "tests", "examples", "bench", "fortran", "bindings", "scripts"]
# Rooms whose comments are still to be rewritten.
EXEMPT = []
# First words that lean on the line above, or that leave the sentence without a subject.
FIRST = "also and as but ditto else likewise nor of or same similarly such than that_of the_same those which whose"
BEGINS = re.compile(rf"(?:{FIRST.replace(' ', '|').replace('_', ' ')})\b(?!_)", re.IGNORECASE)
PARAMETER = re.compile(r"/\*\w+\*/")  # names a parameter that is not used

C = {".c", ".cpp", ".h", ".hpp"}
FORTRAN = {".f", ".f90", ".inc"}
C_TOKEN = re.compile(r'R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\''
                     r'|(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)', re.DOTALL)
FORTRAN_COMMENT = re.compile(r"""(?:[^'"!]|'[^']*'|"[^"]*")*(![!<>]*.*)$""")


def comments(path, text):
    """Yields line, column and text of each comment; comment lines that follow one another come one by one."""
    if path.suffix in C:
        for found in C_TOKEN.finditer(text):
            comment = found["line"] or found["block"]
            if comment and not PARAMETER.fullmatch(comment):
                before = text[:found.start()]
                yield before.count("\n") + 1, len(before) - before.rfind("\n") - 1, comment
    elif path.suffix in FORTRAN:
        for number, line in enumerate(text.splitlines(), 1):
            found = FORTRAN_COMMENT.match(line)
            if path.suffix == ".f" and line[:1] in "cC*":
                yield number, 0, line[1:]
            elif found:
                yield number, found.start(1), found[1]
    else:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.COMMENT:
                yield token.start[0], token.start[1], token.string
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
                yield node.body[0].lineno, 0, ast.get_docstring(node)


def misused(path):
    """Yields lines and first words of comment blocks; a line right below another comment in its column continues it."""
    last = (-1, -1)
    for line, column, comment in comments(path, path.read_text(encoding="utf-8")):
        continues = last == (line - 1, column)
        last = (line, column)
        found = BEGINS.match(comment.lstrip("/*!#<> \t\n"))
        if found and not continues:
            yield line, found.group(0)


def main():
    named = [pathlib.Path(name).resolve() for name in sys.argv[1:]]
    count, bad = 0, []
    for path in sorted(file for place in named or [ROOT / name for name in FOLDERS]
                       for file in (place.rglob("*") if place.is_dir() else [place])):
        name = path.relative_to(ROOT).as_posix()
        exempt = not named and any(name.startswith(f"{room}/") for room in EXEMPT)
        if exempt or path.suffix not in C | FORTRAN | {".py"} or "Generated from" in path.read_text("utf-8")[:80]:
            continue
        count += 1
        bad += [f"{name}:{line}: a comment begins with '{word}'" for line, word in misused(path)]
    print("\n".join(bad) if bad else f"comments in {count} files: each begins with its subject or a verb")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
