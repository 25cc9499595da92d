#!/usr/bin/env python3
"""run_documents.py [--pictures | --install] PREFIX [FILE...]: runs what documents show, as their reader would type it.

The reader has installed rollcon in ~/rollcon (a link to PREFIX), and nothing else: variables are those of a login. Of
each page, blocks with a title are files (blocks of one title are one file), and so are programs of examples/ that a
page names by a link alone in its line. Blocks of sh are typed in their order, into one shell, in a folder of the page's
own. A block of text after one is what it must print: numbers within 1 %, everything else to the letter. Between <!--
tabs --> and <!-- end of tabs --> a page says the same in several languages; a block of text behind them is what each
block of sh there prints. Blocks of C, Fortran, Python and MATLAB without a title are programs by themselves: they are
compiled, or run. Blocks that call octave-cli are passed over where it is not installed. Blocks of sh entitled "install"
need the network, root or minutes: --install runs those of README.md alone, in a copy of the sources. Without files: all
pages that have such blocks. A picture of docs/images that a page shows must come out under its name where the page
saves it; --pictures puts the new ones there.
"""

import concurrent.futures
import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^```(\w+)(?: title=\"([^\"]+)\")?\n(.*?)^```$|^<!-- ((?:end of )?tabs) -->$", re.M | re.S)
PROGRAM = re.compile(r"^\[([\w.]+)\]\((\S*examples/\S+)\)$", re.M)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
MARK = "=== block"
OCTAVE = bool(shutil.which("octave-cli") and shutil.which("mkoctfile"))
COMPILING = threading.Lock()
SETTINGS = "source ~/rollcon/share/rollcon/environment.sh\n"
# The commands for programs without a title, which they read from their standard input.
ALONE = {"python": "python3 -", "matlab": "octave-cli -q", "fortran": "gfortran -fsyntax-only -x f95 -",
         "c": "cc -fsyntax-only $(pkg-config --cflags rollcon) -x c -"}


def pages():
    return [page for page in (ROOT / "README.md", ROOT / "fortran/README.md", *sorted((ROOT / "docs").rglob("*.md")))
            if any(block[0] in ("sh", *ALONE) for block in BLOCK.findall(page.read_text(encoding="utf-8")))]


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


def commands(page):
    """Returns for each block that the reader types its text and what it must print (None: anything)."""
    found, waiting, tabs = [], [], False
    for language, title, text, mark in BLOCK.findall(page.read_text(encoding="utf-8")):
        if mark:
            tabs, waiting = mark == "tabs", [] if mark == "tabs" else waiting
        elif language == "text" and not title:
            for block in waiting:
                block[1] = text
            waiting = []
        elif language == "sh" and title != "install" or language in ALONE and not title:
            typed = text if language == "sh" else f"({SETTINGS}{ALONE[language]} <<'END'\n{text}END\n)\n"
            if "octave-cli" in typed and not OCTAVE:
                continue
            found.append([typed, None])
            waiting = waiting * tabs + [found[-1]]
    return found


def shell(lines, home, folder):
    """Types lines into the shell of a user who has just logged in."""
    login = {"HOME": str(home), "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "USER": "reader", "SHELL": "/bin/bash"}
    return subprocess.run(["bash", "-ec", lines], cwd=folder, env=login, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)


def run(page, home, folder):
    """Returns what fails on a page, or "" where nothing does; None where it needs what is not installed."""
    if page.name == "calculix.md" and not shutil.which("ccx"):
        return None
    folder.mkdir(exist_ok=True)
    for title, path in PROGRAM.findall(page.read_text(encoding="utf-8")):
        shutil.copy(page.parent / path, folder / title)
    for _, title, text, _ in BLOCK.findall(page.read_text(encoding="utf-8")):
        if title and title != "install":
            (folder / title).parent.mkdir(exist_ok=True, parents=True)
            with open(folder / title, "a", encoding="utf-8") as file:
                file.write(text)
    blocks = commands(page)
    # Pages that compile the package for Octave write it to the same place.
    alone = COMPILING if any("rollcon_build" in typed for typed, _ in blocks) else contextlib.nullcontext()
    with alone:
        done = shell("".join(f"echo '{MARK}'\n{typed}" for typed, _ in blocks), home, folder)
    printed = done.stdout.split(MARK + "\n")[1:]
    for (typed, wanted), said in zip(blocks, printed):
        wrong = wanted is not None and same(said, wanted)
        if wrong and not (done.returncode and said is printed[-1]):
            return f"prints {wrong}, at\n{typed}--- all of it\n{said}"
    if done.returncode:
        return f"status {done.returncode} of\n{blocks[len(printed) - 1][0]}--- it says\n{printed[-1]}"
    missing = [name for name in saved(page) if not (folder / name).exists()]
    return f"draws no {missing[0]}" if missing and (OCTAVE or page.name != "octave.md") else ""


def saved(page):
    """Returns pictures that a page both shows and saves."""
    text = page.read_text(encoding="utf-8")
    text += "".join((page.parent / path).read_text(encoding="utf-8") for _, path in PROGRAM.findall(text))
    return [name for name in re.findall(r"images/(\w+\.png)", text)
            if f'savefig("{name}")' in text or f"print('-dpng', '{name}')" in text]


def install():
    """Types the installation that README.md shows, in a copy of the sources, for a user without anything."""
    with tempfile.TemporaryDirectory() as work:
        home, sources = pathlib.Path(work) / "home", pathlib.Path(work) / "sources"
        home.mkdir()
        tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
        for name in tracked.stdout.split("\0")[:-1]:
            (sources / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, sources / name)
        for language, title, text, _ in BLOCK.findall((ROOT / "README.md").read_text(encoding="utf-8")):
            if language == "sh" and title == "install":
                done = shell(text, home, sources)
                print(text, done.stdout[-2000:] if done.returncode else f"status {done.returncode}", flush=True)
                if done.returncode:
                    return 1
        return check([ROOT / "README.md"], (home / "rollcon").resolve())


def check(chosen, prefix):
    failed = 0
    with tempfile.TemporaryDirectory() as work:
        home = pathlib.Path(work) / "home"
        home.mkdir()
        (home / "rollcon").symlink_to(prefix)
        # Matplotlib says once that it looks for fonts, and Octave complains of a home that has nowhere for its history.
        shell("mkdir -p .local/share/octave; python3 -c 'import matplotlib.pyplot'", home, home)
        folders = [pathlib.Path(work) / str(number) for number in range(len(chosen))]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = pool.map(lambda page, folder: run(page, home, folder), chosen, folders)
            for page, folder, wrong in zip(chosen, folders, found):
                if wrong is None:
                    print(f"{page.relative_to(ROOT)}: passed over, as CalculiX is not installed", flush=True)
                    continue
                for name in saved(page) if "--pictures" in sys.argv and not wrong else ():
                    if (folder / name).exists():
                        shutil.copy(folder / name, ROOT / "docs/images" / name)
                failed += bool(wrong)
                without = "octave-cli" in page.read_text(encoding="utf-8") and not OCTAVE
                passed = "runs as it says" + ", but for Octave, which is not installed" * without
                print(f"{page.relative_to(ROOT)}: {f'FAILED: {wrong}' if wrong else passed}", flush=True)
    return 1 if failed else 0


def main():
    arguments = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
    if "--install" in sys.argv:
        return install()
    if not arguments:
        sys.exit(__doc__)
    prefix, *names = (pathlib.Path(name).resolve() for name in arguments)
    return check(names or pages(), prefix)


if __name__ == "__main__":
    sys.exit(main())
