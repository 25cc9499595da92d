#!/usr/bin/env python3
"""Writes docs/frames.md, on frames made by the library, from the records of rollcon-bench.

usage: report_frames.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"
"""

import sys

from report import load, magnitude, of_case, processor, table

TEXT = """# Frames made by the library: errors and times

This page has the errors and times of contacts without a frame from the caller ([theory.md](theory.md), section 4).
Made by `{command}` on {processor}, one thread, on which dgemm does {speed:.0f} Gflop/s. Times are processor times for
everything from the first call to the resultants.

Errors are |(ΔFx, ΔFy)| over μFn and |ΔMz| over μFn √(ab), relative to the same scene on the library's finest frames.
In cases (a) and (b) of [accuracy.md](accuracy.md) the force on the finest frames is 0.16 % and 0.20 % off CONTACT's
extrapolated limits, that on the standard frames 0.01 % and 0.24 %. Between unlike bodies the finest frames differ
from fine lattices by 0.05 to 0.08 % on average ([theory.md](theory.md), section 4). So numbers below 0.2 % show how
well frames agree, not how well they are known to be right. Where the friction force is far below μFn, its error
relative to itself is larger.

## Cells and shape

On an ellipse that is wider than long, the pole of sliding may lie on the longer axis. Forces then depend on how many
strips lie between the pole and the ends. The table has root mean square errors of the force over μFn of extrapolated
pairs, for 8 random directions of creepages and spin with 14 magnitudes each up to full sliding. Its columns name the
coarser frame of the pair; the reference is a pair from 16 × 24 or 24 × 16:

| a/b | 12 × 8 | 10 × 10 | 6 × 16 | 6 × 24 |
| --- | --- | --- | --- | --- |
| 25 | 0.26 % | 0.34 % | 0.85 % | 0.77 % |
| 1 | 0.30 % | 0.17 % | 0.25 % | 0.24 % |
| 0.3 | 0.65 % | 0.55 % | 0.15 % | 0.12 % |
| 0.1 | 0.84 % | 0.83 % | 0.37 % | 0.12 % |
| 0.04 | 0.82 % | 0.78 % | 0.31 % | 0.14 % |

Creep-force tables are therefore made on cells that follow the shape. Frames that the library makes have the same
cells for all ellipses, because half as many elements along the rolling direction cost accuracy where there is no
spin: at a/b = 0.5 the creepage found for a force would be off by up to 0.26 %, instead of 0.09 %.

## Random Hertzian scenes

The scenes have ellipses of ratio 0.2 to 5, and creepages for which linear theory gives 0.2 to 2.5 μFn; two of three
have spin. Cold times are from nothing to the resultants. Warm times are the median of steps that change load and
creepages by 0.3 %. Scenes that need a finer pair than the first raise the means.

{scenes}
A body on a rigid one is the worst case of unlike bodies: pressure strains only one of them, and convergence is slower
than second order.

## A vehicle's time loop

The load (± 30 %), the radius of curvature across (150 to 550 mm), creepages and spin vary, each with a period of its
own. Every step sets all of them; `tolerance` is 1e-6. Errors are root mean squares over 50 steps. Jump is the largest
second difference of any component.

{loop}
"""


def ms(x):
    return f"{1e3 * x:.0f} ms" if x >= 1 else f"{1e3 * x:.3g} ms"


def main():
    records, docs, command = load(sys.argv[1]), sys.argv[2], sys.argv[3]
    scenes, loop = of_case(records, "automatic_frames"), of_case(records, "vehicle_loop")
    rows = [[r["model"], r["mesh"].split()[1], f"{r['extra']['scenes']:.0f}",
             f"{magnitude(r['error'])} / {magnitude(r['extra']['force_worst'])}",
             f"{magnitude(r['moment_error'])} / {magnitude(r['extra']['moment_worst'])}",
             magnitude(r["extra"]["estimate_mean"]),
             f"{ms(r['extra']['cold_seconds'])} / {ms(r['extra']['cold_seconds_median'])}",
             f"{ms(r['extra']['warm_seconds'])} / {ms(r['extra']['warm_seconds_median'])}",
             f"{r['extra']['inaccurate']:.0f}"] for r in scenes]
    first = table(["bodies", "`frame_accuracy`", "scenes", "force, mean / worst", "moment, mean / worst",
                   "estimate, mean", "cold, mean / median", "warm, mean / median", "`INACCURATE`"], rows)
    rows = [[r["mesh"].split()[1], f"{r['extra']['steps']:.0f}", f"{r['nodes']}", magnitude(r["extra"]["rms_x"]),
             magnitude(r["extra"]["rms_y"]), magnitude(r["extra"]["rms_moment"]),
             magnitude(r["extra"]["second_difference"]),
             f"{ms(r['extra']['seconds_mean'])} / {ms(r['extra']['seconds_99'])}",
             f"{r['extra']['allocations']:.0f}"] for r in loop]
    second = table(["`frame_accuracy`", "steps", "nodes of the finer frame", "Fx", "Fy", "moment", "jump",
                    "step, mean / 99 %", "allocations in all"], rows)
    text = TEXT.format(command=command, processor=processor(), speed=scenes[0]["extra"]["dgemm_gflops"],
                       scenes=first, loop=second)
    with open(f"{docs}/frames.md", "w", encoding="utf-8") as file:
        file.write(text)


main()
