#!/usr/bin/env python3
"""documents.py check               links, spelling of names and sizes of the documents as plain files
   documents.py stage FOLDER        pages for MkDocs: links to files outside docs/ lead to copies
   documents.py search FOLDER       makes the search of a built site work where it is opened as a file
   documents.py links FOLDER        links of a built site

Of links to the web only the form is looked at. The references, which git does not hold, are written first. Pages that
git holds lead to bindings/api_contract.md instead of docs/api.md, which begins with it; the site leads to the reference.
"""

import html
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"(!?\[(?:[^\[\]]|\[[^\]]*\])*\]\()([^)\s]+)(\))")
FENCE = re.compile(r"^ *```.*?^ *```$", re.M | re.S)
OUTSIDE = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "RELEASING.md", "SECURITY.md", "SUPPORT.md", "AUTHORS.md",
           "fortran/README.md", "bindings/python/README.md"]
REFERENCES = [ROOT / "docs" / f"{name}.md" for name in ("api", "reference_fortran", "reference_python")]
PROGRAM = re.compile(r"^\[([\w.]+)\]\((\S*examples/\S+)\)$", re.M)  # a link alone in its line: the site shows the file
CONTRACT = ROOT / "bindings/api_contract.md"
README_LINES = 120


def write_references():
    subprocess.run([sys.executable, ROOT / "bindings/generate.py", "--texts", ROOT], check=True, stdout=subprocess.DEVNULL)


def pages():
    return [ROOT / name for name in OUTSIDE if (ROOT / name).exists()] + sorted((ROOT / "docs").rglob("*.md"))


def prose(text):
    """Removes code, in which brackets are no links."""
    return re.sub(r"`[^`\n]*`", "``", re.sub(r"^    .*$", "", FENCE.sub("", text), flags=re.M))


def slug(title):
    """Returns the anchor that GitHub and MkDocs give a heading."""
    title = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", title)
    return re.sub(r"\s+", "-", re.sub(r"[^\w\s-]", "", title.strip().lower()))


def anchors(page):
    found, seen = set(), {}
    for title in re.findall(r"^#+ (.+)$", FENCE.sub("", page.read_text(encoding="utf-8")), re.M):
        name = slug(title)
        seen[name] = seen.get(name, -1) + 1
        found.add(name + (f"-{seen[name]}" if seen[name] else ""))
    return found


def on_site(file):
    """Returns the page whose text a file is a part of on the site."""
    return REFERENCES[0] if file == CONTRACT else file


def dead_links():
    for page in pages():
        for _, target, _ in LINK.findall(prose(page.read_text(encoding="utf-8"))):
            if re.match(r"\w+:", target):
                continue
            path, _, anchor = target.partition("#")
            file = (page.parent / path).resolve() if path else page
            where = f"{page.relative_to(ROOT)}: {target}"
            if file in REFERENCES and page not in REFERENCES:
                yield f"{where}: git does not hold it, so readers of the sources have no such page"
            elif not file.exists():
                yield f"{where}: there is no such file"
            elif anchor and file.suffix == ".md" and anchor not in anchors(on_site(file)):
                yield f"{where}: there is no such heading"


def undocumented_options():
    described = (ROOT / "docs/build.md").read_text(encoding="utf-8")
    sources = [*sorted((ROOT / "cmake").glob("*.cmake")), *sorted((ROOT / "tests").glob("CMakeLists.txt")),
               ROOT / "examples/mpi/CMakeLists.txt"]
    for source in sources:
        text = source.read_text(encoding="utf-8")
        names = re.findall(r"^\s*option\((ROLLCON_\w+)", text, re.M)
        names += re.findall(r"\bset\((ROLLCON_\w+) [^)]*\bCACHE", text)
        names += ["ROLLCON_WITH_" + name for name in re.findall(r"^rollcon_wish\((\w+)", text, re.M)]
        for name in names:
            if not name.endswith("_") and f"`{name}`" not in described:
                yield f"docs/build.md does not describe the option {name}"


def functions_without_example():
    """Lists functions of the C interface without a line from a program in examples/, which is compiled and run."""
    text = (ROOT / "docs/api.md").read_text(encoding="utf-8")
    for section in re.split(r"^#+ (?=rollcon_)", text, flags=re.M)[1:]:
        name = re.match(r"\w+", section)[0]
        if "\nExample, of [" not in section and not name.endswith("_fn"):
            yield f"docs/api.md: no program in examples/ calls {name}: add a line to examples/each_call_*.c"


def other_versions():
    """Lists recipes and citation whose version is not the header's."""
    header = (ROOT / "include/rollcon.h").read_text(encoding="utf-8")
    version = re.search(r'#define ROLLCON_VERSION_STRING "([^"]+)"', header).group(1)
    for name, wanted in (("CITATION.cff", f"\nversion: {version}\n"), ("packaging/vcpkg/vcpkg.json", f'-semver": "{version}"'),
                         ("packaging/spack/package.py", f"rollcon-{version}.tar.xz"),
                         ("packaging/conda-forge/meta.yaml", f'version = "{version.replace("-", "")}"')):
        if wanted not in (ROOT / name).read_text(encoding="utf-8"):
            yield f"{name} has another version than include/rollcon.h, {version}"


def check():
    wrong = list(dead_links()) + list(undocumented_options()) + list(functions_without_example()) + list(other_versions())
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    if readme.count("\n") > README_LINES:
        wrong.append(f"README.md has {readme.count(chr(10))} lines; allowed: {README_LINES}")
    for page in sorted((ROOT / "docs").rglob("*.md")):
        name = page.relative_to(ROOT / "docs").as_posix()
        if name != "README.md" and f": {name}\n" not in (ROOT / "docs/mkdocs.yml").read_text(encoding="utf-8"):
            wrong.append(f"docs/mkdocs.yml does not name docs/{name}")
    for page in pages():
        # Lines of api.md are wrapped where its generator can; messages come in one line.
        lines = re.sub(r"^```text$.*?^```$", lambda m: "\n" * m[0].count("\n"), page.read_text(encoding="utf-8"),
                       flags=re.M | re.S)
        for number, line in enumerate(lines.splitlines(), 1):
            if len(line.rstrip()) > 120 and page.name != "api.md" and not re.match(r"\s*(\||#|!\[|<!--)|    |- `", line) and "](" not in line:
                wrong.append(f"{page.relative_to(ROOT)}:{number}: {len(line)} characters")
    print("\n".join(wrong) or f"documents: {len(pages())} pages, no dead link")
    return 1 if wrong else 0


def staged(path):
    """Returns where a file of the repository goes in the site: documents to its top, pages outside unchanged, others
    to source/."""
    inside = on_site(path).relative_to(ROOT).as_posix()
    if inside == "README.md":
        return "index.md"
    if inside == "docs/README.md":
        return "contents.md"
    if inside.startswith("docs/"):
        return inside.removeprefix("docs/")
    return inside if inside in OUTSIDE else f"source/{inside}.txt"


def with_programs(page, text):
    """Shows whole the programs of examples/ that a page names by a link alone in its line."""
    languages = {".c": "c", ".f": "fortranfixed", ".f90": "fortran", ".py": "python", ".m": "matlab"}

    def shown(match):
        file = (page.parent / match[2]).resolve()
        return f'```{languages[file.suffix]} title="{match[1]}"\n{file.read_text(encoding="utf-8")}```'
    return PROGRAM.sub(shown, text)


def tabbed(text):
    """Makes tabs of MkDocs of what stands between <!-- tabs --> and <!-- end of tabs -->; a line **Name** begins one."""
    def tabs(match):
        parts = re.split(r"^\*\*(.+)\*\*$", match.group(1), flags=re.M)[1:]
        bodies = (re.sub(r"^(?=.)", "    ", body, flags=re.M) for body in parts[1::2])
        return "".join(f'=== "{name}"\n{body}' for name, body in zip(parts[::2], bodies))
    return re.sub(r"^<!-- tabs -->$\n(.*?)^<!-- end of tabs -->$", tabs, text, flags=re.M | re.S)


def searchable(folder):
    """Puts site.js first in every page, and makes a script of the index of the search, which a page that is opened as a
    file may not read by itself."""
    for page in folder.rglob("*.html"):
        up = "../" * (len(page.relative_to(folder).parts) - 1)
        text = page.read_text(encoding="utf-8")
        page.write_text(text.replace("</head>", f'<script src="{up}site.js"></script></head>', 1), encoding="utf-8")
    index = (folder / "search/search_index.json").read_text(encoding="utf-8")
    script = f"var __search = {{ index: Promise.resolve({index}) }}"
    (folder / "search/search_index.js").write_text(script, encoding="utf-8")


def stage(folder):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "docs/images", folder / "images")
    for name in ("site.css", "site.js"):
        shutil.copy(ROOT / "docs" / name, folder)
    for page in pages():
        target = folder / staged(page)

        def moved(match, page=page, target=target):
            path, hash_sign, anchor = match.group(2).partition("#")
            if re.match(r"\w+:", match.group(2)) or not path:
                return match.group(0)
            file = (page.parent / path).resolve()
            goal = folder / staged(file)
            if goal.is_relative_to(folder / "source"):
                goal.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, goal)
            up = "../" * (len(target.relative_to(folder).parts) - 1)
            return match.group(1) + up + goal.relative_to(folder).as_posix() + hash_sign + anchor + match.group(3)
        parts, last, text = [], 0, tabbed(with_programs(page, page.read_text(encoding="utf-8")))
        for fence in FENCE.finditer(text):
            parts += [LINK.sub(moved, text[last:fence.start()]), fence.group(0)]
            last = fence.end()
        target.parent.mkdir(parents=True, exist_ok=True)
        # A wide table has the screen for itself.
        head = "---\nhide: [navigation, toc]\n---\n" if page.name == "calls.md" else ""
        target.write_text(head + "".join(parts) + LINK.sub(moved, text[last:]), encoding="utf-8")


def site_links(folder):
    """Checks that every href and src of every page leads to a file of the site, and to an anchor that it has."""
    ids, dead, count = {}, [], 0
    files = sorted(folder.rglob("*.html"))
    texts = {file: file.read_text(encoding="utf-8") for file in files}
    for file, text in texts.items():
        ids[file] = set(re.findall(r"\bid=\"([^\"]+)\"", text))
    for file, text in texts.items():
        if file.name == "404.html":
            continue
        for target in set(re.findall(r"\b(?:href|src)=\"([^\"]+)\"", text)):
            target = urllib.parse.unquote(html.unescape(target))
            if re.match(r"\w+:|//", target):
                continue
            count += 1
            path, _, anchor = target.partition("#")
            path = path.partition("?")[0]
            goal = (file.parent / path).resolve() if path else file
            goal = goal / "index.html" if goal.is_dir() else goal
            if not goal.exists() or (anchor and goal in ids and anchor not in ids[goal] | {"__comments"}):
                dead.append(f"{file.relative_to(folder)}: {target}")
    print("\n".join(sorted(dead)) or f"site: {len(files)} pages, {count} links, none dead")
    return 1 if dead else 0


def main():
    command, *rest = sys.argv[1:] or [""]
    if command in ("check", "stage"):
        write_references()
    if command == "check" and not rest:
        return check()
    if command in ("stage", "links", "search") and len(rest) == 1:
        return {"stage": stage, "links": site_links, "search": searchable}[command](pathlib.Path(rest[0]).resolve())
    sys.exit(__doc__)


if __name__ == "__main__":
    sys.exit(main())
