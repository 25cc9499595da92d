#!/usr/bin/env python3
"""Tables and a picture of repeated solves and of regular frames, from the records of rollcon-bench.

usage: report_speed.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes DOCS_DIR/speed.md and DOCS_DIR/images/speed_lattice.png (gnuplot).
"""

import os
import sys
import textwrap
from collections import defaultdict

from report import load, of_case, plot, processor, seconds, table


def number(x, digits=3):
    return "-" if x is None else f"{x:.{digits}g}"


def paragraph(text):
    return textwrap.fill(" ".join(text.split()), 120) + "\n\n"


def rows_of(records, columns):
    """Takes columns: heading -> function of a record that gives text."""
    return table(list(columns), [[f(r) for f in columns.values()] for r in records])


def extra(name, digits=3):
    return lambda r: number(r["extra"].get(name), digits)


def milliseconds(name):
    return lambda r: "-" if name not in r["extra"] else f"{r['extra'][name]:.3g} ms"


def tenths(record):
    first, last = (record["extra"][f"milliseconds_{which}_tenth"] for which in ("first", "last"))
    return f"{first:.3g}, {last:.3g} ms"


def lattice(records, docs):
    found = of_case(records, "lattice")
    if not found:
        return ""
    rows, time, memory = [], defaultdict(list), defaultdict(list)
    by_key = {(r["model"], r["method"], r["extra"]["n"]): r for r in found}
    for r in found:
        e, n = r["extra"], r["extra"]["n"]
        given = by_key.get((r["model"].replace(", forces", ""), r["method"], n))
        forces = r["model"].endswith("forces")
        ratio = number(r["seconds"]["wall"] / given["seconds"]["wall"], 2) if forces else "-"
        rows.append([r["model"], f"{n:.0f} x {n:.0f}", r["method"], seconds(r["seconds"]["wall"]),
                     seconds(e.get("warm_seconds")), ratio, seconds(e.get("contact_seconds")),
                     r["iterations"], number(e["applications"]), f"{r['peak_bytes'] / 1e6:.1f} MB",
                     f"{e['bytes_per_node']:.0f}"])
        if not forces:
            name = f"{r['model']}, {r['method']}"
            time[name].append((n * n, r["seconds"]["wall"]))
            memory[name].append((n * n, r["peak_bytes"] / 1e6))
        if "contact_seconds" in e and r["method"] == "fft":
            time[f"{r['model']}, CONTACT"].append((n * n, e["contact_seconds"]))
    image = plot(f"{docs}/images/speed_lattice.png", "Cold solve to 1e-6, one core", "nodes", "seconds",
                 time)
    bytes_image = plot(f"{docs}/images/speed_lattice_memory.png", "Memory of a contact", "nodes", "MB",
                       memory)
    return ("## Regular frames on half-spaces\n\n"
            + paragraph("""The table has cases (a) (longitudinal creepage) and (b) (with spin) of
[accuracy.md](accuracy.md) on grids of N x N nodes, solved to a tolerance of 1e-6. A cold time is from the caller's
arrays to the solution, with operators and coarser grids; a warm time is that of a second solve after a change of
creepage by 1 %. "On rigid" means that one body has all of the compliance, so the normal and the tangential problem
are coupled. "Forces" means that the longitudinal and the lateral force are given instead of the creepages; the column
"forces / creepages" has the ratio of both times. "Applications" counts how often an operator was applied to a vector
of tractions. CONTACT's times are warm times of its fastest solver on a core of this kind. It takes about 3 times as
long for unlike bodies, and about 9 times for given forces.""")
            + table(["case", "grid", "operators", "cold", "warm", "forces / creepages", "CONTACT", "Newton iterations",
                     "applications", "memory", "bytes per node"], rows)
            + (f"\n![Time over nodes]({image})\n" if image else "")
            + (f"\n![Memory over nodes]({bytes_image})\n" if bytes_image else "") + "\n")


def irregular(records):
    found = of_case(records, "irregular")
    if not found:
        return ""
    return ("## Irregular frames on half-spaces\n\n"
            + paragraph("""The table has case (b) on frames of linear triangles, half of whose nodes are in contact,
with dense and with hierarchical operators (`rollcon-bench run irregular`). Inner nodes are off by a fifth of an edge;
graded triangles are a third as wide in the middle as outside. Iterations are those of GMRES for each linear
system.""")
            + rows_of(found, {
                "triangles": lambda r: r["model"], "nodes": lambda r: f"{r['extra']['n']:.0f}",
                "operators": lambda r: r["method"], "cold": lambda r: seconds(r["seconds"]["wall"]),
                "warm": lambda r: seconds(r["extra"]["warm_seconds"]), "memory": lambda r: f"{r['peak_bytes'] / 1e6:.0f} MB",
                "applications": extra("applications"), "iterations": extra("each"),
                "error of the force": lambda r: number(100 * r["error"], 2) + " %" if r.get("error") is not None else "-"})
            + "\n")


def resolve(records):
    found = of_case(records, "resolve")
    if not found:
        return ""
    steps = [r for r in found if "newton_ms" in r["extra"]]
    derived = [r for r in found if "sensitivity_ms" in r["extra"]]
    text = "## Solving again\n\n" + paragraph("""The table has warm solves after a change of creepage, with dense
operators and without prediction. "Pairs" are the pairs of nodes in contact. Iterations of Newton and GMRES and LU
factorisations are means over many solves. "LAPACK" is the time of dgetrf and dgetrs for the system of one Newton
iteration before the sliding unknowns are eliminated.""")
    text += rows_of(steps, {
        "scene": lambda r: r["model"], "frame": lambda r: r["mesh"],
        "change": lambda r: r["quantity"].replace("seconds of a re-solve after ", ""),
        "pairs": lambda r: r["pairs"], "time": lambda r: f"{1e3 * r['seconds']['wall']:.3g} ms",
        "Newton iterations": extra("iterations_mean"), "GMRES": extra("linear_iterations_mean"),
        "factorisations": extra("factorizations_mean"), "LAPACK": milliseconds("lapack_ms"),
        "iteration / LAPACK": extra("iteration_over_lapack", 2)})
    if derived:
        text += "\n" + paragraph("""The next table compares the time for all five derivatives after such a solve with
the time of one Newton iteration:""")
        text += rows_of(derived, {
            "scene": lambda r: r["model"], "frame": lambda r: r["mesh"],
            "time": milliseconds("sensitivity_ms"), "one Newton iteration": milliseconds("iteration_ms"),
            "over iterations": lambda r: number(r["extra"]["sensitivity_ms"] / r["extra"]["iteration_ms"], 2),
            "factorisations": extra("factorizations"), "GMRES": extra("linear_iterations")})
    return text + "\n"


def tables(records):
    text = ""
    found = of_case(records, "table")
    if found:
        text += "## A table of 3000 creepages\n\n" + paragraph("""The cases form a grid of longitudinal creepage,
lateral creepage and spin, and are solved one after the other, warm. "Turning" goes through the grid to and fro, so
that neighbours differ in one creepage; "rewinding" begins each line at the same end. Iterations are means per case.""")
        text += rows_of(found, {
            "bodies": lambda r: r["model"], "frame": lambda r: r["mesh"], "order": lambda r: r["method"],
            "tolerance": lambda r: r["quantity"].rsplit(" ", 1)[-1], "per scene": lambda r: f"{r['value']:.3g} ms",
            "Newton iterations": extra("iterations_mean"), "GMRES": extra("linear_iterations_mean"),
            "slowest": milliseconds("slowest_ms"), "failures": extra("failures")}) + "\n"
    found = of_case(records, "many")
    if found:
        text += "## A list of cases in one call\n\n" + paragraph("""The table compares `rollcon_contact_solve_many`
with a loop of solves. The cases of a grid list are neighbours; those of a scattered list are drawn at random.""")
        text += rows_of(found, {
            "list": lambda r: r["mesh"], "method": lambda r: r["method"], "threads": lambda r: r["threads"],
            "cases": extra("cases", 5), "per case": lambda r: f"{r['value']:.3g} ms",
            "Newton iterations": extra("iterations_per_case"), "time / one by one": extra("seconds_over_one_by_one", 2),
            "not converged": extra("not_ok"), "forces differ by": lambda r: f"{r['error']:.1e}"}) + "\n"
    return text


def loops(records):
    text = ""
    found = of_case(records, "time_loop")
    if found:
        text += "## The time loop of a vehicle\n\n" + paragraph("""The load (±30 %), the lateral creepage and the spin
vary slowly, as in the oscillation of a wheelset; creepages or the traction are given. Numbers are those after 2000
steps. "First, last tenth" is the time of a solve in the first and in the last tenth of the loop; "most" is the number
of iterations of the slowest solve; "fallbacks" counts what was tried beyond Newton's plain iteration; "allocations"
and "growth" are what the loop took from memory.""")
        text += rows_of(found, {
                     "drive": lambda r: r["model"], "elements": lambda r: r["mesh"], "solves": extra("solves", 6),
                     "per solve": milliseconds("milliseconds_per_solve"),
                     "first, last tenth": tenths,
                     "Newton iterations": lambda r: number(r["value"]), "most": extra("most_iterations"),
                     "fallbacks": extra("fallbacks"), "allocations": extra("allocations"),
                     "growth": lambda r: f"{r['extra']['resident_growth_bytes'] / 1024:.0f} KiB",
                     "not converged": extra("not_converged"), "failed": extra("failed")}) + "\n"
    found = of_case(records, "loop")
    if found:
        text += "The next table shows what prediction saves along a loop of small steps:\n\n"
        text += rows_of(found, {
            "bodies": lambda r: r["model"], "prediction": lambda r: "yes" if r["method"] else "no",
            "tolerance": lambda r: r["quantity"].rsplit(" ", 1)[-1], "per step": milliseconds("ms_per_step"),
            "Newton iterations": lambda r: number(r["value"]), "most": extra("most_iterations"),
            "predictions taken": extra("predictions", 5)}) + "\n"
    found = of_case(records, "curve")
    if found:
        text += "## Creep curve of the paper's two rings\n\n" + paragraph("""The creepage goes from one end of the
curve to the other in 100 warm solves. Iterations and factorisations are means per solve.""")
        text += rows_of(found, {
            "bodies": lambda r: r["model"], "mesh": lambda r: r["mesh"], "method": lambda r: r["method"],
            "100 points": lambda r: seconds(r["seconds"]["wall"]), "Newton iterations": extra("iterations_mean"),
            "GMRES": extra("linear_iterations_mean"), "factorisations": extra("factorizations_mean")}) + "\n"
    return text


def stresses(records):
    found = of_case(records, "stresses")
    if not found:
        return ""
    return ("## Stresses inside half-spaces\n\n"
            + paragraph("""The table (`rollcon-bench run stresses`) has the times of stresses and displacements to the
standard accuracy, 1e-5 of the largest traction, below a solved contact of radius 1 whose frame reaches to 1.1. Blocks
of points in layers, at the places of a regular frame, are computed by FFT. The last two columns have the pairs of a
point and a loaded node, and of a point and an element, that are computed in a second.""")
            + rows_of(found, {
                "frame": lambda r: r["mesh"], "points": lambda r: r["model"], "number": extra("points", 7),
                "time": lambda r: seconds(r["seconds"]["wall"]),
                "per point": lambda r: f"{r['extra']['us_per_point']:.3g} µs",
                "points x nodes under load, a second": extra("loaded_pairs_per_second", 2),
                "points x elements, a second": extra("pairs_per_second", 2)}) + "\n")


def saved(records):
    found = of_case(records, "saved_body")
    if not found:
        return ""
    names = sorted({k for r in found for k in r["extra"]})
    return ("## Prepared bodies as files\n\n"
            + paragraph(""""Prepared" means after `rollcon_body_prepare`. After a solve a body also holds the
responses that its contact has asked for.""")
            + table(["", *(f"{r['model']}, {r['mesh']}" for r in found)],
                    [[name.replace("_", " "), *(number(r["extra"].get(name), 4) for r in found)] for name in names])
            + "\n")


def main():
    path, docs, command = sys.argv[1:4]
    records = load(path)
    os.makedirs(f"{docs}/images", exist_ok=True)
    text = ("# Regular frames and repeated solves: time and memory\n\n"
            + paragraph(f"""Made by `{command}` on one core of {processor()}. Times are those of single runs or the
least of a few, on a shared machine, and good to a few ten per cent. Both times of a ratio are from one run.
[thrift.md](thrift.md) has what each shortcut saves by itself.""")
            + lattice(records, docs) + irregular(records) + stresses(records) + resolve(records) + tables(records) + loops(records)
            + saved(records))
    with open(f"{docs}/speed.md", "w", encoding="utf-8") as out:
        out.write(text.rstrip() + "\n")


if __name__ == "__main__":
    main()
