"""Writes fortran/rollcon_{body,contact,wheelrail,table}_plain.f90: a type with the life of a handle and its plain
procedures.

Fortran 2008 differs from C: arrays know their extents, enumerators have a kind of their own, other numbers are
default INTEGERs, texts have lengths, `defaults` are optional and come last.
"""

import re
import textwrap

from generator.table import HANDLES

WIDTH = 118  # the language allows 132
OPTIONS = ("body", "contact", "wheelrail")  # kinds with settings by name

OPENING = """\
! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.

!> The life of a {kind} and its plain procedures. rc_{kind} (module rollcon_{kind}) adds the others; programs use
!> that type. A variable is one reference to the object: assignment adds a reference, `free` and the end of the
!> variable's life drop it.
module rollcon_{kind}_plain
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int32_t, c_int64_t, c_null_char, &
    c_null_ptr, c_ptr
  use rollcon_c
  use rollcon_support
{uses}
  implicit none
  private
  public :: rc_{kind}_plain

  type :: rc_{kind}_plain
    private
    type(c_ptr) :: p = c_null_ptr
  contains
    procedure :: create
{load}{bindings}
    procedure :: free => release
    procedure :: from_id
    procedure :: id
    procedure :: handle
{options}    procedure, private :: assign
    generic :: assignment(=) => assign
    final :: finalize
  end type

contains
"""

LIFE = """\

  !> A new {kind}; a failure leaves none.
  subroutine create(self, {names}, stat, errmsg)
    class(rc_{kind}_plain), intent(inout) :: self
{declarations}
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    call self%free()
    status = rollcon_{kind}_create({values}, self%p)
    if (status /= ROLLCON_OK) self%p = c_null_ptr
    call finish(status, {parent}%handle(), 'rc_{kind}%create', stat, errmsg)
  end subroutine

{load}  !> Gives the reference back; the object lives on while another variable or the library uses it.
  impure elemental subroutine release(self)
    class(rc_{kind}_plain), intent(inout) :: self
    if (c_associated(self%p)) call rollcon_{kind}_release(self%p)
    self%p = c_null_ptr
  end subroutine

  impure elemental subroutine finalize(self)
    type(rc_{kind}_plain), intent(inout) :: self
    call self%free()
  end subroutine

  impure elemental subroutine assign(self, other)
    class(rc_{kind}_plain), intent(inout) :: self
    class(rc_{kind}_plain), intent(in) :: other
    type(c_ptr) :: p
    p = other%p
    if (c_associated(p)) then
      if (rollcon_{kind}_retain(p) /= ROLLCON_OK) p = c_null_ptr
    end if
    call self%free()
    self%p = p
  end subroutine

  !> Adds a reference to the {kind} that `id` names (as the FORTRAN 77 layer counts them).
  subroutine from_id(self, id, stat, errmsg)
    class(rc_{kind}_plain), intent(inout) :: self
    integer, intent(in) :: id
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    type(c_ptr) :: p
    integer(rc_int) :: status
    p = rollcon_{kind}_from_id(int(id, rc_int))
    status = rollcon_{kind}_retain(p)
    call self%free()
    if (status == ROLLCON_OK) self%p = p
    call finish(status, c_null_ptr, 'rc_{kind}%from_id', stat, errmsg)
  end subroutine

  integer function id(self)
    class(rc_{kind}_plain), intent(in) :: self
    id = int(rollcon_id_of(self%p))
  end function

  !> The C handle, for calls of module rollcon_c; the reference stays here.
  function handle(self) result(p)
    class(rc_{kind}_plain), intent(in) :: self
    type(c_ptr) :: p
    p = self%p
  end function
"""


LOAD = """\
  !> A prepared body from a file that rc_body%save wrote: nothing is assembled or factorised.
  subroutine load(self, context, path, stat, errmsg)
    class(rc_body_plain), intent(inout) :: self
    type(rc_context), intent(in) :: context
    character(len=*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
    integer(rc_int) :: status
    call self%free()
    status = rollcon_body_load(context%handle(), c_text(path), self%p)
    if (status /= ROLLCON_OK) self%p = c_null_ptr
    call finish(status, context%handle(), 'rc_body%load', stat, errmsg)
  end subroutine

"""

OPTION = """\

  !> {doc}
  subroutine {verb}_option_{suffix}(self, name, value, stat, errmsg)
    class(rc_{kind}_plain), intent({intent}) :: self
    character(len=*), intent(in) :: name
    {type}, intent({way}) :: value
    integer, intent(out), optional :: stat
    character(len=*), intent(inout), optional :: errmsg
{body}
  end subroutine
"""

# Each row has suffix, type, and function of C.
VALUES = [("int32", "integer(c_int32_t)", "int"), ("int64", "integer(c_int64_t)", "int"),
          ("real", "real(rc_real)", "real"), ("text", "character(len=*)", "str")]


def option_names(kind):
    """Returns suffixes of the settings that the kind has: others have no texts."""
    return VALUES if kind == "contact" else VALUES[:3]


def option_bindings(kind):
    lines = []
    for verb in ("set", "get"):
        names = [f"{verb}_option_{suffix}" for suffix, _, _ in option_names(kind)]
        lines += [f"    procedure, private :: {name}" for name in names]
        lines.append(f"    generic :: {verb} => {', '.join(names)}")
    return "\n".join(lines)


def options(kind):
    """Writes settings by name, of a value's type."""
    out = []
    for verb in ("set", "get"):
        for suffix, declared, c_name in option_names(kind):
            head = f"rollcon_{kind}_{verb}_{c_name}(self%p, c_text(name), "
            what = f"self%p, &\n      'rc_{kind}%{verb}', stat, errmsg)"
            if verb == "set":
                value = {"int32": "int(value, rc_long)", "text": "c_text(value)"}.get(suffix, "value")
                body = [f"call finish({head}{value}), {what}"]
            elif suffix == "int32":
                body = ["integer(rc_long) :: wide", "wide = 0", f"call finish({head}wide), {what}",
                        "value = int(wide, c_int32_t)"]
            elif suffix == "text":
                declared = "character(len=:), allocatable"
                body = ["character(kind=c_char), allocatable :: buffer(:)", "integer(rc_long) :: needed",
                        "integer(rc_int) :: status", "allocate (buffer(1))", "needed = 0",
                        f"status = {head}0_rc_long, buffer, needed)", "deallocate (buffer)",
                        "allocate (buffer(max(needed, 1_rc_long)))", "buffer(1) = c_null_char",
                        "if (status == ROLLCON_OK) &",
                        f"  status = {head}size(buffer, kind=rc_long), buffer, needed)",
                        "value = f_text(buffer)", f"call finish(status, {what}"]
            else:
                body = ["value = 0", f"call finish({head}value), {what}"]
            out.append(OPTION.format(
                doc="A setting by name; rc_option_info lists them.", verb=verb, suffix=suffix, kind=kind, type=declared,
                intent="inout" if verb == "set" else "in", way="in" if verb == "set" else "out",
                body="\n".join("    " + line for line in body)).rstrip("\n"))
    return out


def joined(head, words, tail, indent):
    lines, line = [], " " * indent + head + "("
    for i, word in enumerate(words):
        word += ", " if i + 1 < len(words) else ")" + tail
        if len(line) + len(word) > WIDTH - 2:
            lines.append(line.rstrip() + " &")
            line = " " * (indent + 2)
        line += word
    return lines + [line]


class Procedure:
    """Is one type-bound procedure while it is written."""

    def __init__(self, function):
        self.function = function
        self.name = function.verb
        self.kind = function.group
        self.dummies, self.defaulted, self.texts = [], [], []
        self.locals, self.before, self.after = [], [], []
        self.call = ["self%p"]
        self.refusal = None

    def dummy(self, arg, declaration):
        default = self.function.defaults.get(arg.name)
        if default is None:
            self.dummies.append((arg.name, declaration))
            return arg.name
        self.defaulted.append((arg.name, declaration.replace(", intent(in)", ", intent(in), optional")))
        local = arg.name + "_or_standard"
        if re.fullmatch(r"[A-Z]\w*", default):
            default = "ROLLCON_" + default
        self.locals.append(declaration.split(",")[0] + f" :: {local}")
        self.before += [f"{local} = {default}", f"if (present({arg.name})) {local} = {arg.name}"]
        return local

    def take(self, arg):
        if arg.array and arg.base != "char":
            return self.take_array(arg)
        if arg.out:
            return self.take_result(arg)
        if arg.base == "text" or arg.base == "path":
            name = self.dummy(arg, f"character(len=*), intent(in) :: {arg.name}")
            return self.call.append(f"c_text({name})")
        if arg.base == "real":
            return self.call.append(self.dummy(arg, f"real(rc_real), intent(in) :: {arg.name}"))
        if arg.base == "int32" and arg.enum:
            return self.call.append(self.dummy(arg, f"integer(rc_int), intent(in) :: {arg.name}"))
        if arg.base == "int32" and not self.counts(arg):
            name = self.dummy(arg, f"integer, intent(in) :: {arg.name}")
            return self.call.append(f"int({name}, rc_int)")
        if arg.base == "row":
            name = self.dummy(arg, f"integer, intent(in) :: {arg.name}")
            return self.call.append(f"int({name} - 1, rc_int)")
        if self.counts(arg):
            array = self.counted()
            kind = "rc_int" if arg.base == "int32" else "rc_long"
            extent = array.shape.count("[")
            return self.call.append(f"size({array.name}, {extent}, {kind})")
        if arg.name == "capacity":
            return self.call.append("needed")
        raise ValueError(f"{self.function.name}: {arg.name} is not plain for Fortran")

    def counted(self):
        return next(a for a in self.function.args if a.shape.startswith("[n]") and not a.out)

    def counts(self, arg):
        return arg.name == "n" and any(a.shape.startswith("[n]") for a in self.function.args)

    def take_array(self, arg):
        parts = re.findall(r"\[(.+?)\]", arg.shape)
        intent = "out" if arg.out else "in"
        if all(part.isdigit() for part in parts):
            self.dummies.append((arg.name, f"real(rc_real), intent({intent}) :: {arg.name}({', '.join(parts)})"))
            if arg.out:
                self.before.append(f"{arg.name} = 0")
            matrix = len(parts) == 2 and not arg.out
            return self.call.append(f"transpose({arg.name})" if matrix else arg.name)  # C wants it by rows
        if arg.base == "int32":
            self.dummies.append((arg.name, f"integer, intent(in) :: {arg.name}(:)"))
            return self.call.append(f"int({arg.name}, rc_int)")
        extents = ", ".join(":" * len(parts))
        self.dummies.append((arg.name, f"real(rc_real), intent(in), contiguous :: {arg.name}({extents})"))
        if len(parts) == 2:
            self.refusal = (f"size({arg.name}, 1) /= {parts[1]}",
                            f"the first extent of {arg.name} must be {parts[1]}")
        self.call.append(arg.name)

    def take_result(self, arg):
        if arg.base == "char":
            self.dummies.append((arg.name, f"character(len=:), allocatable, intent(out) :: {arg.name}"))
            self.texts.append(arg.name)
            return self.call.append("buffer")
        if arg.name == "needed":
            return self.call.append("needed")
        if arg.base == "real":
            self.dummies.append((arg.name, f"real(rc_real), intent(out) :: {arg.name}"))
            self.before.append(f"{arg.name} = 0")
            return self.call.append(arg.name)
        if arg.enum:
            self.dummies.append((arg.name, f"integer(rc_int), intent(out) :: {arg.name}"))
            self.before.append(f"{arg.name} = 0")
            return self.call.append(arg.name)
        first = not any(a.out for a in self.function.args[:self.function.args.index(arg)])
        kind = "rc_int" if arg.base == "int32" else "rc_long"
        optional = "" if first or not arg.optional else ", optional"
        self.dummies.append((arg.name, f"integer, intent(out){optional} :: {arg.name}"))
        self.locals.append(f"integer({kind}) :: {arg.name}_c")
        self.before.append(f"{arg.name}_c = 0")
        condition = f"if (present({arg.name})) " if optional else ""
        self.after.append(f"{condition}{arg.name} = int({arg.name}_c)")
        self.call.append(f"{arg.name}_c")

    def write(self):
        function = self.function
        for arg in function.args[1:]:
            self.take(arg)
        what = f"'rc_{self.kind}%{function.fortran}'"
        dummies = self.dummies + self.defaulted
        intent = "in" if function.args[0].const or function.threads.startswith("any") else "inout"
        lines = [""] + comment(function.doc)
        names = ["self"] + [n for n, _ in dummies] + ["stat", "errmsg"]
        lines += joined(f"subroutine {self.kind}_{self.name}", names, "", 2)
        body = [f"class(rc_{self.kind}_plain), intent({intent}) :: self"] + [d for _, d in dummies]
        body += ["integer, intent(out), optional :: stat", "character(len=*), intent(inout), optional :: errmsg"]
        body += self.locals
        if self.texts:
            body += self.text_getter(what)
        else:
            body += self.before
            if self.refusal:
                condition, rule = self.refusal
                body += [f"if ({condition}) then"]
                words = ["ROLLCON_ERR_ARGUMENT", "self%p", what, "stat", "errmsg", f"'{rule}'"]
                body += joined("  call finish", words, "", 0) + ["  return", "end if"]
            call = f"{function.name}({', '.join(self.call)})"
            body += joined("call finish", [call, "self%p", what, "stat", "errmsg"], "", 0) + self.after
        return lines + ["    " + line for line in body] + ["  end subroutine"]

    def text_getter(self, what):
        text = self.texts[0]
        call = f"status = {self.function.name}({', '.join(self.call)})"
        return ["character(kind=c_char), allocatable :: buffer(:)", "integer(rc_long) :: needed",
                "integer(rc_int) :: status"] + self.before + [
                "allocate (buffer(1))", "needed = 0", call.replace("self%p, needed", "self%p, 0_rc_long"),
                "deallocate (buffer)", "allocate (buffer(max(needed, 1_rc_long)))", "buffer(1) = c_null_char",
                "if (status == ROLLCON_OK) " + call.replace("self%p, needed", "self%p, size(buffer, kind=rc_long)"),
                f"{text} = f_text(buffer)",
                f"call finish(status, self%p, {what}, stat, errmsg)"]


def comment(doc):
    text = " ".join(doc.split())
    return textwrap.wrap(text, 120, initial_indent="  !> ", subsequent_indent="  !> ", break_on_hyphens=False)


def write(table, kind):
    plain = [f for f in table.functions if "fortran" in f.plain and f.group == kind]
    create = next(f for f in table.functions if f.name == f"rollcon_{kind}_create")
    names = [(a.name, f"type(rc_{a.base})" if a.base in HANDLES else "integer(rc_int)") for a in create.args[:-1]]
    modules = dict.fromkeys(f"rollcon_{a.base}" for a in create.args[:-1] if a.base in HANDLES)
    values = [name + ("%handle()" if kind_of.startswith("type") else "") for name, kind_of in names]
    bindings = "\n".join(f"    procedure :: {f.fortran} => {kind}_{f.verb}" for f in plain)
    uses = "\n".join(f"  use {module}" for module in modules)
    out = [OPENING.format(kind=kind, uses=uses, bindings=bindings,
                          options=option_bindings(kind) + "\n" if kind in OPTIONS else "",
                          load="    procedure :: load\n" if kind == "body" else "").rstrip("\n")]
    out.append(LIFE.format(kind=kind, names=", ".join(n for n, _ in names), values=", ".join(values), parent="context",
                           load=LOAD if kind == "body" else "",
                           declarations="\n".join(f"    {t}, intent(in) :: {n}" for n, t in names)).rstrip("\n"))
    out += options(kind) if kind in OPTIONS else []
    for function in plain:
        out += Procedure(function).write()
    out += ["", f"end module rollcon_{kind}_plain", ""]
    text = "\n".join(out)
    long = [line for line in text.splitlines() if len(line) > 132]
    if long:
        raise ValueError(f"Fortran line beyond 132 columns: {long[0]}")
    return text
