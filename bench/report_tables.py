#!/usr/bin/env python3
"""Errors of creep-force tables, from the records of rollcon-bench.

usage: report_tables.py RECORDS.jsonl DOCS_DIR "COMMAND THAT MADE THE RECORDS"

Writes the parts "errors" and "unlike bodies" of DOCS_DIR/tables.md and DOCS_DIR/images/tables_errors.png, as far as
there are records of them.
"""

import sys

from precision_plots import Panel, panels
from report import load, magnitude, of_case, processor, put_part, table

REFERENCE = "the reference's frames"  # by their own error
ERRORS = """ {cases} random cases cover the standard table's whole range (magnitudes evenly from 0.03 to 0.97; any
direction and spin). They are compared with two frames of strips on the known ellipse, 1.5 times as fine as the
table's own and extrapolated, from which their known error at full sliding, times s³, is subtracted. Where the table
is more than 0.2 % off, and in every hundredth case, the frames are 2.2 times as fine. In these hundredth cases the
two kinds of frames differ by {reference}. Errors are over μFn, of the moment over μFn √(ab). Made by `{command}` on
{processor}. "Table not in the caches" is measured with 80 copies in turn, "code neither" after other data has filled
all caches.

{methods}
![fraction of cases with a larger error](images/tables_errors.png)

The next table has the regions of the range; r is the length of v above (linear theory gives about r μFn):

{regions} The next table compares the table on the equivalent ellipse with the patch's own solution, both from the
same pressures, for patches of S1002 wheels on 60E1 rails. Lateral shifts go from 0 to 10 mm; yaw, spin and speed of
rotation are random about those of free rolling. The worst are patches with two peaks at shifts of 0 and 0.5 mm, which
fill 0.63 to 0.8 of the ellipse with the second moments of their pressures.

{patches}
"""
UNLIKE = """ {cases} random cases of each pair at μ = 0.3, drawn as those above, with ν = 0.28 in either body, are
compared with frames that the library makes (`frame_accuracy` 0.003, themselves known to 0.2 or 0.3 %). The rows have
the standard table for mean flexibilities alone, the same with the mean strain under the pressure as longitudinal
creepage (as in `rollcon_table_evaluate_contact`), and a table of the pair, made for a/b from 1/5 to 5 in 6 intervals
and this coefficient of friction. Made by `{command}` on {processor}.

{unlike}
"""


def errors(r, kind, rms):
    return f"{magnitude(rms)} / {magnitude(r['extra'][kind + '_99'])} / {magnitude(r['extra'][kind + '_worst'])}"


def force(r):
    return errors(r, "force", r["error"])


def moment(r):
    return errors(r, "moment", r["moment_error"])


def time(r):
    micro = 1e6 * r["seconds"]["wall"]
    if not r["extra"]["seconds_with_derivatives"]:
        return f"{micro:.2g} µs"
    derivatives, table, everything = (
        1e6 * r["extra"][f"seconds_{k}"] for k in ("with_derivatives", "table_cold", "all_cold"))
    return (f"{micro:.2g} µs, with derivatives {derivatives:.2g} µs, table not in the caches {table:.2g} µs, "
            f"code neither {everything:.2g} µs")


def exceeding(r, name):
    """Returns (error, fraction of cases with a larger one), except for the largest."""
    values = r[name]
    return [(v, 1 - k / (len(values) - 1)) for k, v in enumerate(values[:-1])]


def of_patches(r, kind, rms):
    worse = " / ".join(magnitude(r["extra"][f"{kind}_{part}"]) for part in ("90", "worst"))
    return f"{magnitude(r['extra'][kind + '_median'])} / {magnitude(rms)} / {worse}"


HEAD = ["force, rms / 99 % / worst", "moment, rms / 99 % / worst"]


def write_errors(everything, docs, command):
    steel = of_case(everything, "creep_table")
    whole = [r for r in steel if r["mesh"] == "all"]
    frames = next(r for r in steel if r["method"] == REFERENCE)
    methods = table(["", *HEAD, "time of a case"], [[r["method"], force(r), moment(r), time(r)] for r in whole])
    regions = table(["region", "cases", *HEAD],
                    [[r["mesh"], f"{r['extra']['cases']:.0f}", force(r), moment(r)]
                     for r in steel if r not in whole and r is not frames])
    patches = table(["patches", "", "force, median / rms / 90 % / worst", "moment, median / rms / 90 % / worst"],
                    [[r["mesh"], f"{r['extra']['patches']:.0f}", of_patches(r, "force", r["error"]),
                      of_patches(r, "moment", r["moment_error"])] for r in of_case(everything, "equivalent_ellipse")])
    panels(f"{docs}/images/tables_errors.png", "share of cases with a larger error",
           [[Panel(what, "error over μFn" + ("" if what == "force" else "√(ab)"),
                   {r["method"]: exceeding(r, f"{what}_quantiles") for r in whole}) for what in ("force", "moment")]])
    put_part(f"{docs}/tables.md", "errors", ERRORS.format(
        cases=f"{whole[0]['extra']['cases']:.0f}", command=command, processor=processor(), methods=methods,
        reference=f"{force(frames)} in force and {moment(frames)} in moment (rms / 99 % / worst)", regions=regions,
        patches=patches))


def write_unlike(records, docs, command):
    rows = [[r["model"], r["method"], r["mesh"], f"{r['extra']['cases']:.0f}", force(r), moment(r)] for r in records]
    put_part(f"{docs}/tables.md", "unlike bodies", UNLIKE.format(
        cases=f"{records[0]['extra']['cases']:.0f}", command=command, processor=processor(),
        unlike=table(["bodies", "", "a/b", "cases", *HEAD], rows)))


def main():
    everything, docs, command = load(sys.argv[1]), sys.argv[2], sys.argv[3]
    if of_case(everything, "creep_table"):
        write_errors(everything, docs, command)
    unlike = of_case(everything, "creep_table_unlike")
    if unlike:
        write_unlike(unlike, docs, command)


main()
