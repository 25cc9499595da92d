#!/usr/bin/env python3
"""wrap_docs.py [--check] [FILE...]: wraps lines of Markdown beyond 120 characters, and their paragraph or list item.

Without files those of the repository. Tables, code, headings and comments stay as they are. --check changes nothing
and fails where a line would be wrapped.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LONGEST = 120
ITEM = re.compile(r"(\s*)([-*] |\d+\. )")
APART = re.compile(r"\s*(\||#|<|>|```|$)|    ")


def wrap(lines):
    """Wraps one paragraph or list item."""
    if max(map(len, lines)) <= LONGEST:
        return lines
    item = ITEM.match(lines[0])
    first = item.group(0) if item else re.match(r"\s*", lines[0]).group(0)
    hanging = " " * len(first)
    text = " ".join(line.strip() for line in lines)[len(first.strip()):].strip()
    # Code is not broken, and neither is the text of a link.
    words = re.findall(r"(?:`[^`]*`|\[[^]]*\]\([^)]*\)|\S)+", text)
    out, line = [], first.rstrip() if not words else first + words[0]
    for word in words[1:]:
        # A line must not begin like a list, a heading or a table.
        if len(line) + 1 + len(word) > LONGEST - 2 and not re.match(r"([-+*#>|]|\d+\.)$", word):
            out.append(line)
            line = hanging + word
        else:
            line += " " + word
    return out + [line + ("  " if lines[-1].endswith("  ") else "")]  # a line break


def wrapped(text):
    out, block, fenced = [], [], False

    def end():
        if block:
            out.extend(wrap(block))
            block.clear()

    for line in text.split("\n"):
        fence = line.lstrip().startswith("```")
        of_item = block and ITEM.match(block[0]) and line.startswith("    ")  # no code
        apart = fenced or fence or (APART.match(line) and not of_item)
        if apart or ITEM.match(line):
            end()
        if apart:
            out.append(line)
        else:
            block.append(line)
            if line.endswith("  "):
                end()
        fenced = fenced != fence
    end()
    return "\n".join(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    files = options.files or [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md")),
                              ROOT / "fortran/README.md", ROOT / "bindings/api_contract.md",
                              ROOT / "bindings/python/README.md", *sorted((ROOT / "docs").glob("*/*.md")),
                              *(ROOT / f"{name}.md" for name in ("CONTRIBUTING", "RELEASING", "SECURITY", "SUPPORT", "AUTHORS"))]
    stale = 0
    for file in files:
        old = file.read_text(encoding="utf-8")
        new = wrapped(old)
        if new == old:
            continue
        stale += 1
        print(f"{file}: lines beyond {LONGEST} characters")
        if not options.check:
            file.write_text(new, encoding="utf-8")
    return 1 if options.check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
