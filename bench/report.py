#!/usr/bin/env python3
"""Tables and plots from the records of rollcon-bench.

usage: report.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes the half-space part of DOCS_DIR/accuracy.md and DOCS_DIR/images/accuracy_*.png (gnuplot).
"""

import ctypes
import ctypes.util
import datetime
import json
import os
import platform
import subprocess
import sys
from collections import defaultdict

import errors


def load(path):
    with open(path, encoding="utf-8") as lines:
        return [json.loads(line) for line in lines if line.strip()]


# The parts of accuracy.md come in this order; each command rewrites its own.
PARTS = ("work-precision", "estimates", "half-spaces")
TITLE = f"""# Accuracy, time and memory

This page has the error of every method over its time and memory, advice on which to choose, error estimates and true
errors, and the scenes of half-spaces in detail. Bodies with a mesh have pages of their own:
[boundary elements](accuracy_bodies.md) and [finite elements](accuracy_fem.md). Times are those of single runs on a
shared machine and may be several times too long.

{errors.MEANING}
"""


def write_part(path, part, text):
    """Replaces one part of a document and leaves the others as they are."""
    kept = {}
    if os.path.exists(path):
        with open(path, encoding="utf-8") as old:
            found = old.read()
        for name in PARTS:
            begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
            if begin in found and end in found:
                kept[name] = found.split(begin, 1)[1].split(end, 1)[0]
    kept[part] = "\n" + text.strip() + "\n\n"
    with open(path, "w", encoding="utf-8") as out:
        out.write(TITLE)
        for name in PARTS:
            if name in kept:
                out.write(f"\n<!-- {name} -->\n{kept[name]}<!-- end of {name} -->\n")


def put_part(path, name, text):
    """Puts a text between the marks of this name, which the document has."""
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
    with open(path, encoding="utf-8") as file:
        found = file.read()
    before, after = found.split(begin, 1)[0], found.split(end, 1)[1]
    with open(path, "w", encoding="utf-8") as file:
        file.write(before + begin + text + end + after)


COARSE = 5


def unfinished_text(records):
    unfinished = [r for r in records if r["status"] not in (0, 4, COARSE)]  # 4: contact at the rim, meant in the strips
    coarse = [r for r in records if r["status"] == COARSE]
    text = ""
    if unfinished:
        text += (f"{len(unfinished)} of {len(records)} solves did not converge: "
                 + "; ".join(f"{r['case']} {r['mesh']} {r['method']}" for r in unfinished) + ".\n\n")
    if coarse:
        cases = dict.fromkeys(r["case"] for r in coarse)
        text += (f"In {len(coarse)} of {len(records)} solves ({', '.join(cases)}) too few nodes touch for a meaningful "
                 "solution (`ROLLCON_COARSE`). The tables mark them; plots and comparisons leave them out.\n\n")
    return text


def of_case(records, *names):
    return [r for r in records if r["case"] in names]


def percent(x, digits=2):
    return "-" if x is None else f"{100 * x:+.{digits}f} %"


def magnitude(x):
    """Formats an error that has no sign with two digits."""
    return f"{100 * x:.2g} %"


def seconds(x):
    if x is None:
        return "-"
    return f"{1000 * x:.1f} ms" if x < 1 else f"{x:.2f} s"


def table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|" + " --- |" * len(heading)]
    lines += ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def plot(path, title, xlabel, ylabel, series, options=""):
    """Draws log-log lines of series: name -> [(x, y)]."""
    names = [n for n in series if series[n]]
    if not names:
        return None
    script = [
        "set terminal pngcairo size 800,520 font 'Sans,11'",
        f"set output '{path}'",
        f"set title '{title}'",
        f"set xlabel '{xlabel}'",
        f"set ylabel '{ylabel}'",
        "set logscale xy",
        "set format y '10^{%L}'",
        "set grid",
        "set key outside right",
        options,
        "plot " + ", ".join(f"'-' with linespoints pt {5 + i} title '{n}'"
                            for i, n in enumerate(names)),
    ]
    for name in names:
        script += [f"{x} {y}" for x, y in sorted(series[name]) if x and y]
        script.append("e")
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
    return "images/" + os.path.basename(path)


def hertz(records, docs):
    rows, series = [], defaultdict(list)
    for r in of_case(records, "hertz"):
        e = r["extra"]
        rows.append([r["mesh"], r["nodes"], r["pairs"], percent(r["error"], 3),
                     percent(e["error_p0"]), percent(e["error_a"]),
                     percent(e["error_b"]), seconds(r["seconds"]["wall"])])
        if "a/b" not in r["mesh"]:
            series[r["element"]].append((r["pairs"], abs(r["error"])))
    if not rows:
        return ""
    image = plot(f"{docs}/images/accuracy_hertz.png", "Hertz, circle: force at given approach",
                 "nodes in contact", "relative error", series)
    return ("## Hertz: force at given approach, peak pressure and semi-axes\n\n"
            "Peak pressure and semi-axes come from a least-squares fit of p^2 to Hertz's form.\n\n"
            + table(["frame", "nodes", "in contact", "force", "p0", "a", "b", "cold"], rows)
            + f"\n![Hertz]({image})\n")


def carter(records, docs):
    rows, series = [], defaultdict(list)
    for r in of_case(records, "carter"):
        if not r["element"].startswith("quad4"):
            continue
        rows.append([r["mesh"], r["method"], errors.percent(r["error"], 3),
                     errors.percent(r["extra"]["error_traction_l2"]), r["iterations"],
                     seconds(r["seconds"]["wall"])])
        series[r["mesh"].split()[0] + ", " + r["method"].replace("_", " ")].append(
            (r["extra"]["across"], abs(r["error"])))
    if not rows:
        return ""
    image = plot(f"{docs}/images/accuracy_carter.png", "Carter: F/(mu P) at given creepage",
                 "nodes across the contact", "relative error", series)
    return ("## Carter: long strip, frames aligned with the flow\n\n"
            "The middle section of a strip 40 half-widths long. A plane problem has no spin moment. CONTACT "
            "with 50 strips: force 1.25 %, traction 1.54 %.\n\n"
            + table(["nodes across", "scheme", "force", "traction L2", "iterations", "cold"], rows)
            + f"\n![Carter]({image})\n")


def kalker(records, _docs):
    grouped = defaultdict(dict)
    for r in of_case(records, "kalker"):
        grouped[(r["extra"]["a_over_b"], r["extra"]["nu"])][r["quantity"]] = r
    if not grouped:
        return ""
    rows = []
    for (ratio, nu), g in sorted(grouped.items()):
        along, across, spin = (g[motion] for motion in ("longitudinal creepage", "lateral creepage", "spin"))
        found = (along["value"], across["value"], spin["value"], across["extra"]["C32"],
                 spin["extra"]["C33"])
        rows.append([f"{ratio:g}", f"{nu:g}"] + [f"{c:.4g}" for c in found]
                    + [f"{errors.percent(r['error'])}, {errors.percent(r['moment_error'])}"
                       for r in (along, across, spin)])
    return ("## Kalker's creepage coefficients\n\nRings of tri6, characteristic scheme. C32 is C23 found from the "
            "moment of lateral creepage; in theory both are equal. The last columns have, for each motion by "
            "itself, the errors of force vector and moment relative to Kalker's table, which has three digits, with "
            "zeros by symmetry. Hardly anything slips, so the moment is relative to what is carried and not to mu "
            "Fn: to F sqrt(a b), F the force (with spin the greater of the force and the moment over sqrt(a b)).\n\n"
            + table(["a/b", "nu", "C11", "C22", "C23", "C32", "C33", "longitudinal creepage: force, moment",
                     "lateral creepage", "spin"], rows))


def creep_curve(records, _docs):
    rows = [[f"{r['extra']['xi']:.1e}", f"{r['value']:.5f}", f"{r['extra']['contact']:.5f}",
             errors.percent(r["error"]), errors.percent(r["moment_error"], 4), r["iterations"],
             seconds(r["seconds"]["wall"])]
            for r in of_case(records, "creep_curve")]
    if not rows:
        return ""
    return ("## Creep-force curve\n\nDifference of the force vector from CONTACT's longitudinal force, which is 1.5 % "
            "above linear theory at the smallest creepage. Lateral force and moment vanish by symmetry.\n\n"
            + table(["creepage", "F/(mu P)", "CONTACT 44 x 48", "force differs by", "moment by", "iterations", "time"],
                    rows))


def contact_marks(records, which):
    """Returns N, warm seconds and error of the force vector of CONTACT in case a or b, where its time is known."""
    return sorted((r["extra"]["n"], r["seconds"]["wall"], r["error"])
                  for r in of_case(records, f"case_{which}_contact"))


def contact_elements(n):
    """Returns the number of elements in contact of N x N grids, nine tenths of their width in a circular contact."""
    return 0.81 * 3.14159265 / 4 * n * n


def steady_rolling(records, docs):
    text = ""
    for which in ("a", "b"):
        rows, by_nodes, by_time = [], defaultdict(list), defaultdict(list)
        for r in of_case(records, "case_" + which):
            e = r["extra"]
            rings = r["element"] == "tri3 rings"
            if not (r["element"] == "quad4" and r["method"] != "godunov"
                    or rings and r["method"] == "characteristic"):
                continue
            ratio = e.get("error_over_contact")
            time_ratio = e.get("warm_seconds_over_contact")
            rows.append([r["mesh"], r["method"], r["pairs"], errors.percent(r["error"]),
                         errors.percent(r["moment_error"], 3),
                         errors.percent(e.get("contact_error"))
                         + ("*" if "contact_interpolated" in e else ""),
                         "-" if ratio is None else f"{ratio:.2f}",
                         r["iterations"], seconds(r["seconds"]["wall"]), seconds(e["warm_seconds"]),
                         seconds(e.get("contact_seconds")),
                         "-" if time_ratio is None else f"{time_ratio:.2g}"])
            name = r["mesh"].split()[0] + ", " + r["method"].replace("_", " ")
            by_nodes[name].append((r["pairs"], r["error"]))
            by_time[name].append((e["warm_seconds"], r["error"]))
        if not rows:
            continue
        for n, time, error in contact_marks(records, which):
            by_nodes["CONTACT"].append((contact_elements(n), error))
            by_time["CONTACT"].append((time, error))
        first = plot(f"{docs}/images/accuracy_case_{which}_nodes.png",
                     f"Case ({which}): error of the force vector", "nodes in contact", "relative error", by_nodes)
        second = plot(f"{docs}/images/accuracy_case_{which}_time.png",
                      f"Case ({which}): error of the force vector over time of a warm solve",
                      "seconds", "relative error", by_time)
        text += (f"## Case ({which}) compared with CONTACT\n\n"
                 + ("Circle, identical bodies, longitudinal creepage. Frames are grids of N x N nodes, 90 % filled, "
                    "and rings of triangles fitted to the contact. The error of the moment is relative to mu Fn a. "
                    "Warm: solved again after a change of creepage by 1 %. CONTACT's error is that of the force "
                    "vector (its lateral force vanishes by symmetry) at N = 16, 32, 64, 128 and 256; * marks "
                    "first-order interpolation between these. Its warm time was measured on a machine of the same "
                    "kind.\n\n"
                    if which == "a" else
                    "Circle, identical bodies, longitudinal creepage and spin; frames, errors and times are as in "
                    "case (a). CONTACT's error is that of the force vector at N = 20, 40, 80, 112 and 224; that of "
                    "its moment is not published.\n\n")
                 + table(["frame", "scheme", "in contact", "force", "moment", "CONTACT's force", "ratio", "iterations",
                          "cold", "warm", "CONTACT warm", "time ratio"], rows)
                 + f"\n![nodes]({first})\n\n![time]({second})\n\n")
    return text


PAPER_FRAMES = ("673 quad4", "703 tri3", "1985 quad8", "2745 tri6")


def example3(records, _docs):
    rows = [[r["mesh"], r["method"], f"{r['value']:.5e}", errors.percent(r["error"], 3),
             errors.percent(r["moment_error"], 4),
             f"{r['extra']['p0']:.1f}", r["iterations"], seconds(r["seconds"]["wall"]),
             seconds(r["seconds"]["compliance"]),
             f"{r['resident_bytes'] / 1e6:.0f} MB", seconds(r["extra"]["warm_seconds"]),
             f"{r['extra']['warm_iterations']:.0f}",
             f"{r['extra']['warm_heap_allocations']:.0f}"]
            for r in of_case(records, "example3") if r["mesh"] in PAPER_FRAMES]
    if not rows:
        return ""
    uncertain = max(r["extra"]["uncertainty"] for r in of_case(records, "example3"))
    return ("## Example 3: sphere on a rigid plane, Ft = 0.75 mu Fn\n\n"
            "Error of the creepage, turned like the force, relative to the extrapolated limit of frames graded to the "
            f"contact's edge (uncertain by {100 * uncertain:.2g} %), and of the spin moment, which is zero by "
            "symmetry. Cold: from arrays to tractions. Warm: creepage given, changed by 1 %.\n\n"
            + table(["frame", "scheme", "creepage", "error", "moment", "p0, MPa", "iterations", "cold",
                     "of it compliance", "memory", "warm", "iterations", "allocations"], rows))


def kernel(records, _docs):
    rows = [[r["mesh"], f"{r['extra']['kernel_evaluations']:.3g}",
             seconds(r["extra"]["seconds_compliance"]), f"{r['value']:.2e}"]
            for r in of_case(records, "kernel")]
    if not rows:
        return ""
    return ("## Half-space kernel\n\n"
            + table(["frame", "point evaluations", "time", "per second"], rows))


def linear_solver(records, docs):
    rows, series = [], defaultdict(list)
    for r in of_case(records, "linear_solver"):
        rows.append([r["mesh"], r["model"], r["method"], r["pairs"], r["unknowns"], r["iterations"],
                     r["linear_iterations"], seconds(r["value"])])
        series[r["method"] + ", " + r["model"]].append((r["pairs"], r["value"]))
    if not rows:
        return ""
    image = plot(f"{docs}/images/accuracy_linear_solver.png", "Dense LU against GMRES",
                 "nodes in contact", "seconds outside the compliance", series)
    return ("## Dense LU against GMRES\n\n"
            + table(["frame", "bodies", "solver", "in contact", "unknowns", "Newton", "Krylov",
                     "time"], rows)
            + f"\n![LU and GMRES]({image})\n")


def blas_kernels():
    """Returns OpenBLAS's name for the kernels it picks here: some are several times as slow as others."""
    try:
        name = ctypes.CDLL(ctypes.util.find_library("openblas")).openblas_get_corename
    except (OSError, AttributeError, TypeError):
        return ""
    name.restype = ctypes.c_char_p
    return f" (OpenBLAS's kernels for {name().decode()})"


def processor():
    return f"{processor_name()}{blas_kernels()}, {os.cpu_count()} cores, {datetime.date.today()}"


def processor_name():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as info:
            for line in info:
                if line.startswith("model name"):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or "unknown processor"


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    os.makedirs(f"{sys.argv[2]}/images", exist_ok=True)
    records, docs, command = load(sys.argv[1]), sys.argv[2], sys.argv[3]
    threads = sorted({r["threads"] for r in records})
    text = [f"Made by `{command}` on {processor()}, {'/'.join(map(str, threads))} thread(s).\n",
            unfinished_text(records)]
    for section in (example3, steady_rolling, hertz, carter, kalker, creep_curve, linear_solver,
                    kernel):
        text.append(section(records, docs))
    write_part(f"{docs}/accuracy.md", "half-spaces",
               "\n".join(part.rstrip() + "\n" for part in text if part))


if __name__ == "__main__":
    main()
