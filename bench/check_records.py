#!/usr/bin/env python3
"""Checks that records of rollcon-bench are whole.

check_records.py FILE CASE...    every CASE has records, every record its fields, a good status, times
"""

import json
import math
import sys

FIELDS = ["case", "method", "model", "mesh", "pairs", "unknowns", "error", "against", "seconds",
          "peak_bytes", "iterations", "threads"]


def faults(record):
    for field in FIELDS:
        if field not in record:
            yield f"no field {field}"
    if record.get("status", 0) < 0:
        yield f"status {record['status']}"
    if not math.isfinite(record.get("error", math.nan)):
        yield "error is not a number"
    if "moment_error" in record and not (record["error"] >= 0 and (record["moment_error"] or 0) >= 0):
        yield "errors of rolling are never negative"
    if not record.get("seconds", {}).get("wall", 0) > 0:
        yield "no time"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as lines:
        records = [json.loads(line) for line in lines]
    wrong = [f"{r.get('case')}, {r.get('method')}, {r.get('mesh')}: {fault}"
             for r in records for fault in faults(r)]
    seen = {r["case"] for r in records}
    wrong += [f"no record of {case}" for case in sys.argv[2:] if case not in seen]
    for line in wrong:
        print(line)
    print(f"{len(records)} records of {len(seen)} cases, {len(wrong)} faults")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
