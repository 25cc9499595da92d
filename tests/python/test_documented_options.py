"""Tests that the tables of settings in bindings/api_contract.md are those that the library has."""

import pathlib
import re
import unittest

import rollcon as rc

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "bindings" / "api_contract.md"
TYPES = {rc.TYPE_INT: "int", rc.TYPE_REAL: "real", rc.TYPE_STR: "text"}


def documented(title):
    """Returns the rows of the table whose first column has the title: name -> type, range, standard."""
    _, _, rest = DOCUMENT.read_text().partition(f"\n| {title} | type | range | standard |")
    rows = {}
    for line in rest.partition("\n\n")[0].splitlines():
        match = re.match(r"\| `(\w+)` \| (int|real|text) \| ([^|]*) \| ([^|]*) \|", line)
        if match:
            rows[match[1]] = match.groups()[1:]
    return rows


class DocumentedOptions(unittest.TestCase):

    def same(self, rows, options):
        self.assertTrue(rows)
        self.assertEqual(sorted(rows), sorted(option.name for option in options))
        for option in options:
            kind, allowed, standard = rows[option.name]
            self.assertEqual(kind, TYPES[option.type], option.name)
            if kind == "text":
                continue
            low, high = (float(v) for v in allowed.split(" to "))
            self.assertEqual((low, high, float(standard)),
                             (option.low, option.high, option.standard), option.name)

    def test_of_contacts(self):
        self.same(documented("name"), rc.option_table())

    def test_of_bodies(self):
        self.same(documented("body option"), rc.option_table("body"))

    def test_of_procedures(self):
        self.same(documented("procedure option"), rc.option_table("procedure"))

    def test_of_wheels(self):
        self.same(documented("wheel option"), rc.option_table("wheelrail"))


if __name__ == "__main__":
    unittest.main()
