"""Writes fortran/rollcon.inc: interfaces and enumerators for programs that call the FORTRAN 77 layer, in a form that
fixed and free sources take alike. It is made of the layer's own text (fortran_77.py)."""

import re

OPENING = """\
! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! INCLUDE 'rollcon.inc' behind IMPLICIT, before other declarations:
! the compiler then checks every call of the FORTRAN 77 layer. It asks
! for a compiler of Fortran 90 or newer, in fixed or free form.
"""


def split(text, room=66):
    """Puts a statement in columns 7 to 72; continued lines have & in column 73 and, on the next line, in column 6."""
    lines, line = [], ""
    for word in re.findall(r"[^,]+,? ?", text):
        if len(line + word.rstrip()) > room:
            lines.append(line)
            line = ""
        line += word
    lines.append(line)
    out = ["      " + lines[0]] + ["     &" + line for line in lines[1:]]
    return "".join(f"{line:<72}&\n" for line in out[:-1]) + out[-1].rstrip() + "\n"


def declaration(line, names):
    """Returns what a declaration says of dummy arguments, or nothing."""
    kind, _, entities = line.strip().partition(" :: ")
    if kind.startswith("procedure"):
        kind = "EXTERNAL"
    elif kind not in ("integer", "double precision", "character(len=*)"):
        return ""
    parts = [part.strip() for part in re.split(r",(?![^(]*\))", entities)]
    parts = [part for part in parts if re.match(r"\w+", part).group() in names]
    return f"{kind.upper().replace('(LEN=*)', '*(*)')} {', '.join(parts).upper()}" if parts else ""


def write(table, layer):
    out = [OPENING]
    for enum in table.enums:
        out.append(split("INTEGER " + ", ".join(name for name, _, _ in enum.values)))
        for name, number, _ in enum.values:
            out.append(f"      PARAMETER ({name} = {number})\n")
    out.append("      INTERFACE\n")
    for head, body in re.findall(r"^subroutine (.*?\))\n(.*?)^end subroutine", layer.replace("&\n", ""), re.M | re.S):
        names = [name.strip() for name in head[head.index("(") + 1:-1].split(",")]
        out.append(split(f"SUBROUTINE {re.sub(' +', ' ', head).upper()}"))
        said = [declaration(line, names) for line in body.splitlines() if " :: " in line]
        # Extents come before the arrays that they belong to.
        out += [split(line) for line in sorted(filter(None, said), key=lambda line: not line.startswith("INTEGER"))]
        out.append("      END SUBROUTINE\n")
    out.append("      END INTERFACE\n")
    return "".join(out)
