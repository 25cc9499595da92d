#!/usr/bin/env python3
"""clang-tidy over the sources of src/, joined into groups as builds with ROLLCON_UNITY join them.

    tidy.py BUILD [JOBS] [--changed BASE] [--deep]     after the build, whose precompiled header it needs

It walks the headers of the C++ library once for a group instead of once for a source. What it says
of a joined source is printed with the name and line of the part. Sources that the build leaves out
are looked at as well. With --changed only those that differ from this commit, and for each header that
differs one that includes it; each changed file must compile by itself. Fails with any finding, and where something does not
compile. With --deep the analyzer follows paths as far as it ever does, which takes two and a half times
as long.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

# The analyzer leaves a function after so many states; its own limit is 225000. Calls are followed without a limit of
# this script.
STATES = 40000
# A group has about so many sources.
GROUP = 36

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
import unity  # noqa: E402


def parts_of(file):
    """Returns [(line at which it begins, source), ...] of a joined source, [] of another."""
    lines = file.read_text().split("\n")
    return [(number + 2, match.group(1)) for number, line in enumerate(lines)
            if (match := re.match(r'#line 1 "(.*)"$', line))]


TOKEN = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/', re.S)


def code_of(text):
    """Returns a source without layout and without comments, but for those that clang-tidy reads."""
    return " ".join(TOKEN.sub(lambda m: m[0] if m[0][0] in "\"'" or "NOLINT" in m[0] else " ", text).split())


def changed_files(base):
    """Returns the files whose code differs from that of a commit, new ones included."""
    git = ["git", "-C", str(ROOT)]
    names = subprocess.check_output([*git, "diff", "--name-only", "--diff-filter=d", base, "--", "src"], text=True)
    names += subprocess.check_output([*git, "ls-files", "--others", "--exclude-standard"], text=True)

    def differs(name):
        before = subprocess.run([*git, "show", f"{base}:{name}"], capture_output=True, text=True)
        return before.returncode != 0 or code_of(before.stdout) != code_of((ROOT / name).read_text())
    return {str(ROOT / name) for name in names.splitlines() if differs(name)}


def affected(sources, changed):
    """Returns the sources that changed, and for each header that did one that sees it, best the one of its name."""
    headers = unity.Headers([ROOT / "src"])
    sees = {source: unity.Source(source, headers).headers for source in sources}
    chosen = {source for source in sources if source in changed}
    for header in sorted(changed):
        users = [source for source in sources if header in sees[source]]
        if users and not chosen.intersection(users):
            stem = os.path.splitext(header)[0]
            chosen.add(min(users, key=lambda source: os.path.splitext(source)[0] != stem))
    return sorted(chosen)


def commands_for(commands, sources, folder, jobs):
    """Returns a command for each of the sources that the build compiles alone, and for groups of the others."""
    alone = {command["file"]: command for command in commands}
    # A source that stands for an absent component defines the same functions as the component.
    loose = [source for source in sources if source not in alone and not source.endswith("_absent.cpp")]
    first = next(command for command in commands if parts_of(pathlib.Path(command["file"])))
    number = min(len(loose), max(jobs, -(-len(loose) // GROUP)))
    joined = unity.write_joined(folder, "joined", number, loose, [ROOT / "src"]) if loose else []
    joined = [{**first, "file": file, "command": first["command"].replace(first["file"], file)}
              for file in sorted(joined, key=os.path.getsize, reverse=True)]
    return joined + [alone[source] for source in sources if source in alone]


def system_folders(commands):
    """Returns the folders of all sources: a header of a component may need one that others do not."""
    found = {}
    for command in commands:
        words = shlex.split(command["command"])
        found |= {words[at + 1]: None for at, word in enumerate(words) if word == "-isystem"}
    return [part for folder in found for part in ("-isystem", folder)]


def compiles_alone(command, file, folders):
    """Returns what the compiler says of a source or header by itself, without anything included before."""
    words = shlex.split(command["command"])
    kept = [word for word in words[1:] if re.match(r"-([DIWf]|std)", word) and "pch" not in word] + folders
    # A header is no main file.
    once = ["-Wno-pragma-once-outside-header", "-Wno-unused-function", "-Wno-unused-const-variable"]
    result = subprocess.run([words[0], *kept, *once, "-fsyntax-only", "-x", "c++", file],
                            cwd=command["directory"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return result.returncode, result.stdout


def lacks_header(command, file, folders):
    """Says whether a header is not on this machine, as those of components that the build does not have."""
    words = shlex.split(command["command"])
    kept = [word for word in words[1:] if re.match(r"-([DI]|std)", word) and "pch" not in word] + folders
    result = subprocess.run([words[0], *kept, "-E", "-o", os.devnull, "-x", "c++", file],
                            cwd=command["directory"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return result.returncode != 0


def in_parts(output, parts):
    """Returns the output with places in parts instead of in the joined source."""
    def part(match):
        line = int(match.group(1))
        start, name = max((start, name) for start, name in parts if start <= line)
        return f"{name}:{line - start + 1}"
    if parts:
        joined = r"^\S*/joined_\d+\.cpp:(\d+)(?=:)"
        output = re.sub(joined, lambda m: part(m) if int(m.group(1)) >= parts[0][0] else m.group(),
                        output, flags=re.M)
    return output


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("jobs", type=int, nargs="?", default=os.cpu_count())
    parser.add_argument("--changed", metavar="BASE")
    parser.add_argument("--deep", action="store_true")
    options = parser.parse_args()
    build = options.build.resolve()
    limit = [] if options.deep else [
        f"--extra-arg={word}" for word in ("-Xclang", "-analyzer-config", "-Xclang", f"max-nodes={STATES}")]
    commands = json.loads((build / "compile_commands.json").read_text())
    commands = [command for command in commands
                if re.search(r"rollcon_objects\.dir/\S+\.cpp\.o", command["command"])]
    if not any(parts_of(pathlib.Path(command["file"])) for command in commands):
        sys.exit(f"tidy.py: {build} was not configured with ROLLCON_UNITY")
    made = {command["file"] for command in commands if "/generated/src/" in command["file"]}
    sources = sorted({str(path) for path in (ROOT / "src").rglob("*.cpp")} | made)
    changed = set()
    if options.changed:
        changed = changed_files(options.changed)
        sources = affected(sources, changed)
    first = next(command for command in commands if parts_of(pathlib.Path(command["file"])))
    folders = system_folders(commands)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        lacking = {source for source, lacks in zip(sources, pool.map(
            lambda source: lacks_header(first, source, folders), sources)) if lacks}
    for source in sorted(lacking):
        print(f"clang-tidy: {source} is left out: a header that it includes is not found")
    sources = [source for source in sources if source not in lacking]
    changed -= lacking
    folder = build / "tidy"
    folder.mkdir(exist_ok=True)
    runs = commands_for(commands, sources, folder, options.jobs)
    (folder / "compile_commands.json").write_text(json.dumps(runs, indent=1))

    def check(command):
        result = subprocess.run(["clang-tidy", f"--config-file={ROOT}/.clang-tidy", "-p", folder, "--quiet",
                                 *limit, command["file"]],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        parts = parts_of(pathlib.Path(command["file"]))
        return result.returncode, in_parts(result.stdout, parts)

    by_itself = {command["file"]: command for command in commands}
    files = sorted(file for file in changed if re.search(r"/src/.*\.[ch]pp$", file) and os.path.exists(file))
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        outcomes = [*pool.map(lambda file: compiles_alone(by_itself.get(file, first), file, folders), files),
                    *pool.map(check, runs)]
        for status, output in outcomes:
            finding = re.search(r": (?:warning|error):", output)
            if status or finding:
                failed += 1
                print(output, flush=True)
    print(f"clang-tidy: {len(sources)} sources in {len(runs)} runs, {len(files)} changed files by themselves, "
          f"{failed} with findings")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
