#!/usr/bin/env python3
"""Tables and plots of finite-element bodies, from the records of rollcon-bench.

usage: report_fem.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes DOCS_DIR/accuracy_fem.md and DOCS_DIR/images/accuracy_fem_*.png (gnuplot).
"""

import os
import sys
from collections import defaultdict

from report import load, of_case, percent, plot, processor, seconds, table
from report_bodies import megabytes, slope

PHASES = {"assembly": "assembly", "order": "ordering", "factor": "factorisation",
          "condense": "condensation"}


def growth(records, docs):
    rows = of_case(records, "fem_growth")
    if not rows:
        return ""
    text = ("## Growth with size\n\n"
            "The table has blocks of hex8, held at the bottom, with 400 contact nodes on top (1200 unknowns; their "
            "neighbours on the surface are condensed as well). The condensed stiffness is the end of the factor, so "
            "nothing else is solved for.\n\n")
    time, memory = defaultdict(list), defaultdict(list)
    cells, exponents = [], []
    for r in rows:
        unknowns = r["extra"]["unknowns"]
        cells.append([r["threads"], f"{unknowns:.0f}",
                      f"{r['extra']['condensed_unknowns']:.0f}"]
                     + [seconds(r["seconds"][p]) for p in PHASES]
                     + [seconds(r["value"]), megabytes(r["extra"]["peak_bytes"]),
                        f"{r['extra']['factor_nonzeros'] / 1e6:.1f} M"])
        name = f"{r['threads']} thread(s)"
        time[name].append((unknowns, r["value"]))
        memory[name].append((unknowns, r["extra"]["peak_bytes"] / 1e9))
    text += table(["threads", "unknowns", "condensed"] + list(PHASES.values())
                  + ["in all", "memory", "nonzeros"], cells)
    for name in time:
        if slope(time[name]) is not None and len(time[name]) > 3:
            exponents.append(f"seconds {slope(time[name]):.2f}, bytes {slope(memory[name]):.2f}")
    first = plot(f"{docs}/images/accuracy_fem_growth_time.png", "Until condensed", "unknowns",
                 "seconds", time)
    second = plot(f"{docs}/images/accuracy_fem_growth_memory.png", "Until condensed", "unknowns",
                  "peak, GB", memory)
    return (text + "\nExponents over the larger half: " + "; ".join(exponents)
            + f".\n\n![time]({first})\n\n![memory]({second})\n")


def ring_loads(records, docs):
    series, by_time, rows = defaultdict(list), defaultdict(list), []
    for r in of_case(records, "ring_loads", "fem_ring_loads"):
        nu, kind = r["extra"]["nu"], r["mesh"].split(",")[0]
        if nu == 0.3 and r["model"] == "pressure":
            series[kind].append((r["unknowns"], abs(r["error"])))
            by_time[kind].append((r["seconds"]["wall"], abs(r["error"])))
        if r["method"] == "FEM":
            rows.append([r["mesh"], r["nodes"], r["unknowns"], r["model"], f"{nu:g}",
                         percent(r["error"]),
                         seconds(r["seconds"]["assembly"]), seconds(r["seconds"]["factor"]),
                         seconds(r["seconds"]["wall"]), megabytes(r["peak_bytes"])])
    if not rows:
        return ""
    first = plot(f"{docs}/images/accuracy_fem_ring_unknowns.png",
                 "Ring under a patch of pressure (nu = 0.3)", "unknowns", "worst relative error",
                 series)
    second = plot(f"{docs}/images/accuracy_fem_ring_time.png",
                  "Ring under a patch of pressure (nu = 0.3)", "seconds, arrays to displacements",
                  "worst relative error", by_time)
    return ("## A ring under loads on a patch\n\n"
            "The ring, the loads (pressure and shear) and the displacements are those of the same table for "
            "boundary elements in [accuracy_bodies](accuracy_bodies.md), without the displacements at s = 2, where "
            "these meshes have no nodes. The plots have finite and boundary elements (tri, quad; with s = 2).\n\n"
            + table(["elements", "nodes", "unknowns", "load", "nu", "error", "assembly", "factorisation",
                     "in all", "memory"], rows)
            + f"\n![unknowns]({first})\n\n![time]({second})\n")


def same_block(records, docs):
    rows, approach, by_time = [], defaultdict(list), defaultdict(list)
    for r in of_case(records, "same_block"):
        e = r["extra"]
        rows.append([r["mesh"], f"{e['unknowns']:.0f}", f"{r['value']:.6f}", percent(r["error"], 3),
                     f"{e['p0']:.2f}", percent(e["p0_error"]), seconds(r["seconds"]["wall"])])
        approach[r["method"]].append((e["unknowns"], abs(r["error"])))
        by_time[r["method"]].append((r["seconds"]["wall"], abs(r["error"])))
    if not rows:
        return ""
    first = plot(f"{docs}/images/accuracy_fem_same_block.png",
                 "One block by finite and by boundary elements", "unknowns",
                 "approach, relative difference", approach)
    second = plot(f"{docs}/images/accuracy_fem_same_block_time.png",
                  "One block by finite and by boundary elements", "seconds",
                  "approach, relative difference", by_time)
    return ("## One block by finite and by boundary elements\n\n"
            "A block of 10 x 10 x 5 mm is held at its bottom, under a rigid sphere. The same frame of 449 nodes is "
            "laid on every mesh, so only the body's compliance differs. Reference: 12 x 12 quad8 (boundary "
            "elements) in the zone of 2.5 mm.\n\n"
            + table(["mesh", "unknowns", "approach, mm", "difference", "p0, MPa", "difference",
                     "seconds"], rows)
            + f"\n![approach]({first})\n\n![time]({second})\n")


def ring_pairs(records, _docs):
    rows = []
    for r in of_case(records, "ring_pairs"):
        e = r["extra"]
        rows.append([r["model"], r["mesh"], f"{e['unknowns1']:.0f}", f"{e['unknowns2']:.0f}",
                     f"{e['p0']:.2f}", percent(e["p0_over_fine"] - 1), f"{r['value']:.4e}",
                     percent(r["error"]), r["iterations"], seconds(r["seconds"]["wall"])])
    if not rows:
        return ""
    return ("## Example 1 by finite and by boundary elements\n\n"
            "Creepage and peak pressure of two equal rings, by least squares, are compared with the fine mesh of "
            "[accuracy_bodies](accuracy_bodies.md) (-1.505e-3, 106.45 MPa). Between two rings with the same mesh "
            "the slip that pressure causes cancels. Between a finite-element ring and a boundary-element ring the "
            "difference of their errors in this slip remains. It falls as the mesh is refined: a tenth of the "
            "creepage is 3 % of the strain under the pressure."
            "\n\n"
            + table(["pair", "mesh", "unknowns 1", "unknowns 2", "p0, MPa", "p0", "creepage",
                     "difference", "iterations", "seconds"], rows))


def example2(records, _docs):
    rows = []
    for r in of_case(records, "ring_on_halfspace"):
        e = r["extra"]
        rows.append([r["model"], r["mesh"], r["method"].replace("_", " "), f"{e['p0']:.2f}",
                     percent(e["p0_over_hertz"] - 1), f"{e['half_width']:.3f}",
                     f"{r['value']:.4e}", percent(r["error"]), f"{e['gap']:.4f}",
                     f"{e['slip']:.4f}", r["iterations"], seconds(r["seconds"]["wall"])])
    if not rows:
        return ""
    return ("## Example 2: a ring of finite elements on a half-space\n\n"
            "The paper has p0 near 107.9 MPa, a half-width near 0.99 mm (both Hertz, plane problem), and a "
            "greatest gap of 0.0086 mm and slip velocity of 0.0139 mm/s in its zone. It does not state the length "
            "of this zone (here 3 mm, which gives example 1 its greatest gap). The creepage at Ft = 0.5373 mu Fn is "
            "compared with that of the plane problem of the two materials: pressure stretches the ring and not the "
            "ground, and adds -4.3e-3 to Carter's -6.3e-4. The paper's slip velocity is that of a contact without "
            "this coupling (equal materials: 0.014 to 0.02). Godunov's differences are made for linear faces. The "
            "block of boundary elements has 288 quadrilaterals on its top.\n\n"
            + table(["pair", "mesh", "scheme", "p0, MPa", "p0", "half-width, mm", "creepage",
                     "difference", "gap, mm", "slip, mm/s", "iterations", "seconds"], rows))


def location(records, _docs):
    rows = [[r["method"], r["elements"], r["nodes"], seconds(r["seconds"]["tree"]),
             seconds(r["seconds"]["search"]), seconds(r["seconds"]["wall"])]
            for r in of_case(records, "location")]
    if not rows:
        return ""
    return ("## Location of a frame's nodes\n\n"
            + table(["faces of type", "faces", "nodes", "tree", "search", "in all"], rows))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    os.makedirs(f"{sys.argv[2]}/images", exist_ok=True)
    records, docs, command = load(sys.argv[1]), sys.argv[2], sys.argv[3]
    text = ["# Finite-element bodies: accuracy, time and memory\n",
            f"Made by `{command}` on {processor()}, one thread unless said otherwise. Times are "
            "those of single runs on a shared machine, good to a few ten per cent.\n"]
    for section in (growth, ring_loads, same_block, ring_pairs, example2, location):
        text.append(section(records, docs))
    with open(f"{docs}/accuracy_fem.md", "w", encoding="utf-8") as out:
        out.write("\n".join(part.rstrip() + "\n" for part in text if part))


if __name__ == "__main__":
    main()
