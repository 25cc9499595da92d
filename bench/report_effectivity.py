#!/usr/bin/env python3
"""Table of error estimates beside true errors, from the records of the bench case effectivity.

rollcon-bench run effectivity --json FILE
report_effectivity.py FILE > effectivity.md
"""

import json
import statistics
import sys

SCHEMES = {"characteristic": 0, "least_squares": 1, "godunov": 2, "-": 0}


def groups(path):
    """Groups records by scene, kind of frame, scheme and quantity; meshes come in the order they were run."""
    found = {}
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            r = json.loads(line)
            if r["case"] != "effectivity":
                continue
            scene, mesh = r["mesh"].split(": ")
            kind, size = mesh.rsplit(" ", 1)
            if scene == "example 3" and kind != "rings":
                kind, size = "paper's", mesh
            if scene == "ball on block":
                scene += ", " + r["model"]
            quantity = r["quantity"].removeprefix("error of the ")
            found.setdefault((quantity, scene, kind, r["method"]), []).append((size, r))
    return found


def percent(x):
    return f"{100 * x:.2g}"


def table(found, quantity):
    print(f"\n### {quantity.capitalize()}\n")
    print("| scene | frames | scheme | sizes | true error, % | estimate, % | effectivity |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    rows = [(k, v) for k, v in found.items() if k[0] == quantity]
    seen = set()
    for (_, scene, kind, scheme), records in rows:
        if quantity == "normal force":  # the scheme of the tangential problem hardly touches it
            if (scene, kind) in seen:
                continue
            seen.add((scene, kind))
        sizes = ", ".join(size for size, _ in records)
        errors = ", ".join(percent(r["error"]) for _, r in records)
        estimates = ", ".join(percent(r["value"]) for _, r in records)
        ratios = ", ".join(f"{r['extra']['effectivity']:.2f}" for _, r in records)
        print(f"| {scene} | {kind} | {scheme} | {sizes} | {errors} | {estimates} | {ratios} |")


def summary(found):
    print("| quantity | scheme | records | below 0.3 | 0.3 to 3 | above 3 | median |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for quantity in ("normal force", "tangential force", "tractions"):
        for scheme in SCHEMES:
            e = [
                r["extra"]["effectivity"]
                for (q, _, _, s), records in found.items()
                for _, r in records
                if q == quantity and s == scheme
            ]
            if not e:
                continue
            low, high = sum(x < 0.3 for x in e), sum(x > 3 for x in e)
            name = "frictionless" if scheme == "-" else scheme
            print(
                f"| {quantity} | {name} | {len(e)} | {low} | {len(e) - low - high} | {high} "
                f"| {statistics.median(e):.2f} |"
            )


def cost(found):
    print("\n### Time over that of the cold solve\n")
    print("| scheme | up to 400 nodes: median | more: median | more: greatest |")
    print("| --- | --- | --- | --- |")
    for scheme in ("-", "characteristic", "least_squares", "godunov"):
        times = {
            (key[1], key[2], size): (r["nodes"], r["extra"]["estimate_over_solve"])
            for key, records in found.items()
            for size, r in records
            if key[3] == scheme
        }
        small = [t for n, t in times.values() if n <= 400]
        large = [t for n, t in times.values() if n > 400]
        name = "frictionless" if scheme == "-" else scheme
        if small and large:
            print(
                f"| {name} | {statistics.median(small):.2f} | {statistics.median(large):.2f} "
                f"| {max(large):.2f} |"
            )


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = groups(sys.argv[1])
    summary(found)
    for quantity in ("normal force", "tangential force", "tractions"):
        table(found, quantity)
    cost(found)


if __name__ == "__main__":
    main()
