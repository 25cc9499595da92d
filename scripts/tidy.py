#!/usr/bin/env python3
"""clang-tidy over every source of src/, in the groups in which a build with ROLLCON_UNITY compiles them.

    tidy.py BUILD [JOBS] [--deep]

It walks the headers of the C++ library once for a group instead of once for a source. What it says
of a joined source is printed with the name and line of the part. Sources that the build leaves out
are joined here. Fails with any finding, and where something does not compile. With --deep the analyzer
follows paths as far as it ever does, which takes two and a half times as long.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

# The analyzer leaves a function after so many states; its own limit is 225000. Calls are followed as ever.
STATES = 40000

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
import unity  # noqa: E402


def parts_of(file):
    """[(line at which it begins, source), ...] of a joined source, [] of another."""
    lines = file.read_text().split("\n")
    return [(number + 2, match.group(1)) for number, line in enumerate(lines)
            if (match := re.match(r'#line 1 "(.*)"$', line))]


def with_the_rest(commands, folder):
    """Commands for what no command compiles yet, in the manner of the first."""
    done = {part for command in commands for _, part in parts_of(pathlib.Path(command["file"]))}
    done |= {command["file"] for command in commands}
    rest = sorted({str(path) for path in (ROOT / "src").rglob("*.cpp")} - done)
    first = commands[0]
    more = [{**first, "file": file, "command": first["command"].replace(first["file"], file)}
            for file in unity.write_joined(folder, "rest", 1, rest, [ROOT / "src"])]
    return commands + more


def in_parts(output, parts):
    """The output with places in parts instead of in the joined source."""
    def part(match):
        line = int(match.group(1))
        start, name = max((start, name) for start, name in parts if start <= line)
        return f"{name}:{line - start + 1}"
    if parts:
        joined = r"^\S*/(?:unity|rest)_\d+\.cpp:(\d+)(?=:)"
        output = re.sub(joined, lambda m: part(m) if int(m.group(1)) >= parts[0][0] else m.group(),
                        output, flags=re.M)
    return output


def main():
    options = [argument for argument in sys.argv[1:] if argument != "--deep"]
    if not options:
        sys.exit(__doc__)
    build = pathlib.Path(options[0]).resolve()
    jobs = int(options[1]) if len(options) > 1 else os.cpu_count()
    limit = [] if "--deep" in sys.argv else [
        f"--extra-arg={word}" for word in ("-Xclang", "-analyzer-config", "-Xclang", f"max-nodes={STATES}")]
    # Joins again what was edited since.
    subprocess.run(["cmake", build], check=True, stdout=subprocess.DEVNULL)
    commands = json.loads((build / "compile_commands.json").read_text())
    commands = [command for command in commands
                if re.search(r"rollcon_objects\.dir/\S+\.cpp\.o", command["command"])]
    joined = sorted((command for command in commands if parts_of(pathlib.Path(command["file"]))),
                    key=lambda command: -os.path.getsize(command["file"]))
    if not joined:
        sys.exit(f"tidy.py: {build} was not configured with ROLLCON_UNITY")
    folder = build / "tidy"
    folder.mkdir(exist_ok=True)
    commands = with_the_rest(joined + [c for c in commands if c not in joined], folder)
    (folder / "compile_commands.json").write_text(json.dumps(commands, indent=1))

    def check(command):
        result = subprocess.run(["clang-tidy", f"--config-file={ROOT}/.clang-tidy", "-p", folder, "--quiet",
                                 *limit, command["file"]],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        parts = parts_of(pathlib.Path(command["file"]))
        return result.returncode, in_parts(result.stdout, parts)

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for status, output in pool.map(check, commands):
            finding = re.search(r": (?:warning|error):", output)
            if status or finding:
                failed += 1
                print(output, flush=True)
    checked = sum(max(1, len(parts_of(pathlib.Path(command["file"])))) for command in commands)
    print(f"clang-tidy: {checked} sources in {len(commands)} runs, {failed} with findings")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
