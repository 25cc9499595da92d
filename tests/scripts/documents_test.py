"""documents_test.py SOURCES: pages that scripts/run_documents.py must pass, and pages that it must not."""

import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "scripts"))
import run_documents  # noqa: E402

SHELL = "export SET='by the installation' PKG_CONFIG_PATH=$HOME\n"
PACKAGE = "Name: rollcon\nDescription: none\nVersion: 0\nCflags:\n"
SETTINGS = "source ~/rollcon/share/rollcon/environment.sh\n"


def sh(text):
    return f"```sh\n{text}\n```\n"


def prints(text):
    return f"```text\n{text}\n```\n"


# Name, page, and a part of what must be said about it; empty: nothing.
PAGES = [
    ("what it says", sh("echo force 10 N") + prints("force 10.05 N"), ""),
    ("another number", sh("echo force 10 N") + prints("force 10.2 N"), "prints"),
    ("another word", sh("echo force 10 N") + prints("load 10 N"), "prints"),
    ("a line more", sh("echo 1; echo 2") + prints("1"), "2 lines, not 1"),
    ("a warning that it does not show", sh("echo 1; echo careful >&2") + prints("1"), "2 lines, not 1"),
    ("a command that fails", sh("echo 1") + sh("false"), "status 1"),
    ("nothing of the tester's", sh("echo ${PYTHONPATH:-no} ${LD_LIBRARY_PATH:-no}") + prints("no no"), ""),
    ("settings once for a page", sh(SETTINGS + "echo $SET") + sh("echo $SET") + prints("by the installation"), ""),
    ("files by title", '```python title="a.py"\nprint(3)\n```\n' + sh("python3 a.py") + prints("3"), ""),
    ("a program by its link", "[b.py](examples/b.py)\n\n" + sh("python3 b.py") + prints("4"), ""),
    ("a program without a title", "```python\nprint(5)\n```\n" + prints("5"), ""),
    ("a program without a title that fails", "```python\nprint(\n```\n", "status 1"),
    ("a fragment of C", "```c\nint f(void) { return 1 }\n```\n", "status 1"),
    ("tabs", "<!-- tabs -->\n" + sh("echo 1") + sh("echo 1") + "<!-- end of tabs -->\n" + prints("1"), ""),
    ("tabs of which one differs",
     "<!-- tabs -->\n" + sh("echo 2") + sh("echo 1") + "<!-- end of tabs -->\n" + prints("1"), "prints"),
    ("an installation", '```sh title="install"\nfalse\n```\n', ""),
    ("a picture that nothing draws",
     "![x](images/y.png)\n" + '```python title="c.py"\nx.savefig("y.png")\n```\n' + sh("true"), "draws no y.png"),
]


def main():
    failed = 0
    for number, (name, text, wanted) in enumerate(PAGES):
        with tempfile.TemporaryDirectory() as work:
            work = pathlib.Path(work)
            settings = work / "home/rollcon/share/rollcon"
            settings.mkdir(parents=True)
            (settings / "environment.sh").write_text(SHELL, encoding="utf-8")
            (work / "home/rollcon.pc").write_text(PACKAGE, encoding="utf-8")
            (work / "examples").mkdir()
            (work / "examples/b.py").write_text("print(4)\n", encoding="utf-8")
            (work / "folder").mkdir()
            page = work / "page.md"
            page.write_text(text, encoding="utf-8")
            said = run_documents.run(page, work / "home", work / "folder")
        if bool(said) != bool(wanted) or wanted not in said:
            failed += 1
            print(f"{name}: it says '{said}', not '{wanted}'")
    print(f"{len(PAGES)} pages, {failed} judged wrongly")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
