#!/usr/bin/env python3
"""Runs a GoogleTest program, judges hangs by what processors did, and shows what failed.

    watch.py [--processor SECONDS] [--idle SECONDS] [--times LEAST] PROGRAM [ARGUMENT...]

A test may take so many seconds of processors, however long other work makes it last, and the program
may do nothing for so many seconds of the clock, as in a deadlock. One that does more or less is killed.
Prints what failing tests printed, or the test that was running when the program ended too early, then
the summary. With --times it also prints which tests took at least so many seconds of processors: these, and
not those of the clock, say what a test costs on a busy machine. The exit status is the program's, 1 where
it was killed, 2 where it ran no test.
"""
import argparse
import os
import re
import select
import signal
import subprocess
import sys
import time

TICKS = os.sysconf("SC_CLK_TCK")
PERIOD = 0.5


def processor_seconds(pid):
    """Returns the processor seconds of the process, all of its threads and those of its children that have ended."""
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as file:
            fields = file.read().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return sum(map(int, fields[11:15])) / TICKS


class Report:
    """Follows the output: drops the lines of tests that passed, and keeps all others."""

    def __init__(self):
        self.running = ""
        self.ran = None
        self.seconds = {}
        self._lines = []
        self._rest = b""

    def take(self, chunk):
        lines = (self._rest + chunk).split(b"\n")
        self._rest = lines.pop()
        for line in lines:
            self._line(line.decode(errors="replace"))

    def end(self):
        """Prints what the program left of a line, and of a test in the middle."""
        if self._rest:
            self._line(self._rest.decode(errors="replace"))
        if self.running:
            self._show()

    def _line(self, line):
        begins = re.match(r"\[ RUN      \] (\S+)", line)
        if begins:
            self.running, self._lines = begins.group(1), [line]
        elif not self.running:
            summary = re.match(r"\[==========\] (\d+) tests? from .* ran\.", line)
            if summary:
                self.ran = int(summary.group(1))
            if summary or re.match(r"\[  (?:PASSED|FAILED|SKIPPED) ", line):
                print(line, flush=True)
        else:
            self._lines.append(line)
            # Output without an end of line may stand before.
            ends = re.search(r"\[(       OK|  FAILED |  SKIPPED)\s*\] " + re.escape(self.running), line)
            if ends:
                if "FAILED" in ends.group(1):
                    self._show()
                self.running, self._lines = "", []

    def _show(self):
        print("\n".join(self._lines), flush=True)


def watch(child, report, most, idle):
    """Reads until the program ends; returns the reason why it was killed, or nothing."""
    test, at_test, at_work, clock = None, 0.0, 0.0, time.monotonic()
    while True:
        readable, _, _ = select.select([child.stdout], [], [], PERIOD)
        if readable:
            chunk = os.read(child.stdout.fileno(), 1 << 16)
            if not chunk:
                return ""
            report.take(chunk)
        used, now = processor_seconds(child.pid), time.monotonic()
        if report.running != test:
            if test:
                report.seconds[test] = used - at_test
            test, at_test = report.running, used
        if used - at_work > 0.1 or readable:
            at_work, clock = used, now
        if used - at_test > most:
            return f"took more than {most:g} s of processors"
        if now - clock > idle:
            return f"did nothing for {idle:g} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--processor", type=float, default=120)
    parser.add_argument("--idle", type=float, default=300)
    parser.add_argument("--times", type=float, metavar="LEAST")
    parser.add_argument("program", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    command = options.program[1:] if options.program[:1] == ["--"] else options.program
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             start_new_session=True)
    # CTest's own limit, or an interrupt, ends both.
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda *_: (os.killpg(child.pid, signal.SIGKILL), sys.exit(1)))
    report = Report()
    reason = watch(child, report, options.processor, options.idle)
    if reason:
        os.killpg(child.pid, signal.SIGKILL)
    status = child.wait()
    report.end()
    if options.times is not None:
        for test, seconds in sorted(report.seconds.items(), key=lambda row: -row[1]):
            if seconds >= options.times:
                print(f"{seconds:8.2f} s {test}")
    where = f" in {report.running}" if report.running else ""
    if reason:
        print(f"KILLED{where}: it {reason}")
        return 1
    if status < 0 or report.running:
        name = signal.Signals(-status).name if status < 0 else f"status {status}"
        print(f"ENDED{where}: {name}")
        return 1
    if not report.ran and status == 0:
        print("no test ran")
        return 2
    return status


if __name__ == "__main__":
    sys.exit(main())
