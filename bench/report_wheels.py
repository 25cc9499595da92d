#!/usr/bin/env python3
"""Writes the parts "errors and times" and "a wheelset in an integrator" of docs/wheelrail.md, from the records of
rollcon-bench.

usage: report_wheels.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"
"""

import sys

from precision_plots import Panel, panels
from report import load, magnitude, of_case, processor, put_part, table

TEXT = """
S1002 on 60E1 under 10 kN on each wheel, yaw 2.4 mrad for each millimetre. Made by `{command}` on
{processor},
one thread, processor time. Errors are relative to the finest strips (12 x 14) at 41 shifts: |(ΔFx, ΔFy)| over μFn,
and those of the spin moments over μFn times the radius of the circle with the patches' area. The first table is for a
vehicle's time loop of {steps} steps, in which the wheelset is shifted to and fro in 1000 steps each:

{loop} Allocations are those of all steps. Times are longer where patches split or join, or have no strips. The next
table is for the Manchester benchmark's 21 shifts from 0 to 10 mm with both wheels, from nothing, handles and
profiles included. Roll and rate are given, heights are found:

{manchester}"""


WHEELSET = """
Made by `{command}` on
{processor}, one thread,
processor time. Paths are compared with that of accuracy 0.005 and tolerance 1e-7 over half a second. Jacobians are by `rollcon_wheelrail_get_derivative`; with CVODE's own differences,
steps and paths are the same within a few per cent. Times with a table include about 2 s in which its map for both
profiles is found. Eigenvalues are those of the hunting motion about the middle, in
1/s.

{table}
![path error over time per wheel and step]({picture})
"""


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

    if records_of := of_case(records, "wheelset"):
        put_wheelset(records_of, docs, command)


def put_wheelset(records, docs, command):
    def of(method, tolerance):
        return next(r for r in records
                    if r["method"] == method and r["model"] == "own" and r["mesh"] == f"tolerance {tolerance}")

    rows, curves = [], {}
    for method in dict.fromkeys(r["method"] for r in records):
        rough, fine = of(method, "0.0001"), of(method, "1e-06")
        x = fine["extra"]
        rows.append([method, f"{fine['error']:.2g}",
                     f"{rough['extra']['steps']:.0f} / {x['steps']:.0f}", f"{x['solves']:.0f}",
                     f"{x['with_a_warning']:.0f} / {x['without_an_answer']:.0f}",
                     f"{time(rough['seconds']['wall'])} / {time(fine['seconds']['wall'])}",
                     f"{x['growth']:.2f} + {x['frequency']:.2f} i",
                     f"{x['growth_over_half']:.2f} + {x['frequency_over_half']:.2f} i"])
        if fine["error"] > 1e-6:
            curves[method] = [(1e3 * r["seconds"]["wall"] / r["extra"]["steps"] / 2, r["error"]) for r in (rough, fine)]
    picture = panels(f"{docs}/images/wheelset.png", "path, mm rms of 3",
                     [[Panel("a wheelset in CVODE", "ms per wheel and step", curves)]])
    put_part(f"{docs}/wheelrail.md", "a wheelset in an integrator", WHEELSET.format(
        command=command, processor=processor(), picture=picture,
        table=table(["forces by", "path, mm", "steps at 1e-4 / 1e-6", "solves", "with a warning / without an answer",
                     "time at 1e-4 / 1e-6", "by derivatives", "by differences over 0.5 mm"], rows)))


main()
