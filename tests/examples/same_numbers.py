#!/usr/bin/env python3
"""Runs programs and demands the same text from all, digit by digit: same_numbers.py program ..."""

import difflib
import subprocess
import sys


def output(program):
    command = [sys.executable, program] if program.endswith(".py") else [program]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode:
        sys.exit(f"{program}: status {result.returncode}\n{result.stdout}{result.stderr}")
    return [line.rstrip() for line in result.stdout.splitlines()]


def main():
    programs = sys.argv[1:]
    first = output(programs[0])
    words = sum(len(line.split()) for line in first)
    if not any(ch.isdigit() for line in first for ch in line):
        sys.exit(f"{programs[0]} prints no number")
    for program in programs[1:]:
        other = output(program)
        if other != first:
            print(*difflib.unified_diff(first, other, programs[0], program, lineterm=""), sep="\n")
            sys.exit(1)
    print(f"{len(programs)} programs print the same {words} words; bound: no difference")


main()
