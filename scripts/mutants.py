"""Makes mutants of contact laws and kernels: which files, which changes, which sample. mutations.py uses it."""
import random
import re

# Each entry has a name, the weight in the sample, and files under src/. Headers that half the library and its tests
# include are left out, because each of their mutants would cost half a build.
GROUPS = [
    ("friction and Newton", 50, [
        "contact/laws/*", "contact/linear/free_system.cpp", "contact/linear/reduced_system.cpp",
        "contact/newton/*.cpp", "contact/newton/strategies/*.cpp",
        "contact/problem/law_residual.cpp", "contact/problem/problem.cpp", "contact/results/power.cpp",
        "contact/results/sensitivity.cpp", "contact/linear/split_factors.cpp"]),
    ("contact geometry", 20, [
        "contact/scene/geometry.cpp", "contact/scene/rim.cpp", "contact/problem/moments.cpp",
        "contact/prepare/gap_between_nodes.cpp", "contact/derived.cpp",
        "contact/operators/assemble_operators.cpp", "contact/operators/dense_operators.cpp",
        "contact/operators/traction_space.cpp"]),
    ("convection", 12, ["contact/convection/*"]),
    ("regular frames", 22, ["contact/operators/lattice/*"]),
    ("half-space", 26, ["bodies/halfspace/*"]),
    ("boundary elements", 26, [
        "bodies/bem/assembly.cpp", "bodies/bem/boundary_integrals.cpp", "bodies/bem/equations.cpp",
        "bodies/bem/far_field.cpp", "bodies/bem/near_field.cpp", "bodies/bem/kelvin*", "bodies/bem/balance.cpp",
        "bodies/bem/unknowns.cpp", "quadrature/*.cpp"]),
    ("finite elements", 16, [
        "bodies/fem/assembly.cpp", "bodies/fem/element_stiffness*.cpp", "bodies/fem/equations.cpp",
        "bodies/model/felt_tractions.cpp"]),
    ("bodies", 12, [
        "bodies/meshed_*.cpp", "bodies/remainder_compliance.cpp", "bodies/sum_compliance.cpp",
        "bodies/model/supports.cpp", "bodies/frame_on_body.cpp", "bodies/contact_surface.cpp",
        "bodies/pair.cpp", "geometry/coupled_element.cpp", "geometry/surface_coupling.cpp",
        "geometry/surface_patch.cpp"]),
    ("shape functions and rules", 16, [
        "mesh/shape.cpp", "mesh/volume_shape.cpp", "mesh/quadrature.cpp", "mesh/volume_quadrature.cpp",
        "mesh/surface_geometry.cpp", "mesh/dual_cells.cpp"]),
]
# These have no code of their own, or a choice of starts that the solution does not depend on.
LEFT_OUT = re.compile(r"_absent\.cpp$|nested_start\.cpp$")

TOKEN = re.compile(r"""
    (?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*|R"\((?:.*?)\)"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')
  | (?P<number>(?:\d[\d']*\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?)[uUlLfF]*|0x[0-9a-fA-F]+)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<sign><<=|>>=|<=>|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|::|[-+*/%<>=!&|^~?:;,.(){}\[\]])
""", re.X | re.S | re.M)

COMPARISONS = {"<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="],
               "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"]}
ARITHMETIC = {"+": "-", "-": "+", "*": "/", "/": "*"}
NO_STATEMENT = {"return", "if", "for", "while", "do", "else", "switch", "case", "default", "break",
                "continue", "goto", "using", "namespace", "template", "struct", "class", "enum",
                "typedef", "static", "constexpr", "const", "auto", "double", "float", "int", "bool",
                "public", "private", "protected", "extern", "inline", "void", "unsigned", "throw",
                "delete", "static_assert", "friend", "virtual", "operator", "reserve"}


# The pattern finds a member's default in a header.
MEMBER = re.compile(r" +(?:std::)?\w+ [\w, =]+ = \d[\d.]*;")


class Mutant:
    def __init__(self, file, text, begin, end, new, operator):
        self.file, self.begin, self.end, self.new = file, begin, end, new
        line = text.count("\n", 0, begin) + 1
        column = begin - (text.rfind("\n", 0, begin) + 1) + 1
        self.id = f"{file}:{line}:{column}:{operator}"
        self.old = text[begin:end]
        self.place = ""  # place in the words of the source: see name_places

    def words(self, text):
        """Returns the line with its place marked, and what comes there: it holds while lines move."""
        first, last = text.rfind("\n", 0, self.begin) + 1, text.find("\n", self.end)
        before, after = text[first:self.begin][-30:].lstrip(), text[self.end:last][:30].rstrip()
        shown, new = (" ".join(part.split())[:40] for part in (self.old, self.new))
        return f"{self.file}: {before}«{shown}»{after} → {new}".rstrip()

    def apply(self, text):
        return text[:self.begin] + self.new + text[self.end:]


def tokens_of(text):
    """Yields (kind, text, begin) of what is neither comment, string nor preprocessor line."""
    return [(m.lastgroup, m.group(), m.start()) for m in TOKEN.finditer(text) if m.lastgroup != "skip"]


def matching(tokens, k):
    """Returns the index of the bracket that closes the one at k."""
    pairs = {"(": ")", "{": "}", "[": "]"}
    depth = 0
    for j in range(k, len(tokens)):
        if tokens[j][1] in pairs:
            depth += 1
        elif tokens[j][1] in pairs.values():
            depth -= 1
            if depth == 0:
                return j
    return len(tokens) - 1


def left_out(tokens):
    """Returns ranges of token indices inside functions bytes()."""
    out = []
    for k, (_, word, _) in enumerate(tokens):
        if word == "bytes" and tokens[k + 1:k + 3] and tokens[k + 1][1] == "(" and tokens[k + 2][1] == ")":
            j = k + 3
            while j < len(tokens) and tokens[j][1] in ("const", "noexcept", "override"):
                j += 1
            if j < len(tokens) and tokens[j][1] == "{":
                out.append((j, matching(tokens, j)))
    return out


def mutants_of(file, text):
    tokens = tokens_of(text)
    skipped = left_out(tokens)
    found = []

    def add(k, new, operator, end=None):
        begin = tokens[k][2]
        found.append(Mutant(file, text, begin, end or begin + len(tokens[k][1]), new, operator))

    for k, (kind, token, begin) in enumerate(tokens):
        if any(a <= k <= b for a, b in skipped):
            continue
        before, previous = tokens[k - 1][:2] if k else ("sign", ";")
        following = tokens[k + 1][1] if k + 1 < len(tokens) else ""
        if previous == "operator":
            continue
        end = begin + len(token)
        # The sources are formatted: operators of two sides, and those alone, have blanks around.
        spaced = text[begin - 1:begin].isspace() and end < len(text) and text[end].isspace()
        after_value = previous in (")", "]") or (
            before in ("word", "number") and previous not in ("return", "case"))
        if token in ARITHMETIC and spaced and after_value:
            add(k, ARITHMETIC[token], token)
        elif token in ("+=", "-=", "*=", "/="):
            add(k, ARITHMETIC[token[0]] + "=", token)
        elif token == "-" and not after_value and following != "-" and not text[end].isspace():
            add(k, "", "minus")
        elif token in COMPARISONS and (spaced or token in ("==", "!=", "&&", "||")):
            if token != "&&" or spaced:  # not a reference
                for new in COMPARISONS[token]:
                    add(k, new, f"{token}{new}")
        elif token == "!":
            add(k, "", "not")
        elif token in ("min", "max") and following == "(" and previous == "::":
            add(k, "max" if token == "min" else "min", token)
        elif kind == "number" and previous not in ("[", "<") and not re.search(r"[eExX]", token) and not (
                file.endswith(".hpp") and MEMBER.match(text, text.rfind("\n", 0, begin) + 1)):
            whole = re.fullmatch(r"\d+", token)
            if whole:
                add(k, str(int(token) + 1), "number")
            elif re.fullmatch(r"\d+\.\d*", token):
                add(k, repr(2 * float(token)) if float(token) else "1.0", "number")
        elif token == "if" and following == "(":
            close = matching(tokens, k + 1)
            inside = text[tokens[k + 1][2] + 1:tokens[close][2]]
            if ";" not in inside:
                found.append(Mutant(file, text, tokens[k + 1][2], tokens[close][2] + 1,
                                    f"(!({inside}))", "if"))
        elif token == "void" and previous in (";", "}", "{") and tokens[k + 1][0] == "word":
            j = k + 2
            while j + 1 < len(tokens) and tokens[j][1] == "::":
                j += 2
            if j < len(tokens) and tokens[j][1] == "(":
                body = matching(tokens, j) + 1
                while body < len(tokens) and tokens[body][1] in ("const", "noexcept", "override"):
                    body += 1
                if body < len(tokens) and tokens[body][1] == "{":
                    place = tokens[body][2] + 1
                    found.append(Mutant(file, text, place, place, " return;", "return"))
        if previous in (";", "{", "}") and kind == "word" and token not in NO_STATEMENT:
            j = k
            while j < len(tokens) and tokens[j][1] not in (";", "{", "}"):
                j = matching(tokens, j) + 1 if tokens[j][1] in "([" else j + 1
            statement = tokens[k:j]
            if j < len(tokens) and tokens[j][1] == ";" and len(statement) > 2 and is_statement(statement):
                found.append(Mutant(file, text, begin, tokens[j][2], "", "drop"))
    return found


def is_statement(statement):
    """Says whether it is an assignment or a call, no declaration (two words, or a word and * or &, in a row)."""
    words = [token for _, token, _ in statement]
    if "reserve" in words or "shrink_to_fit" in words:
        return False
    depth = 0
    for (kind, token, _), (kind2, token2, _) in zip(statement, statement[1:]):
        depth += (token in "([") - (token in ")]")
        if depth == 0:
            if token in ("=", "+=", "-=", "*=", "/=", "++", "--"):
                return True
            if kind == "word" and (kind2 == "word" or token2 in ("*", "&", "<")):
                return False
            if token == ">" and kind2 == "word":
                return False
    return words[-1] == ")" or words[-1] in ("++", "--")


def sources(root, group):
    files = []
    for pattern in group[2]:
        found = [f for f in sorted((root / "src").glob(pattern)) if not LEFT_OUT.search(f.name)]
        if not found:
            raise LookupError(f"mutants.py: no file is src/{pattern} any more, of the group '{group[0]}'")
        files += found
    return [str(f.relative_to(root)) for f in dict.fromkeys(files)]


def name_places(mutants, text):
    """Gives each mutant of a file its place; equal ones are counted in their order."""
    seen = {}
    for mutant in sorted(mutants, key=lambda m: m.begin):
        words = mutant.words(text)
        seen[words] = seen.get(words, 0) + 1
        mutant.place = words if seen[words] == 1 else f"{words} ({seen[words]})"
    return mutants


def all_mutants(root):
    """Returns {group: {file: [mutants]}} of the tree at root."""
    texts = {file: (root / file).read_text() for group in GROUPS for file in sources(root, group)}
    return {group[0]: {file: name_places(mutants_of(file, texts[file]), texts[file])
                       for file in sources(root, group)} for group in GROUPS}


def sample(mutants, seed, size):
    """Draws from each group, spread over its files, in an order that mixes the groups."""
    groups = [group for group in GROUPS if any(mutants[group[0]].values())]
    total = sum(group[1] for group in groups)
    chosen = []
    for name, share, _ in groups:
        rng = random.Random(f"{seed} {name}")
        queues = []
        for file, candidates in sorted(mutants[name].items()):
            candidates = list(candidates)
            rng.shuffle(candidates)
            # Large files give more mutants, and each gives some.
            queues += [(n / (len(candidates) ** 0.5 or 1), rng.random(), m)
                       for n, m in enumerate(candidates)]
        wanted = max(1, round(share * size / total))
        queues.sort(key=lambda row: row[:2])
        chosen += [(n / wanted, name, m) for n, (_, _, m) in enumerate(queues[:wanted])]
    chosen.sort(key=lambda row: row[:2])
    return [(name, mutant) for _, name, mutant in chosen]


SELF_TEST = r'''#include <a + b>
// a + b
void f(double* x, const std::vector<double>& v) {
  const char* s = "a + b < c";
  double y = 1.5 * *x - v[3] / -x[0];  /* 1 + 2 */
  if (y <= 0 && !done(x)) return;
  x[0] += std::min(y, 1e-3);
  v.reserve(3);
  swap(x, v);
}
std::size_t bytes() const { return 8 * n + 2; }
'''
EXPECTED = [
    "3:50:return", "5:14:number", "5:18:*", "5:23:-", "5:30:/", "5:32:minus", "6:6:if", "6:9:<=<",
    "6:9:<=>=", "6:12:number", "6:14:&&||", "6:17:not", "7:3:drop", "7:8:+=", "7:16:min", "8:13:number",
    "9:3:drop"]


def self_test(root):
    found = sorted((m.id.split(":", 1)[1] for m in mutants_of("f", SELF_TEST)),
                   key=lambda i: (int(i.split(":")[0]), int(i.split(":")[1]), i))
    if found != EXPECTED:
        print("found   ", found, "\nexpected", EXPECTED)
        return 1
    moved = "\n\n" + SELF_TEST
    before, after = ([m.place for m in name_places(mutants_of("f", text), text)] for text in (SELF_TEST, moved))
    if before != after or len(set(before)) != len(before):
        print("places change when lines move, or are not told apart:", before)
        return 1
    try:
        sources(root, ("moved", 1, ["contact/laws/*", "no_room/none.cpp"]))
        print("a pattern that no file matches is not told")
        return 1
    except LookupError:
        pass
    mutants = all_mutants(root)
    counts = {name: sum(map(len, files.values())) for name, files in mutants.items()}
    print(counts)
    first, second = sample(mutants, 1, 100), sample(mutants, 1, 100)
    if [m.id for _, m in first] != [m.id for _, m in second] or min(counts.values()) < 100:
        print("samples of one seed differ, or a group lost its files")
        return 1
    return 0
