"""Writes the headers in include/: prototypes, enumerators and their documentation."""

import textwrap

from generator.table import HANDLES

WIDTH = 98
TYPES = {"int32": "int32_t", "row": "int32_t", "path": "const char *",
         "int64": "int64_t", "real": "double", "text": "const char *",
         "char": "char", "user": "void *", "handle": "void *"}

OPENING = """\
/*
 * rollcon {version}: frictional rolling contact of elastic bodies.
 *
 * Generated from bindings/api.toml by bindings/generate.py; do not edit.
 * Copyright (c) the rollcon authors. BSD-3-Clause.
 *
 * C90 with <stdint.h>, C++98; no other header is needed.
 *
 * What holds for all functions; their comments say the rest (docs/api.md says more):
 *  - A function that can fail returns a rollcon_status: 0 success, > 0 usable with a caveat,
 *    < 0 failed, and then the object is unchanged unless the function's comment says otherwise.
 *  - rollcon_last_error() tells in words why the last call of this thread that failed did so,
 *    rollcon_last_caveat() what the last one that returned a status > 0 has to say.
 *  - NULL gives ROLLCON_ERR_ARGUMENT, as does a value out of range, unless a comment says
 *    otherwise; released, garbage and wrong-kind handles give ROLLCON_ERR_HANDLE; an object that
 *    another call is using ROLLCON_ERR_BUSY. Comments list what else is returned.
 *  - Threads: one at a time per object, unless a comment says "any": then any thread at any time.
 *  - Arguments: the object, inputs (count before array), outputs. Inputs are copied, results are
 *    copied out. NaN and infinity are refused (ROLLCON_ERR_NONFINITE).
 *  - A text comes out as (capacity, text, needed): bytes at text, the NUL counted, and the bytes
 *    needed; other results of unknown length alike. Capacity 0 only asks for the need, with NULL
 *    for the result; one that is too small is ROLLCON_ERR_CAPACITY and tells the need, too. The
 *    need may be NULL otherwise.
 *  - New handles are the caller's to release, and NULL after a failure.
 *  - Programs that check once, at their end, set rollcon_context_set_latch.
 *  - Vectors are stored x y z, x y z, ...: x[n][3] in C, x(3,n) in Fortran.
 *  - Any consistent set of units; the reference says force, length and time. Angles in radians.
 *  - Axes: n is the outward normal of body 1, t1 the rolling direction, t2 = n x t1. Tractions and
 *    forces are those on body 1; slip is that of body 1 relative to body 2.
 */
#ifndef ROLLCON_H
#define ROLLCON_H

#include <stdint.h>

#define ROLLCON_VERSION_MAJOR {major}
#define ROLLCON_VERSION_MINOR {minor}
#define ROLLCON_VERSION_PATCH {patch}
#define ROLLCON_VERSION_PRERELEASE "{prerelease}" /* "rc2" and the like; empty: a release */
#define ROLLCON_VERSION_STRING "{version}"
/* Number of the binary interface: of the shared library's SONAME; for rollcon_context_create. */
#define ROLLCON_ABI {abi}

/* Consumers of a static library on Windows define ROLLCON_STATIC; the build of the shared one
   defines ROLLCON_BUILDING. */
#ifndef ROLLCON_API
#if defined(_WIN32) && defined(ROLLCON_STATIC)
#define ROLLCON_API
#elif defined(_WIN32) && defined(ROLLCON_BUILDING)
#define ROLLCON_API __declspec(dllexport)
#elif defined(_WIN32)
#define ROLLCON_API __declspec(dllimport)
#elif defined(__GNUC__)
#define ROLLCON_API __attribute__((visibility("default")))
#else
#define ROLLCON_API
#endif
#endif
#if defined(_WIN32)
#define ROLLCON_CALL __cdecl
#else
#define ROLLCON_CALL
#endif

#ifdef __cplusplus
extern "C" {{
#endif

/* Handles: opaque, never dereferenced, reference counted. */
{handles}
/* Only inside a progress callback. */
typedef struct rollcon_event rollcon_event;
"""

LAYERS = """\
/*
 * rollcon {version}: what layers over rollcon.h need.
 *
 * Generated from bindings/api.toml by bindings/generate.py; do not edit.
 * Copyright (c) the rollcon authors. BSD-3-Clause.
 */
#ifndef ROLLCON_LAYERS_H
#define ROLLCON_LAYERS_H

#include <rollcon.h>

#ifdef __cplusplus
extern "C" {{
#endif
"""

CLOSING = """
#ifdef __cplusplus
}
#endif

#endif
"""


def c_type(arg):
    """Returns the type of an argument up to its name, '*' included."""
    if arg.base in ("log_fn", "progress_fn"):
        return f"rollcon_{arg.base} "
    if arg.base in HANDLES or arg.base == "event":
        const = "const " if arg.const else ""
        return f"{const}rollcon_{arg.base} *" + ("*" if arg.out else "")
    base = TYPES[arg.base]
    if arg.base == "handle":
        return "const " + base
    if base.endswith("*"):
        return base
    if arg.out:
        return base + " *"
    return f"const {base} *" if arg.array else base + " "


def return_type(returns):
    if returns == "status":
        return "rollcon_status "
    if returns == "text":
        return "const char *"
    if returns in HANDLES:
        return f"rollcon_{returns} *"
    return {"int32": "int32_t ", "void": "void "}[returns]


def declaration(head, args):
    """Returns `head(arg, arg, ...);` with the arguments broken into lines of the allowed width."""
    words = [c_type(a) + a.name for a in args] or ["void"]
    text = head + "(" + ", ".join(words) + ");"
    if len(text) <= WIDTH:
        return text
    lines, line = [], head + "("
    for i, word in enumerate(words):
        word += "," if i + 1 < len(words) else ");"
        if len(line) + len(word) + 1 > WIDTH:
            lines.append(line.rstrip())
            line = "    "
        line += word + " "
    return "\n".join(lines + [line.rstrip()])


def paragraph(text, first=" * ", following=None):
    return textwrap.fill(text, WIDTH, initial_indent=first,
                         subsequent_indent=following or first, break_on_hyphens=False)


def argument_lines(args):
    lines = []
    width = max((len(a.name) for a in args), default=0)
    of_texts = ("capacity", "needed") if any(a.base == "char" for a in args) else ()
    for arg in args:
        if not arg.doc and (arg.base == "char" or arg.name in of_texts):
            continue
        words = []
        if arg.array:
            words.append(arg.shape)
        if arg.out and (arg.array or arg.base not in HANDLES):
            words.append("out")
        if arg.optional and "NULL" not in arg.doc:
            words.append("may be NULL")
        notes = ", ".join(words)
        text = "; ".join(part for part in (notes, arg.doc) if part)
        if text:
            lines.append(paragraph(text, f" *   {arg.name:<{width}}  ",
                                   " *   " + " " * width + "  "))
    return lines


# The header's opening says of every function that it may return these.
COMMON = ("ERR_ARGUMENT", "ERR_HANDLE", "ERR_BUSY")


def function_comment(function):
    lines = ["/*", paragraph(function.doc)] + argument_lines(function.args)
    if function.ownership:
        lines.append(paragraph("Ownership: " + function.ownership, following=" *   "))
    others = [name for name in function.errors if name not in COMMON]
    if others:
        names = ", ".join("ROLLCON_" + name for name in others)
        lines.append(paragraph("Also returns: " + names + ".", following=" *   "))
    if function.threads.startswith("any"):
        lines.append(" * Threads: any.")
    if function.source:
        lines.append(paragraph("Source: " + function.source + ".", following=" *   "))
    return "\n".join(lines + [" */"])


def enum_block(enum):
    lines = ["", "/* " + paragraph(enum.doc, "   ").lstrip() + " */", "enum {"]
    width = max(len(name) for name, _, _ in enum.values)
    for i, (name, number, doc) in enumerate(enum.values):
        comma = "," if i + 1 < len(enum.values) else ""
        value = f"{number}{comma}"
        lines.append(f"  {name:<{width}} = {value:<5} /* {doc} */")
    lines.append("};")
    if enum.name == "status":
        lines.append("typedef int32_t rollcon_status;")
    return "\n".join(lines) + "\n"


def callback_block(callback):
    comment = "/* " + paragraph(callback.doc, "   ").lstrip() + " */"
    head = f"typedef {return_type(callback.returns)}(ROLLCON_CALL *{callback.name})"
    return "\n" + comment + "\n" + declaration(head, callback.args) + "\n"


def write(table):
    major, minor, patch = table.version
    out = [OPENING.format(handles="\n".join(f"typedef struct rollcon_{h} rollcon_{h};" for h in HANDLES),
                          version=table.version_text, prerelease=table.prerelease, major=major, minor=minor, patch=patch,
                          abi=table.abi)]
    out += [enum_block(enum) for enum in table.enums]
    out += [callback_block(callback) for callback in table.callbacks]
    return "".join(out) + prototypes(table, "rollcon.h") + CLOSING


def write_layers(table):
    return LAYERS.format(version=table.version_text) + prototypes(table, "rollcon_layers.h") + CLOSING


def prototypes(table, header):
    out = []
    for group in table.groups:
        if group.header != header:
            continue
        rule = "-" * max(4, WIDTH - 8 - len(group.title))
        out.append(f"\n/* {rule} {group.title} */\n")
        out.append("/* " + paragraph(group.doc, "   ").lstrip() + " */\n")
        for function in group.functions:
            head = f"ROLLCON_API {return_type(function.returns)}ROLLCON_CALL {function.name}"
            out.append("\n" + function_comment(function) + "\n" +
                       declaration(head, function.args) + "\n")
    return "".join(out)
