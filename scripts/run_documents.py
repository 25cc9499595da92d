#!/usr/bin/env python3
"""run_documents.py [--pictures] PREFIX [FILE...]: runs the programs in the documents from their text, over the library installed in
PREFIX.

Of each page, blocks with a title are files (blocks of one title are one file), blocks of sh run in their order, and a
block of text after one is what it must print: numbers within 1 %, everything else to the letter. Lines of sh with a #
at their beginning are comments. Each page runs in a folder of its own. Without files: README.md and all pages that have
such blocks. A picture of docs/images that a page shows must come out under its name where the page saves it; --pictures
puts the new ones there.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^```(\w+)(?: title=\"([^\"]+)\")?\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")


def pages():
    found = [ROOT / "README.md", ROOT / "bindings/python/README.md", ROOT / "fortran/README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return [page for page in found if any(b[0] == "sh" for b in BLOCK.findall(page.read_text(encoding="utf-8")))]


def same(printed, wanted):
    """Says why two texts differ, or nothing."""
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
    octave = next(prefix.rglob("rollcon_build.m"), prefix).parent
    return {**os.environ, "ROLLCON_OCTAVE": str(octave), "PREFIX": str(prefix), "PKG_CONFIG_PATH": str(lib / "pkgconfig"), "LD_LIBRARY_PATH": str(lib),
            "PYTHONPATH": str(python), "PATH": "/usr/bin:/bin", "MPLBACKEND": "Agg", "SOURCES": str(ROOT)}


def run(page, env, folder):
    """Returns what fails on a page, or nothing; None: what it needs is not installed."""
    last, runs = None, 0
    if page.name == "octave.md" and not (shutil.which("octave-cli") and shutil.which("mkoctfile")):
        return None
    blocks = BLOCK.findall(page.read_text(encoding="utf-8"))
    for _, title, text in blocks:
        if title:
            (pathlib.Path(folder) / title).parent.mkdir(exist_ok=True)
            with open(pathlib.Path(folder) / title, "a", encoding="utf-8") as file:
                file.write(text)
    for language, title, text in blocks:
        if language == "sh":
            # The installation itself is done already.
            lines = [line for line in text.splitlines() if not re.match(r"#|PREFIX=|cmake |export PKG_CONFIG", line)]
            done = subprocess.run(["bash", "-euc", "\n".join(lines)], cwd=folder, env=env, text=True, capture_output=True)
            if done.returncode:
                return f"status {done.returncode} of\n{text}{done.stdout}{done.stderr}"
            last, runs = done.stdout, runs + 1
        elif language == "text" and not title and last is not None:
            wrong = same(last, text)
            if wrong:
                return f"prints {wrong}\n--- all of it\n{last}"
            last = None
    missing = [name for name in saved(page) if not (pathlib.Path(folder) / name).exists()]
    return f"draws no {missing[0]}" if missing else "" if runs else "runs nothing"


def saved(page):
    """Returns pictures that a page both shows and saves."""
    text = page.read_text(encoding="utf-8")
    return [name for name in re.findall(r"images/(\w+\.png)", text)
            if f'savefig("{name}")' in text or f"print('-dpng', '{name}')" in text]


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--pictures"]
    if not arguments:
        sys.exit(__doc__)
    prefix, failed = pathlib.Path(arguments[0]).resolve(), 0
    chosen = [pathlib.Path(name).resolve() for name in arguments[1:]] or pages()
    for page in chosen:
        with tempfile.TemporaryDirectory() as folder:
            wrong = run(page, environment(prefix), folder)
            for name in saved(page) if "--pictures" in sys.argv and not wrong else ():
                shutil.copy(pathlib.Path(folder) / name, ROOT / "docs/images" / name)
        failed += bool(wrong)
        said = "not run: Octave is not installed" if wrong is None else f"FAILED: {wrong}" if wrong else "runs as it says"
        print(f"{page.relative_to(ROOT)}: {said}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
