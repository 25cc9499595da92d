#!/usr/bin/env python3
"""How many tests passed, failed and were skipped, from CTest's records (ctest --output-junit).

    count_tests.py FILE...

A program of GoogleTest counts as the tests that it ran, any other one as one test, and a program that
ended before its summary as one that failed. Prints one line, and the names of what failed.
"""
import collections
import re
import sys
import xml.etree.ElementTree

SUMMARY = re.compile(r"^\[==========\] (\d+) tests? from .* ran\.", re.M)
PART = re.compile(r"^\[  (PASSED|FAILED|SKIPPED) +\] (\d+) tests?\b", re.M)


def count(case):
    """Counts passed, failed, skipped for one program."""
    status = case.get("status")
    if status in ("notrun", "disabled"):
        skipped = case.find("skipped")  # by its return code; otherwise the program was not found
        asked = skipped is not None and skipped.get("message", "").startswith("SKIP_")
        return collections.Counter({"skipped" if asked else "failed": 1})
    output = case.findtext("system-out") or ""
    found = SUMMARY.search(output)
    parts = {name.lower(): int(number) for name, number in PART.findall(output)}
    if not found or (status == "fail" and not parts.get("failed")):
        return collections.Counter({"passed" if status == "run" else "failed": 1})
    return collections.Counter(parts)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    total, failed = collections.Counter(), []
    for name in sys.argv[1:]:
        for case in xml.etree.ElementTree.parse(name).getroot().iter("testcase"):
            counts = count(case)
            total += counts
            if counts["failed"]:
                failed.append(case.get("name"))
    for name in failed:
        print(f"failed in: {name}")
    print(f"{total['passed']} passed, {total['failed']} failed, {total['skipped']} skipped")
    return 1 if total["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
