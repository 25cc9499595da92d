#!/usr/bin/env python3
"""Lines of src/ that tests have reached, from the counters of a build with ROLLCON_COVERAGE=ON.

    coverage.py BUILD [--minimum 90] [--documented docs/testing.md] [--lines]

Prints a table of folders, the files with lines that no test reached, and with --lines the ranges of
these lines. Fails below the minimum, and with --documented where a file has clearly more lines
unreached than the table under "## Coverage" of that document grants it. Needs gcov and Python alone.
A line that several objects compile (headers, templates) is reached where one of them reached it.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# A file needs a row in the document from this many lines on; counts of lines shift a little with
# threads, instruction sets and what the optimiser made of them.
UNDOCUMENTED = 6
SLACK = 1.25


def notes_of(build):
    """Returns the notes that the compiler wrote beside the library's objects, in its present configuration: sources
    may have been compiled alone before and are now in groups, or the other way round."""
    commands = json.loads((build / "compile_commands.json").read_text())
    outputs = [build / match.group(1) for command in commands
               if (match := re.search(r" -o (\S*\brollcon_objects\.dir/\S+\.o) ", command["command"]))]
    notes = sorted(note for output in outputs if (note := output.with_suffix(".gcno")).exists())
    if not notes:
        sys.exit(f"coverage.py: no notes in {build}: was it built with ROLLCON_COVERAGE=ON?")
    return notes


def read(gcov, notes, build):
    """Returns the counts of a batch of objects: {file: {line: count}}."""
    result = subprocess.run([gcov, "--json-format", "--stdout", *map(str, notes)], cwd=build,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
    counts = collections.defaultdict(collections.Counter)
    for text in result.stdout.decode().splitlines():
        if not text.strip():
            continue
        record = json.loads(text)
        for file in record["files"]:
            path = pathlib.Path(record["current_working_directory"], file["file"])
            path = pathlib.Path(os.path.normpath(path))
            if ROOT / "src" not in path.parents:
                continue
            lines = counts[str(path.relative_to(ROOT))]
            for line in file["lines"]:
                lines[line["line_number"]] += line["count"]
    return counts


def collect(build, gcov):
    notes = notes_of(build)
    batches = [notes[k:k + 8] for k in range(0, len(notes), 8)]
    merged = collections.defaultdict(collections.Counter)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for counts in pool.map(lambda batch: read(gcov, batch, build), batches):
            for file, lines in counts.items():
                merged[file].update(lines)
    return merged


def ranges(numbers):
    """Formats [3, 4, 5, 9] as '3-5 9'."""
    runs = []
    for number in sorted(numbers):
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return " ".join(str(a) if a == b else f"{a}-{b}" for a, b in runs)


def documented(path):
    """Returns {file or folder: lines granted} from the rows `| src/... | lines | reason |`."""
    text = path.read_text().split("\n## Coverage", 1)
    if len(text) < 2:
        sys.exit(f"coverage.py: {path} has no section Coverage")
    section = text[1].split("\n## ", 1)[0]
    return {name: int(lines)
            for name, lines in re.findall(r"^\| `?(src/[^`| ]+\.[ch]pp)`? *\| *(\d+) *\|", section, re.M)}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--minimum", type=float, default=90.0, help="per cent of lines, in all")
    parser.add_argument("--documented", type=pathlib.Path, help="document with the table of reasons")
    parser.add_argument("--lines", action="store_true", help="print the ranges of unreached lines")
    parser.add_argument("--gcov", default="gcov")
    options = parser.parse_args()

    counts = collect(options.build.resolve(), options.gcov)
    missed = {file: [n for n, count in lines.items() if count == 0]
              for file, lines in counts.items()}
    folders = collections.defaultdict(lambda: [0, 0])
    for file, lines in counts.items():
        for name in (str(pathlib.Path(file).parent), "src, in all"):
            folders[name][0] += len(lines) - len(missed[file])
            folders[name][1] += len(lines)

    print(f"{'folder':32} {'lines':>7} {'reached':>8} {'per cent':>9}")
    for name, (reached, lines) in sorted(folders.items(), key=lambda row: ("all" in row[0], row[0])):
        print(f"{name:32} {lines:7d} {reached:8d} {100 * reached / lines:9.1f}")
    print("\nlines that no test reached:")
    for file in sorted((file for file in missed if missed[file]), key=lambda f: (-len(missed[f]), f)):
        where = f": {ranges(missed[file])}" if options.lines else ""
        print(f"  {file} {len(missed[file])} of {len(counts[file])}{where}")
    compiled = {str(f.relative_to(ROOT)) for f in (ROOT / "src").rglob("*.cpp")} - set(counts)
    absent = sorted(file for file in compiled)
    if absent:
        print("\nsources of components that this build has not:\n  " + "\n  ".join(absent))

    failures = []
    reached, lines = folders["src, in all"]
    if 100 * reached < options.minimum * lines:
        failures.append(f"{100 * reached / lines:.2f} % of lines reached, {options.minimum:g} % asked")
    if options.documented:
        granted = documented(options.documented)
        for file, numbers in sorted(missed.items()):
            grant = granted.get(file, UNDOCUMENTED / SLACK)
            if len(numbers) > grant * SLACK + 1:
                failures.append(f"{file}: {len(numbers)} lines not reached ({ranges(numbers)}), "
                                f"{options.documented.name} grants {int(grant)}")
        for file in sorted(granted):
            if not (ROOT / file).exists():
                failures.append(f"{options.documented.name} lists {file}, which does not exist")
    for failure in failures:
        print(f"COVERAGE: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
