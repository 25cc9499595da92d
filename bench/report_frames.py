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
   ends, and no node begins or ceases to touch. Where the curvature of a profile jumps, at the rounded end of a roller,
   rows lie close to the jump, so that its peak of pressure is found.
2. Results are smooth functions of load, motions, friction, gap and profiles, and have no memory: solved from nothing or
   after any other scene they are the same (to 1e-12 of μFn along a chain of 15 drawn contacts). Derivatives
   (`rollcon_contact_get_sensitivity`) count that the contact moves.
3. The option `frame_accuracy` chooses how many strips there are. Each solve is one on two counts. Their difference
   extrapolates friction forces, spin moment and creepages and gives the error estimate; finer strips follow until the
   estimate is below what was asked for.
4. Where strips do not fit, **fitted frames** are laid before the pressures are known: bodies with meshes, conformal
   frames and inclined patches (a ball in a V), viscoelastic bodies (regular grids over the contact, which has moved
   ahead), very unlike bodies (Dundurs' β above 0.1; if β μ is above 0.1 as well, regular grids), tilts, given spin
   moments, tangential forces under a given approach, contacts that end where a body ends, rows with two intervals
   (necks at about 45 degrees to the rolling direction, roughness shorter than a strip), published procedures. They
   come in pairs whose results are extrapolated, and a pair stays while it is good enough.
5. **Steps in time** have one regular grid that stays from step to step ([time](time.md)).

Laws of friction other than Coulomb's, and layers, are solved at the nodes of strips that were fitted without friction.

## Errors

40 Hertzian contacts of like bodies (ratios of axes 0.1 to 10, Poisson's ratios 0 to 0.49, friction coefficients 0.05
to 1, two of three with spin) were compared with what the finest counts tend to. Errors of the extrapolated results are
|(ΔFx, ΔFy)| over ∫ |λt|, and |ΔMz| over the same times the radius of a circle of the contact's area. Brackets have the
errors of the finer strips alone:

| `frame_accuracy`, at least | strips, beside | force, mean | force, worst | moment, mean | moment, worst |
| --- | --- | --- | --- | --- | --- |
| 0.015 | 8 x 12, 5 x 8 | 0.25 % (0.31) | 1.6 % (1.7) | 0.37 % (0.62) | 1.4 % (2.2) |
| 0.004 | 12 x 18, 5 x 8 | 0.13 % (0.14) | 0.64 % (0.78) | 0.17 % (0.29) | 0.64 % (0.95) |
| 0.0015 | 16 x 24, 8 x 12 | 0.04 % (0.07) | 0.17 % (0.29) | 0.08 % (0.16) | 0.42 % (0.50) |
| | 20 x 30, 12 x 18 | 0.03 % (0.05) | 0.15 % (0.19) | 0.04 % (0.10) | 0.15 % (0.31) |
| 0 | 24 x 36, 12 x 18 | 0.01 % (0.03) | 0.06 % (0.13) | 0.03 % (0.07) | 0.09 % (0.22) |

The table has the errors of the counts themselves, not of solves with that `frame_accuracy`, which go on to finer
strips where the estimate asks for them. Pressures, half lengths and linear coefficients on strips are in
[theory.md](theory.md), section 4.

## Random contacts by accuracy

60 other contacts were drawn from these ranges, a third of bodies whose moduli differ by a factor of up to 10, a quarter
with tangential forces given; errors of these are the forces that the creepages found are off by. Errors are relative
to the finest strips, over μFn; estimates are means. Cold times are those of a solve from nothing, warm ones the median
of steps that change load and creepages by 0.3 %, of processor, from Python, on one thread of a shared machine:

| `frame_accuracy` | force, mean / worst | moment, mean / worst | estimate | cold, mean / median | warm, mean / median | `INACCURATE` |
| --- | --- | --- | --- | --- | --- | --- |
| 0.06 | 0.49 / 3.0 % | 0.25 / 1.5 % | 1.7 % | 16 / 8 ms | 5.4 / 3 ms | 0 |
| 0.02 | 0.37 / 2.5 % | 0.18 / 0.89 % | 0.95 % | 40 / 12 ms | 15 / 3 ms | 0 |
| 0.01 | 0.17 / 1.2 % | 0.07 / 0.23 % | 0.50 % | 80 / 27 ms | 43 / 16 ms | 0 |
| 0.005 | 0.09 / 0.71 % | 0.04 / 0.15 % | 0.26 % | 0.31 / 0.11 s | 0.16 / 0.04 s | 0 |
| 0.002 | 0.02 / 0.08 % | 0.01 / 0.06 % | 0.14 % | 0.79 / 0.45 s | 0.44 / 0.23 s | 9 |

The worst contacts, and those above what was asked (one at 0.02 and 0.01, two at 0.005), are of bodies too unlike for
strips, on fitted frames; the slowest ones are of unlike bodies on either.

Pairs of frames of very unlike half-spaces are extrapolated as errors of order 2.6, and their estimate is at least 22 β
over the power 2.6 of the intervals across, because two frames may agree by chance. 30 drawn ellipses (ratio 0.22 to
8.4, β from 0.11 to 0.37, β μ up to 0.1) are off by 0.44 % of μFn in the mean and 1.2 % at worst at the accuracy 0.02,
and by 0.13 and 0.70 % at 0.005, beside frames of 48 x 32. One of them, the most slender, passes its estimate (0.70
beside 0.44 %).

## Derivatives

Derivatives on strips agree with differences of solves to 4e-9; they are extrapolated as the results are. Where results
of several counts are mixed they are differences of solves of the mixture. Under other laws than Coulomb's they are those
of the finest strips, and miss how a mixture changes: in eight of 48 cases, by up to 1.7 % of the slope.

## An example

The contact of [first_contact.c](../examples/first_contact.c) (steel, radii of 460 and 300 mm, 80 kN, μ = 0.3,
longitudinal creepage −0.001) at several accuracies. Hertz's largest pressure is 1139.2 MPa and his approach 0.09049 mm.
Times are those of a first solve, on one thread of a shared machine:

| `frame_accuracy` | nodes | force, N | largest pressure, MPa | approach, mm | estimate | time |
| --- | --- | --- | --- | --- | --- | --- |
| 0.06 | 101 | 10594 | 1138.1 | 0.09048 | 0.58 % | 4 ms |
| 0.02 | 101 | 10594 | 1138.1 | 0.09048 | 0.58 % | 4 ms |
| 0.005 | 223 | 10619 | 1138.8 | 0.09048 | 0.34 % | 14 ms |
| 0.002 | 611 | 10622 | 1139.1 | 0.09048 | 0.07 % | 0.2 s |
| 0.001 | 877 | 10608 | 1139.1 | 0.09048 | 0.02 % | 0.4 s |

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
