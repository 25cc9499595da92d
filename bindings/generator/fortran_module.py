"""Writes fortran/rollcon_c.f90: module rollcon_c, the C interface that Fortran sees."""

WIDTH = 100  # the language allows 132
KINDS = {"int32": "integer(c_int32_t)", "row": "integer(c_int32_t)",
         "int64": "integer(c_int64_t)", "real": "real(c_double)"}

OPENING = """\
! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.
!
! The C functions of rollcon {version}, argument by argument; rollcon.h documents them. Handles are
! type(c_ptr), texts are arrays of characters ended by c_null_char. Callbacks must be bind(C)
! module procedures, passed by c_funloc: a contained procedure would need an executable stack.
module rollcon_c
  use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr
  implicit none
  public

  integer(c_int32_t), parameter :: rollcon_header_version = {number}_c_int32_t
  integer(c_int32_t), parameter :: rollcon_header_abi = {abi}_c_int32_t
"""


def dummy(arg):
    """Returns the declaration of a dummy argument."""
    if arg.base in ("log_fn", "progress_fn"):
        return f"type(c_funptr), value :: {arg.name}"
    if arg.base in ("text", "path"):
        return f"character(kind=c_char), intent(in) :: {arg.name}(*)"
    if arg.base == "char":
        return f"character(kind=c_char), intent(out) :: {arg.name}(*)"
    if arg.base in KINDS:
        kind, intent = KINDS[arg.base], "out" if arg.out else "in"
        if arg.array:
            return f"{kind}, intent({intent}) :: {arg.name}(*)"
        # Failures leave the result alone: with intent(out) it would be undefined then.
        return f"{kind}, intent(inout) :: {arg.name}" if arg.out else f"{kind}, value :: {arg.name}"
    return f"type(c_ptr), {'intent(out)' if arg.out else 'value'} :: {arg.name}"


def callback_dummy(arg):
    """Returns the declaration for a callback, where a text arrives as an address: the callee does not know its
    length."""
    return f"type(c_ptr), value :: {arg.name}" if arg.base == "text" else dummy(arg)


def argument_list(head, args, tail, indent):
    """Returns `head(a, b, ...) tail`, continued over as many lines as it takes."""
    lines, line = [], indent + head + "("
    for i, arg in enumerate(args):
        word = arg.name + (", " if i + 1 < len(args) else "")
        if len(line) + len(word) > WIDTH - 2:
            lines.append(line.rstrip() + " &")
            line = indent + "    "
        line += word
    if len(line) + len(tail) + 1 > WIDTH:
        lines.append(line + ") &")
        return "\n".join(lines + [indent + "    " + tail])
    return "\n".join(lines + [f"{line}) {tail}"])


def interface(name, returns, args, bind, to_dummy):
    result = {"status": "integer(c_int32_t)", "int32": "integer(c_int32_t)"}.get(returns,
                                                                                 "type(c_ptr)")
    word = "subroutine" if returns == "void" else "function"
    tail = bind if returns == "void" else f"result(rc) {bind}"
    lines = ["", argument_list(f"{word} {name}", args, tail, "    "),
             "      import :: c_int32_t, c_int64_t, c_double, c_char, c_ptr, c_funptr",
             "      implicit none"]
    lines += ["      " + to_dummy(arg) for arg in args]
    if returns != "void":
        lines.append(f"      {result} :: rc")
    return "\n".join(lines + [f"    end {word} {name}"]) + "\n"


def write(table):
    major, minor, patch = table.version
    out = [OPENING.format(version=table.version_text, abi=table.abi,
                          number=10000 * major + 100 * minor + patch)]
    for enum in table.enums:
        out.append(f"\n  ! {enum.name}\n")
        for name, number, _ in enum.values:
            out.append(f"  integer(c_int32_t), parameter :: {name.lower()} = {number}_c_int32_t\n")
    out.append("\n  abstract interface\n")
    for callback in table.callbacks:
        out.append(interface(callback.name, callback.returns, callback.args, "bind(C)",
                             callback_dummy))
    out.append("\n  end interface\n\n  interface\n")
    for function in table.functions:
        out.append(interface(function.name, function.returns, function.args,
                             f'bind(C, name="{function.name}")',
                             dummy))
    out.append("\n  end interface\nend module rollcon_c\n")
    text = "".join(out)
    long = [line for line in text.splitlines() if len(line) > 132]
    if long:
        raise ValueError(f"Fortran line beyond 132 columns: {long[0]}")
    return text
