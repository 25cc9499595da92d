#!/usr/bin/env python3
"""Measures how time and memory of each model grow with its size, and puts a table and a picture into the documents.

usage: crossings.py measure RECORDS.jsonl [--quick]            by the library that ROLLCON_LIBRARY names
       crossings.py report RECORDS.jsonl DOCS_DIR "COMMAND"    a table in DOCS_DIR/howto/choose.md, and its picture

Every size runs in a process of its own, on one thread. Times are those of the processor, so that other work beside it
counts little. A library without a component leaves its models out; records of several libraries may be joined.
"""

import json
import os
import resource
import sys
import time

YOUNG, POISSON, LOAD, RADIUS = 210e3, 0.28, 80e3, 500.0
HALF = 1.2 * (0.75 * LOAD * RADIUS * (1 - POISSON ** 2) / YOUNG * 2) ** (1 / 3)  # 1.2 radii of Hertz's circle
# Sizes: intervals along and across a frame, parts through the wall of a quarter of a cylinder, elements along a cube.
SIZES = {
    "half-space, regular, FFT": (32, 64, 128, 256),
    "half-space, irregular, dense": (30, 44, 62, 80),
    "half-space, irregular, hierarchical": (30, 44, 62, 100, 140),
    "boundary elements, dense": (4, 6, 8, 10, 12),
    "boundary elements, hierarchical": (6, 8, 10, 12, 18, 32),
    "finite elements, CHOLMOD": (8, 16, 24),
    "finite elements, MUMPS": (8, 16, 24),
}


def half_space(name, n):
    import numpy as np
    import rollcon as rc
    context = rc.Context()
    context.set_threads(1)
    wheel, rail = rc.Body(context, "halfspace"), rc.Body(context, "halfspace")
    for body in (wheel, rail):
        body.set_elastic(YOUNG, POISSON)
    contact = rc.Contact(context, wheel, rail)
    contact.set_gap_quadratic(1 / (2 * RADIUS), 1 / (2 * RADIUS))
    if "irregular" in name:
        line = np.linspace(-HALF, HALF, n + 1)
        y, x = np.meshgrid(line, line, indexing="ij")
        inner = np.zeros((n + 1, n + 1), bool)
        inner[1:-1, 1:-1] = True
        shift = np.random.default_rng(3).uniform(-0.2, 0.2, (2, n + 1, n + 1)) * (2 * HALF / n) * inner
        contact.frame_nodes(np.column_stack([(x + shift[0]).ravel(), (y + shift[1]).ravel(), 0 * x.ravel()]))
        node = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
        a, b, c, d = node[:-1, :-1].ravel(), node[:-1, 1:].ravel(), node[1:, 1:].ravel(), node[1:, :-1].ravel()
        contact.frame_add_elements(rc.TRI3, np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])]))
        contact.set("operators", "dense" if "dense" in name else "hierarchical")
    else:
        contact.frame_rectangle(rc.QUAD4, n, n, -HALF, HALF, -HALF, HALF)
    contact.set_friction(0.3)
    contact.set_rolling(20000.0)
    contact.set_creep(longitudinal=-1e-3, spin=1e-4)
    contact.set("tolerance", 1e-6)
    contact.prescribe("normal", "force", LOAD)
    status = contact.solve()
    return {"status": int(status), "nodes": (n + 1) ** 2, "unknowns": 3 * (n + 1) ** 2}


def quadratic_surface(n):
    """Returns nodes, quad8 elements and their tags, of a quarter of a cylinder in 2 n by n by n parts."""
    import numpy as np
    parts = (2 * n, n, n)
    number, elements, tags = {}, [], []

    def node(q):
        return number.setdefault(tuple(q), len(number))

    for tag, (axis, end) in enumerate(((0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)), 1):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for i in range(parts[u]):
            for j in range(parts[v]):
                ring = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
                if not end:
                    ring = [(b, a) for a, b in ring]
                element = []
                for a, b in ring:
                    q = [0, 0, 0]
                    q[axis], q[u], q[v] = 2 * parts[axis] * end, 2 * i + a, 2 * j + b
                    element.append(node(q))
                elements.append(element)
                tags.append(tag)
    q = np.array(list(number)) / (2 * np.array(parts)) * [np.pi / 2, 1, 1]
    radius = 1 + q[:, 2]
    x = np.column_stack([radius * np.sin(q[:, 0]), q[:, 1], radius * np.cos(q[:, 0])])
    return x, np.array(elements), np.array(tags)


def boundary_elements(name, n):
    import numpy as np
    import rollcon as rc
    x, element, tag = quadratic_surface(n)
    context = rc.Context()
    context.set_threads(1)
    body = rc.Body(context, "bem")
    body.set_nodes(x)
    for t in range(1, 7):
        body.add_elements(rc.QUAD8, element[tag == t], tag=t)
    body.set_elastic(1000.0, 0.3)
    for held, mask in ((1, rc.DOF_X), (2, rc.DOF_Z), (3, rc.DOF_Y), (4, rc.DOF_Y)):
        body.set_support(np.unique(element[tag == held]), mask)
    body.set_pressure(5, 10.0)
    body.set("factor", 1 if "dense" in name else 2)
    body.set("factor_accuracy", 1e-4)
    body.prepare()
    u = body.displacements()
    radius = np.hypot(x[:, 0], x[:, 2])
    exact = 10 * 1.3 / (1000 * 3) * (0.4 * radius + 4 / radius)
    error = np.abs(np.hypot(u[:, 0], u[:, 2]) - exact).max() / exact.max()
    return {"status": 0, "nodes": len(x), "unknowns": int(body.stat("unknowns")), "error": error,
            "condition": body.stat("condition")}


def finite_elements(_name, n):
    import numpy as np
    import rollcon as rc
    context = rc.Context()
    context.set_threads(1)
    body = rc.Body(context, "fem")
    z, y, x = np.meshgrid(*3 * [np.arange(n + 1.0)], indexing="ij")
    body.set_nodes(np.column_stack([x.ravel() - n / 2, y.ravel() - n / 2, z.ravel() - n]))
    node = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    corners = [node[k:k + n, j:j + n, i:i + n] for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    body.add_elements(rc.HEX8, np.stack(corners, axis=-1).reshape(-1, 8), tag=1)
    body.set_elastic(1e4, 0.3, tag=1)
    body.set_support(node[0].ravel())
    first = n // 2 - 3
    body.tag_faces_of_nodes(node[-1, first:first + 7, first:first + 7].ravel(), 2)
    body.set_contact_faces([2])
    ball = rc.Body(context, "rigid")
    contact = rc.Contact(context, body, ball)
    contact.frame_rectangle(rc.QUAD4, 6, 6, -2.5, 2.5, -2.5, 2.5)
    contact.set_gap_quadratic(1 / 400, 1 / 400)
    contact.set_friction(0.0)
    contact.prescribe("normal", "force", 500.0)
    status = contact.solve()
    return {"status": int(status), "nodes": (n + 1) ** 3, "unknowns": int(body.stat("unknowns"))}


def needs(name):
    if name.startswith("half"):
        return [] if "FFT" not in name else ["fftw"]
    if name.startswith("boundary"):
        return ["bem"] + (["hmat"] if "hierarchical" in name else [])
    return ["fem", name.split(", ")[1].lower()]


def run(name, n):
    make = {"half": half_space, "boun": boundary_elements, "fini": finite_elements}[name[:4]]
    import numpy  # noqa: F401, so that it is not measured
    import rollcon  # noqa: F401
    before = resource.getrusage(resource.RUSAGE_SELF)
    began = time.monotonic()
    record = make(name, n)
    after = resource.getrusage(resource.RUSAGE_SELF)
    record.update(model=name, size=n, wall=time.monotonic() - began,
                  seconds=after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
                  bytes=1024 * (after.ru_maxrss - before.ru_maxrss))
    print(json.dumps(record))


def has(feature):
    import rollcon as rc
    return rc.has_feature(feature)


def measure(path, quick, only):
    import subprocess
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    for name, sizes in SIZES.items():
        if only and only not in name or not all(has(f) for f in needs(name)):
            continue
        if "MUMPS" in name and has("cholmod"):
            continue  # finite elements are factorised by CHOLMOD then
        for n in sizes[:2] if quick else sizes:
            done = subprocess.run([sys.executable, __file__, "run", name, str(n)], env=environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            if done.returncode != 0:
                said = done.stderr.strip().splitlines() or [f"the process ended with status {done.returncode}"]
                print(f"{name}, {n}: {said[-1]}", flush=True)
                break
            print(done.stdout.strip(), flush=True)
            with open(path, "a", encoding="utf-8") as records:
                records.write(done.stdout)


def memory(bytes_):
    return f"{bytes_ / 1e9:.2g} GB" if bytes_ >= 1e9 else f"{bytes_ / 1e6:.0f} MB"


def crossing(records, first, second):
    """Returns the unknowns from which the second model takes less time, by lines between sizes in logarithms."""
    import math
    lines = []
    for name in (first, second):
        lines.append(sorted((math.log(r["unknowns"]), math.log(r["seconds"])) for r in records if r["model"] == name))
    if min(map(len, lines)) < 2:
        return None

    def at(line, x):
        k = max(1, min(len(line) - 1, sum(p[0] < x for p in line)))
        (x0, y0), (x1, y1) = line[k - 1], line[k]
        return y0 + (y1 - y0) * (x - x0) / (x1 - x0)

    low, high = max(line[0][0] for line in lines), max(line[-1][0] for line in lines)
    if at(lines[0], low) >= at(lines[1], low):
        return f"below {math.exp(low):,.0f}"
    if at(lines[0], high) <= at(lines[1], high):
        return f"beyond {math.exp(high):,.0f}"
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if at(lines[0], middle) < at(lines[1], middle) else (low, middle)
    return f"{math.exp(low):,.0f}"


def report(path, docs, command):
    from collections import defaultdict
    from report import load, plot, processor, put_part, table
    records = load(path)
    models = [name for name in SIZES if any(r["model"] == name for r in records)]
    time_of, rows = defaultdict(list), []
    for name in models:
        for r in sorted((r for r in records if r["model"] == name), key=lambda r: r["unknowns"]):
            time_of[name].append((r["unknowns"], r["seconds"]))
            digits = 2 if r["seconds"] < 99.5 else 3
            rows.append([name, f"{r['nodes']:,}", f"{r['unknowns']:,}", f"{r['seconds']:.{digits}g} s", memory(r["bytes"]),
                         f"{r['error']:.1e}" if "error" in r else "-"])
    image = plot(f"{docs}/images/sizes.png", "Time of a first solve on one thread", "unknowns", "seconds", time_of)
    text = (f"Made by `{command}`, {processor()}; seconds of one processor. Hierarchical "
            "factors have factor_accuracy = 1e-4; errors are those of Lamé's displacements.\n\n"
            f"![Time over unknowns](../{image})\n\n"
            + table(["model", "nodes", "unknowns", "first solve", "memory", "error"], rows))
    pairs = [("half-space, irregular, dense", "half-space, irregular, hierarchical"),
             ("boundary elements, dense", "boundary elements, hierarchical")]
    found = [(a, b, crossing(records, a, b)) for a, b in pairs]
    text += "\n" + table(["first", "second, faster from", "unknowns"], [f for f in found if f[2]])
    put_part(f"{docs}/howto/choose.md", "sizes", "\n" + text + "\n")


if __name__ == "__main__":
    if sys.argv[1] == "run":
        run(sys.argv[2], int(sys.argv[3]))
    elif sys.argv[1] == "measure":
        measure(sys.argv[2], "--quick" in sys.argv, next((a for a in sys.argv[3:] if a != "--quick"), ""))
    else:
        report(sys.argv[2], sys.argv[3], sys.argv[4])
