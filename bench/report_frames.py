#!/usr/bin/env python3
"""Writes docs/frames.md, on frames made by the library, from the records of rollcon-bench.

usage: report_frames.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"
"""

import sys

from report import load, magnitude, of_case, processor, table

TEXT = """# Frames made by the library: errors and times

This page is about contacts without a frame from the caller: how their frames are found, and how good they are.
[theory.md](theory.md), section 4, has the equations.

## How frames are found

1. Half-spaces and rigid surfaces in steady rolling are solved on **strips**: rows of nodes along the rolling direction.
   The ends of the rows' chords and the width are found together with the pressures: the frame ends where the contact
   ends, and no node begins or ceases to touch.
2. Results are smooth functions of load, motions, friction, gap and profiles, and have no memory: solved from nothing or
   after any other scene they are the same (to 1e-12 of μFn along a chain of 15 drawn contacts). Derivatives
   (`rollcon_contact_get_sensitivity`) count that the contact moves.
3. The option `frame_accuracy` chooses how many strips there are. Each solve is one on two counts, whose difference
   gives the error estimate, and finer ones follow until the estimate is below what was asked for.
4. Where strips do not fit, **fitted frames** are laid before the pressures are known: bodies with meshes, conformal
   frames, very unlike bodies (Dundurs' β above 0.15), tilts, steps in time, given spin moments, tangential forces
   under a given approach, contacts that end where a body ends, rows with two intervals (necks at about 45 degrees to
   the rolling direction, roughness shorter than a strip), published procedures. They come in pairs of which results
   are extrapolated, and a pair stays while it is good enough.

Laws of friction other than Coulomb's, and layers, are solved at the nodes of strips that were fitted without friction.

## Errors

The forces are those of Hertzian contacts of ratio 0.1 to 10 under random creepages and spin, measured over 30 drawn
contacts. Errors are |(ΔFx, ΔFy)| over μFn:

| `frame_accuracy`, at least | strips | force, mean | force, worst |
| --- | --- | --- | --- |
| 0.025 | 6 x 9 | 0.45 % | 4.2 % |
| 0.009 | 8 x 12 | 0.25 % | 2.9 % |
| 0.004 | 12 x 18 | 0.084 % | 0.95 % |
| 0.0025 | 16 x 24 | 0.039 % | 0.29 % |

From 0.0015 on there are 20 x 30 strips, below that 24 x 36. The table has the errors of the counts themselves, not of
solves with that `frame_accuracy`, which go on to finer strips where the estimate asks for them. The worst contact is
a slender ellipse slanted to the rolling direction. Pressures, half lengths and linear coefficients on strips are in
[theory.md](theory.md), section 4.

## Random contacts by accuracy

30 drawn Hertzian contacts of steel (curvatures of ratio 0.18 to 5.6, creepages of 0.2 to 2.5 μFn by linear theory,
two of three with spin). Errors are relative to the finest strips, estimates are means: |(ΔFx, ΔFy)| over μFn, and
|ΔMz| over μFn times the radius of a circle of the contact's area. Cold times are those of a solve from nothing, warm
ones the median of steps that change load and creepages by 0.3 %, from Python on one thread of a shared machine. None
was `INACCURATE`:

| `frame_accuracy` | force, mean / worst | moment, mean / worst | estimate | cold, mean / median | warm, mean / median |
| --- | --- | --- | --- | --- | --- |
| 0.06 | 0.54 / 2.7 % | 0.46 / 1.6 % | 1.0 % | 1.6 / 1.6 ms | 0.8 / 0.8 ms |
| 0.02 | 0.32 / 1.9 % | 0.27 / 0.83 % | 0.57 % | 4.5 / 3.9 ms | 2.5 / 2.2 ms |
| 0.01 | 0.21 / 0.84 % | 0.22 / 0.67 % | 0.37 % | 13 / 4.2 ms | 7.9 / 2.2 ms |
| 0.005 | 0.08 / 0.34 % | 0.10 / 0.34 % | 0.19 % | 60 / 19 ms | 33 / 11 ms |
| 0.002 | 0.011 / 0.035 % | 0.013 / 0.039 % | 0.087 % | 0.28 / 0.19 s | 0.17 / 0.11 s |

## Derivatives

By load and approach derivatives on strips agree with differences of solves to 4e-9. Where results of two counts are
mixed the derivative is that of the finer ones, and misses how the mixture changes: it was off by up to 7 % of the
slope of the force in two of six cases.

## An example

The contact of [first_contact.c](../examples/first_contact.c) (steel, radii of 460 and 300 mm, 80 kN, μ = 0.3,
longitudinal creepage −0.001) at several accuracies. Hertz's largest pressure is 1139.2 MPa and his approach 0.09049 mm.
Times are those of a first solve, on one thread of a shared machine:

| `frame_accuracy` | nodes | force, N | largest pressure, MPa | approach, mm | estimate | time |
| --- | --- | --- | --- | --- | --- | --- |
| 0.06 | 58 | 10674 | 1138.4 | 0.09065 | 1.5 % | 2 ms |
| 0.02 | 101 | 10561 | 1138.4 | 0.09054 | 0.75 % | 4 ms |
| 0.005 | 223 | 10603 | 1138.8 | 0.09049 | 0.28 % | 20 ms |
| 0.002 | 611 | 10617 | 1139.1 | 0.09049 | 0.08 % | 0.2 s |
| 0.001 | 877 | 10607 | 1139.1 | 0.09049 | 0.07 % | 0.5 s |

## Random Hertzian scenes

The scenes have ellipses of ratio 0.2 to 5, and creepages for which linear theory gives 0.2 to 2.5 μFn; two of three
have spin. Made by `{command}` on {processor}, one thread, on which dgemm does {speed:.0f} Gflop/s. Times are processor
times; cold ones are from nothing to the resultants, warm ones the median of steps that change load and creepages by
0.3 %. Errors are |(ΔFx, ΔFy)| over μFn and |ΔMz| over μFn √(ab), relative to the same scene on the library's finest
frames.

{scenes}
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
    second = table(["`frame_accuracy`", "steps", "nodes", "Fx", "Fy", "moment", "jump",
                    "step, mean / 99 %", "allocations in all"], rows)
    text = TEXT.format(command=command, processor=processor(), speed=scenes[0]["extra"]["dgemm_gflops"],
                       scenes=first, loop=second)
    with open(f"{docs}/frames.md", "w", encoding="utf-8") as file:
        file.write(text)


main()
