"""Writes sections of the work-precision part: for each family of cases a pair of plots and a table."""

from collections import defaultdict

from errors import error_text, moment_error
from precision_plots import Panel, panels
from report import COARSE, contact_elements, contact_marks, of_case, seconds

SCHEMES = ("godunov", "least_squares", "characteristic")
TIME, MEMORY = "seconds, arrays to results", "peak memory, MB"

# These are the wall seconds of CONTACT published with its own performance tests: sequential, a workstation of 2016,
# steady rolling with given creepages, SteadyGS; by elements that slip.
PUBLISHED_2016 = [(1872, 4.8), (7735, 97.0), (30181, 2210.0)]
# This is CONTACT's published Carter example (user guide): 50 strips across the contact.
PUBLISHED_STRIPS = [(50, 0.0125)]


def megabytes(r):
    return r["peak_bytes"] / 1e6


def wall(r):
    return r["seconds"]["wall"]


def warm(r):
    return r["extra"].get("warm_seconds")


def error(r, name=None):
    value = r["extra"].get("error_" + name) if name else r["error"]
    return None if value is None else abs(value)


def curves(records, x, y=error, name=lambda r: r["element"]):
    found = defaultdict(list)
    for r in sorted(records, key=lambda r: r["extra"]["across"]):
        if r["status"] in (0, 4):
            found[name(r)].append((x(r), y(r)))
    return found


def floor_of(records, name=None):
    key = "uncertainty_" + name if name else "uncertainty"
    return max((r["extra"].get(key, 0) for r in records), default=0)


def by_scheme(records, x, xlabel, marks=None, **kwargs):
    """Returns a panel for each scheme."""
    row = []
    for scheme in SCHEMES:
        own = [r for r in records if r["method"] == scheme]
        found = curves(own, x, **kwargs)
        if own and marks:
            found.update(marks)
        row.append(Panel(scheme.replace("_", " "), xlabel, found, floor_of(own)))
    return row


def memory_text(r):
    return f"{megabytes(r):.0f} MB" if megabytes(r) >= 1 else f"{megabytes(r):.1f} MB"


def size_table(records, columns):
    """Returns a table with one row for each method; cells: size, error, seconds, memory."""
    rows, most = defaultdict(list), 0
    for r in records:
        rows[tuple(f(r) for f in columns.values())].append(r)
    lines = []
    for key, found in rows.items():
        found.sort(key=lambda r: r["extra"]["across"])
        most = max(most, len(found))
        cells = [f"**{r['extra']['across']:.3g}**: {error_text(r)}, {seconds(wall(r))}, "
                 f"{memory_text(r)}" + (", coarse" if r["status"] == COARSE else "") for r in found]
        lines.append("| " + " | ".join(list(key) + cells) + " |")
    head = list(columns) + ["**size**: error, time, memory"] + [""] * (most - 1)
    return ("| " + " | ".join(head) + " |\n|" + " --- |" * len(head) + "\n" + "\n".join(lines) + "\n")


def folded(title, text):
    return f"<details><summary>{title}</summary>\n\n{text}\n</details>\n"


ELEMENT = {"element": lambda r: r["element"]}
SCHEME = {"scheme": lambda r: r["method"].replace("_", " ")}
MODEL = {"model": lambda r: r["model"]}


def reference_text(records):
    r = records[0]
    floor = floor_of(records)
    uncertain = [f"{100 * floor:.2g} %"] if floor > 0 else []
    if moment_error(r) is not None and floor_of(records, "moment") > 0:
        uncertain.append(f"the moment by {100 * floor_of(records, 'moment'):.2g} %")
    return (f"Error: {r['quantity']}. Reference: {r['against']}"
            + (f" (uncertain by {', '.join(uncertain)})." if uncertain else "."))


def section(title, records, image, note, columns, more=""):
    if not records or image is None:
        return ""
    return (f"### {title}\n\n{note} {reference_text(records)}\n\n![{title}]({image})\n\n" + more
            + folded(f"Every run: {title}", size_table(records, columns)) + "\n")


def hertz(records, images):
    flat = [r for r in of_case(records, "hertz") if "a/b" not in r["mesh"]]
    blocks = of_case(records, "hertz_block")
    if not flat:
        return ""
    image = panels(f"{images}/precision_hertz.png", "relative error of the force",
                   [[Panel("time", TIME, curves(flat, wall)),
                     Panel("memory", MEMORY, curves(flat, megabytes))]])
    text = section("Hertz, half-spaces", flat, image, "Circle, without friction. Size: nodes across.",
                   ELEMENT)
    bem = [r for r in blocks if r["model"] == "BEM block"]
    fem = [r for r in blocks if r["model"] == "FEM block"]
    floor = floor_of(blocks)
    image = panels(f"{images}/precision_hertz_block.png", "relative error of the approach",
                   [[Panel(title, label, curves(own, x), floor)
                     for title, own in (("BEM block", bem), ("FEM block", fem))]
                    for x, label in ((wall, TIME), (megabytes, MEMORY))])
    return text + section("Hertz, blocks", blocks, image,
                          "A rigid sphere on a block of 10 x 10 x 5 mm that is held at its bottom, "
                          "without friction. The frame is the block's own zone of 2.5 mm, so body "
                          "and frame are refined together. Size: elements along the zone.",
                          MODEL | ELEMENT)


def lame(records, images):
    found = of_case(records, "lame")
    kinds = ("cylinder", "sphere")
    image = panels(f"{images}/precision_lame.png", "largest error of a displacement",
                   [[Panel(kind, label, curves([r for r in found if r["model"] == kind], x))
                     for kind in kinds] for x, label in ((wall, TIME), (megabytes, MEMORY))])
    return section("Lame: thick walls under pressure", found, image,
                   "Bodies alone, without contact: a quarter of a cylinder and a part of a sphere, inner "
                   "radius 1, outer radius 2. Boundary elements solid, finite elements dashed. "
                   "Size: elements through the wall.",
                   {"wall": lambda r: r["model"], "by": lambda r: r["method"]} | ELEMENT)


def plain(case, title, image_name, ylabel, note, y=error):
    """Writes a section of panels scheme by scheme, time above memory."""
    def make(records, images):
        found = of_case(records, case)
        image = panels(f"{images}/precision_{image_name}.png", ylabel,
                       [by_scheme(found, wall, TIME, y=y),
                        by_scheme(found, megabytes, MEMORY, y=y)])
        return section(title, found, image, note, SCHEME | ELEMENT)
    return make


def kalker(records, images):
    found = of_case(records, "kalker_meshes")
    if not found:
        return ""
    image = panels(f"{images}/precision_kalker.png", "error of the force vector, worst of three",
                   [by_scheme(found, wall, TIME), by_scheme(found, megabytes, MEMORY)])
    finest = [r for r in found if r["element"] == "tri6 rings" and r["method"] == "characteristic"]
    finest = max(finest, key=lambda r: r["extra"]["across"])["extra"]
    listed = ", ".join(f"{c} {finest[c]:.4g}" for c in ("C11", "C22", "C23", "C32", "C33"))
    return section("Kalker's coefficients", found, image,
                   "Circle, nu = 1/4, creepages of 0.06 % of those of full sliding. Each frame has three solves "
                   "(longitudinal creepage, lateral creepage, spin), and the worst of their errors counts. The moment "
                   "is relative to what each solve carries at an arm of sqrt(a b). Finest tri6 rings: "
                   f"{listed} (Kalker's table: 4.12, 3.67, 1.47, 1.47, 1.19). Size: nodes across.",
                   SCHEME | ELEMENT)


def steady_rolling(which):
    def make(records, images):
        found = of_case(records, "case_" + which)
        if not found:
            return ""
        measured = contact_marks(records, which)
        marks = {"CONTACT, measured": [(t, e) for _, t, e in measured]}
        image = panels(f"{images}/precision_case_{which}.png", "error of the force vector",
                       [by_scheme(found, wall, TIME),
                        by_scheme(found, warm, "seconds of a warm solve", marks),
                        by_scheme(found, megabytes, MEMORY)])
        sizes = {"CONTACT, measured": [(contact_elements(n), t) for n, t, _ in measured],
                 "CONTACT, published 2016": PUBLISHED_2016}
        one = [r for r in found if r["element"] == "quad4"]
        growth = panels(f"{images}/precision_case_{which}_growth.png", "seconds",
                        [[Panel("quad4, cold", "nodes in contact",
                                curves(one, lambda r: r["pairs"], wall,
                                       lambda r: r["method"].replace("_", " ")) | sizes),
                          Panel("quad4, warm", "nodes in contact",
                                curves(one, lambda r: r["pairs"], warm,
                                       lambda r: r["method"].replace("_", " ")) | sizes)]])
        return section(f"Case ({which})", found, image,
                       "Circle, identical half-spaces, longitudinal creepage. Black: CONTACT's error of the force "
                       "vector relative to its own limit, N = 16 to 256, and its warm time on one core of a machine "
                       "of this kind. Warm: solved again after a change of creepage by 1 %. Size: nodes across." if which == "a" else
                       "Circle, identical half-spaces, longitudinal creepage and spin. Everything else is as in "
                       "case (a).",
                       SCHEME | ELEMENT,
                       f"![Case ({which}), growth]({growth})\n\n"
                       + ("Time over nodes in contact. CONTACT's published wall seconds come with its performance "
                          "tests (steady rolling, creepages given, SteadyGS, a workstation of 2016, by elements in "
                          "slip); its measured ones are of its fastest solver, warm.\n\n" if which == "a" else ""))
    return make


def case_e(records, images):
    found = of_case(records, "case_e")
    if not found:
        return ""
    def named(r):
        return r["method"].replace("_", " ")
    image = panels(f"{images}/precision_case_e.png", "relative error of the force",
                   [[Panel("cold", TIME, curves(found, wall, name=named)),
                     Panel("warm", "seconds of a warm solve",
                           curves(found, warm, name=named)
                           | {"CONTACT, measured": [(r["extra"]["contact_seconds"],
                                                     r["extra"]["contact_error"])
                                                    for r in found
                                                    if r["method"] == "characteristic"]}),
                     Panel("memory", MEMORY, curves(found, megabytes, name=named)),
                     Panel("size", "nodes across the contact",
                           curves(found, lambda r: r["extra"]["across"], name=named)
                           | {"CONTACT, measured": [(0.9 * r["extra"]["n"],
                                                     r["extra"]["contact_error"])
                                                    for r in found
                                                    if r["method"] == "characteristic"],
                              "CONTACT, published": PUBLISHED_STRIPS})]])
    return section("Case (e): Carter's strip compared with CONTACT", found, image,
                   "Equidistant nodes, nine tenths of them in contact. rollcon rolls a strip of 40 "
                   "half-widths in three dimensions, with 11 lines of nodes. CONTACT solves the plane "
                   "problem, so its times are much shorter. Its published error is that of 50 strips (user "
                   "guide); its measured errors are relative to its own limit.", SCHEME)


def carter(records, images):
    return plain("carter", "Carter's strip", "carter", "relative error of the force",
                 "A long strip of identical cylinders, force in the middle section, with equidistant nodes "
                 "and with nodes graded to the contact's edges. Size: nodes across.")(records, images)


def bodies(case, title, note, second, second_label):
    """Writes sections of the paper's examples with bodies that have a mesh: a second quantity, which does not depend
    on the scheme, has a plot of its own."""
    def make(records, images):
        found = of_case(records, case)
        if not found:
            return ""
        several = len({r["model"] for r in found}) > 2 or case == "example2"
        def named(r):
            return r["element"] + (", block" if "BEM block" in r["model"] else "")
        ylabel = "error of the force vector" if case == "example4" else "error of the creepage"
        image = panels(f"{images}/precision_{case}.png", ylabel,
                       [by_scheme(found, wall, TIME, name=named),
                        by_scheme(found, megabytes, MEMORY, name=named)])
        one = [r for r in found if r["method"] == "characteristic"]
        floor = floor_of(one, second)
        other = panels(f"{images}/precision_{case}_{second}.png", f"relative error, {second_label}",
                       [[Panel("time", TIME, curves(one, wall, lambda r: error(r, second),
                                                          named), floor),
                         Panel("memory", MEMORY,
                               curves(one, megabytes, lambda r: error(r, second), named), floor)]])
        more = (f"![{title}, {second_label}]({other})\n\nThe {second_label} of the same runs "
                f"(characteristic); the reference is uncertain by {100 * floor:.2g} %.\n\n")
        return section(title, found, image, note, (MODEL if several else {}) | SCHEME | ELEMENT,
                       more)
    return make


SECTIONS = [
    hertz,
    carter,
    case_e,
    steady_rolling("a"),
    steady_rolling("b"),
    kalker,
    plain("creep_curve_meshes", "Creep-force curve", "creep_curve", "error of the force vector, worst of eleven",
          "Eleven creepages from stick to slip on one frame, a/b = 1/2. The time is that of the whole "
          "curve. Size: nodes across."),
    lame,
    bodies("example1", "Example 1: two rings",
           "BEM on BEM (solid), FEM on FEM (dashed), FEM on BEM (dotted). The frame is the rings' "
           "own zone. The creepage depends more on where the contact's edge falls between the nodes "
           "than on the elements. Size: nodes across the contact.", "approach", "approach"),
    bodies("example2", "Example 2: a ring on a half-space or a block",
           "FEM ring on a half-space (dashed) and on a block of boundary elements (dotted). Pressure "
           "stretches the ring and not the ground, so the creepage depends on the ring's strains. Size: "
           "nodes across the contact.", "approach", "approach"),
    plain("example3", "Example 3: a sphere on a plane", "example3", "relative error of the creepage",
          "The paper's four frames and others like them. Rings are graded to the contact's edge. "
          "Size: nodes across."),
    bodies("example4", "Example 4: a wheel on a rail",
           "A wheel of boundary (solid) or finite elements (dashed) on a rigid rail head. Pressure "
           "strains the wheel and not the rail; only the rest of the creepage drives the force. "
           "Size: nodes along the zone.", "normal_force", "normal force"),
]
