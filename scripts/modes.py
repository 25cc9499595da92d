#!/usr/bin/env python3
"""modes.py [railway] [bearings] [finite_elements] [research]: measures what the modes of docs/start/*.md cost and give.

Needs the Python package. Writes the tables into the pages, between <!-- modes: NAME --> and <!-- end of modes -->.
Times are of processor, of one thread. Without names: all four.
"""

import math
import os
import pathlib
import re
import statistics
import sys
import tempfile
import time

os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
import numpy as np  # noqa: E402
import rollcon as rc  # noqa: E402

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs/start"


def seconds(call):
    began = time.process_time()
    call()
    return time.process_time() - began


def spent(value):
    """Writes a time with two digits."""
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= size:
            return f"{float(f'{value / size:.2g}'):g} {unit}"
    return "0"


def off(value):
    return f"{float(f'{100 * value:.2g}'):g} %"


def context():
    made = rc.Context()
    made.set_threads(1)
    return made


def steel(owner, young=210000, poisson=0.28):
    bodies = rc.Body(owner, "halfspace"), rc.Body(owner, "halfspace")
    for body in bodies:
        body.set_elastic(young, poisson)
    return bodies


def measured(contact, again):
    """Solves from nothing, then as `again` changes the case five times; returns the first time, the median of the
    others, and of the first case the tangential force, the largest pressure and the approach."""
    first = seconds(contact.solve)
    answer = np.array(contact.resultant()[0][:2]), contact.stat("max_pressure"), contact.motion()[0]
    return first, statistics.median(seconds(lambda k=k: (again(k), contact.solve())) for k in range(1, 6)), *answer


def by_pressure_and_approach(rows):
    return "| mode | gives | first | again | largest pressure off | approach off |", [
        f"| {name} | {gives} | {spent(first)} | {spent(again)} | {off(abs(pressure / rows[-1][5] - 1))} | "
        f"{off(abs(approach / rows[-1][6] - 1))} |" for name, gives, first, again, _, pressure, approach in rows]


def railway():
    shifts = np.arange(1, 4.01, 0.05)

    def ellipses(wheel, owner):
        wheel.set("hertzian", 1)
        wheel.set_table(rc.Table.standard(owner))

    def pressures(wheel, owner):
        wheel.set("accuracy", 0.02)
        wheel.set_table(rc.Table.standard(owner))

    rows = []
    for name, gives, set_up in (
            ("`hertzian` 1, `set_table`", "forces; ellipses of the overlaps", ellipses),
            ("`accuracy` 0.02, `set_table`", "forces; pressures solved", pressures),
            ("`accuracy` 0.02", "all fields, stick and slip", lambda wheel, _: wheel.set("accuracy", 0.02)),
            ("`accuracy` 0.01 (standard)", "the same", lambda wheel, _: None),
            ("`accuracy` 0.005", "the same", lambda wheel, _: wheel.set("accuracy", 0.005))):
        owner = context()
        tread, rail = steel(owner)
        tread.set_profile_shape("s1002", [1])
        rail.set_profile_shape("60e1", [1])
        wheel = rc.WheelRail(owner, tread, rail, "right")
        wheel.set_track(1435, 14, math.atan(1 / 40))
        wheel.set_wheelset(1360, -70, 460)
        wheel.set_friction(0.3)
        wheel.prescribe_vertical("force", 80000)
        wheel.set_velocity([20000, 0, 0, 0, 0, -20000 / 460])
        set_up(wheel, owner)
        times, forces, pressure = [], [], []
        for y in shifts:
            wheel.set_position([0, y, 0, 0, 0, 0])
            times.append(seconds(wheel.solve))
            forces.append(wheel.resultant()[0][0])
            pressure.append(wheel.patch_stat(0, "max_pressure"))
        rows.append((name, gives, statistics.median(times), np.array(forces), np.array(pressure)))
    limit = 0.3 * 80000
    return "| mode | gives | a step | forward force off, of μFz | largest pressure off |", [
        f"| {name} | {gives} | {spent(t)} | {off(np.abs(f - rows[-1][3]).max() / limit)} | "
        f"{off(np.abs(p / rows[-1][4] - 1).max())} |" for name, gives, t, f, p in rows]


def bearings():
    def grid(along, across):
        return lambda contact: contact.frame_rectangle("quad4", along, across, -0.18, 0.18, -4.9, 4.9)

    def tilt(contact, k):
        contact.set_pose(2, [[1, 0, 0], [0, 1, -1e-5 * k], [0, 1e-5 * k, 1]])

    rows = []
    for name, gives, set_up in (
            ("no frame, `frame_accuracy` 0.05", "strips of the library's own", lambda c: c.set("frame_accuracy", 0.05)),
            ("no frame, 0.005 (standard)", "the same", lambda c: None),
            ("no frame, 0.002", "the same", lambda c: c.set("frame_accuracy", 0.002)),
            ("`frame_rectangle`, 16 x 64 quad4", "your own grid, FFT", grid(16, 64)),
            ("`frame_rectangle`, 32 x 128", "the same", grid(32, 128)),
            ("`frame_rectangle`, 128 x 512", "the same", grid(128, 512))):
        owner = context()
        ring, roller = steel(owner, 208e3, 0.3)
        ring.set_profile_shape("line", [10, 0])
        ring.revolve_profile([0, 0, -30], [0, 1, 0], 30)
        roller.set_profile_shape("arc", [2000, 5])
        roller.revolve_profile([0, 0, 6], [0, 1, 0], 6)
        contact = rc.Contact(owner, ring, roller)
        contact.set_friction(0.05)
        contact.prescribe("normal", "force", 1500)
        set_up(contact)
        rows.append((name, gives, *measured(contact, lambda k, contact=contact: tilt(contact, k))))
    return by_pressure_and_approach(rows)


def block(owner, size, kind="fem"):
    """Makes the block of the page from elements of a size, held at its bottom."""
    x, z = np.linspace(-8, 8, round(16 / size) + 1), np.linspace(-8, 0, round(8 / size) + 1)
    n = len(x)
    nodes = np.array([(a, b, c) for c in z for b in x for a in x])
    node = np.arange(len(nodes)).reshape(len(z), n, n)
    square = [(0, 0), (0, 1), (1, 1), (1, 0)]
    quads = [np.stack([node[k, j:j + n - 1, i:i + n - 1] for j, i in square], -1).reshape(-1, 4) for k in range(len(z))]
    body = rc.Body(owner, kind)
    body.set_nodes(nodes)
    body.add_elements("hex8", np.hstack([np.vstack(quads[:-1]), np.vstack(quads[1:])]))
    body.set_elastic(1e4, 0.3)
    body.set_support(node[0].ravel())
    body.tag_faces_of_nodes(node[-1].ravel(), 2)
    body.set_contact_faces([2])
    return body


def finite_elements():
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "block.rcb")
        owner = context()
        block(owner, 1).save(path)
        for name, gives, make in (
                ("half-space", "no edges, no bottom", lambda owner: steel(owner, 1e4, 0.3)[0]),
                ("`fem`, 2 mm", "stresses inside, supports", lambda owner: block(owner, 2)),
                ("`fem`, 1 mm", "the same", lambda owner: block(owner, 1)),
                ("`fem`, 1 mm, `rollcon_body_load`", "prepared once and saved",
                 lambda owner: rc.Body.load(owner, path)),
                ("`fem`, 0.5 mm", "the same", lambda owner: block(owner, 0.5)),
                ("`fem`, 0.4 mm", "the same", lambda owner: block(owner, 0.4))):
            owner, kept = context(), []

            def begin(owner=owner, kept=kept, make=make):
                contact = rc.Contact(owner, make(owner), rc.Body(owner, "rigid"))
                contact.frame_rectangle("quad4", 12, 12, -5, 5, -5, 5)
                contact.set_gap_quadratic(1 / 400, 1 / 400)
                contact.set_friction(0.3)
                contact.set_rolling(10)
                contact.set_creep(-0.002)
                contact.prescribe("normal", "force", 1500)
                kept.append(contact)
            made = seconds(begin)
            contact = kept[0]
            first, again, *answer = measured(contact, lambda k, contact=contact: contact.set_creep(-0.002 - 1e-5 * k))
            rows.append((name, gives, made + first, again, *answer))
    return by_pressure_and_approach(rows)


def research():
    half = 8.0, 6.5

    def grid(n, **options):
        def set_up(contact):
            contact.frame_rectangle("quad4", n, n, -half[0], half[0], -half[1], half[1])
            for name, value in options.items():
                contact.set(name, value)
        return set_up

    rows = []
    for name, gives, set_up in (
            ("no frame, `frame_accuracy` 0.05", "strips of the library's own", lambda c: c.set("frame_accuracy", 0.05)),
            ("no frame, 0.005 (standard)", "the same", lambda c: None),
            ("no frame, 0.002", "the same", lambda c: c.set("frame_accuracy", 0.002)),
            ("`frame_ellipse`, 24 x 16", "a frame that stays", lambda c: c.frame_ellipse(24, 16, 6.7, 5.1)),
            ("`frame_rectangle`, 32 x 32 quad4", "a grid, FFT", grid(32)),
            ("`frame_rectangle`, 64 x 64", "the same", grid(64)),
            ("64 x 64, `convection` least_squares", "the same, better under spin",
             grid(64, convection="least_squares")),
            ("`frame_rectangle`, 512 x 512, least_squares", "the same", grid(512, convection="least_squares"))):
        owner = context()
        contact = rc.Contact(owner, *steel(owner))
        contact.set_gap_quadratic(1 / 920, 1 / 600)
        contact.set_friction(0.3)
        contact.set_rolling(20000)
        contact.set_creep(-0.001, 0.0005, 1e-4)
        contact.prescribe("normal", "force", 80000)
        set_up(contact)
        rows.append((name, gives, *measured(contact, lambda k: contact.set_creep(-0.001 - 1e-5 * k, 0.0005, 1e-4))))
    force, largest = rows[-1][4:6]
    return "| mode | gives | first | again | force off | largest pressure off |", [
        f"| {name} | {gives} | {spent(a)} | {spent(b)} | {off(np.hypot(*(f - force)) / np.hypot(*force))} | "
        f"{off(abs(p / largest - 1))} |" for name, gives, a, b, f, p, _ in rows]


def main():
    tables = {function.__name__: function for function in (railway, bearings, finite_elements, research)}
    for name in sys.argv[1:] or tables:
        head, rows = tables[name]()
        page = DOCS / f"{name}.md"
        words = (f"<!-- modes: {name} -->\n{head}\n{'| --- ' * head.count(' | ')}| --- |\n" + "\n".join(rows) +
                 f"\n\n`python3 scripts/modes.py {name}` makes this table.\n<!-- end of modes -->")
        old = page.read_text(encoding="utf-8")
        page.write_text(re.sub(r"<!-- modes: .*<!-- end of modes -->", lambda _, words=words: words, old, flags=re.S),
                        encoding="utf-8")
        print(words)


if __name__ == "__main__":
    main()
