#!/usr/bin/env python3
"""run_documents.py PREFIX [FILE...]: runs the programs in the documents from their text, over the library installed in
PREFIX.

Of each page, blocks with a title are files (blocks of one title are one file), blocks of sh run in their order, and a
block of text after one is what it must print: numbers within 1 %, everything else to the letter. Lines of sh with a #
at their beginning are comments. Each page runs in a folder of its own. Without files: README.md and all pages that have
such blocks.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^```(\w+)(?: title=\"([^\"]+)\")?\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")


def pages():
    found = [ROOT / "README.md", ROOT / "bindings/python/README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return [page for page in found if any(b[0] == "sh" for b in BLOCK.findall(page.read_text(encoding="utf-8")))]


def same(printed, wanted):
    """Why two texts differ, or nothing."""
    printed, wanted = printed.strip().splitlines(), wanted.strip().splitlines()
    if len(printed) != len(wanted):
        return f"{len(printed)} lines, not {len(wanted)}"
    for one, two in zip(printed, wanted):
        words = [" ".join(NUMBER.sub("#", line).split()) for line in (one, two)]
        numbers = [list(map(float, NUMBER.findall(line))) for line in (one, two)]
        if words[0] != words[1] or any(abs(a - b) > 0.01 * max(abs(b), 1e-12) for a, b in zip(*numbers)):
            return f"'{one}', not '{two}'"
    return ""


def environment(prefix):
    lib = next(prefix.rglob("librollcon.so")).parent
    python = next(prefix.rglob("dist-packages/rollcon")).parent
    return {**os.environ, "PREFIX": str(prefix), "PKG_CONFIG_PATH": str(lib / "pkgconfig"), "LD_LIBRARY_PATH": str(lib),
            "PYTHONPATH": str(python), "PATH": "/usr/bin:/bin", "MPLBACKEND": "Agg", "SOURCES": str(ROOT)}


def run(page, env, folder):
    """What fails on a page, or nothing."""
    last, runs = None, 0
    blocks = BLOCK.findall(page.read_text(encoding="utf-8"))
    for _, title, text in blocks:
        if title:
            with open(pathlib.Path(folder) / title, "a", encoding="utf-8") as file:
                file.write(text)
    for language, title, text in blocks:
        if language == "sh":
            # What installs is done already.
            lines = [line for line in text.splitlines() if not re.match(r"#|cmake |export PKG_CONFIG", line)]
            done = subprocess.run(["bash", "-euc", "\n".join(lines)], cwd=folder, env=env, text=True, capture_output=True)
            if done.returncode:
                return f"status {done.returncode} of\n{text}{done.stdout}{done.stderr}"
            last, runs = done.stdout, runs + 1
        elif language == "text" and not title and last is not None:
            wrong = same(last, text)
            if wrong:
                return f"prints {wrong}\n--- all of it\n{last}"
            last = None
    return "" if runs else "runs nothing"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    prefix, failed = pathlib.Path(sys.argv[1]).resolve(), 0
    chosen = [pathlib.Path(name).resolve() for name in sys.argv[2:]] or pages()
    for page in chosen:
        with tempfile.TemporaryDirectory() as folder:
            wrong = run(page, environment(prefix), folder)
        failed += bool(wrong)
        print(f"{page.relative_to(ROOT)}: {'FAILED: ' + wrong if wrong else 'runs as it says'}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
