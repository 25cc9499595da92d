"""same_tables.py <csv> <csv>...: every table has the numbers of the first one, to 1e-12 of the
largest of its column; and the numbers are those of creep forces at all."""

import csv
import sys

TOLERANCE = 1e-12


def read(path):
    with open(path, newline="") as file:
        head, *rows = csv.reader(file)
    return head, [[float(v) for v in row] for row in rows]


head, first = read(sys.argv[1])
assert len(first) >= 90, f"{sys.argv[1]}: only {len(first)} rows"
column = {name: i for i, name in enumerate(head)}
largest = [max(abs(row[i]) for row in first) for i in range(len(head))]
for row in first:
    assert row[column["status"]] == 0, row
    force = (row[column["Fx/(mu N)"]] ** 2 + row[column["Fy/(mu N)"]] ** 2) ** 0.5
    assert force <= 1 + 1e-9, f"force {force} beyond the friction bound: {row}"
assert 0.9 < max(abs(row[column["Fy/(mu N)"]]) for row in first), "no row comes near the bound"

for path in sys.argv[2:]:
    other_head, other = read(path)
    assert other_head == head and len(other) == len(first), path
    worst = max(abs(a - b) / (scale or 1)
                for row, twin in zip(first, other) for a, b, scale in zip(row, twin, largest))
    print(f"{path}: largest difference {worst:.1e}, bound {TOLERANCE:.0e}")
    assert worst <= TOLERANCE
