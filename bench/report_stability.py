#!/usr/bin/env python3
"""Tables of the stability suite, from the records of rollcon-bench.

usage: report_stability.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes DOCS_DIR/stability.md and DOCS_DIR/images/stability_iterations.png (gnuplot).
"""

import os
import sys
from collections import Counter, defaultdict

from report import load, of_case, plot, processor, table

BOUND = 1e-8  # error to which laws hold
STATUS = {0: "OK", 1: "NOT_CONVERGED", 2: "NO_CONTACT", 3: "CANCELLED", 4: "RIM_CONTACT", 5: "COARSE", 6: "INACCURATE",
          -1: "ERR_ARGUMENT", -3: "ERR_NONFINITE", -4: "ERR_MESH", -5: "ERR_STATE", -6: "ERR_OPTION",
          -8: "ERR_SINGULAR", -9: "ERR_MEMORY", -10: "ERR_UNSUPPORTED", -12: "ERR_LOAD",
          -99: "ERR_INTERNAL"}
SAYS_SOLVED = (0, 2, 4, 5)
STANDARD = ("cold", "warm from another state")


def outcome(r):
    """Returns the outcome: "solved" if the laws hold, "refused" if another status is right, "not converged", else
    "wrong"."""
    if r["status"] == 1:
        return "not converged"
    if not r["extra"]["right"]:
        return "wrong"
    if r["status"] in SAYS_SOLVED:
        return "solved" if r["error"] is not None and r["error"] <= BOUND else "wrong"
    return "refused"


def good(r):
    return outcome(r) in ("solved", "refused")


def share(records):
    return f"{100 * sum(map(good, records)) / len(records):.1f} %" if records else "-"


def by_group(records):
    groups = defaultdict(list)
    for r in records:
        groups[r["model"]].append(r)
    return groups


def greatest(records, value, form="{:.1e}"):
    found = [v for v in map(value, records) if v is not None]
    return form.format(max(found)) if found and max(found) > 0 else "-"


def suite_table(records):
    def row(name, found):
        kinds = Counter(map(outcome, found))
        solved = [r for r in found if outcome(r) == "solved"]
        steps = [r["iterations"] for r in solved] or [0]
        return [name, len(found), kinds["solved"], kinds["refused"], kinds["not converged"], kinds["wrong"],
                greatest(solved, lambda r: r["error"]), greatest(solved, lambda r: r["extra"]["residual"]),
                f"{sum(steps) / len(steps):.1f}", max(steps),
                greatest(solved, lambda r: r["extra"]["condition"]),
                f"{1000 * sum(r['seconds']['wall'] for r in found) / len(found):.1f}"]

    rows = [row(name, found) for name, found in by_group(records).items()]
    rows.append(row("**all**", records))
    return table(["group", "scenes", "solved", "refused", "not converged", "wrong", "laws", "residual",
                  "iterations", "most", "condition", "ms"], rows)


def warm_table(records):
    def row(name, found):
        kinds = Counter(map(outcome, found))
        steps = [r["iterations"] for r in found if outcome(r) == "solved"] or [0]
        return [name, len(found), kinds["not converged"], kinds["wrong"],
                greatest(found, lambda r: r["error"] if outcome(r) == "solved" else None),
                f"{sum(steps) / len(steps):.1f}", max(steps),
                greatest(found, lambda r: r["extra"]["difference"])]

    rows = [row(name, found) for name, found in by_group(records).items()]
    rows.append(row("**all**", records))
    return table(["group", "solves", "not converged", "wrong", "laws", "iterations", "most",
                  "tractions differ"], rows)


def procedures(records, docs):
    published = [r for r in records if r["method"] not in STANDARD and r["method"] != "refused"]
    if not published:
        return ""
    names = list(dict.fromkeys(r["method"] for r in published))
    subset = {(r["model"], r["mesh"]) for r in published}
    cold = [r for r in records if r["method"] == "cold" and (r["model"], r["mesh"]) in subset]
    ways = {"default": cold, **{n: [r for r in published if r["method"] == n] for n in names}}
    rows = []
    for group in [*by_group(cold), None]:
        found = {w: [r for r in rs if group in (None, r["model"])] for w, rs in ways.items()}
        rows.append([group or "**all**", len(found["default"]), *(share(rs) for rs in found.values())])
    curves = {}
    for way, rs in ways.items():
        able = [r for r in rs if r["status"] >= 0]
        steps = sorted(max(r["iterations"], 1) for r in able if outcome(r) == "solved")
        curves[way.replace("_", " ")] = [
            (n, 100 * sum(s <= n for s in steps) / len(able))
            for n in (1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 50, 80, 120, 200, 300, 500)]
    image = plot(f"{docs}/images/stability_iterations.png", "Scenes solved within so many iterations",
                 "Newton iterations", "per cent", curves,
                 "set key inside bottom right; unset logscale y; set format y '%g'; set yrange [0:100]; set xrange [1:500]")
    picture = f"\n![iterations]({image})\n" if image else ""
    return ("## The paper's procedures on the same scenes\n\n"
            "The table has the per cent of scenes that are solved or rightly refused, of the named scenes and "
            "every twentieth random scene with up to 300 nodes. All procedures ([procedures.md](procedures.md)) are "
            "condensed and start from zero tractions, with 500 iterations at most and no fallbacks. `reduced` "
            "cannot use the characteristic scheme; its scenes have `godunov` instead.\n\n" + table(["group", "scenes", *ways], rows) + picture + "\n")


def quoted(text):
    """Returns the text from the name of the function on: what stands before is the status in words."""
    at = text.find("rollcon_")
    return (text[at:] if at >= 0 else text).replace("|", "\\|")


def limits(records):
    cold = [r for r in records if r["method"] == "cold"]
    random = [r for r in cold if r["model"].startswith("random")]
    failed = [r for r in cold if r["status"] == 1]
    wrong = [r for r in records if r["method"] in STANDARD and outcome(r) == "wrong"]
    text = "## Limits that remain\n\n"
    if failed:
        text += (f"{len(failed)} of {len(cold)} cold solves end with `ROLLCON_NOT_CONVERGED` "
                 f"({sum(r in random for r in failed)} of {len(random)} random scenes):\n\n")
        rows = [[name, len(rs), ", ".join(r["mesh"] for r in rs[:12]) + (", ..." if len(rs) > 12 else ""),
                 f"{min(r['pairs'] for r in rs)} to {max(r['pairs'] for r in rs)}",
                 f"{max(r['seconds']['wall'] for r in rs):.1f} s"]
                for name, rs in by_group(failed).items()]
        text += table(["group", "not converged", "scenes (seeds)", "nodes in contact", "longest"], rows) + "\n"
    text += (f"Solves that say they succeeded and break a law, or end with a status that is not right: {len(wrong)}"
             + (" (" + "; ".join(f"{r['model']} {r['mesh']}" for r in wrong[:20]) + ")" if wrong else "")
             + ".\n\n" + LIMITS)
    several = [r for r in records if r["method"] == STANDARD[1] and good(r) and (r["extra"]["difference"] or 0) > 1e-3]
    if several:
        names = list(dict.fromkeys(f"{r['model']} {r['mesh']}" for r in several))
        text += ("Scenes whose solution from another state keeps all laws and yet differs by more than 1e-3 of the "
                 f"largest traction: {len(names)} ("
                 + "; ".join(names) + ").\n\n")
    return text


LIMITS = """- *Several solutions.* Between unlike bodies, or on a rigid one, the contact problem with large friction
may have several solutions, or none that a discrete frame can represent. The iteration fails most often with
coefficients of 1 and more, and with Poisson's ratios near -1, where pressure pulls the surface sideways most. A
discrete problem may have several solutions even for like bodies: with slivers and the characteristic scheme.
- *Rounding.* Some scenes depend on the last digits. If friction is disturbed in its last digits, twelve times each,
  the solved scenes 1369, 1442, 2514 and 3981 fail one to three times, and scene 368 of the list is solved six times;
  of eight others of the list one is solved and one refused, once each. So another processor may have another list:
  one without AVX-512 fails at 1442 and 3981.
- *Small steps of the characteristic scheme* make slip nearly independent of a node's own traction. So does contact
  that reaches the rim of a regular frame where material leaves it ([theory](theory.md), section 5). Enlarge the
  frame, or take `least_squares`.
- *Contact up to a body's own edges*, flat along the path. All laws hold, but creep forces depend strongly on scheme
  and mesh. For a conformal pin as stiff and as wide as its bore, on a mesh refined once, the longitudinal force over
  the load is 0.02 (finite elements) and 0.05 (boundary elements) with the characteristic scheme, and 0.16 and 0.15
  with least squares.
- *The size of numbers.* Gaps and displacements are differences, so an approach is resolved to the rounding of the
  least gap. A contact shallower than 1e-16 of it is no more precise than the last digit of its gaps.

"""


def says(records):
    refused = [r for r in records if r["method"] == "refused"]
    rows = [[r["model"], quoted(r["note"])] for r in refused]
    text = ("## What the library says at its limits\n\nThe texts are those of `rollcon_last_error`:\n\n"
            + table(["asked for", "said"], rows))
    warned = [("the contact reaches the rim of the frame", 4), ("the bodies do not touch", 2),
              ("the iteration does not converge", 1)]
    rows = [[what, f"`ROLLCON_{STATUS[status]}`", sum(r["status"] == status for r in records if r["method"] == "cold")]
            for what, status in warned]
    return text + ("\nWith statuses above 0 results can be read:\n\n"
                   + table(["when", "status", "in this suite, cold"], rows) + "\n")


RUNGS = """## What each fallback saves

The table counts the fallbacks of [theory](theory.md), section 6, in 9,675 solves, of which 36 do not converge: random
and named scenes as above on frames of up to 300 nodes, from nothing and from another state; forces near what friction
carries; friction raised to 0.6 to 10; creepages of 10 to 1e6; forces given under friction of 1e-6 to 0.1 between unlike
bodies; and the laws of friction other than Coulomb's. *Tried* and *solved* are numbers of solves. The solves in which
any fallback was tried were repeated with one fallback switched off, so that the fallbacks after it took its place.
*Lost* are solves that then did not converge, *gained* those that converged only then, because iterations were left for
others. The last column is the processor time of the solves in which the fallback was tried.

| fallback | tried | solved | lost without it | gained | seconds with, without |
| --- | --- | --- | --- | --- | --- |
| a cold start after a warm one | 299 | 238 | 2 | 0 | 3.3, 4.4 |
| loads found from the outside | 478 | 289 | 60 | 3 | 17.0, 19.6 |
| another scale of slip | 291 | 76 | 6 | 2 | 21.6, 19.8 |
| normal and tangential problem in turn | 174 | 24 | 8 | 0 | 16.8, 17.1 |
| friction grown from none | 173 | 31 | 28 | 0 | 15.2, 8.4 |

The approach is bracketed in 99 of 800 small loads on quadratic elements, and 98 of them are lost without it. Loads that
are 5 % beyond sliding are refused at once in 231 solves, loads beyond sliding in the end in 117.

"""

HEAD = """This page has the results of scenes that are stiff, extreme or degenerate. The solver's own residuals do not
count: each solution is judged by the laws of contact, recomputed from what the caller gave and what the public
functions return. Displacements at nodes and upstream points come from `rollcon_contact_get_displacements_at`
(integrals of the tractions, not the solver's matrices). Gaps follow from them, from the gap of the undeformed bodies
and from the approach. Slip follows by the schemes of [theory](theory.md), section 5, which the tests implement
independently. Forces are integrals of the shape functions. Let p0 be the largest pressure, q0 the largest mu p, u0
the largest normal displacement or overlap, and s0 the largest slip velocity in contact (rigid, elastic, or what
tractions of the size found cause). The error is the greatest of

- tension -p / p0; penetration -gap / u0; the lesser of p / p0 and gap / u0, in place of pressure times gap;
- (|q| - mu p) / q0, and its magnitude at slipping nodes;
- the slip of sticking nodes, and the slip of slipping nodes across their traction or along it: either over s0, or the
  change of traction over q0 that would correct it, whichever is less;
- the difference of sums of tractions from resultants and prescribed forces, and of motions from prescribed ones.

A scene is *solved* if the library says so (`OK`, `RIM_CONTACT`, `COARSE`, `NO_CONTACT`), if this status is right for
the scene, and if the error is at most 1e-8. It is *refused* if the library rightly ends with an error (a tangential
load that friction cannot carry under the pressures of the scene). Otherwise it is *not converged* if the library says
so, and *wrong* if not. All settings are standard except `accuracy` on regular grids: it is 1e-10, because operators
come from tables there and the check from integrals.

"""


def main():
    path, docs, command = sys.argv[1:4]
    os.makedirs(f"{docs}/images", exist_ok=True)
    records = of_case(load(path), "stability")
    cold = [r for r in records if r["method"] == "cold"]
    random = [r for r in cold if r["model"].startswith("random")]
    named = [r for r in cold if not r["model"].startswith("random")]
    warm = [r for r in records if r["method"] == STANDARD[1]]
    statuses = Counter(STATUS.get(r["status"], str(r["status"])) for r in random)
    text = (f"# Stability\n\nMade by `{command}` on one core of {processor()}. Times show orders of magnitude only.\n\n"
            + HEAD
            + f"## Named scenes, from nothing\n\nThe columns have the greatest error of the laws, the residual at "
            "which the iteration stopped, Newton iterations (mean and most of the solved scenes), the greatest "
            "estimated condition of Newton's system at the solution, and the mean time of a solve.\n\n" + suite_table(named)
            + "\n## Random scenes, from nothing\n\nEach scene draws bodies, frame, gap, loads, friction, scheme "
            "and operators from the ranges of the named scenes and wider ones, with fixed seeds. Statuses: " + ", ".join(f"{n} {s}" for s, n in statuses.most_common()) + f". Success: {share(random)}.\n\n" + suite_table(random)
            + "\n## From another state\n\nEach scene is solved after another one of the same bodies and frame: "
            "pressed three times as deep, with mu = 3 and a thousand times the creepage backwards; with a "
            "thousandth of the approach or load, mu = 1e-3 and large spin; or with the gap tilted. The last column "
            "is the difference of the tractions from those found from nothing, over the largest of them. Where "
            "friction is large between unlike bodies, several solutions may exist.\n\n" + warm_table(warm) + "\n"
            + RUNGS + procedures(records, docs) + limits(records) + says(records))
    with open(f"{docs}/stability.md", "w", encoding="utf-8") as out:
        out.write(text.rstrip() + "\n")


if __name__ == "__main__":
    main()
