#!/usr/bin/env python3
"""Mutation check: do the tests notice when a law or a kernel is changed?

    mutations.py --work DIR [--sample 170] [--seed 1] [--log FILE]    make mutants, run the tests
                 --room mesh                                          of this room, shown to its nearest program
    mutations.py --work DIR --again [--only ID...]                    survivors, or these, again
                 --tests all                                          nightly tests as well; quick: no long ones
                 --least 95                                           fails where fewer per cent are noticed
    mutations.py --report FILE [--equivalent docs/testing.md]         the table of a log
    mutations.py --list                                               all mutants, one per line
    mutations.py --self-test                                          of the operators, in a second

DIR receives a copy of the tree at HEAD and a build of it in which the inside of the library is one
shared object, so that a mutant costs the compilation of what it touches and one link. Each mutant
changes one place of one file. It is noticed when a test program fails, crashes or takes far longer
than without the change (a limit on its CPU time); it survives when all tests pass, or those that the
budget lets run; it is invalid when it does not compile. Tests whose names are near the file's run
first, then those that noticed others, then quick ones. The log has one JSON object per mutant and is
continued where a run ended. The same seed gives the same mutants for the same sources.

Operators: + and -, * and /, = with them, unary minus and ! dropped, < <= > >= == != changed to a
neighbour or the opposite, && and ||, min and max, whole numbers and plain decimals changed (0 to 1,
n to n + 1, x to 2 x; not the defaults of members in headers), conditions of if negated, statements
dropped, functions left at their first line. Not touched: comments, strings, preprocessor lines,
template brackets, numbers with an exponent (tolerances), reserve(), and functions bytes() (memory
counts, no laws).

An ID is file:line:column:operator. Mutants that change no behaviour are equivalent: they are listed
with their reason in the section "## Mutations" of the document given by --equivalent, by their place in
the words of the source (`--list` and the report print them), which holds while lines move.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

from mutants import GROUPS, all_mutants, sample, self_test

ROOT = pathlib.Path(__file__).resolve().parent.parent

# A room's mutants are shown to these test programs, nearest first.
PROGRAMS = {
    "contact": ["contact", "capi", "capi_inside", "stability", "bodies", "validation"],
    "bodies": ["bodies", "contact", "capi", "capi_inside", "stability", "validation"],
    "mesh": ["mesh", "bodies", "contact", "capi", "capi_inside", "stability", "validation"],
}
PROGRAMS["quadrature"] = PROGRAMS["bodies"]
PROGRAMS["geometry"] = PROGRAMS["mesh"]
# A test of each stage takes so many seconds at most; longer tests than the last stage's are left out.
STAGES = [0.03, 0.15, 1.0, 4.0, 20.0]


def copy_tree(tree, also):
    """Copies the tree at HEAD, and configures its library as one shared object with everything visible."""
    if not tree.exists():
        tree.mkdir(parents=True)
        archive = subprocess.Popen(["git", "-C", ROOT, "archive", "HEAD"], stdout=subprocess.PIPE)
        subprocess.run(["tar", "x", "-C", tree], stdin=archive.stdout, check=True)
        library = tree / "cmake/RollconLibrary.cmake"
        text = library.read_text()
        for old, new in (("add_library(rollcon_static STATIC", "add_library(rollcon_static SHARED"),
                         ("CXX_VISIBILITY_PRESET hidden", "CXX_VISIBILITY_PRESET default")):
            if old not in text:
                sys.exit(f"mutations.py: {library} has no '{old}' any more")
            text = text.replace(old, new)
        library.write_text(text)
    for file in also:
        shutil.copyfile(ROOT / file, tree / file)


def nearest_of(room):
    """Tries the mutants of one room by the program that is nearest to it."""
    programs = PROGRAMS[room][:1]
    PROGRAMS.clear()
    PROGRAMS[room] = programs


def prepare(work, jobs):
    tree, build = work / "tree", work / "build"
    linker = "-fuse-ld=lld" if shutil.which("ld.lld") else ""
    # The cache gives back what a mutant changed.
    launcher = "ccache" if shutil.which("ccache") else ""
    os.environ.update(CCACHE_DIR=str(work / "ccache"))
    os.environ.pop("CCACHE_DISABLE", None)
    subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -D_GLIBCXX_ASSERTIONS", "-DROLLCON_SHARED=OFF",
                    "-DROLLCON_STATIC=ON", "-DROLLCON_TESTS=ON", "-DROLLCON_FORTRAN=OFF", "-DROLLCON_INSTALL=OFF",
                    f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}", "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON",
                    f"-DCMAKE_EXE_LINKER_FLAGS={linker}",
                    f"-DCMAKE_SHARED_LINKER_FLAGS={linker} -Wl,-Bsymbolic-functions"],
                   check=True, stdout=subprocess.DEVNULL)
    built = compile_all(work, jobs)
    if built.returncode != 0:
        sys.exit(built.stdout.decode())


def compile_all(work, jobs):
    programs = sorted({f"test_{p}" for programs in PROGRAMS.values() for p in programs})
    return subprocess.run(["ninja", "-C", work / "build", f"-j{jobs}", *programs],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def run_tests(work, program, names, limit, report=None):
    """Returns (exit status, first failing test) of one test program, -1 for one that took too long."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    environment["GTEST_FILTER"] = ":".join(names)
    command = [str(work / "build/tests" / f"test_{program}"), "--gtest_brief=1"]
    command += [f"--gtest_output=json:{report}"] if report else ["--gtest_fail_fast"]

    def limits():
        resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 2))
        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    output = work / "output.txt"
    with output.open("wb") as out:
        try:
            status = subprocess.run(command, env=environment, cwd=work, preexec_fn=limits,
                                    timeout=20 * limit, stdout=out, stderr=out).returncode
        except subprocess.TimeoutExpired:
            return -1, ""
    failed = re.search(rb"\[  FAILED  \] ([^\s,]+)", output.read_bytes()[-1 << 20:])
    return status, failed.group(1).decode() if failed else ""


def notices(work, program, names, limit):
    """Returns None, or how the tests noticed. What fails once must fail again: no test of time misleads."""
    status, failed = run_tests(work, program, names, limit)
    if status == 1 and failed:
        status = run_tests(work, program, [failed], limit)[0]
    return {"by": program, "status": status, "test": failed} if status != 0 else None


def baseline(work, tests):
    """Returns {program: [(seconds, test)]} of the unchanged library, stored in DIR."""
    kept = work / f"baseline_{tests}.json"
    left_out = {"all": [], "change": ["nightly"], "quick": ["nightly", "long"]}[tests]
    wanted = ["*-" + ":".join(f"*_{kind}.*:*_{kind}/*" for kind in left_out)] if left_out else ["*"]
    if kept.exists():
        return json.loads(kept.read_text())
    times = {}
    for program in sorted({p for programs in PROGRAMS.values() for p in programs}):
        report = work / "report.json"
        report.unlink(missing_ok=True)
        if run_tests(work, program, wanted, 3000, report)[0] != 0:
            print(f"test_{program} fails without any change; its failing tests are left out")
        times[program] = [(float(test["time"].rstrip("s")), f"{suite['name']}.{test['name']}")
                          for suite in json.loads(report.read_text())["testsuites"]
                          for test in suite["testsuite"]
                          if test["result"] == "COMPLETED" and not test.get("failures")]
    kept.write_text(json.dumps(times))
    return times


def suites_of(tree):
    """Returns {suite: the file under tests/ that defines it}."""
    suites = {}
    for file in sorted((tree / "tests").rglob("*_test.cpp")):
        for suite in re.findall(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),", file.read_text(), re.M):
            suites[suite] = file.relative_to(tree / "tests")
    return suites


def nearness(source, test):
    """Returns how much the names of a source and a test file have in common; rooms alone do not count."""
    words = lambda path: set(re.split(r"[/_.]", str(path.with_suffix(""))))
    return len((words(source) & words(test)) - {source.parts[0], "test"})


def stages_of(file, times, suites, noticing):
    """Returns [(program, tests, seconds)]: tests whose names are near the file's, those that noticed mutants of it
    or of its room before, then all, quick ones of near programs first. No test comes twice."""
    stages, taken = [], set()
    source = pathlib.Path(file).relative_to("src")
    room = source.parts[0]

    def add(program, tests):
        tests = sorted((t, name) for t, name in tests if (program, name) not in taken)
        taken.update((program, name) for _, name in tests)
        for k in range(0, len(tests), 25):
            part = tests[k:k + 25]
            stages.append((program, [name for _, name in part], sum(t for t, _ in part)))

    def near(name):
        words = [word for word in re.split(r"[/.]", name) if word in suites]
        return nearness(source, suites[words[0]]) if words else 0

    def stage(program, k):
        below = STAGES[k - 1] if k else 0.0
        add(program, [(t, name) for t, name in times[program] if below <= t < STAGES[k]])

    short = [(p, t, name) for p in PROGRAMS[room] for t, name in times[p] if t < STAGES[3]]
    for where in (file, room + "/"):
        for program in PROGRAMS[room]:
            add(program, [(t, name) for p, t, name in short if p == program and any(
                where in i for i in noticing.get((p, name), ()))])
        for least in (3, 2, 1) if where == file else ():
            for program in PROGRAMS[room][:2]:
                add(program, [(t, n) for p, t, n in short if p == program and near(n) >= least])
    first, rest = PROGRAMS[room][:2], PROGRAMS[room][2:]
    for programs, some in ((first, (0, 1, 2)), (rest, (0, 1, 2)), (first + rest, range(3, len(STAGES)))):
        for k in some:
            for program in programs:
                stage(program, k)
    return stages


def try_mutant(work, mutant, stages, options):
    path = work / "tree" / mutant.file
    original = path.read_text()
    if original[mutant.begin:mutant.end] != mutant.old:
        sys.exit(f"mutations.py: {path} is not the file that the mutants were made of")
    start = time.time()
    try:
        path.write_text(mutant.apply(original))
        if compile_all(work, options.jobs).returncode != 0:
            return {"result": "invalid", "seconds": time.time() - start}
        built, tests = time.time(), 0
        for program, names, seconds in stages:
            if time.time() - built > options.budget:
                break
            tests += len(names)
            how = notices(work, program, names, options.patience * seconds + 10)
            if how:
                return {"result": "noticed", **how, "build": built - start,
                        "seconds": time.time() - start}
        return {"result": "survived", "tests": tests, "build": built - start,
                "seconds": time.time() - start}
    finally:
        path.write_text(original)


def run(options):
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # the tree is put right again
    work = options.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    copy_tree(work / "tree", options.also)
    mutants = all_mutants(work / "tree")
    places = {m.place for files in mutants.values() for ms in files.values() for m in ms}
    for place in sorted(equivalents(options.equivalent) - places):
        print(f"called equivalent, but no longer in the sources: {place}")
    if options.room:
        nearest_of(options.room)
        mutants = {group: {file: ms for file, ms in files.items() if file.startswith(f"src/{options.room}/")}
                   for group, files in mutants.items()}
    prepare(work, options.jobs)
    times, suites = baseline(work, options.tests), suites_of(work / "tree")
    if options.prepare:
        return
    known = {m.id: (group, m) for group, files in mutants.items() for ms in files.values() for m in ms}
    if options.only:
        chosen = [known[i] for i in options.only]
    else:
        chosen = sample(mutants, options.seed, options.sample)
        chosen.sort(key=lambda one: one[1].file.endswith(".hpp"))  # a header costs half a build, so it comes last
    part, parts = map(int, options.part.split("/"))
    chosen = chosen[part - 1::parts]
    log = options.log or work / "log.jsonl"
    logged = {record["id"]: record for record in records(log)}
    if options.again:
        chosen = [known[i] for i, record in logged.items() if record["result"] == "survived"]
    done = set() if options.only or options.again else set(logged)
    for group, mutant in chosen:
        if mutant.id in done:
            continue
        noticing = collections.defaultdict(list)
        for r in records(log):
            if r.get("test"):
                noticing[(r["by"], r["test"])].append(r["id"])
        stages = stages_of(mutant.file, times, suites, noticing)
        record = {"id": mutant.id, "place": mutant.place, "group": group, "old": mutant.old[:200],
                  "new": mutant.new[:200]}
        record.update(try_mutant(work, mutant, stages, options))
        with log.open("a") as out:
            out.write(json.dumps(record) + "\n")
        print(f"{record['result']:9} {record['seconds']:6.0f} s {mutant.id}", flush=True)
    return report(log, options.equivalent, options.least)


def records(log):
    return [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []


def equivalents(document):
    if not document:
        return set()
    section = document.read_text().split("\n## Mutations", 1)[-1].split("\n## ", 1)[0]
    equivalent = section.split("\nEquivalent:\n", 1)[-1]  # after the table of survivors
    return {found.replace("\\|", "|") for found in re.findall(r"^\| `(src/[^`]+)` \|", equivalent, re.M)}


def report(log, document, least=0.0):
    latest = {record["id"]: record for record in records(log)}
    same = equivalents(document)
    table = collections.defaultdict(collections.Counter)
    for record in latest.values():
        result = record["result"]
        if result == "survived" and record["place"] in same:
            result = "equivalent"
        table[record["group"]][result] += 1
        table["in all"][result] += 1
    print(f"{'group':28} {'mutants':>8} {'noticed':>8} {'survived':>9} {'equivalent':>11} {'per cent':>9}")
    for name in [group[0] for group in GROUPS] + ["in all"]:
        c = table[name]
        asked = c["noticed"] + c["survived"]
        print(f"{name:28} {asked + c['equivalent']:8d} {c['noticed']:8d} {c['survived']:9d} "
              f"{c['equivalent']:11d} {100 * c['noticed'] / max(1, asked):9.1f}")
    print(f"not compiled: {table['in all']['invalid']}")
    for record in sorted(latest.values(), key=lambda r: r["id"]):
        if record["result"] == "survived" and record["place"] not in same:
            print(f"survived {record['id']}: {record['place']}")
    c = table["in all"]
    if 100 * c["noticed"] < least * (c["noticed"] + c["survived"]):
        print(f"fewer than {least:g} per cent are noticed")
        return 1
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--sample", type=int, default=170)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--also", nargs="+", default=[], metavar="FILE",
                        help="taken from the working tree instead of HEAD: new tests")
    parser.add_argument("--jobs", type=int, default=2, help="compilers at a time")
    parser.add_argument("--room", choices=sorted(PROGRAMS), help="a trial: mutants and tests of one room alone")
    parser.add_argument("--log", type=pathlib.Path)
    parser.add_argument("--prepare", action="store_true", help="build, time the tests and stop")
    parser.add_argument("--part", default="1/1", metavar="K/N", help="every N-th mutant from the K-th")
    parser.add_argument("--budget", type=float, default=1e9, metavar="SECONDS",
                        help="of tests after which a mutant has survived")
    parser.add_argument("--patience", type=float, default=5, metavar="FACTOR",
                        help="of the time without a mutant, then tests take far longer")
    parser.add_argument("--again", action="store_true", help="those that survived by the log")
    parser.add_argument("--only", nargs="+", metavar="ID")
    parser.add_argument("--tests", choices=["quick", "change", "all"], default="change",
                        help="quick ones, those that run for every change, or nightly ones as well")
    parser.add_argument("--least", type=float, default=0.0, metavar="PER CENT",
                        help="fail where fewer of those that could be are noticed")
    parser.add_argument("--report", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--equivalent", type=pathlib.Path, metavar="DOCUMENT")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        rooms = {pathlib.Path(file).parts[1] for files in all_mutants(ROOT).values() for file in files}
        if rooms - set(PROGRAMS):
            print("no programs are named for mutants of", *sorted(rooms - set(PROGRAMS)))
            return 1
        return self_test(ROOT)
    if options.report:
        return report(options.report, options.equivalent, options.least)
    if options.list:
        for files in all_mutants(ROOT).values():
            for found in files.values():
                for m in found:
                    print(m.id, m.place)
        return 0
    if not options.work:
        parser.error("--work says where to build")
    return run(options)


if __name__ == "__main__":
    sys.exit(main())
