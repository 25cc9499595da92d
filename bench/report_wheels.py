#!/usr/bin/env python3
"""Writes the part "errors and times" of docs/wheelrail.md, from the records of rollcon-bench.

usage: report_wheels.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"
"""

import sys

from report import load, magnitude, of_case, processor, put_part, table

TEXT = """
S1002 on 60E1 under 10 kN on each wheel, yaw 2.4 mrad for each millimetre. Made by `{command}` on
{processor},
one thread, processor time. Errors are relative to the finest strips (12 x 12) at 41 shifts: |(ΔFx, ΔFy)| over μFn,
and those of the spin moments over μFn times the radius of the circle with the patches' area. The first table is for a
vehicle's time loop of {steps} steps, in which the wheelset is shifted to and fro in 1000 steps each:

{loop} Allocations are those of all steps. Times are longer where patches split or join, or have no strips. The next
table is for the Manchester benchmark's 21 shifts from 0 to 10 mm with both wheels, from nothing, handles and
profiles included. Roll and rate are given, heights are found:

{manchester}"""


def both(r, kind):
    mean, worst = (("error", "worst_error") if kind == "force" else ("moment_error", "worst_moment_error"))
    return f"{magnitude(r[mean])} / {magnitude(r['extra'][worst])}"


def time(seconds):
    if seconds < 9.95e-5:
        return f"{1e6 * seconds:.0f} µs"
    return f"{1e3 * seconds:.2g} ms" if seconds < 0.0995 else f"{seconds:.2g} s"


def row(r):
    extra = r["extra"]
    return [r["model"], r["method"], r["mesh"], both(r, "force"), both(r, "moment"),
            " / ".join(time(s) for s in (extra["seconds_median"], r["seconds"]["wall"], extra["seconds_99"])),
            time(extra["seconds_cold"]), f"{extra['allocations']:.0f}"]


def main():
    records, docs, command = load(sys.argv[1]), sys.argv[2], sys.argv[3]
    loop, manchester = of_case(records, "wheel_rail"), of_case(records, "manchester")
    first = table(["shifts", "patches by", "given", "force, mean / worst", "moment, mean / worst",
                   "step, median / mean / 99 %", "first step", "allocations"], [row(r) for r in loop])
    second = table(["patches by", "force, mean / worst", "moment, mean / worst", "above 1 %", "time"],
                   [[r["method"], both(r, "force"), both(r, "moment"),
                     f"{r['extra']['above_one_percent']:.0f} of {r['extra']['cases']:.0f}", time(r["seconds"]["wall"])]
                    for r in manchester])
    put_part(f"{docs}/wheelrail.md", "errors and times", TEXT.format(
        command=command, processor=processor(), steps=f"{loop[0]['extra']['steps']:.0f}", loop=first,
        manchester=second))


main()
