"""Says which method to choose when, and what the defaults cost and give, from the records."""

import math
from collections import defaultdict

from errors import error_text, judged, uncertainty
from report import of_case, seconds, table

FAMILIES = {
    "hertz": "Hertz, half-spaces", "hertz_block": "Hertz, blocks", "carter": "Carter",
    "case_a": "case (a)", "case_b": "case (b)", "kalker_meshes": "Kalker",
    "creep_curve_meshes": "creep curve", "lame": "Lame", "example1": "example 1",
    "example2": "example 2", "example3": "example 3", "example4": "example 4",
}
TARGETS = (0.03, 0.01, 0.003)
DEFAULT = "characteristic"


def curves(records):
    found = defaultdict(list)
    for r in records:
        if r["status"] in (0, 4) and "a/b" not in r["mesh"]:
            found[(r["case"], r["model"], r["element"], r["method"])].append(r)
    for runs in found.values():
        runs.sort(key=lambda r: r["extra"]["across"])
    return found


def reaching(runs, target):
    """Returns the coarsest run of a curve from which on no error is beyond the target. The finest alone counts only
    if the one before it is not far: a curve may cross its reference by chance."""
    count = 0
    while count < len(runs) and judged(runs[-1 - count]) <= target:
        count += 1
    if count == 0 or (count == 1 and len(runs) > 1 and judged(runs[-2]) > 3 * target):
        return None
    return runs[-count]


def cheapest(records, target, wanted=lambda r: True):
    """Returns the cheapest run. Godunov's differences do not count: where they converge they are least squares
    (quadrilaterals along the flow), elsewhere their curves cross the reference by chance."""
    candidates = []
    for runs in curves([r for r in records if wanted(r) and r["method"] != "godunov"]).values():
        r = reaching(runs, target)
        if r:
            candidates.append(r)
    return min(candidates, key=lambda r: r["seconds"]["wall"], default=None)


def what(r, several_models):
    scheme = {"frictionless": "", "BEM": "BEM", "FEM": "FEM"}.get(
        r["method"], r["method"].replace("_", " "))
    parts = [r["element"]] + ([r["model"]] if several_models else []) + ([scheme] if scheme else [])
    return ", ".join(parts)


def cell(r, several_models):
    if r is None:
        return "-"
    return (f"{seconds(r['seconds']['wall'])}, {r['peak_bytes'] / 1e6:.1f} MB: "
            + what(r, several_models))


def cheapest_table(records):
    rows = []
    for case, title in FAMILIES.items():
        found = of_case(records, case)
        if not found:
            continue
        several = len({r["model"] for r in found}) > 1
        floor = max(map(uncertainty, found))
        rows.append([title] + ["below the reference's uncertainty" if t < floor
                               else cell(cheapest(found, t), several) for t in TARGETS])
    return table(["case"] + [f"error below {100 * t:g} %" for t in TARGETS], rows)


def mean(values):
    """Returns the geometric mean."""
    values = [v for v in values if v > 0]
    return math.exp(sum(map(math.log, values)) / len(values)) if values else None


def scheme_ratios(records, case, elements=None):
    """Returns errors and seconds of the characteristic scheme and Godunov's over those of least squares on the same
    mesh, as geometric means. Errors below the reference's uncertainty count as that."""
    runs = defaultdict(dict)
    for r in of_case(records, case):
        if r["status"] in (0, 4) and (elements is None or r["element"] in elements):
            runs[(r["model"], r["element"], r["mesh"])][r["method"]] = r
    found = {}
    for scheme in ("characteristic", "godunov"):
        pairs = [(g[scheme], g["least_squares"]) for g in runs.values()
                 if scheme in g and "least_squares" in g]
        def size(r):
            return max(judged(r), uncertainty(r), 1e-9)
        found[scheme] = (mean([size(a) / size(b) for a, b in pairs]),
                         mean([a["seconds"]["wall"] / b["seconds"]["wall"] for a, b in pairs]))
    return found


def scheme_table(records):
    rows = []
    for case, title in FAMILIES.items():
        if not any(r["method"] == "godunov" for r in of_case(records, case)):
            continue
        ratios = scheme_ratios(records, case)
        row = [title]
        for scheme in ("characteristic", "godunov"):
            row += ["-" if v is None else f"{v:.2f}" for v in ratios[scheme]]
        rows.append(row)
    return table(["case", "characteristic: error", "time", "Godunov: error", "time"], rows)


def cost(r):
    return f"{seconds(r['seconds']['wall'])}, {r['peak_bytes'] / 1e6:.1f} MB"


def pair(records, case, target, first, second):
    """Returns cells of the cheapest run of each sort, or nothing where there is neither."""
    found = of_case(records, case)
    runs = [cheapest(found, target, wanted) for wanted in (first, second)]
    if not any(runs):
        return None
    return [f"{cost(r)}: {what(r, False)}, error {error_text(r)}" if r else "no run" for r in runs]


def frames_text(records):
    """Describes frames with the default scheme."""
    def rings(r):
        return "rings" in r["element"] and r["method"] == DEFAULT
    def grids(r):
        return "rings" not in r["element"] and r["method"] == DEFAULT
    rows = []
    for case, name in (("case_a", "case (a)"), ("case_b", "case (b)"), ("example3", "example 3")):
        cells = pair(records, case, 0.01, rings, grids)
        if cells:
            rows.append([name] + cells)
    if not rows:
        return ""
    return ("**Frame on half-spaces.** Where the outline of the contact is known, fit the frame to it. Cheapest "
            "runs with the default scheme and an error below 1 %:\n\n"
            + table(["case", "rings of triangles graded to the contact's edge", "equal elements"], rows) + "\n")


def finest(records, case, element, scheme, model=None):
    runs = [r for r in of_case(records, case) if r["element"] == element
            and r["method"] == scheme and r["status"] in (0, 4) and model in (None, r["model"])]
    return max(runs, key=lambda r: r["extra"]["across"], default=None)


def by_schemes(records, case, element, model=None):
    """Returns errors of the finest mesh by characteristic, least squares and Godunov."""
    runs = [finest(records, case, element, s, model)
            for s in ("characteristic", "least_squares", "godunov")]
    return list(map(error_text, runs)) if all(runs) else None


def schemes_text(records):
    rows = []
    for case, title in (("case_a", "case (a)"), ("case_b", "case (b)"), ("kalker_meshes", "Kalker"),
                        ("example3", "example 3")):
        for element in ("tri3 rings", "quad4", "quad8"):
            errors = by_schemes(records, case, element)
            if errors:
                rows.append([title, element] + errors)
    if not rows:
        return ""
    return ("**Scheme of convection.** The characteristic scheme is the only one that keeps converging on triangles "
            "fitted to the contact. On quadrilaterals along the flow Godunov's differences and least squares are the "
            "same; on other meshes Godunov's differences seldom converge, and the tables of cheapest runs leave them "
            "out. On coarse grids of quad8 take least squares. With spin (case (b), Kalker) the characteristic scheme "
            "has by far the smaller error of the force on fitted triangles. On grids it has the larger one, and the "
            "smaller error of the moment. Errors on the finest mesh:\n\n"
            + table(["case", "elements", "characteristic", "least squares", "Godunov"], rows) + "\n")


def examples_text(records):
    """Says what limits the paper's examples with meshed bodies."""
    rows = []
    for case, title in (("example1", "example 1"), ("example2", "example 2"),
                        ("example4", "example 4")):
        def laid(r):
            return r["element"].startswith("laid")
        found = of_case(records, case)
        floor = max(map(uncertainty, found), default=0)
        for target in (0.05, 0.03, 0.01):
            if target < floor:
                continue
            runs = [cheapest(found, target, laid), cheapest(found, target, lambda r: not laid(r))]
            if any(runs):
                rows.append([title, f"{100 * target:g} %"]
                            + [f"{cost(r)}: {what(r, True)}" if r else "not reached" for r in runs])
    if not rows:
        return ""
    return ("**Rolling bodies with a mesh.** The error of creepage and force depends on how well the frame meets "
            "the contact's edge, and not on the bodies' elements: approach and normal force are right to one per "
            "cent on meshes whose creepage is off by ten. A separate frame, graded to the contact's edge and laid "
            "on coarse quadratic bodies, usually costs less. Where pressure strains one body only (examples 2 and "
            "4), the slip is a small difference of large strains: use quadratic elements, and look at the curve of "
            "your element before you trust a coarse mesh. Cheapest runs:\n\n"
            + table(["case", "error below", "frame laid on the bodies", "the bodies' own faces"], rows) + "\n")


def bodies_text(records):
    def boundary(r):
        return r["method"] == "BEM" or r["model"].startswith("BEM")
    def quadratic(r):
        return r["element"] in ("quad8", "quad9", "tri6", "hex20", "wedge15", "tet10")
    rows = []
    for case, name, target in (("lame", "thick walls", 0.003), ("hertz_block", "sphere on a block", 0.01)):
        kinds = [pair(records, case, target, wanted, lambda r, wanted=wanted: not wanted(r))
                 for wanted in (boundary, quadratic)]
        if all(kinds):
            rows.append([name, f"{100 * target:g} %"] + kinds[0] + kinds[1])
    if not rows:
        return ""
    return ("**Bodies.** Cheapest runs:\n\n"
            + table(["case", "error below", "boundary elements", "finite elements", "quadratic elements",
                     "linear elements"], rows) + "\n")


def defaults_text(records):
    """Describes the defaults of the scheme; those of the procedures are in a document of their own."""
    groups = (("rings graded to the contact", lambda e: "rings" in e),
              ("quad4 and tri3", lambda e: e in ("quad4", "tri3")),
              ("quad8 and tri6", lambda e: e in ("quad8", "tri6")))
    rows = []
    for case, name in (("case_a", "case (a)"), ("case_b", "case (b)"), ("example3", "example 3")):
        for title, wanted in groups:
            elements = {r["element"] for r in of_case(records, case) if wanted(r["element"])}
            ratio = scheme_ratios(records, case, elements)[DEFAULT]
            if ratio[0]:
                rows.append([name, title, f"{ratio[0]:.2f}", f"{ratio[1]:.2f}"])
    if not rows:
        return ""
    return ("**Defaults.** The next table has the error and the time of the characteristic scheme over those of least "
            "squares on the same meshes. With any scheme a second solve costs a small part of a cold one (warm curves "
            "of the plots). [procedures.md](procedures.md) has what the default procedure (condensed, exact Jacobian) "
            "saves.\n\n" + table(["case", "elements", "error", "time"], rows) + "\n")


def choice(records):
    if not records:
        return ""
    return ("### Which method to choose when, and what the defaults cost and give\n\n"
            + frames_text(records) + schemes_text(records) + bodies_text(records)
            + examples_text(records) + defaults_text(records)
            + "**Cheapest runs** whose error, and that of all finer runs of the same curve, is below a bound. In "
              "rolling cases the larger one of the errors of force vector and moment counts:\n\n" + cheapest_table(records)
            + "\n**Schemes over least squares** on the same meshes: geometric means over all meshes of a case, of the "
            "larger error of force vector and moment (at least the uncertainty of the reference):\n\n"
            + scheme_table(records) + "\n")
