#!/usr/bin/env python3
"""Tables and plots of bodies with a mesh, from the records of rollcon-bench.

usage: report_bodies.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes DOCS_DIR/accuracy_bodies.md and DOCS_DIR/images/accuracy_bodies_*.png (gnuplot).
"""

import math
import os
import sys
from collections import defaultdict

from report import load, of_case, percent, plot, processor, seconds, table


def megabytes(x):
    return f"{x / 1e6:.0f} MB"


def kernel(records, _docs):
    rates = defaultdict(dict)
    assembly = []
    for r in of_case(records, "bem_kernel"):
        rate = f"{r['value'] / 1e6:.0f}"
        if r["method"] == "assembly":
            assembly.append([r["mesh"], rate, f"{r['extra']['kernel_evaluations'] / 1e6:.1f}",
                             seconds(r["extra"]["seconds_assembly"])])
        else:
            rates[r["element"]][r["method"]] = rate
    if not rates:
        return ""
    sets = sorted({name for of in rates.values() for name in of}, key=["baseline", "avx2", "avx512"].index)
    return ("## Kernel\n\n"
            "The table has millions of point evaluations a second on one core, by the instructions of the "
            "processor. An evaluation is T and U at a quadrature point far from the element, with all shape "
            "functions.\n\n"
            + table(["element"] + sets, [[e] + [of.get(name, "") for name in sets]
                                         for e, of in rates.items()])
            + "\nThe next table has evaluations during the assembly of a body, with near field and choice of rules:\n\n"
            + table(["mesh", "millions a second", "millions", "assembly"], assembly))


def ring_loads(records, docs):
    rows, series, by_time = [], defaultdict(list), defaultdict(list)
    for r in of_case(records, "ring_loads"):
        nu = r["extra"]["nu"]
        rows.append([r["mesh"], r["nodes"], r["unknowns"], r["model"], f"{nu:g}",
                     percent(r["error"]), seconds(r["seconds"]["assembly"]),
                     seconds(r["seconds"]["factor"]), seconds(r["seconds"]["wall"]),
                     megabytes(r["peak_bytes"])])
        if nu == 0.3:
            kind = r["mesh"].split(",")[0] + ", " + r["model"]
            series[kind].append((r["nodes"], abs(r["error"])))
            by_time[kind].append((r["seconds"]["wall"], abs(r["error"])))
    if not rows:
        return ""
    first = plot(f"{docs}/images/accuracy_bodies_ring_nodes.png",
                 "Ring under loads on a patch (nu = 0.3)", "nodes", "worst relative error",
                 series)
    second = plot(f"{docs}/images/accuracy_bodies_ring_time.png",
                  "Ring under loads on a patch (nu = 0.3)", "seconds, arrays to displacements",
                  "worst relative error", by_time)
    return ("## A ring under loads on a patch\n\n"
            "The ring of example 1 alone, with its hub held, has 100 MPa on |s| <= 1 as pressure, as shear along "
            "the circumference, or along the axle. Meshes are named by the elements along and across this patch. "
            "Displacements at (s, y) = (0, 0), (1, 0), (2, 0), (0, 2), (0, 3.9) and (0, 4), and their mean over the "
            "patch, are compared with a Fourier series in the angle, in all directions in which they do not vanish. "
            "The table has the worst of 12 (pressure), 9 (shear), 10 (axial) or 6 (pressure, nu = 0.49) values. "
            "Errors of components along the load are relative to themselves, others to the largest displacement.\n\n"
            + table(["elements", "nodes", "unknowns", "load", "nu", "error", "assembly", "LU",
                     "in all", "memory"], rows)
            + f"\n![nodes]({first})\n\n![time]({second})\n")


def rings(records, docs):
    rows, by_time, by_size = [], defaultdict(list), defaultdict(list)
    for r in of_case(records, "rings"):
        e = r["extra"]
        rows.append([r["mesh"], r["method"].replace("_", " "), percent(r["error"]),
                     f"{e['p0_mid_plane']:.2f}", percent(e["p0_over_fine"] - 1),
                     r["iterations"], seconds(r["seconds"]["assembly"]),
                     seconds(r["seconds"]["factor"]), seconds(r["seconds"]["condense"]),
                     seconds(r["seconds"]["wall"]), megabytes(r["resident_bytes"]),
                     seconds(e["warm_seconds"])])
        kind = r["mesh"].split(",")[0] + ", " + r["method"].replace("_", " ")
        if r["method"] != "godunov":
            by_time[kind].append((r["seconds"]["wall"], abs(r["error"])))
            by_size[kind].append((e["body_unknowns"] / 3, abs(r["error"])))
    if not rows:
        return ""
    image = plot(f"{docs}/images/accuracy_bodies_rings.png",
                 "Two rings: error of the creepage", "nodes of a ring",
                 "relative difference", by_size)
    return ("## Example 1: two equal rings\n\n"
            "The creepage at Ft = 0.6271 mu Fn and the peak pressure in the mid-plane are compared with those of a "
            "fine mesh of finite elements (36 x 12 hex20 in the zone, 148,716 unknowns a ring): -1.505e-3 and "
            "106.45 MPa. Other fine meshes (hex8 36 x 16 and 48 x 12, hex20 32 x 8 and 48 x 8) are within 1.6 and "
            "0.1 % of it. The plane problem (Carter, Hertz: -1.472e-3, 103.87 MPa) differs: rings as wide as these, "
            "with free sides, have 2.5 % more pressure. Warm: solved again after a change of creepage by 1 %."
            "\n\n"
            + table(["mesh", "scheme", "creepage", "p0, MPa", "p0", "iterations",
                     "assembly", "LU",
                     "condensation", "cold", "memory", "warm"], rows)
            + f"\n![rings]({image})\n")


def ring_sections(records, docs):
    rows, by_time = [], defaultdict(list)
    for r in of_case(records, "ring_sections"):
        e = r["extra"]
        rows.append([r["model"], r["mesh"], int(e["body_unknowns"]), percent(e["p0"]), percent(e["approach"]),
                     percent(r["error"]), percent(e["lateral"]), seconds(e["processor"]),
                     megabytes(r["peak_bytes"])])
        worst = max(abs(x) for x in (e["p0"], e["approach"], r["error"], e["lateral"]))
        by_time[r["model"]].append((e["processor"], worst))
    if not rows:
        return ""
    image = plot(f"{docs}/images/accuracy_bodies_sections.png", "Two rings: worst error of all components",
                 "processor seconds, arrays to results", "relative difference", by_time)
    return ("## Sections beside finite and boundary elements\n\n"
            "The same two rings on one frame, of 24 lines along the contact and 12 across, graded to the contact's "
            "edges: by sections ([sections](sections.md)), hex20 and quad8 of boundary elements. Pressure in the "
            "middle, approach, and creepages under a force of 0.6271 mu Fn along and across are compared with a section "
            f"of 24 x 24 quad8; its pressure is {percent(e['fine_p0'])} off, and its creepage "
            f"{percent(e['fine_creepage'])} off that of the fine hex20 above. Processor time is that of bodies and "
            "first solve.\n\n"
            + table(["by", "mesh", "unknowns of a ring", "pressure", "approach", "creepage along", "across",
                     "processor", "memory"], rows)
            + f"\n![sections]({image})\n")


def wheel(records, _docs):
    rows = [[r["mesh"], f"{r['value']:.1f} N", percent(r["error"]), f"{r['extra']['p0']:.1f}",
             r["iterations"], seconds(r["seconds"]["assembly"]), seconds(r["seconds"]["factor"]),
             seconds(r["seconds"]["condense"]), seconds(r["seconds"]["wall"]),
             megabytes(r["resident_bytes"]), seconds(r["extra"]["warm_seconds"])]
            for r in of_case(records, "wheel")]
    if not rows:
        return ""
    return ("## Example 4: wheel on a rigid rail head\n\n"
            "The force at an approach of 0.015 mm is compared with the paper's 457 N. The paper does not give the "
            "profiles; [examples](examples.md) has those used here.\n\n"
            + table(["mesh", "force", "difference", "p0, MPa", "iterations", "assembly", "LU",
                     "condensation", "cold", "memory", "warm"], rows))


def slope(points):
    """Returns the exponent of a power law through the larger half of the points."""
    points = sorted(points)[len(points) // 2:]
    if len(points) < 2:
        return None
    x = [math.log(p[0]) for p in points]
    y = [math.log(p[1]) for p in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y))
            / sum((a - mean_x) ** 2 for a in x))


def growth(records, docs):
    phases = ["assembly", "factor", "condense", "wall"]
    names = {"assembly": "assembly", "factor": "LU", "condense": "condensation", "wall": "in all"}
    text = ""
    for threads in sorted({r["threads"] for r in of_case(records, "growth")}):
        rows, series = [], defaultdict(list)
        for r in of_case(records, "growth"):
            if r["threads"] != threads:
                continue
            nodes = r["extra"]["body_unknowns"] / 3
            rows.append([f"{nodes:.0f}", r["nodes"]] + [seconds(r["seconds"][p]) for p in phases]
                        + [megabytes(r["resident_bytes"]), f"{r['extra']['body_condition']:.1e}"])
            for p in phases:
                series[names[p]].append((nodes, r["seconds"][p]))
            series["bytes/1e9"].append((nodes, r["resident_bytes"] / 1e9))
        image = plot(f"{docs}/images/accuracy_bodies_growth_{threads}.png",
                     f"Two rings, growing meshes, {threads} thread(s)", "nodes of a ring",
                     "seconds, GB", series)
        slopes = ", ".join(f"{name} {slope(points):.1f}" for name, points in series.items()
                           if slope(points) is not None)
        text += (f"### {threads} thread(s)\n\n"
                 + table(["nodes", "pairs"] + [names[p] for p in phases]
                         + ["memory", "condition"], rows)
                 + f"\nExponents over the larger half: {slopes}.\n\n![growth]({image})\n\n")
    return "## Growth with size\n\n" + text if text else ""


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    os.makedirs(f"{sys.argv[2]}/images", exist_ok=True)
    records, docs, command = load(sys.argv[1]), sys.argv[2], sys.argv[3]
    text = ["# Bodies with a mesh: accuracy, time and memory\n",
            f"Made by `{command}` on {processor()}, one thread unless said otherwise. Times are "
            "those of single runs on a shared machine, good to a few ten per cent.\n"]
    for section in (kernel, ring_loads, rings, ring_sections, wheel, growth):
        text.append(section(records, docs))
    with open(f"{docs}/accuracy_bodies.md", "w", encoding="utf-8") as out:
        out.write("\n".join(part.rstrip() + "\n" for part in text if part))


if __name__ == "__main__":
    main()
