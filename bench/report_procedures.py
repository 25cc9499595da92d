#!/usr/bin/env python3
"""Tables and pictures of the solution procedures, from the records of rollcon-bench.

usage: report_procedures.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes DOCS_DIR/procedures.md and DOCS_DIR/images/procedures_*.png (gnuplot).
"""

import os
import statistics
import sys
from collections import defaultdict

from report import load, of_case, processor, seconds, table
from report_procedures_plots import SOLVERS, bars, curves
from report_procedures_text import CHOICE, OPTIONS

METHODS = {("exact", "auto"): "exact", ("b_derivative", "auto"): "B-derivative",
           ("simplified", "auto"): "simplified", ("reduced", "jacobi"): "reduced, Jacobi",
           ("reduced", "pseudo_temporal"): "reduced, pseudo-temporal",
           ("reduced", "extrapolation"): "reduced, extrapolation"}
SAME = 1e-6  # largest relative difference of tractions that counts as one solution
STATUS = {-1: "refused", 1: "not converged", 2: "no contact", 3: "no steady solution"}


def parts(record):
    """Returns system, Jacobian with estimate, linear solver, preconditioner."""
    system, jacobian, estimate, solver, preconditioner = record["method"].split()
    return system, METHODS[(jacobian, estimate)], solver, preconditioner


def converged(record):
    return record["status"] in (0, 4)  # 4: contact at the frame's rim


def same(record):
    return converged(record) and record["error"] is not None and record["error"] <= SAME


def status(record):
    return STATUS.get(record["status"], f"status {record['status']}")


def unknowns(record):
    """Returns the number of unknowns, with those of the bodies where they are written out."""
    own = record["extra"].get("body_unknowns", 0)
    if parts(record)[0] == "monolithic" and record["unknowns"] < own:
        return f"{record['unknowns'] + own:.0f}"
    return f"{record['unknowns']}"


def by_solver(records):
    """Maps (system, method) -> solver -> record, in the order of METHODS."""
    found = defaultdict(dict)
    for r in records:
        system, method, solver, _ = parts(r)
        if solver in SOLVERS:
            found[(system, method)][solver] = r
    order = {m: k for k, m in enumerate(METHODS.values())}
    return dict(sorted(found.items(), key=lambda item: (item[0][0], order[item[0][1]])))


def cell(records, text):
    """Returns one entry for the three linear solvers: the text of each, or why there is none."""
    out = []
    for solver in SOLVERS:
        r = records.get(solver)
        out.append("-" if r is None else text(r) if same(r) else
                   "other" if converged(r) else "no")
    return " / ".join(out)


def figure16a(records, docs):
    rows = of_case(records, "procedures_example3")
    if not rows:
        return ""
    text = (f"## Example 3: time of each way of solving (the paper's figure 16)\n\n"
            f"Sphere on a rigid plane, {rows[0]['mesh']}, Ft = 0.75 mu Fn, from zero tractions "
            "(exact condensed: from a Hertzian pressure). Seconds are without compliance and convection, which are "
            f"the same for all. The last column is the difference of the tractions from those of the standard "
            f"procedure, the first row; above {SAME:g} it is not the same solution.\n\n")
    images, cells = [], []
    for system in ("condensed", "monolithic"):
        groups = {}
        for (of, method), found in by_solver(
                [r for r in rows if r["model"] == "godunov"]).items():
            if of == system:
                groups[method] = {s: r["value"] for s, r in found.items() if same(r)}
        if any(groups.values()):
            images.append(bars(f"{docs}/images/procedures_time_{system}.png",
                               f"Example 3, {rows[0]['mesh']}, {system}", "seconds", groups))
    for r in rows:
        system, method, solver, _ = parts(r)
        cells.append([r["model"].replace("_", " "), system, method, SOLVERS.get(solver, "auto"),
                      unknowns(r), r["iterations"] if converged(r) else
                      f"{r['iterations']} ({status(r)})", r["linear_iterations"],
                      f"{r['extra'].get('factorizations', 0):.0f}", seconds(r["value"]),
                      "-" if r["error"] is None else f"{r['error']:.1e}"])
    return (text + "".join(f"![time]({i})\n\n" for i in images)
            + table(["scheme", "system", "Jacobian", "solver", "unknowns", "iterations", "Krylov",
                     "factorisations", "seconds", "difference"], cells))


def figure16b(records, docs):
    rows = [r for r in of_case(records, "procedures_density")]
    if not rows:
        return ""
    by_mesh = defaultdict(dict)
    for r in rows:
        system, method, solver, _ = parts(r)
        by_mesh[r["nodes"]][(method, solver)] = r
    series, cells = defaultdict(list), []
    for nodes, found in sorted(by_mesh.items()):
        for method in METHODS.values():
            lu = found.get((method, "lu"))
            if lu is None or not same(lu):
                continue
            for solver in ("gmres", "gmres_adaptive"):
                r = found.get((method, solver))
                if r is not None and same(r):
                    series[f"{method}, {SOLVERS[solver]}"].append((nodes, r["value"] / lu["value"]))
        line = [nodes, next(iter(found.values()))["pairs"]]
        standard = found.get(("exact", "auto"))
        line.append(seconds(standard["value"]) if standard else "-")
        for method in list(METHODS.values())[1:4]:
            one = {s: found[(method, s)] for s in SOLVERS if (method, s) in found}
            line += [cell(one, lambda r: str(r["iterations"])),
                     cell(one, lambda r: seconds(r["value"]))]
        cells.append(line)
    image = curves(f"{docs}/images/procedures_density.png",
                   "Example 3: time relative to LU over the density of the mesh", "nodes",
                   "seconds over those with LU", series,
                   ["set logscale x", "set xtics (200, 300, 400, 500, 700, 1000)",
                    "set ytics (0.1, 0.2, 0.3, 0.5, 0.7, 1)"])
    heading = ["nodes", "in contact", "standard"]
    for method in list(METHODS.values())[1:4]:
        heading += [f"{method}: iterations", "time"]
    return ("### Over the density of the mesh\n\n"
            "The frames are linear quadrilaterals, the system is condensed, and entries are for LU / GMRES / "
            "adaptive GMRES (the paper's figure 16(b): time relative to LU).\n\n"
            f"![density]({image})\n\n" + table(heading, cells))


def figure21(records, docs):
    rows = of_case(records, "procedures_example4")
    if not rows:
        return ""
    text = (f"## Example 4: error function over iterations and time (the paper's figure 21)\n\n"
            f"Wheel on a rigid rail head, {rows[0]['mesh']}, {rows[0]['pairs']} nodes in contact. "
            "The error function is relative to that of the start. The standard procedure solves a frictionless "
            "problem first and then the whole one, so its curve falls twice. LU, GMRES and adaptive GMRES take "
            "nearly the same path.\n\n")
    pictures = {"condensed": ("exact", "B-derivative", "simplified", "reduced, Jacobi"),
                "monolithic": ("exact", "B-derivative", "simplified", "reduced, Jacobi")}
    cells = []
    for system, wanted in pictures.items():
        over_iterations, over_time = defaultdict(list), defaultdict(list)
        for r in rows:
            of, method, solver, preconditioner = parts(r)
            if of != system or method not in wanted or not r.get("psi"):
                continue
            psi = [p / r["psi"][0] if p is not None and r["psi"][0] else None for p in r["psi"]]
            name = f"{method}, {SOLVERS.get(solver, 'auto')}"
            over_iterations[name] = list(enumerate(psi))
            over_time[name] = [(t, p) for t, p in zip(r["psi_seconds"], psi)
                               if t > 1e-3 * r["psi_seconds"][-1]]
        for kind, series, label, options in (
                ("iterations", over_iterations, "iteration", []),
                ("seconds", over_time, "seconds", ["set logscale x"])):
            image = curves(f"{docs}/images/procedures_psi_{system}_{kind}.png",
                           f"Example 4, {system}: error function", label,
                           "Psi over its first value", series,
                           ["set format y '10^{%L}'"] + options, False)
            if image:
                text += f"![{system}, {kind}]({image})\n\n"
    for r in rows:
        system, method, solver, preconditioner = parts(r)
        cells.append([system, method, SOLVERS.get(solver, "auto"), unknowns(r), r["iterations"],
                      r["linear_iterations"], f"{r['extra'].get('factorizations', 0):.0f}",
                      seconds(r["value"]),
                      f"{r['error']:.1e}" if converged(r) and r["error"] is not None
                      else status(r)])
    return text + table(["system", "Jacobian", "solver", "unknowns", "iterations", "Krylov",
                         "factorisations", "seconds", "difference"], cells)


def combinations(records, _docs):
    rows = of_case(records, "procedures_examples")
    if not rows:
        return ""
    examples = list(dict.fromkeys(r["model"] for r in rows))
    found = {e: by_solver([r for r in rows if r["model"] == e]) for e in examples}
    keys = list(dict.fromkeys(k for e in examples for k in found[e]))
    good = [r for r in rows if same(r)]
    apart = [r for r in rows if converged(r) and not same(r)]
    failed = [r for r in rows if not converged(r)]
    text = ("## Every combination on the paper's examples\n\n"
            "Meshes are coarse here ("
            + ", ".join(f"{e}: {next(r for r in rows if r['model'] == e)['nodes']} nodes in the "
                        "frame" for e in examples)
            + f"), convection by Godunov's scheme. Of {len(rows)} solves {len(good)} reach the "
            f"tractions of the standard procedure within {SAME:g} (worst of them "
            f"{max((r['error'] for r in good), default=0):.1e}), {len(apart)} converge to others, "
            f"{len(failed)} do not converge.\n\n")
    for title, show in (("Iterations", lambda r: str(r["iterations"])),
                        ("Krylov iterations", lambda r: str(r["linear_iterations"])),
                        ("Factorisations",
                         lambda r: f"{r['extra'].get('factorizations', 0):.0f}"),
                        ("Seconds without compliance and convection",
                         lambda r: seconds(r["extra"].get("solving_seconds")))):
        text += (f"{title}, LU / GMRES / adaptive GMRES:\n\n"
                 + table(["system", "Jacobian"] + [e.replace("example", "ex.") for e in examples],
                         [[k[0], k[1]] + [cell(found[e].get(k, {}), show) for e in examples]
                          for k in keys]) + "\n")
    sizes = []
    for e in examples:
        for system in ("condensed", "monolithic"):
            one = [r for k, g in found[e].items() for r in g.values() if k[0] == system]
            if one:
                sizes.append([e, one[0]["pairs"], system, unknowns(one[0]),
                              f"{max(r['peak_bytes'] for r in one) / 1e6:.1f} MB"])
    text += ("Unknowns of the linear systems (monolithic: with those of the bodies; gap vectors and slips, "
             "eliminated exactly beforehand, not counted), and the most "
             "memory that the contact counted:\n\n"
             + table(["example", "pairs in contact", "system", "unknowns", "memory"], sizes))
    if apart or failed:
        text += ("\nNot the solution of the standard procedure:\n\n"
                 + table(["example", "procedure", "result", "iterations", "difference"],
                         [[r["model"], r["method"].replace("_", " "),
                           "another one" if converged(r) else status(r), r["iterations"],
                           "-" if r["error"] is None else f"{r['error']:.1e}"]
                          for r in apart + failed]))
    return text


def speed(records, _docs):
    rows = of_case(records, "procedures_speed")
    if not rows:
        return ""
    cells, best, lu = [], [], []
    for example in dict.fromkeys(r["model"] for r in rows):
        one = [r for r in rows if r["model"] == example]
        standard = one[0]
        warm = standard["extra"].get("warm_seconds")
        rivals = [r for r in one[1:] if same(r)]
        for r in one:
            again = r["extra"].get("warm_seconds")
            cells.append([example, " ".join(parts(r)[:2]) + ", "
                          + SOLVERS.get(parts(r)[2], "auto"), unknowns(r), r["iterations"],
                          r["linear_iterations"], seconds(r["value"]),
                          f"{r['value'] / standard['value']:.1f}" if converged(r) else status(r),
                          seconds(again), f"{again / warm:.1f}" if again and warm else "-",
                          f"{r['resident_bytes'] / 1e6:.0f} MB",
                          "-" if r["error"] is None else f"{r['error']:.1e}"])
        if rivals:
            cold = min(r["value"] for r in rivals) / standard["value"]
            again = [r["extra"]["warm_seconds"] for r in rivals if r["extra"].get("warm_seconds")]
            best.append(f"{example}: {cold:.1f} times cold"
                        + (f", {min(again) / warm:.0f} times on re-solve" if again and warm
                           else ""))
            lu += [f"{example}: {r['value'] / standard['value']:.0f} times" for r in rivals
                   if parts(r)[2] == "lu"]
    return ("## The standard and the best monolithic procedure\n\n"
            "Cold times are from arrays to tractions, bodies included. A re-solve is after a change of the "
            "creepage, which is given in both, by 1 %; the fastest of several. Memory is that of the process. GMRES "
            "has the factorised matrices of the bodies as preconditioner. The standard procedure is faster than the "
            "best monolithic one by these factors: " + "; ".join(best) + ".\n\n"
            "In a cold solve the gain is limited: both assemble the bodies and factorise their matrices once, "
            "which is most of the standard's time. Condensation adds triangular solves for the unknowns of the "
            "frame, all at once and as fast as matrix products, while GMRES uses the same factors in every one of "
            "its iterations. LU of the whole system in every step, as in the paper, costs for "
            + ("; ".join(lu) or "not measured") + " the standard's cold time (dense bodies of this size were left "
            "out). A re-solve of the standard works on the nodes in contact alone.\n\n"
            + table(["example", "procedure", "unknowns", "iterations", "Krylov", "cold", "ratio",
                     "re-solve", "ratio", "memory", "difference"], cells))


def preconditioners(records, docs):
    rows = of_case(records, "preconditioners")
    if not rows:
        return ""
    text = ("## Preconditioners of GMRES\n\n"
            "The tables have the Krylov iterations per linear system at a relative tolerance of 1e-6, with "
            "`b_derivative`; in brackets the time of the whole solve. After 2000 iterations the system is given to "
            "LU.\n\n")
    for name in dict.fromkeys(r["model"] for r in rows):
        one = [r for r in rows if r["model"] == name]
        kinds = list(dict.fromkeys(parts(r)[3] for r in one))
        series, cells = defaultdict(list), []
        for mesh in dict.fromkeys(r["mesh"] for r in one):
            line = {parts(r)[3]: r for r in one if r["mesh"] == mesh}
            first = next(iter(line.values()))
            cells.append([mesh, unknowns(first)] + [
                "-" if k not in line else
                f"{line[k]['value']:.1f} ({seconds(line[k]['extra'].get('solving_seconds'))})"
                if converged(line[k]) else status(line[k]) for k in kinds])
            for k, r in line.items():
                if converged(r):
                    series[k.replace("_", " ")].append((int(mesh.split()[1]), r["value"]))
        text += (f"{name}:\n\n"
                 + table(["mesh", "unknowns"] + [k.replace("_", " ") for k in kinds], cells) + "\n")
        image = curves(f"{docs}/images/procedures_krylov_"
                       + "".join(c if c.isalnum() else "_" for c in name.lower()) + ".png",
                       name, "nodes or elements across the zone", "Krylov iterations per system",
                       series, ["set logscale x", "set xtics (4, 6, 8, 10, 12, 16, 24, 32, 40)"])
        if image:
            text += f"![Krylov iterations]({image})\n\n"
    return text


def random_scenes(records, _docs):
    rows = of_case(records, "procedures_random")
    if not rows:
        return ""
    kinds = {"creepages given": lambda e: not e["force_given"],
             "force given": lambda e: e["force_given"] and e["sticking"] >= 0.02,
             "force given, hardly a pair sticks": lambda e: e["force_given"]
             and e["sticking"] < 0.02}
    rows = [r for r in rows if "force_given" in r["extra"]]
    found, cells = defaultdict(list), []
    for r in rows:
        system, method, solver, _ = parts(r)
        found[(system, method, solver)].append(r)
    for (system, method, solver), group in found.items():
        good = [r for r in group if same(r)]
        line = [system, method, SOLVERS.get(solver, "auto")]
        for kind in kinds.values():
            of_kind = [r for r in group if kind(r["extra"])]
            line.append(f"{sum(map(same, of_kind))} of {len(of_kind)}")
        line.append(sum(1 for r in group if converged(r) and not same(r)))
        line += [f"{statistics.median(r['iterations'] for r in good):.0f}" if good else "-",
                 max((r["iterations"] for r in good), default="-"),
                 f"{max((r['error'] for r in good), default=0):.1e}",
                 seconds(sum(r["extra"].get("solving_seconds", 0) for r in good)
                         / len(good)) if good else "-"]
        cells.append(line)
    return (f"## {len({r['model'] for r in rows})} random contacts of half-spaces\n\n"
            "The contacts are ellipses of equal, different or rigid bodies with friction from 0.05 to 0.6. Loads "
            "or approaches, and creepages and spin or a longitudinal force, are drawn from fixed seeds. A contact "
            f"is solved if it has, within 600 iterations, tractions within {SAME:g} of the standard's. Hardly a pair "
            "sticks where less than 2 % of the pairs in contact do so in the solution.\n\n"
            + table(["system", "Jacobian", "solver"] + list(kinds)
                    + ["another solution", "iterations (median)", "most", "worst difference",
                       "mean time"], cells))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    os.makedirs(f"{sys.argv[2]}/images", exist_ok=True)
    records, docs, command = load(sys.argv[1]), sys.argv[2], sys.argv[3]
    text = ["# Solution procedures\n",
            f"Made by `{command}` on {processor()}, one thread. Times are those of single runs (below "
            "0.3 s the faster of two) on a shared machine, good to a few ten per cent.\n", OPTIONS,
            CHOICE]
    for section in (figure16a, figure16b, figure21, combinations, speed, preconditioners,
                    random_scenes):
        text.append(section(records, docs))
    with open(f"{docs}/procedures.md", "w", encoding="utf-8") as out:
        out.write("\n".join(part.rstrip() + "\n" for part in text if part))


if __name__ == "__main__":
    main()
