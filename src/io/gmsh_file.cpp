#include "io/gmsh_file.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <map>
#include <utility>

#include "io/gmsh_numbers.hpp"
#include "io/mesh_builder.hpp"
#include "io/profile_lines.hpp"
#include "io/whole_file.hpp"

namespace rollcon {
namespace {

constexpr std::array<const char*, 4> dimension_names{"point", "curve", "surface", "volume"};
constexpr int most_given = 27;              ///< most nodes of an element
constexpr std::int32_t any_dimension = -1;  ///< dimension of a name in Gmsh 2.0, which writes none

class GmshReader {
 public:
  explicit GmshReader(const std::string& path)
      : in_(path, whole_file(path, std::uintmax_t{1} << 34U)),
        mesh_(in_.bytes(), [this](std::int64_t at, const std::string& what) { in_.fail_at(at, what); }) {}

  MeshFile read() {
    read_format();
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word()) {
      if (!word.starts_with('$')) in_.fail_here("'" + printable(word) + "' where a section should begin");
      read_section(std::string(word.substr(1)));
    }
    if (!seen_nodes_) in_.fail_here("there is no section Nodes: truncated");
    mesh_.finish_mesh();
    for (const Member& m : member_) mesh_.put_element(m.group, m.element, m.at);
    return mesh_.take();
  }

 private:
  struct Member {
    std::size_t group;
    std::int64_t element, at;
  };

  void read_format() {
    if (in_.word() != "$MeshFormat")
      in_.fail_here("it does not begin with $MeshFormat: no Gmsh file of version 2 or 4");
    const std::string_view version = in_.word();
    if (version != "2" && version != "2.0" && version != "2.1" && version != "2.2" && version != "4.1")
      in_.fail_here("it is of version '" + printable(version) + "'; allowed: 2 to 2.2 and 4.1 (gmsh -format msh41)");
    fourth_ = version == "4.1";
    const std::int32_t binary = in_.int4(), bytes = in_.int4();
    if (binary != 0 && binary != 1) in_.fail_here("its type is " + std::to_string(binary) + "; allowed: 0, 1");
    if (bytes != 8) in_.fail_here("it counts on numbers of " + std::to_string(bytes) + " bytes; allowed: 8");
    if (binary == 1) {
      in_.end_line();
      in_.use_binary();
      if (in_.int4() != 1) in_.fail_here("it was written with another byte order");
    }
    if (in_.word() != "$EndMeshFormat") in_.fail_here("$EndMeshFormat is missing");
  }

  void read_section(const std::string& name) {
    if (name == "PhysicalNames") return read_names();
    if (name == "PartitionedEntities") in_.fail_here("the mesh is partitioned: save it without partitions");
    const bool ours = name == "Nodes" || name == "Elements" || (fourth_ && name == "Entities");
    if (ours && fourth_ && in_.binary()) in_.end_line();
    if (name == "Entities" && fourth_) read_entities();
    if (name == "Nodes") {
      if (std::exchange(seen_nodes_, true)) in_.fail_here("a second section Nodes");
      fourth_ ? read_nodes_4() : read_nodes_2();
    }
    if (name == "Elements") fourth_ ? read_elements_4() : read_elements_2();
    if (ours && in_.word() != "$End" + name)
      in_.fail_here("$End" + name + " is missing: the numbers are too many or few");
    if (!ours) in_.skip_section(name);
  }

  /// Reads names, which are text in files of both kinds.
  void read_names() {
    const std::int64_t n = text_integer(in_.word());
    for (std::int64_t i = 0; i < n; ++i) {
      std::int64_t dimension = text_integer(in_.word()), number = dimension;
      const std::string_view line = in_.rest_of_line();
      const std::size_t from = line.find('"'), to = line.rfind('"');
      if (from == std::string_view::npos || to <= from + 1 || to - from > 1024)
        in_.fail_here("no name in quotation marks");
      if (const std::string_view second = trimmed(line.substr(0, from)); !second.empty())
        number = text_integer(second);
      else
        dimension = any_dimension;
      if (dimension < any_dimension || dimension > 3)
        in_.fail_here("dimension " + std::to_string(dimension) + "; allowed: 0 to 3");
      names_[{static_cast<std::int32_t>(dimension), number}] = line.substr(from + 1, to - from - 1);
    }
    in_.skip_section("PhysicalNames");
  }

  std::int64_t text_integer(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
      in_.fail_here("'" + printable(text) + "' is no integer");
    return value;
  }

  std::size_t group_of(std::int32_t dimension, std::int64_t number) {
    const auto [entry, made] = groups_.try_emplace({dimension, number}, 0);
    if (made) {
      auto named = names_.find({dimension, number});
      if (named == names_.end()) named = names_.find({any_dimension, number});
      entry->second =
          mesh_.group(named != names_.end() ? named->second
                                            : std::string(dimension_names[static_cast<std::size_t>(dimension)]) + " " +
                                                  std::to_string(number));
    }
    return entry->second;
  }

  // ------------------------------------------------------------------------------- version 2

  /// Reads the number of entries, which is text in files of both kinds.
  std::int64_t count_of_section() {
    const std::int64_t n = text_integer(in_.word());
    if (in_.binary()) in_.end_line();
    return n;
  }

  void read_nodes_2() {
    const std::int64_t n = in_.count(count_of_section(), 4, "nodes");
    for (std::int64_t i = 0; i < n; ++i) {
      const std::int64_t number = in_.int4();
      read_node(number);
    }
  }

  void read_node(std::int64_t number) {
    Vec3 x;
    for (double& c : x) c = in_.real();
    mesh_.add_node(number, x, in_.at());
  }

  void read_elements_2() {
    const std::int64_t n = in_.count(count_of_section(), 1, "elements");
    for (std::int64_t done = 0; done < n;) {
      std::int64_t number = 0;
      if (!in_.binary()) number = in_.int4();
      const std::int32_t type = in_.int4();
      const std::int32_t alike = in_.binary() ? in_.int4() : 1;
      const std::int32_t tags = in_.int4();
      if (alike < 1 || alike > n - done) in_.fail_here("a block of " + std::to_string(alike) + " elements");
      in_.count(tags, 1, "an element's tags");
      for (std::int32_t i = 0; i < alike; ++i, ++done) {
        if (in_.binary()) number = in_.int4();
        std::int32_t physical = 0;
        for (std::int32_t t = 0; t < tags; ++t) {
          const std::int32_t tag = in_.int4();
          if (t == 0) physical = tag;
        }
        if (const std::int64_t element = read_element(number, type, magnitude(physical)); physical != 0)
          member_.push_back({group_of(dimension_of(type), magnitude(physical)), element, in_.at()});
      }
    }
  }

  /// Returns the number without its sign, which would turn an element of lower dimension over.
  static std::int32_t magnitude(std::int32_t physical) { return physical == INT32_MIN ? 0 : std::abs(physical); }

  static std::int32_t dimension_of(std::int32_t type) {
    const std::int32_t ours = gmsh_type(type)->type;
    return type == 15 ? 0 : ours == 0 ? 1 : ours / 100;
  }

  std::int64_t read_element(std::int64_t number, std::int32_t type, std::int32_t tag) {
    const ForeignType* t = gmsh_type(type);
    if (!t)
      in_.fail_here(
          "element " + std::to_string(number) + " is of Gmsh's type " + std::to_string(type) +
          "; allowed: triangles, quadrilaterals, tetrahedra, prisms and hexahedra of orders 1 and 2 (no pyramids)");
    std::array<std::int64_t, most_given> nodes{};
    for (int k = 0; k < t->given; ++k) nodes[static_cast<std::size_t>(k)] = fourth_ ? in_.size8() : in_.int4();
    mesh_.add_element(number, *t, nodes.data(), tag, in_.at());
    return mesh_.elements() - 1;
  }

  // ----------------------------------------------------------------------------- version 4.1

  void read_entities() {
    std::array<std::int64_t, 4> n{};
    for (std::int64_t& count : n) count = in_.size8();
    for (std::int32_t dimension = 0; dimension < 4; ++dimension) {
      in_.count(n[static_cast<std::size_t>(dimension)], 4, "entities");
      for (std::int64_t i = 0; i < n[static_cast<std::size_t>(dimension)]; ++i) {
        const std::int32_t entity = in_.int4();
        for (int c = 0; c < (dimension == 0 ? 3 : 6); ++c) in_.real();
        std::vector<std::int32_t>& physical = physicals_[{dimension, entity}];
        for (std::int64_t k = in_.count(in_.size8(), 1, "physical groups of an entity"); k > 0; --k)
          physical.push_back(magnitude(in_.int4()));
        if (dimension == 0) continue;
        for (std::int64_t k = in_.count(in_.size8(), 1, "bounds of an entity"); k > 0; --k) in_.int4();
      }
    }
  }

  void read_nodes_4() {
    const std::int64_t blocks = in_.count(in_.size8(), 4, "blocks of nodes");
    const std::int64_t all = in_.count(in_.size8(), 4, "nodes");
    in_.size8();
    in_.size8();
    std::int64_t read = 0;
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::int32_t dimension = in_.int4();
      in_.int4();
      const std::int32_t parametric = in_.int4();
      if (dimension < 0 || dimension > 3) in_.fail_here("dimension " + std::to_string(dimension) + "; allowed: 0 to 3");
      const std::int64_t n = in_.count(in_.size8(), 4, "nodes of a block");
      number_.clear();
      for (std::int64_t i = 0; i < n; ++i) number_.push_back(in_.size8());
      for (std::int64_t i = 0; i < n; ++i) {
        read_node(number_[static_cast<std::size_t>(i)]);
        for (std::int32_t k = 0; parametric != 0 && k < dimension; ++k) in_.real();
      }
      read += n;
    }
    if (read != all)
      in_.fail_here("the blocks have " + std::to_string(read) + " nodes; announced: " + std::to_string(all));
  }

  void read_elements_4() {
    const std::int64_t blocks = in_.count(in_.size8(), 4, "blocks of elements");
    const std::int64_t all = in_.count(in_.size8(), 2, "elements");
    in_.size8();
    in_.size8();
    std::int64_t read = 0;
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::int32_t dimension = in_.int4(), entity = in_.int4(), type = in_.int4();
      const std::int64_t n = in_.count(in_.size8(), 2, "elements of a block");
      const auto found = physicals_.find({dimension, entity});
      static const std::vector<std::int32_t> none;
      const std::vector<std::int32_t>& physical = found == physicals_.end() ? none : found->second;
      for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t number = in_.size8();
        const std::int64_t element = read_element(number, type, physical.empty() ? 0 : physical.front());
        if (i == 0 && dimension != dimension_of(type))
          in_.fail_here("elements of type " + std::to_string(type) + " in an entity of dimension " +
                        std::to_string(dimension));
        for (const std::int32_t p : physical) {
          if (static_cast<std::int64_t>(member_.size()) > in_.bytes())
            in_.fail_here("the groups have too many members for a file of this size");
          member_.push_back({group_of(dimension, p), element, in_.at()});
        }
      }
      read += n;
    }
    if (read != all)
      in_.fail_here("the blocks have " + std::to_string(read) + " elements; announced: " + std::to_string(all));
  }

  GmshNumbers in_;
  MeshBuilder mesh_;
  bool fourth_ = false, seen_nodes_ = false;
  std::map<std::pair<std::int32_t, std::int64_t>, std::string> names_;
  std::map<std::pair<std::int32_t, std::int64_t>, std::size_t> groups_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> physicals_;  ///< physical groups of an
                                                                                          ///< entity
  std::vector<Member> member_;
  std::vector<std::int64_t> number_;  ///< workspace
};

}  // namespace

MeshFile read_gmsh_file(const std::string& path) {
  return GmshReader(path).read();
}

}  // namespace rollcon
