#!/usr/bin/env python3
"""Joins C++ sources into a few, which compilers and clang-tidy get through much faster.

    unity.py [--alike] [-I FOLDER...] FOLDER NUMBER SOURCE...

Writes FOLDER/unity_K.cpp, K = 0, 1, ..., each the text of some sources behind `#line`s, and prints
their names. There are NUMBER of them, or more where sources cannot stand together. A joined source
means what its parts mean one by one: no name that a part keeps to itself (unnamed namespaces,
statics, constants, usings, macros) occurs in another part of it, and all parts have the same
using-directives. It is text rather than #include since some of clang-tidy's checks look at the main
file only.
"""
import argparse
import pathlib
import re
import sys

TOKEN = re.compile(r"""
    (?P<skip> //[^\n]* | /\*.*?\*/ | \s+)
  | (?P<text> (?:u8|[uUL])?R"(?P<end>[^(\s]*)\(.*?\)(?P=end)" | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])+')
  | (?P<number> \.?\d(?:[eEpP][+-]|'?[\w.])*)
  | (?P<name> [A-Za-z_]\w*)
  | (?P<mark> ::|->|\[\[|\]\]|.)
""", re.S | re.X)
DIRECTIVE = re.compile(r"^[ \t]*#[ \t]*(\w+)((?:\\\n|[^\n])*)", re.M)
OPEN = {"(": ")", "{": "}", "[": "]", "[[": "]]"}
NO_NAMES = {"const", "constexpr", "static", "inline", "thread_local", "extern", "noexcept", "typename",
            "auto", "decltype", "final", "static_assert", "alignas", "mutable", "unsigned", "signed"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.M)


class Source:
    """declared: names in namespaces; own: those of them that it keeps to itself; mentioned: names that
    it might look up; usings: what those among its own that are usings say; hidden: whether it has an unnamed
    namespace; directives: of using; headers: those of the project that it sees."""

    def __init__(self, path, headers=None):
        self.path = path
        self.text = pathlib.Path(path).read_text()
        self.own = set()
        self.declared = set()
        self.mentioned = set()
        self.hidden = False
        self.usings = {}
        self.directives = set()
        self._tokens = []
        text = DIRECTIVE.sub(self._directive, self.text)
        last = before = ""
        for match in TOKEN.finditer(text):
            kind = match.lastgroup if match.lastgroup != "end" else "text"
            if kind == "skip":
                continue
            token = match.group() if kind in ("name", "mark") else "0"
            if kind == "name" and not (last in (".", "->") or (last == "::" and before == "std")):
                self.mentioned.add(token)
            self._tokens.append(token)
            before, last = last, token
        self.headers = headers.seen_by(self) if headers else frozenset()
        self._at = 0
        self._scope(unnamed=False)

    def _directive(self, match):
        """Preprocessor lines are no part of declarations; macros belong to the file."""
        names = re.findall(r"[A-Za-z_]\w*", match.group(2))
        if match.group(1) != "include":
            self.mentioned.update(names)
        if match.group(1) == "define":
            self._keep(names[0])
        return "\n"

    def _next(self):
        self._at += 1
        return self._tokens[self._at - 1] if self._at <= len(self._tokens) else ""

    def _peek(self):
        return self._tokens[self._at] if self._at < len(self._tokens) else ""

    def _block(self, opening):
        """Passes the rest of a bracket that was opened, and returns what was in it."""
        start, closing = self._at, [OPEN[opening]]
        while closing:
            token = self._next()
            if not token:
                sys.exit(f"unity.py: {self.path}: '{opening}' is not closed")
            if token in OPEN:
                closing.append(OPEN[token])
            elif token == closing[-1]:
                closing.pop()
            elif token == "]]" and closing[-2:] == ["]", "]"]:  # a[b[0]]
                del closing[-2:]
        return self._tokens[start:self._at - 1]

    def _scope(self, unnamed):
        while self._at < len(self._tokens):
            token = self._peek()
            if token == "}":
                self._at += 1
                return
            if token == "namespace":
                self._namespace(unnamed)
            elif token == "using":
                self._using()
            elif token == "extern" and self._tokens[self._at + 1:self._at + 3] == ["0", "{"]:
                self._at += 3
                self._scope(unnamed)
            else:
                self._declaration(unnamed)

    def _namespace(self, unnamed):
        head = []
        while (token := self._next()) not in ("{", ";"):
            head.append(token)
        if token == "{":
            self.hidden |= head == ["namespace"]
            self._scope(unnamed or head == ["namespace"])
        else:
            self._keep(head[1], head)  # an alias

    def _using(self):
        head = []
        while (token := self._next()) != ";":
            head.append(token)
        if head[1] == "namespace":
            self.directives.add("".join(head[2:]))
        else:
            self._keep(head[1] if "=" in head else head[-1], head)

    def _keep(self, name, head=None):
        self.own.add(name)
        if head:
            self.usings[name] = " ".join(head)
        self.declared.add(name)

    def _declaration(self, unnamed):
        """Of a function, type or variables: its names are the file's own if they are in an unnamed
        namespace or if it is static or constant."""
        head, angles, called, own = [], 0, False, unnamed
        names, kind, assigned, initialised = [], "", False, False
        while True:
            token = self._next()
            if token in ("", ";"):
                break
            if token in OPEN:
                inside = self._block(token)
                if token == "(" and not angles and not called and not assigned and head:
                    if head[-1] in ("alignas", "decltype", "noexcept", "explicit"):
                        continue
                    called = True
                    if head[-1] not in NO_NAMES and (len(head) < 2 or head[-2] != "::"):
                        names.append(head[-1])
                    if "operator" in head:
                        names = ["operator"]
                elif token == "{" and not angles:
                    if kind:
                        if kind == "enum":
                            names += [b for a, b in zip([","] + inside, inside) if a == ","]
                        kind = ""  # what follows are variables of that type
                        head.append("}")
                    elif called and not assigned:
                        member = initialised and (head[-1].isidentifier() or head[-1] == ">")
                        if not member:
                            break  # the body of a function
                        head.append("}")
                    elif not assigned and head:
                        names.append(head[-1])
                        assigned = True
                elif token == "[" and not angles and not assigned and head:
                    names.append(head[-1])
                continue
            if token == "<" and head and (head[-1].isidentifier() or head[-1] == "operator"):
                angles += 1
            elif token == ">" and angles:
                angles -= 1
            elif not angles:
                if token in ("struct", "class", "union", "enum") and not called and not kind:
                    scoped = token == "enum" and self._peek() in ("class", "struct")
                    kind = "enum class" if scoped else token
                    self._type_name(names)
                elif token == "=" and not called:
                    if not assigned and head:
                        names.append(head[-1])
                    assigned = True
                elif token == "," and not called:
                    if not assigned and head:
                        names.append(head[-1])
                    assigned = False
                elif token == ":" and called:
                    initialised = True
                if token in ("static", "constexpr") or (token == "const" and not called):
                    own = True
            if not (angles and head and head[0] == "template"):
                head.append(token)
        if not called and not assigned and not kind and len(head) > 1:
            names.append(head[-1])
        # Members defined outside of their class are no names of a namespace, functions with external
        # linkage no names of a file.
        names = {name for name in names
                 if name.isidentifier() and name not in NO_NAMES and not name.isupper()}  # no macros
        self.declared |= names
        if own and (unnamed or not called or "static" in head):
            self.own |= names

    def _type_name(self, names):
        while (token := self._peek()) in ("class", "struct", "[[", "alignas"):
            self._at += 1
            if token == "[[":
                self._block(token)
            elif token == "alignas":
                self._at += 1
                self._block("(")
        if token.isidentifier():
            self._at += 1
            if self._peek() != "::":
                names.append(token)


class Headers:
    """Of the project, from these folders."""

    def __init__(self, folders):
        self._folders = [pathlib.Path(folder) for folder in folders]
        self._read = {}

    def find(self, source, name):
        for folder in [pathlib.Path(source.path).parent, *self._folders]:
            if (folder / name).is_file():
                return str((folder / name).resolve())
        return name

    def of(self, source):
        paths = [self.find(source, name) for name in INCLUDE.findall(source.text)]
        return [path for path in paths if path.startswith("/")]

    def seen_by(self, source):
        seen = set()
        waiting = self.of(source)
        while waiting:
            path = waiting.pop()
            if path not in seen:
                seen.add(path)
                if path not in self._read:
                    self._read[path] = Source(path)
                waiting += self.of(self._read[path])
        return frozenset(seen)

    def declared(self, paths):
        return set().union(*(self._read[path].declared for path in paths))

    def hidden(self, paths):
        return any(self._read[path].hidden for path in paths)


def keeps_out(one, other, headers, alike):
    """Whether a name of the first stands in the second for something else, declared there or in one of
    its headers (what is declared nowhere in namespaces is local, a member or of std), or is declared by
    a header that the first does not see alone."""
    seen = other.declared | headers.declared(other.headers)
    names = one.own & (other.mentioned & seen | headers.declared(other.headers - one.headers))
    return any(not alike or name not in one.usings or
               name in other.own and one.usings[name] != other.usings.get(name) for name in names)


def quarrel(one, other, headers, alike):
    # Headers with unnamed namespaces are there for sources that compile them each in its own way.
    return (one.directives != other.directives or headers.hidden(one.headers | other.headers) or
            keeps_out(one, other, headers, alike) or keeps_out(other, one, headers, alike))


def grouped(sources, number, headers, alike):
    """Next comes always the source that has the fewest groups left; the smallest of them takes it."""
    enemies = {one: {other for other in sources if other is not one and quarrel(one, other, headers, alike)}
               for one in sources}
    groups = [[] for _ in range(number)]
    shut = {source: set() for source in sources}  # groups in which an enemy is
    waiting = sorted(sources, key=lambda source: source.path)
    while waiting:
        source = max(waiting, key=lambda one: (len(shut[one]), len(enemies[one])))
        waiting.remove(source)
        open_ones = [k for k in range(len(groups)) if k not in shut[source]]
        if not open_ones:
            open_ones = [len(groups)]
            groups.append([])
        k = min(open_ones, key=lambda k: len(groups[k]))
        groups[k].append(source)
        for enemy in enemies[source]:
            shut[enemy].add(k)
    return [sorted(group, key=lambda source: source.path) for group in groups if group]


def joined(group, headers):
    """C++ headers come first: what the sources declare is nothing to them."""
    def text(source):
        def found(match):
            return match.group().replace(f'"{match.group(1)}"', f'"{headers.find(source, match.group(1))}"')
        return f'#line 1 "{source.path}"\n' + INCLUDE.sub(found, source.text)
    lines = dict.fromkeys(f'#include "{path}"' for source in group for path in headers.of(source)
                          if path.endswith(".hpp"))
    return "\n".join([*lines, *map(text, group)])


def write_joined(folder, stem, number, paths, folders, alike=False):
    """Names of the files written."""
    headers = Headers(folders)
    files = []
    for k, group in enumerate(grouped([Source(path, headers) for path in paths], number, headers, alike)):
        files.append(str(folder / f"{stem}_{k}.cpp"))
        file = pathlib.Path(files[-1])
        # A file that stays the same keeps its time.
        text = joined(group, headers)
        if not file.exists() or file.read_text() != text:
            file.write_text(text)
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--alike", action="store_true", help="usings are no obstacle unless they contradict one another")
    parser.add_argument("-I", dest="folders", action="append", default=[], help="folder of headers")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("number", type=int)
    parser.add_argument("sources", nargs="+")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    print(*write_joined(options.folder, "unity", options.number, options.sources, options.folders,
                        options.alike), sep="\n")


if __name__ == "__main__":
    main()
