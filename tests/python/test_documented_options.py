"""The table of solver settings in docs/api.md is the one that the library has."""

import pathlib
import re
import unittest

import rollcon as rc

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "api.md"
TYPES = {rc.TYPE_INT: "int", rc.TYPE_REAL: "real", rc.TYPE_STR: "text"}


class DocumentedOptions(unittest.TestCase):

    def test_names_types_ranges_and_standards(self):
        rows = {}
        for line in DOCUMENT.read_text().splitlines():
            match = re.match(r"\| `(\w+)` \| (int|real|text) \| ([^|]*) \| ([^|]*) \|", line)
            if match:
                rows[match[1]] = match.groups()[1:]
        options = rc.option_table()
        self.assertEqual(sorted(rows), sorted(option.name for option in options))
        for option in options:
            kind, allowed, standard = rows[option.name]
            self.assertEqual(kind, TYPES[option.type], option.name)
            if kind == "text":
                continue
            low, high = (float(v) for v in allowed.split(" to "))
            self.assertEqual((low, high, float(standard)),
                             (option.low, option.high, option.standard), option.name)


if __name__ == "__main__":
    unittest.main()
