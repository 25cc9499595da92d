#!/usr/bin/env python3
"""Error estimates beside true errors, from the records of rollcon-bench.

usage: report_estimates.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes the part "estimates" of DOCS_DIR/accuracy.md and DOCS_DIR/images/precision_estimates.png.
"""

import os
import statistics
import subprocess
import sys
from collections import defaultdict

from precision_plots import Panel, panels
from report import load, of_case, processor, table, write_part


def scene_of(r):
    scene = r["mesh"].split(":")[0]
    for start, name in (("creepage", "creep curve"), ("Kalker", "linear theory")):
        if scene.startswith(start):
            return name
    return scene


def usable(r):
    return (r["status"] in (0, 4) and r["error"] and r["value"]
            and r["error"] > 0 and r["value"] > 0)


def row(records):
    """Returns the median and the range that holds nine tenths of the effectivities, and the cost."""
    effectivity = sorted(r["value"] / r["error"] for r in records)
    cut = len(effectivity) // 20
    within = effectivity[cut:len(effectivity) - cut]
    cost = statistics.median(r["extra"]["estimate_over_solve"] for r in records)
    below = sum(e < 1 for e in effectivity) / len(effectivity)
    return [len(records), f"{statistics.median(effectivity):.2f}",
            f"{within[0]:.2f} to {within[-1]:.2f}", f"{100 * below:.0f} %", f"{100 * cost:.0f} %"]


HEAD = ["runs", "median effectivity", "nine in ten", "below the true error", "time over the solve's"]


def estimates(records, docs, command):
    found = [r for r in of_case(records, "effectivity") if usable(r)]
    if not found:
        return ""
    quantities = list(dict.fromkeys(r["quantity"] for r in found))
    row_of_panels = []
    for quantity in quantities:
        clouds = defaultdict(list)
        for r in found:
            if r["quantity"] == quantity:
                clouds[scene_of(r)].append((r["error"], r["value"]))
        row_of_panels.append(Panel(quantity.replace("error of the ", ""), "true error", clouds,
                                   cloud=True))
    image = panels(f"{docs}/images/precision_estimates.png", "estimate", [row_of_panels])
    rows = []
    for quantity in quantities:
        for scheme in dict.fromkeys(r["method"] for r in found):
            own = [r for r in found if r["quantity"] == quantity and r["method"] == scheme]
            if own:
                rows.append([quantity.replace("error of the ", ""), scheme.replace("_", " ")]
                            + row(own))
    return ("## Error estimates and true errors\n\n"
            f"Made by `{command}` on {processor()}.\n\n"
            "The effectivity is the library's estimate (a statistic of the solve) over the true error, on scenes whose "
            "answer is known. 1 is perfect; above 1 the estimate is on the safe side.\n\n"
            f"![estimates]({image})\n\n" + table(["quantity", "scheme"] + HEAD, rows))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    docs = sys.argv[2]
    os.makedirs(f"{docs}/images", exist_ok=True)
    text = estimates(load(sys.argv[1]), docs, sys.argv[3])
    if text:
        by_scene = os.path.join(os.path.dirname(os.path.abspath(__file__)), "report_effectivity.py")
        tables = subprocess.run([sys.executable, by_scene, sys.argv[1]], capture_output=True,
                                text=True, check=True).stdout
        text += f"\n<details><summary>By scene and frame</summary>\n\n{tables}\n</details>\n"
        write_part(f"{docs}/accuracy.md", "estimates", text)


if __name__ == "__main__":
    main()
