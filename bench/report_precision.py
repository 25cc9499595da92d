#!/usr/bin/env python3
"""Work-precision plots and tables from the records of rollcon-bench.

usage: report_precision.py DOCS_DIR "COMMAND THAT MADE THE RECORDS" RECORDS.jsonl...

Writes the work-precision part of DOCS_DIR/accuracy.md and DOCS_DIR/images/precision_*.png (gnuplot).
"""

import os
import sys

from precision_sections import SECTIONS
from precision_text import choice
from report import load, processor, unfinished_text, write_part

def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    docs, command = sys.argv[1], sys.argv[2]
    images = f"{docs}/images"
    os.makedirs(images, exist_ok=True)
    records = [r for path in sys.argv[3:] for r in load(path)]
    threads = "/".join(map(str, sorted({r["threads"] for r in records})))
    text = ("## Error over time and over memory\n\n"
            f"Made by `{command}` on {processor()}, {threads} thread(s).\n\nEach curve is one method (scheme of "
            "convection, element, model of the bodies), each point one element size. Time is from the caller's "
            "arrays to the results: the fastest of up to five runs, as long as they take less than a quarter of a "
            "second together. Memory is what the library counts, bodies included. Where there is neither a closed "
            "form nor a published limit, the reference is extrapolated from finer runs. A grey line marks its "
            "uncertainty: below it a curve says nothing. Plots of rolling cases show the error of the force vector; "
            "tables add that of the moment. All runs use the standard solution procedure; "
            "[procedures.md](procedures.md) compares the others.\n\n" + unfinished_text(records) + choice(records))
    text += "".join(make(records, images) for make in SECTIONS)
    write_part(f"{docs}/accuracy.md", "work-precision", text)


if __name__ == "__main__":
    main()
