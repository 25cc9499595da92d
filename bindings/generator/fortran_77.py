"""fortran/rollcon_f77.f90: the FORTRAN 77 layer, one external subroutine for each name `f77`.
Arguments are those of the C function in their order; what FORTRAN 77 says otherwise:
  - handles are INTEGERs; index_base is 1; `row` counts from 1; the status is the last argument
  - node_stride and component_stride become LDX: X(LDX,N), and of the second name X(LDX,3)
  - a table of node ids gets LDC: IC(LDC,N)
  - texts have lengths of their own: no capacity and no need
  - real [3][3] is a matrix as written
  - a second name leaves out arguments that may be NULL: arrays are then 0, callbacks absent
  - several functions of one name: a handle of any kind, or all their results
"""

import re

WIDTH = 118  # the language allows 132
HANDLES = {"context": "ictx", "body": "ibody", "contact": "icon", "wheelrail": "iwr",
           "table": "itab"}
CALLBACKS = {"log_fn": "log", "progress_fn": "progress"}

OPENING = """\
! Generated from bindings/api.toml by bindings/generate.py; do not edit.
! Copyright (c) the rollcon authors. BSD-3-Clause.
!
! FORTRAN 77 layer of rollcon {version}: plain external subroutines. Name mangling, integer width and hidden CHARACTER
! lengths are those of the compiler and the options that build this file, which must be the caller's. Handles are
! INTEGERs > 0, the last argument is always IERR, the status. README.md lists the names beside those of rollcon.h.
"""


def dummy_name(arg):
    """Returns a name that FORTRAN 77's implicit types agree with."""
    name = {"n_cases": "nc", "n_results": "nres", "n_rows": "nr", "n_values": "nv", "n_nodes": "nn", "max_level": "level",
            "parameters": "par", "connectivity": "ic"}.get(arg.name, arg.name)
    for kind, short in HANDLES.items():
        if arg.base == kind:
            name = name.replace(kind, short)
            return name if name.startswith("i") else "i" + name
    if arg.base in CALLBACKS:
        return {"log_fn": "sink", "progress_fn": "watch"}[arg.base]
    if arg.name == "capacity":
        return "maxn"
    integer = arg.base in ("int32", "int64", "row")
    if integer and name[0] not in "ijklmn":
        return "i" + name
    if arg.base == "real" and name[0] in "ijklmn":
        return "x" + name
    return name


class Routine:
    """Is one subroutine while it is written."""

    def __init__(self, name, function, variant):
        self.name, self.function, self.variant = name, function, variant
        self.dummies = []  # (name, FORTRAN 77 type, shown in the list of calls)
        self.locals, self.before, self.after = [], [], []
        self.call = []
        self.handle = "c_null_ptr"
        self.lower = ""
        self.text_out = []  # what they are called beside the buffer of the library

    def dummy(self, name, kind, shown=""):
        self.dummies.append((name, kind, shown or name.upper()))

    def refuse_if(self, condition, number, rule):
        self.before += [f"if ({condition}) then",
                        f"  call refuse({self.handle}, '{self.name}: {number.upper()} is', {number}, '{rule}', ierr)",
                        "  return", "end if"]

    def extent(self, shape, count):
        """Returns the number of entries of an array with this C shape."""
        parts = re.findall(r"\[(.+?)\]", shape)
        return "*".join(count if part == "n" else part for part in parts)

    # ------------------------------------------------------------------ one rule for each kind of argument

    def take(self, arg):
        rule = getattr(self, "take_" + arg.base, None)
        if arg.base in HANDLES:
            rule = self.take_out_handle if arg.out else self.take_handle
        elif arg.base in CALLBACKS:
            rule = self.take_callback
        elif arg.array and arg.base == "real":
            rule = self.take_reals
        elif arg.array and arg.base == "int32":
            rule = self.take_out_integers if arg.out else self.take_integers
        elif arg.out and arg.base in ("int32", "int64"):
            rule = self.take_out_integer
        rule(arg, dummy_name(arg))

    def take_handle(self, arg, name):
        self.dummy(name, "integer")
        self.call.append(f"{arg.base}_of({name})")
        self.handle = self.handle if len(self.dummies) > 1 else self.call[0]

    def take_out_handle(self, arg, name):
        self.dummy(name, "integer")
        self.locals.append("type(c_ptr) :: p")
        self.before.append(f"{name} = 0")
        self.call.append("p")
        self.after.append(f"if (ierr == ROLLCON_OK) {name} = rollcon_id_of(p)")

    def take_callback(self, arg, name):
        if self.variant:
            return self.call.append("c_null_funptr")
        kind = CALLBACKS[arg.base]
        self.dummy(name, f"procedure({kind}_77)")
        self.locals.append("type(box), pointer :: b")
        first = self.dummies[0][0]
        self.before += [f"b => box_of({first})", f"b%{kind} => {name}"]
        self.call.append(f"c_funloc(call_{kind})")

    def take_user(self, arg, name):
        self.call.append("c_null_ptr" if self.variant else "c_loc(b)")

    def take_text(self, arg, name):
        self.dummy(name, "character(len=*)")
        self.call.append(f"c_name({name})")

    def take_path(self, arg, name):
        self.dummy(name, "character(len=*)")
        self.call.append(f"c_text({name})")

    def take_int32(self, arg, name):
        if arg.name == "header_abi":
            self.call.append("ROLLCON_HEADER_ABI")
        elif arg.name == "index_base":
            self.call.append("1_c_int32_t")
        else:
            self.dummy(name, "integer")
            self.call.append(f"narrow({name})")

    def take_row(self, arg, name):
        self.dummy(name, "integer")
        self.call.append(f"narrow({name} - 1)")

    def take_int64(self, arg, name):
        if arg.name == "capacity" and self.text_out:
            self.call.append("capacity")
        elif arg.name == "node_stride":
            self.dummy("ldx", "integer")
            rows = "n" if self.variant else "3"
            self.refuse_if(f"ldx < {rows}", "ldx", f"; allowed: {rows.upper()} or more")
            self.call.append("1_c_int64_t" if self.variant else "int(ldx, c_int64_t)")
        elif arg.name == "component_stride":
            self.call.append("int(ldx, c_int64_t)" if self.variant else "1_c_int64_t")
        else:
            self.dummy(name, "integer")
            self.call.append(f"int({name}, c_int64_t)")

    def take_real(self, arg, name):
        self.dummy(name, "double precision")
        self.call.append(name)

    def take_reals(self, arg, name):
        if arg.optional and self.variant and not arg.out:
            self.locals += [f"double precision, allocatable :: {name}(:)", "integer :: no_room"]
            self.refuse_if("n < 0", "n", "; allowed: 0 or more")
            self.before += [f"allocate ({name}({self.extent(arg.shape, 'n')}), stat=no_room)",
                            "if (no_room /= 0) then",
                            f"  call no_memory({self.handle}, '{self.name}', ierr)", "  return", "end if",
                            f"{name} = 0"]
            return self.call.append(name)
        parts = re.findall(r"\[(.+?)\]", arg.shape)
        if all(part.isdigit() for part in parts):
            size = ", ".join(reversed(parts))
            self.dummy(name, f"double precision({size})", f"{name.upper()}({size.replace(' ', '')})")
            matrix = len(parts) == 2 and parts[0] == parts[1] and not arg.out
            return self.call.append(f"transpose({name})" if matrix else name)  # C wants it by rows
        shown = {"[n*3]": "LDX,3" if self.variant else "LDX,N"}.get(arg.shape)
        if not shown:
            words = {"capacity": "MAXN", "n_cases": "NC", "parameters": "NP", "columns": "NCOL"}
            shown = ",".join(words.get(p, p.upper()) for p in reversed(parts))
        self.dummy(name, "double precision(*)", f"{name.upper()}({shown})")
        self.call.append(name)

    def take_integers(self, arg, name):
        if "nodes of the type" in arg.shape:
            self.dummy(name, "integer(*)", f"{name.upper()}(LDC,N)")
            self.dummy("ldc", "integer")
            self.locals.append("integer(c_int32_t), allocatable :: packed(:, :)")
            self.before += [f"call pack_77({self.handle}, '{self.name}', itype, n, {name}, ldc, packed, ierr)",
                            "if (ierr /= ROLLCON_OK) return"]
            return self.call.append("packed")
        self.dummy(name, "integer(*)", f"{name.upper()}(N)")
        packed = f"packed_{arg.name}"
        self.locals.append(f"integer(c_int32_t), allocatable :: {packed}(:)")
        self.before += [f"call pack_list_77({self.handle}, '{self.name}', n, {name}, {packed}, ierr)",
                        "if (ierr /= ROLLCON_OK) return"]
        self.call.append(packed)

    def take_out_integers(self, arg, name):
        count = "nc" if "n_cases" in arg.shape else "n" if arg.shape == "[n]" else "maxn"
        self.dummy(name, "integer(*)", f"{name.upper()}({count.upper()})")
        self.locals.append("integer(c_int32_t), allocatable :: whole(:)")
        if count == "maxn":  # no more room than there are nodes
            count = "int(room)"
            self.locals.append("integer(c_int64_t) :: room, elements")
            self.before += ["room = 0", "elements = 0",
                            f"ierr = rollcon_{self.function.group}_get_size({self.handle}, room, elements)",
                            "room = min(room, int(maxn, c_int64_t))"]
            self.call = [word.replace("int(maxn, c_int64_t)", "room") for word in self.call]
        self.before += [f"call room_77({self.handle}, '{self.name}', {count}, whole, ierr)",
                        "if (ierr /= ROLLCON_OK) return"]
        self.call.append("whole")
        self.after.append(f"call give_integers(whole, {name})")

    def take_out_integer(self, arg, name):
        if arg.name == "needed":
            return self.call.append("needed")
        kind = "c_int32_t" if arg.base == "int32" else "c_int64_t"
        self.dummy(name, "integer")
        self.locals.append(f"integer({kind}) :: {arg.name}_c")
        self.before.append(f"{arg.name}_c = 0")
        self.call.append(f"{arg.name}_c")
        self.after.append(f"{name} = int({arg.name}_c)")

    def take_char(self, arg, name):
        self.dummy(name, "character(len=*)")
        self.call.append("buffer" if len(self.text_out) == 1 else f"buffer_{arg.name}")


def joined(head, words, tail, indent):
    """Returns `head(a, b, ...)tail`, continued over as many lines as it takes."""
    lines, line = [], " " * indent + head + "("
    for i, word in enumerate(words):
        word += ", " if i + 1 < len(words) else ")" + tail
        if len(line) + len(word) > WIDTH - 2:
            lines.append(line.rstrip() + " &")
            line = " " * (indent + 2)
        line += word
    if not words:
        line += ")" + tail
    return lines + [line]


def declarations(dummies):
    """Puts dummies of one type in one line."""
    rows = {}
    for name, kind, _ in dummies:
        match = re.match(r"((?:character|procedure)\(.*\)|[a-z ]+)(\(.*\))?$", kind)
        rows.setdefault(match.group(1), []).append(name + (match.group(2) or ""))
    lines = []
    for kind, names in sorted(rows.items(), key=lambda row: row[0] != "integer"):
        line = f"  {kind} :: "
        for name in names:
            if len(line) + len(name) > WIDTH - 4:
                lines.append(line.rstrip(", "))
                line = f"  {kind} :: "
            line += name + ", "
        lines.append(line.rstrip(", "))
    return lines


def subroutine(name, dummies, body, doc):
    lines = ["", f"!> {doc}"]
    lines += joined("subroutine " + name.lower(), [d[0] for d in dummies], "", 0)
    lines += ["  use rollcon_f77_support", "  implicit none"] + declarations(dummies)
    return lines + ["  " + line for line in body] + ["end subroutine"]


def routine(name, function, variant):
    """Returns the subroutine's text, and its arguments in the form of the list of calls."""
    r = Routine(name, function, variant)
    r.text_out = [a for a in function.args if a.base == "char"]
    for arg in function.args:
        r.take(arg)
    r.dummy("ierr", "integer")
    call = [line.strip() for line in joined("ierr = " + function.name, r.call, "", 2)]
    call = [call[0]] + ["  " + line for line in call[1:]]
    body = list(dict.fromkeys(r.locals))
    if r.text_out:
        asks = any(a.name == "needed" for a in function.args)
        if not asks:
            raise ValueError(f"{function.name}: a text comes without its need")
        buffers = [word for word in r.call if word.startswith("buffer")]
        body += [f"character(kind=c_char), allocatable :: {', '.join(b + '(:)' for b in buffers)}",
                 "integer(c_int64_t) :: capacity, needed"]
        body += [f"allocate ({', '.join(b + '(1)' for b in buffers)})", "capacity = 0", "needed = 1"] + r.before + call + [
            f"deallocate ({', '.join(buffers)})", "capacity = max(needed, 1_c_int64_t)",
            f"allocate ({', '.join(b + '(capacity)' for b in buffers)})"]
        body += [f"{b}(1) = c_null_char" for b in buffers]
        body += ["if (ierr == ROLLCON_OK) then"] + ["  " + line for line in call] + ["end if"] + r.after
        body += [f"call give_text({r.handle}, '{name}', {b}, {dummy_name(text)}, ierr)"
                 for b, text in zip(buffers, r.text_out)]
    else:
        body += r.before + call + r.after
    doc = first_sentence(function.doc)
    return subroutine(name, r.dummies, body, doc), [d[2] for d in r.dummies]


def first_sentence(doc):
    sentence = re.split(r"(?<=[.;:])\s", " ".join(doc.split()))[0].rstrip(";:.")
    return sentence[:110] + "."


def fact(name, functions):
    """Serves functions that need no object: what they return becomes the last arguments."""
    dummies, body = [], []
    for function in functions:
        if function.name == "rollcon_has_feature":
            out = "ihas"
        elif function.returns == "int32":
            out = "n" if len(functions) == 1 else "i" + function.name.split("_")[-1]
        else:
            out = "text"
        args = []
        for arg in function.args:
            inner = dummy_name(arg)
            dummies.append((inner, "integer" if arg.base == "int32" else "character(len=*)", inner.upper()))
            args.append(f"narrow({inner})" if arg.base == "int32" else f"c_name({inner})")
        dummies.append((out, "character(len=*)" if out == "text" else "integer", out.upper()))
        result = f"{function.name}({', '.join(args)})"
        if function.name in ("rollcon_last_error", "rollcon_last_caveat"):
            body.append(f"text = names_77(f_text_at({result}))")
        else:
            body.append(f"{out} = " + (f"f_text_at({result})" if out == "text" else result))
    return subroutine(name, dummies, body, first_sentence(functions[0].doc)), [d[2] for d in dummies]


def of_any_kind(name, functions):
    """Serves retain and release: the handle tells its kind."""
    dummies = [("ih", "integer", "IH"), ("ierr", "integer", "IERR")]
    release = functions[0].returns == "void"
    body = ["ierr = ROLLCON_OK", "if (ih == 0) return"] if release else []
    body.append("select case (kind_of(ih))")
    for function in functions:
        kind = function.group
        body.append(f"case (of_{kind})")
        if release:
            body += [f"  call {function.name}({kind}_of(ih))", "  ih = 0"]
        else:
            body.append(f"  ierr = {function.name}({kind}_of(ih))")
    body += ["case default", f"  call no_handle('{name}', ih, ierr)", "end select"]
    doc = first_sentence(functions[0].doc) + (" The handle becomes 0." if release else "")
    return subroutine(name, dummies, body, doc), [d[2] for d in dummies]


def routines(table):
    """Returns (name, functions, text, arguments) in the order of the table."""
    by_name = {}
    for function in table.functions:
        for name in function.f77:
            by_name.setdefault(name, []).append(function)
    for name, functions in by_name.items():
        if len(functions) > 1 and functions[0].args:
            text, args = of_any_kind(name, functions)
        elif functions[0].returns in ("int32", "text"):
            text, args = fact(name, functions)
        else:
            text, args = routine(name, functions[0], functions[0].f77.index(name) == 1)
        yield name, functions, text, args


def translation(table):
    """Translates C names into those that the callers of this layer know."""
    rows = [(f.name, " or ".join(f.f77)) for f in table.functions if f.f77]
    rows.sort(key=lambda row: -len(row[0]))  # no name is taken for the beginning of a longer one
    lines = ["", "!> A text of the library with this layer's names in place of those of rollcon.h.",
             "module rollcon_f77_names", "  implicit none", "  private", "  public :: names_77",
             f"  integer, parameter :: count = {len(rows)}",
             "  type :: pair", "    character(len=48) :: c", "    character(len=16) :: f77", "  end type",
             "contains", "", "  pure function names_77(text) result(told)",
             "    character(len=*), intent(in) :: text", "    character(len=:), allocatable :: told",
             "    type(pair) :: name(count)", "    integer :: i, at, length"]
    lines += [f"    name({i}) = pair('{c}', '{f77}')" for i, (c, f77) in enumerate(rows, 1)]
    return lines + """\
    told = text
    do i = 1, count
      length = len_trim(name(i)%c)
      do
        at = index(told, name(i)%c(:length))
        if (at == 0) exit
        told = told(:at - 1)//trim(name(i)%f77)//told(at + length:)
      end do
    end do
  end function
end module rollcon_f77_names""".splitlines()


def write(table):
    out = [OPENING.format(version=table.version_text)]
    for _, _, text, _ in routines(table):
        out += text
    long = [line for line in out if len(line) > 132 and "\n" not in line]
    if long:
        raise ValueError(f"Fortran line beyond 132 columns: {long[0]}")
    return "\n".join(out).replace("\n\n\n", "\n\n") + "\n"


def write_names(table):
    head = ("! Generated from bindings/api.toml by bindings/generate.py; do not edit.\n"
            "! Copyright (c) the rollcon authors. BSD-3-Clause.")
    return "\n".join([head] + translation(table)) + "\n"


def call_list(table):
    """Returns the rows of the table in fortran/README.md."""
    rows = ["| call | C function |", "| --- | --- |"]
    for name, functions, _, args in routines(table):
        names = ", ".join(f"`{f.name}`" for f in functions)
        rows.append(f"| `{name}({', '.join(args)})` | {names} |")
    return "\n".join(rows) + "\n"
