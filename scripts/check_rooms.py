#!/usr/bin/env python3
"""Checks over the includes of src/ that each room uses only itself and the rooms below it.

check_rooms.py [--list]: prints every include that goes upwards and ends with 1 if there is one;
--list prints which rooms each room uses instead.
"""
import collections
import pathlib
import re
import sys

# Rooms from the bottom up; rooms in one line may not use each other.
ROOMS = [
    ["support"],
    ["linalg", "mesh"],
    ["io", "quadrature", "geometry"],
    ["bodies"],
    ["contact"],
    ["procedures"],
    ["framing"],
    ["tables"],
    ["wheelrail"],
    ["capi"],
]
# The folders inside a room have an order, too; "" is what lies flat in it, "*" each folder that is not named.
INSIDE = {
    "bodies": [["model"], ["*"], [""]],
    "contact": [
        ["laws", "heat", "convection"],
        ["scene"],
        ["operators"],
        ["problem"],
        ["linear"],
        ["newton"],
        ["effort", "host", "prepared"],
        ["solution"],
        ["derived"],
        ["prepare"],
        ["settle"],
        ["estimate"],
        ["results"],
        ["solver"],
        ["plan", "statistics"],
        ["cases"],
        [""],
    ],
}
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')


def heights(levels):
    return {name: height for height, level in enumerate(levels) for name in level}


def place(path):
    """Returns room and inner room of a path below src/."""
    parts = path.split("/")
    inner = INSIDE.get(parts[0])
    if not inner:
        return parts[0], ""
    if len(parts) > 2:
        return parts[0], parts[1]
    stem = parts[1].partition(".")[0]
    return parts[0], stem if any(stem in level for level in inner) else ""


def allowed(user, used, rooms, inside):
    if user[0] != used[0]:
        return rooms[used[0]] < rooms[user[0]]
    if user[1] == used[1]:
        return True
    levels = inside[user[0]]
    height = lambda inner: levels.get(inner, levels.get("*"))
    return height(used[1]) < height(user[1])


def main():
    source = pathlib.Path(__file__).resolve().parent.parent / "src"
    rooms = heights(ROOMS)
    inside = {room: heights(levels) for room, levels in INSIDE.items()}
    uses = collections.defaultdict(collections.Counter)
    bad = []
    for path in sorted(source.rglob("*.[ch]pp")):
        user_path = path.relative_to(source).as_posix()
        user = place(user_path)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(line)
            if not found or not (source / found.group(1)).exists():
                continue
            used = place(found.group(1))
            uses["/".join(user).rstrip("/")]["/".join(used).rstrip("/")] += 1
            if not allowed(user, used, rooms, inside):
                bad.append(f"src/{user_path}:{number}: {'/'.join(user)} may not use {found.group(1)}")
    if "--list" in sys.argv[1:]:
        for room in sorted(uses):
            print(f"{room}: {', '.join(f'{used} {count}' for used, count in sorted(uses[room].items()))}")
        return 0
    count = sum(sum(c.values()) for c in uses.values())
    print("\n".join(bad) if bad else f"includes between rooms: {count}, none upwards")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
