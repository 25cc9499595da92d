#include "io/abaqus_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_set>

#include "io/mesh_builder.hpp"
#include "io/profile_lines.hpp"
#include "mesh/volume_type.hpp"

namespace rollcon {
namespace {

using Words = std::vector<std::string_view>;

std::string in_upper_case(std::string_view text) {
  std::string s(text);
  for (char& c : s)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return s;
}

/// Splits a line into what stands between commas, without blanks around it; nothing follows a last comma.
void split(std::string_view line, Words& words) {
  words.clear();
  while (true) {
    const std::size_t to = std::min(line.find(','), line.size());
    words.push_back(trimmed(line.substr(0, to)));
    if (to == line.size()) break;
    line.remove_prefix(to + 1);
  }
  while (!words.empty() && words.back().empty()) words.pop_back();
}

std::optional<std::int64_t> integer(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

std::int32_t sides_of(std::int32_t type) {
  const int corners = corner_count(static_cast<VolumeType>(type));
  return corners == 4 ? 4 : corners == 6 ? 5 : 6;
}

struct Keyword {
  std::string name;                         ///< in upper case, without blanks
  std::map<std::string, std::string> with;  ///< parameters, in upper case; values unchanged

  std::string value(const char* parameter) const {
    const auto found = with.find(parameter);
    return found == with.end() ? "" : found->second;
  }
  bool has(const char* parameter) const { return with.contains(parameter); }
};

/// Holds members of a set or a surface, until all nodes and elements are known.
struct Mention {
  enum Kind { node, element, face, set, faces_of_set, nodes_of_set } kind;
  std::size_t group;
  std::int64_t first, last = 0, step = 1;  ///< numbers in the file; for a set, its group
  std::int32_t side = -1;
  std::int64_t line = 0;
  bool listed = true;  ///< one by one, not as a range
};

class AbaqusReader {
 public:
  explicit AbaqusReader(const std::string& path)
      : lines_(path, std::uintmax_t{1} << 34U),
        mesh_(lines_.bytes(), [this](std::int64_t line, const std::string& what) { lines_.fail_at(line, what); }) {}

  MeshFile read() {
    bool any = false;
    for (std::string_view line; lines_.next(line);) {
      line = trimmed(line);
      if (line.empty() || line.starts_with("**")) continue;
      if (line.front() == '*') {
        begin(line);
        any = true;
      } else if (!any) {
        lines_.fail_here("no keyword, which begins with *, before it: no Abaqus file");
      } else {
        take(line);
      }
    }
    end_block();
    if (mesh_.elements() == 0) lines_.fail_whole("it has no *ELEMENT of a surface or a volume");
    mesh_.finish_mesh();
    for (const Mention& m : mention_) resolve(m);
    MeshFile file = mesh_.take();
    for (const auto& [kind, n] : passed_)
      file.told += (file.told.empty() ? "passed over: " : ", ") + printable(kind) + " (" + std::to_string(n) + ")";
    return file;
  }

 private:
  /// Begins a keyword, whose line goes on in the next one where it ends in a comma.
  void begin(std::string_view line) {
    end_block();
    std::string whole(line);
    while (whole.ends_with(',') && lines_.next(line)) {
      whole += trimmed(line);
      constexpr std::size_t most = 10'000;
      if (whole.size() > most) lines_.fail_here("a keyword of more than 10000 letters");
    }
    Words words;
    split(std::string_view(whole).substr(1), words);
    now_ = {};
    take_line_ = nullptr;
    goes_on_ = false;
    if (words.empty()) return;
    for (const char c : in_upper_case(words[0]))
      if (c != ' ' && c != '\t') now_.name += c;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t equal = std::min(words[i].find('='), words[i].size());
      const std::string_view value = equal < words[i].size() ? trimmed(words[i].substr(equal + 1)) : std::string_view{};
      now_.with[in_upper_case(trimmed(words[i].substr(0, equal)))] = unquoted(value);
    }
    open_block();
  }

  static std::string unquoted(std::string_view text) {
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return std::string(text);
  }

  std::string needed(const char* parameter) {
    std::string value = now_.value(parameter);
    if (value.empty()) lines_.fail_here("*" + now_.name + " without " + parameter);
    return value;
  }

  void open_block() {
    const std::string& name = now_.name;
    for (const char* maker : {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYMMETRICMODELGENERATION",
                              "CYCLICSYMMETRYMODEL", "IMPORT"})
      if (name == maker) lines_.fail_here("*" + name + " is not read: write all nodes and elements out");
    for (const char* reader : {"NODE", "ELEMENT", "NSET", "ELSET", "SURFACE"})
      if (name == reader && now_.has("INPUT"))
        lines_.fail_here("*" + name + " with INPUT is not followed: put the mesh into one file");
    for (const char* other : {"SURFACEDEFINITION", "RIGIDSURFACE", "MODELCHANGE", "REFINEMESH", "ADAPTIVEMESH", "MESH"})
      if (name == other) pass("*" + name);
    if (name == "INCLUDE") lines_.fail_here("*INCLUDE is not followed: put the mesh into one file");
    if (name == "SYSTEM") lines_.fail_here("*SYSTEM is not read: write nodes in the global axes");
    if (name == "PART" && ++parts_ > 1)
      lines_.fail_here("a second *PART, in which numbers begin anew: write a flat file, or one part");
    if (name == "INSTANCE") {
      if (++instances_ > 1) lines_.fail_here("a second *INSTANCE: write a flat file, or one instance");
      take_line_ = &AbaqusReader::refuse_place;
    }
    if (name == "NODE") {
      if (const std::string system = in_upper_case(now_.value("SYSTEM")); !system.empty() && system != "R")
        lines_.fail_here("*NODE with SYSTEM=" + printable(system) + "; allowed: R (rectangular)");
      take_line_ = &AbaqusReader::take_node;
      open_group("NSET");
    } else if (name == "ELEMENT") {
      const std::string given = in_upper_case(needed("TYPE"));
      bool unsupported = false;
      type_ = abaqus_type(given, unsupported);
      if (unsupported)
        lines_.fail_here("elements of type " + printable(given) +
                         "; allowed: solids of 4, 6, 8, 10, 15, 20 and 27 nodes, surfaces of 3, 4, 6, 8 and 9");
      take_line_ = type_ ? &AbaqusReader::take_element : &AbaqusReader::pass_element;
      open_group("ELSET");
    } else if (name == "NSET" || name == "ELSET") {
      if (name == "NSET" && now_.has("GENERATE") && now_.has("ELSET"))
        lines_.fail_here("*NSET with both GENERATE and ELSET");
      group_ = mesh_.group(needed(name.c_str()));
      take_line_ = now_.has("GENERATE") ? &AbaqusReader::take_range : &AbaqusReader::take_members;
      if (name == "NSET" && now_.has("ELSET")) {  // the nodes of the set's elements
        add_mention(Mention::nodes_of_set, known_set(now_.value("ELSET")), 0, 1);
      }
    } else if (name == "SURFACE") {
      const std::string type = in_upper_case(now_.value("TYPE"));
      const std::string combine = in_upper_case(now_.value("COMBINE"));
      if (!combine.empty() && combine != "UNION") return pass("surfaces combined by " + combine);
      if (!type.empty() && type != "ELEMENT" && type != "NODE") return pass("surfaces of type " + type);
      group_ = mesh_.group(needed("NAME"));
      take_line_ = combine.empty() && type != "NODE" ? &AbaqusReader::take_face : &AbaqusReader::take_members;
    }
  }

  void open_group(const char* parameter) {
    grouped_ = !now_.value(parameter).empty();
    if (grouped_) group_ = mesh_.group(now_.value(parameter));
  }

  void end_block() {
    if (!number_.empty())
      lines_.fail_at(element_line_, "an element of " + std::to_string(number_.size() - 1) + " nodes; its type has " +
                                        std::to_string(type_->given));
  }

  void take(std::string_view line) {
    if (!take_line_) return;
    split(line, words_);
    if (!words_.empty()) (this->*take_line_)();
    goes_on_ = line.ends_with(',');
  }

  std::int64_t number(std::string_view text) {
    const auto value = integer(text);
    if (!value) lines_.fail_here("'" + printable(text) + "' is no integer");
    return *value;
  }

  void refuse_place() { lines_.fail_here("an *INSTANCE that is moved: write nodes in the global axes"); }

  void take_node() {
    if (words_.size() > 7)
      lines_.fail_here(std::to_string(words_.size()) + " entries; needed: a number and 3 coordinates");
    Vec3 x{0, 0, 0};
    for (std::size_t c = 0; c < 3 && c + 1 < words_.size(); ++c)
      x[c] = words_[c + 1].empty() ? 0 : lines_.number_in(words_[c + 1]);
    const std::int64_t id = number(words_[0]);
    mesh_.add_node(id, x, lines_.number());
    if (grouped_) add_mention(Mention::node, id);
  }

  /// Counts, by kind, keywords that make or name mesh and are not read.
  void pass(const std::string& kind) { ++passed_[kind]; }

  /// Counts an element of a kind that rollcon does not have.
  void pass_element() {
    if (goes_on_) return;
    pass("elements of type " + in_upper_case(now_.value("TYPE")));
    if (const auto id = integer(words_[0])) passed_element_.insert(*id);
  }

  /// Takes an element, which may go on over several lines.
  void take_element() {
    if (number_.empty()) element_line_ = lines_.number();
    for (const std::string_view word : words_) number_.push_back(number(word));
    const auto needed = static_cast<std::size_t>(type_->given) + 1;
    if (number_.size() > needed) end_block();
    if (number_.size() < needed) return;
    mesh_.add_element(number_[0], *type_, number_.data() + 1, 0, element_line_);
    if (grouped_) add_mention(Mention::element, number_[0]);
    number_.clear();
  }

  void add_mention(Mention::Kind kind, std::int64_t first, std::int64_t last, std::int64_t step) {
    mention_.push_back({kind, group_, first, last, step, -1, lines_.number()});
  }
  /// Adds a member; numbers that follow each other are one mention.
  void add_mention(Mention::Kind kind, std::int64_t id) {
    if (!mention_.empty()) {
      Mention& last = mention_.back();
      if (last.kind == kind && last.group == group_ && last.listed && last.last < id && last.last == id - 1) {
        last.last = id;
        return;
      }
    }
    add_mention(kind, id, id, 1);
  }

  Mention::Kind kind_of_set() const { return now_.name == "ELSET" ? Mention::element : Mention::node; }

  void take_range() {
    if (words_.size() < 2 || words_.size() > 3)
      lines_.fail_here(std::to_string(words_.size()) + " entries; needed: first, last and step");
    const std::int64_t first = number(words_[0]), last = number(words_[1]),
                       step = words_.size() > 2 ? number(words_[2]) : 1;
    if (step < 1 || first > last) lines_.fail_here("a range that goes nowhere");
    add_mention(kind_of_set(), first, last, step);
    mention_.back().listed = false;
  }

  void take_members() {
    for (const std::string_view word : words_) {
      if (const auto id = integer(word))
        add_mention(kind_of_set(), *id);
      else if (!word.empty() && !is_weight(word))
        add_set(word);
    }
  }

  /// Says whether a word is the area that surfaces of nodes may have behind each node.
  bool is_weight(std::string_view word) const { return now_.name == "SURFACE" && word.find('.') != word.npos; }

  std::int64_t known_set(std::string_view name) {
    const std::int64_t found = mesh_.find_group(unquoted(name));
    if (found < 0) lines_.fail_here("no set '" + printable(name) + "' before this line");
    return found;
  }

  void add_set(std::string_view name) { add_mention(Mention::set, known_set(name), 0, 1); }

  void take_face() {
    const std::string side = words_.size() > 1 ? in_upper_case(words_[1]) : "";
    std::int32_t s = -1;  // the elements themselves, for surface elements
    if (side.size() == 2 && side[0] == 'S' && side[1] >= '1' && side[1] <= '6')
      s = side[1] - '1';
    else if (side == "EDGE" || side.starts_with("END") || (side.size() == 2 && side[0] == 'E'))
      return pass("edges and ends in surfaces");
    else if (!side.empty() && side != "SPOS" && side != "SNEG")
      lines_.fail_here("face '" + printable(side) + "'; allowed: S1 to S6, SPOS, SNEG");
    const auto id = integer(words_[0]);
    add_mention(id ? Mention::face : Mention::faces_of_set, id ? *id : known_set(words_[0]), 0, 1);
    mention_.back().side = s;
  }

  // --------------------------------------------------------- once nodes and elements are known

  void put_face(std::size_t group, std::int64_t element, std::int32_t side, std::int64_t line) {
    const std::int32_t type = mesh_.type_of(element);
    if (is_volume_type(type)) {
      const std::int32_t sides = sides_of(type);
      if (side < 0 || side >= sides)
        lines_.fail_at(line, "face " + (side < 0 ? std::string("missing") : "S" + std::to_string(side + 1)) +
                                 " of an element; allowed for its type: S1 to S" + std::to_string(sides));
      mesh_.put_face(group, element, side, line);
    } else {
      mesh_.put_element(group, element, line);
    }
  }

  void resolve(const Mention& m) {
    switch (m.kind) {
      case Mention::node:
      case Mention::element: {
        const bool node = m.kind == Mention::node;
        const Numbering& numbers = node ? mesh_.node_numbers() : mesh_.element_numbers();
        numbers.each_between(m.first, m.last, m.step, [&](std::int64_t k) {
          node ? mesh_.put_node(m.group, k, m.line) : mesh_.put_element(m.group, k, m.line);
        });
        for (std::int64_t i = 0; m.listed && i <= m.last - m.first; ++i)
          if (numbers.find(m.first + i) < 0 && (node || !passed_element_.contains(m.first + i)))
            pass(node ? "nodes of sets, not in the file" : "elements of sets, not in the file");
        break;
      }
      case Mention::face: {
        const std::int64_t element = mesh_.element_numbers().find(m.first);
        if (passed_element_.contains(m.first)) return pass("faces of elements that are passed over");
        if (element < 0) lines_.fail_at(m.line, "there is no element " + std::to_string(m.first));
        put_face(m.group, element, m.side, m.line);
        break;
      }
      case Mention::set:
        mesh_.put_group(m.group, static_cast<std::size_t>(m.first), m.line);
        break;
      case Mention::faces_of_set:
      case Mention::nodes_of_set: {
        const std::vector<std::int32_t> elements = mesh_.members(static_cast<std::size_t>(m.first)).element;
        for (const std::int32_t e : elements)
          if (m.kind == Mention::faces_of_set)
            put_face(m.group, e, m.side, m.line);
          else
            mesh_.put_nodes_of(m.group, e, m.line);
      }
    }
  }

  TextLines lines_;
  MeshBuilder mesh_;
  Keyword now_;
  void (AbaqusReader::*take_line_)() = nullptr;
  Words words_;
  int parts_ = 0, instances_ = 0;
  const ForeignType* type_ = nullptr;
  bool grouped_ = false;
  std::size_t group_ = 0;
  std::vector<std::int64_t> number_;  ///< numbers of the element that is being read
  std::int64_t element_line_ = 0;
  std::vector<Mention> mention_;
  bool goes_on_ = false;  ///< true if the line before ends in a comma
  std::map<std::string, int> passed_;
  std::unordered_set<std::int64_t> passed_element_;
};

}  // namespace

MeshFile read_abaqus_file(const std::string& path) {
  return AbaqusReader(path).read();
}

}  // namespace rollcon
