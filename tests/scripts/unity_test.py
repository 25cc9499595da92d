#!/usr/bin/env python3
"""Tests what cmake/unity.py may put into one source, and what it must hold apart.

usage: unity_test.py FOLDER_OF_UNITY
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop())
import unity  # noqa: E402

HIDDEN = "namespace x {{\nnamespace {{\n{}\n}}  // namespace\n{}\n}}  // namespace x\n"
SOURCES = {
    "one": HIDDEN.format("int helper() { return 1; }", "int a() { return helper(); }"),
    "same_name": HIDDEN.format("int helper() { return 2; }", "int b() { return helper(); }"),
    "seen_elsewhere": "namespace x {\nint helper(int);\nint c() { return helper(3); }\n}  // namespace x\n",
    "constant": "namespace x {\nconstexpr int limit = 4;\nint d() { return limit; }\n}  // namespace x\n",
    "other_constant": "namespace x {\nstatic const double limit = 5;\ndouble e() { return limit; }\n}\n",
    "macro": "#define SIZE 6\nnamespace x {\nint f() { return SIZE; }\n}\n",
    "same_macro": "#define SIZE 7\nnamespace x {\nint g() { return SIZE; }\n}\n",
    "all_of_std": "#include <vector>\nusing namespace std;\nvector<int> h() { return {}; }\n",
    "member": "namespace x {\nstruct Box { int helper() const; };\nint i(const Box& b) { return b.helper(); }\n}\n",
    "nothing": "namespace x {\nint j() { return 8; }\n}\n",
}


class Groups(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def groups(self, names):
        """Returns the names of the sources in each joined file."""
        place = pathlib.Path(self.folder.name)
        for name in names:
            (place / f"{name}.cpp").write_text(SOURCES[name])
        files = unity.write_joined(place, "unity", 1, [str(place / f"{n}.cpp") for n in names], [place])
        return [{n for n in names if f'#line 1 "{place}/{n}.cpp"' in pathlib.Path(file).read_text()}
                for file in files]

    def test_everything_once_and_quarrels_apart(self):
        groups = self.groups(list(SOURCES))
        self.assertEqual(sorted(name for group in groups for name in group), sorted(SOURCES))
        apart = [("one", "same_name"), ("one", "seen_elsewhere"), ("constant", "other_constant"),
                 ("macro", "same_macro"), *(("all_of_std", name) for name in SOURCES if name != "all_of_std")]
        for pair in apart:
            for group in groups:
                self.assertFalse(set(pair) <= group, pair)

    def test_what_agrees_stands_together(self):
        for pair in (["one", "nothing"], ["constant", "macro"], ["one", "constant"], ["one", "member"]):
            self.assertEqual(self.groups(pair), [set(pair)])

    def test_text_of_the_parts_is_kept_with_their_lines(self):
        self.groups(["one", "nothing"])
        text = (pathlib.Path(self.folder.name) / "unity_0.cpp").read_text()
        for name in ("one", "nothing"):
            self.assertIn(f'{name}.cpp"\n{SOURCES[name]}', text)


if __name__ == "__main__":
    unittest.main()
