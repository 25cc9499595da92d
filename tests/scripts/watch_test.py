#!/usr/bin/env python3
"""Tests that a program of tests which fails, crashes or hangs says where, and that its tests are counted.

usage: watch_test.py ROOT
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop())
BEGIN = "print('[ RUN      ] suite.{0}', flush=True)\n"
PASSES = BEGIN.format("good") + "print('quiet words')\nprint('[       OK ] suite.good (1 ms)')\n"
FAILS = BEGIN.format("bad") + "print('x.cpp:3: Failure')\nprint('[  FAILED  ] suite.bad (1 ms)')\n"
SKIPS = BEGIN.format("later") + "print('[  SKIPPED ] suite.later (1 ms)')\n"
END = "print('[==========] {0} tests from 1 test suite ran. (9 ms total)')\nprint('[  PASSED  ] 1 test.')\n"
SUMMARY_OF_THREE = END.format(3) + (
    "print('[  SKIPPED ] 1 test, listed below:')\nprint('[  FAILED  ] 1 test, listed below:')\n"
    "print('[  FAILED  ] suite.bad')\nimport sys; sys.exit(1)\n")
CRASHES = BEGIN.format("crash") + "print('last words', flush=True)\nimport os; os.abort()\n"
SPINS = BEGIN.format("spin") + "while True: pass\n"
SLEEPS = BEGIN.format("sleep") + "import time; time.sleep(60)\n"
# A program that uses little of a processor, and nothing for a while, does not hang.
SLOW = PASSES + "import time; time.sleep(1)\n" + PASSES + END.format(2)


def watched(text, *options):
    result = subprocess.run([sys.executable, ROOT / "tests/watch.py", *options, "--", sys.executable, "-c", text],
                            stdout=subprocess.PIPE, text=True, timeout=60, check=False)
    return result.returncode, result.stdout


class Watch(unittest.TestCase):
    def test_what_passed_is_silent(self):
        status, output = watched(PASSES + END.format(1))
        self.assertEqual(status, 0)
        self.assertNotIn("quiet words", output)
        self.assertIn("1 tests from 1 test suite ran", output)

    def test_what_fails_is_shown(self):
        status, output = watched(PASSES + FAILS + SKIPS + SUMMARY_OF_THREE)
        self.assertEqual(status, 1)
        self.assertIn("suite.bad\nx.cpp:3: Failure", output)
        self.assertNotIn("quiet words", output)

    def test_a_crash_names_its_test(self):
        status, output = watched(PASSES + CRASHES)
        self.assertEqual(status, 1)
        self.assertIn("last words\nENDED in suite.crash: SIGABRT", output)

    def test_hangs_are_told_by_what_processors_do(self):
        status, output = watched(SPINS, "--processor", "1")
        self.assertEqual(status, 1)
        self.assertIn("KILLED in suite.spin: it took more than 1 s of processors", output)
        status, output = watched(SLEEPS, "--idle", "1")
        self.assertEqual(status, 1)
        self.assertIn("KILLED in suite.sleep: it did nothing for 1 s", output)
        self.assertEqual(watched(SLOW, "--processor", "30", "--idle", "30")[0], 0)

    def test_seconds_of_processors_are_told(self):
        work = BEGIN.format("work") + "import time\nwhile time.process_time() < 1: pass\n"
        output = watched(work + SLOW, "--times", "0.5")[1]
        self.assertRegex(output, r"\d\.\d\d s suite\.work")
        self.assertNotIn(" s suite.good", output)

    def test_a_program_without_tests_fails(self):
        self.assertEqual(watched("pass")[0], 2)
        self.assertEqual(watched(PASSES)[0], 2)

    def test_an_exit_within_a_test_fails(self):
        status, output = watched(BEGIN.format("leaves") + "import sys; sys.exit(0)\n")
        self.assertEqual(status, 1)
        self.assertIn("ENDED in suite.leaves", output)


CASE = '<testcase name="{0}" status="{1}"><system-out>{2}</system-out>{3}</testcase>'
RAN = "[==========] {0} tests from 2 test suites ran. (9 ms total)\n[  PASSED  ] {1} tests.\n"


class Count(unittest.TestCase):
    def count(self, *cases):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "tests.xml")
            file.write_text('<?xml version="1.0"?><testsuite>' + "".join(cases) + "</testsuite>")
            result = subprocess.run([sys.executable, ROOT / "scripts/count_tests.py", file],
                                    stdout=subprocess.PIPE, text=True, check=False)
        return result.returncode, result.stdout

    def test_shards_count_as_their_tests(self):
        self.assertEqual(self.count(CASE.format("a", "run", RAN.format(5, 5), ""),
                                    CASE.format("b", "run", "a program", "")),
                         (0, "6 passed, 0 failed, 0 skipped\n"))

    def test_failures_are_counted_and_named(self):
        some = RAN.format(7, 4) + "[  SKIPPED ] 1 test, listed below:\n[  FAILED  ] 2 tests, listed below:\n"
        self.assertEqual(self.count(CASE.format("a", "fail", some, "<failure/>"),
                                    CASE.format("b", "fail", "ENDED in x.y: SIGABRT", "<failure/>"),
                                    CASE.format("c", "notrun", "", '<skipped message="SKIP_RETURN_CODE=77"/>'),
                                    CASE.format("d", "notrun", "", '<skipped message="no such program"/>')),
                         (1, "failed in: a\nfailed in: b\nfailed in: d\n4 passed, 4 failed, 2 skipped\n"))

    def test_a_program_that_fails_after_its_tests_passed_fails(self):
        self.assertEqual(self.count(CASE.format("a", "fail", RAN.format(5, 5), "<failure/>"))[0], 1)


if __name__ == "__main__":
    unittest.main()
