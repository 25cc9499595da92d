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
            "Success: solved with the laws kept to 1e-8, or ended with the status that is right. Scenes of up to 300 nodes: the\n"
            "named ones, and every twentieth random one; all procedures condensed, from zero tractions, with 500 iterations at most\n"
            "and no fallbacks ([procedures.md](procedures.md) says what they are). `reduced` cannot take the characteristic scheme: its scenes have\n"
            "`godunov` instead.\n\n" + table(["group", "scenes", *ways], rows) + picture + "\n")


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
        text += (f"Scenes whose solution from another state keeps all laws and yet differs by more than 1e-3 of the largest traction: {len(names)} ("
                 + "; ".join(names) + ").\n\n")
    return text


LIMITS = """- *Several solutions.* Between unlike bodies (or on a rigid one) the contact problem with large friction may have several solutions,
  or none that a discrete frame can hold; a coefficient of 1 and more, and Poisson's ratios near -1, where pressure pulls the surface
  sideways most, are where the iteration fails most. A discrete problem may have several even for like bodies: slivers and the characteristic scheme.
- *Rounding decides a few of those.* With friction disturbed in its last digits (twelve times each) scenes 1369, 1442, 2514 and 3981, solved
  above, fail one to three times, and 368, which failed, is solved six times; of eight others of the list one is solved and
  one refused, once each. So another
  processor's list may have other members: one without AVX-512 fails at 1442 and 3981.
- *Small steps of the characteristic scheme* make slip nearly blind to a node's own traction; so does contact that reaches the rim of
  a regular frame where material leaves it ([theory](theory.md), section 5): enlarge the frame, or take `least_squares`.
- *Contact up to a body's own edges*, flat along the path. All laws are kept, but creep forces depend much on scheme and mesh: with a conformal pin as stiff
  and as wide as its bore the longitudinal force over the load was 0.02 and 0.05 (characteristic; bore of finite, of boundary elements) and 0.16 and 0.15
  (least squares) on a mesh refined once.
- *The size of numbers.* Gaps and displacements are differences: an approach is resolved to rounding of the least gap. Contacts shallower than
  1e-16 of it are as flat as their gaps' last digit.

"""


def says(records):
    refused = [r for r in records if r["method"] == "refused"]
    rows = [[r["model"], quoted(r["note"])] for r in refused]
    text = ("## What the library says at its limits\n\nTexts of `rollcon_last_error` when this was asked for:\n\n"
            + table(["asked for", "said"], rows))
    warned = [("the contact reaches the rim of the frame", 4), ("the bodies do not touch", 2),
              ("the iteration does not converge", 1)]
    rows = [[what, f"`ROLLCON_{STATUS[status]}`", sum(r["status"] == status for r in records if r["method"] == "cold")]
            for what, status in warned]
    return text + ("\nStatuses above 0 have no text of their own; results can be read:\n\n"
                   + table(["when", "status", "in this suite, cold"], rows) + "\n")


RUNGS = """## What each fallback saves

Of 12,812 solves (the random and named scenes above on frames of up to 300 nodes, from nothing and from another
state; forces near what friction carries; friction raised to 0.6 to 10; creepages of 10 to 1e6; small steps of a sequence; small loads
on quadratic elements; forces given under friction of 1e-6 to 0.1 between unlike bodies) 28 did not converge. A fallback
(docs/theory.md, section 6) was *tried* in so many, and *solved* so many. Each of those solves was repeated in a copy of the library with that fallback alone switched off: *lost* are solves that then did not converge (fallbacks after it are tried in its place), *gained* those that did
only then, as iterations were left for others; the last column is the processor time of all of them with it and without it.

| fallback | tried | solved | lost without it | gained | seconds with, without |
| --- | --- | --- | --- | --- | --- |
| a cold start after a warm one | 492 | 388 | 7 | 1 | 6.8, 10.7 |
| pressures: approach bracketed | 53 | 52 | 40 | 0 | 0.02, 0.03 |
| one load: creepage bracketed | 252 | 166 | 0 | 0 | 4.4, 5.9 |
| relaxation node by node | 480 | 55 | 3 | 6 | 17.0, 15.9 |
| several loads: creepages sought | 306 | 200 | 3 | 4 | 11.7, 12.3 |
| another scale of slip | 247 | 54 | 10 | 2 | 17.5, 15.8 |
| friction lowered from above | 76 | 16 | 8 | 0 | 3.3, 3.1 |
| normal and tangential problem in turn | 159 | 20 | 8 | 0 | 15.1, 15.1 |
| friction grown from none | 154 | 24 | 24 | 0 | 14.4, 9.2 |
| loads 5 % beyond sliding refused at once | 278 | 278 | 0 | 0 | 0.9, 13.4 |
| loads beyond sliding refused in the end | 106 | 106 | 106 | 0 | 5.4, 5.2 |

Searches for one creepage and for several are first of all quick: under small friction (1377 solves) those that they solve take 2.0
and 1.6 times as long without them, and without the first of them and friction lowered from above together 53 are lost. Bracketing the approach of
coupled problems was tried 103 times and solved three, none of them lost without it: it is gone.

"""

HEAD = """Scenes that are stiff, extreme or degenerate, each judged by laws of contact that are recomputed from what the caller
gave and what the public functions return, not by the solver's own residuals: displacements at nodes and upstream points by
`rollcon_contact_get_displacements_at` (from tractions, not from the solver's matrices), gaps from them, the gap of the undeformed bodies
and the approach, slip from them by the schemes of [theory](theory.md), section 5, written once more in the tests, forces by integrals of
the shape functions. With p0 the largest pressure, q0 the largest mu p, u0 the largest normal displacement or overlap, and s0 the largest slip velocity in contact (rigid,
elastic, or what tractions of the size found cause), the error is the greatest of

- tension -p / p0; penetration -gap / u0; the lesser of p / p0 and gap / u0, which stands for pressure times gap;
- (|q| - mu p) / q0, at slipping nodes its magnitude;
- slip of sticking nodes, and slip across or along the traction at slipping ones, over s0, or the change of traction over q0 that would put it right if that is less;
- sums of tractions against resultants and prescribed forces; motions against those prescribed.

**Solved**: the library says so (`OK`, `RIM_CONTACT`, `COARSE`, `NO_CONTACT`), this status is right for the scene, and that error is at most 1e-8.
**Refused**: it ended with an error, rightly (a tangential load that friction cannot carry under the pressures of the scene).
**Wrong**: neither, whatever the library says. All settings are standard but `accuracy` on regular grids (1e-10: operators come from tables there, the
check from integrals).

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
    text = (f"# Stability\n\nMade by `{command}` on one core of {processor()}; times on a shared machine, for their order of magnitude.\n\n"
            + HEAD
            + f"## Named scenes, from nothing\n\nGreatest error of the laws, residual that the iteration stopped at, Newton iterations (mean and most, of those solved),\n"
            "greatest estimated condition of Newton's system at the solution, mean time of a solve.\n\n" + suite_table(named)
            + "\n## Random scenes, from nothing\n\nFixed seeds; every scene draws bodies, frame, gap, loads, friction, scheme and operators over the ranges of the named ones and wider. "
            "Statuses: " + ", ".join(f"{n} {s}" for s, n in statuses.most_common()) + f". Success: {share(random)}.\n\n" + suite_table(random)
            + "\n## From another state\n\nAfter a solve of the same bodies and frame with everything else wildly different: pressed three times as deep with mu = 3 and a thousand times the creepage\n"
            "backwards; with a thousandth of the approach or load, mu = 1e-3 and large spin; with the gap tilted. Difference: of tractions from those found from nothing, over the largest "
            "(several solutions may exist where friction is large between unlike bodies).\n\n" + warm_table(warm) + "\n"
            + RUNGS + procedures(records, docs) + limits(records) + says(records))
    with open(f"{docs}/stability.md", "w", encoding="utf-8") as out:
        out.write(text.rstrip() + "\n")


if __name__ == "__main__":
    main()
