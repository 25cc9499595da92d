#pragma once
/// Reads meshes from files of mesh generators: Gmsh's .msh, versions 2 to 2.2 and 4.1, text or binary, and the .inp of
/// Abaqus and CalculiX.

#include <cstdint>
#include <string>
#include <vector>

#include "io/profile_lines.hpp"
#include "mesh/vec3.hpp"

namespace rollcon {

/// Holds all that a file calls by one name: elements, nodes, faces of volume elements. Lists are ascending.
struct MeshGroup {
  struct Face {
    std::int32_t element = 0, side = 0;
    bool operator==(const Face&) const = default;
    bool operator<(const Face& other) const {
      return element != other.element ? element < other.element : side < other.side;
    }
  };
  std::string name;
  std::vector<std::int32_t> element{}, node{};
  std::vector<Face> face{};
};

/// Holds a file's mesh, its nodes and elements counted from 0 in the order of the file, whatever their numbers there.
struct MeshFile {
  std::vector<Vec3> node;
  std::vector<std::int64_t> number;     ///< number of each node in the file
  std::vector<std::int32_t> type;       ///< type of each element: a number of VolumeType or ElementType; 0: a point or
                                        ///< line
  std::vector<std::int32_t> tag;        ///< tag of each element: Gmsh's physical group, else 0
  std::vector<std::int64_t> offset{0};  ///< elements + 1 offsets into connectivity
  std::vector<std::int32_t> connectivity;
  std::vector<MeshGroup> group;
  std::string told;  ///< kinds and numbers of what was passed over in the file; empty: nothing

  std::int64_t elements() const { return static_cast<std::int64_t>(type.size()); }
  std::int64_t nodes() const { return static_cast<std::int64_t>(node.size()); }
};

/// Reads the file in the format that the end of its name tells: .msh, .inp. Throws err_io naming the file and the line
/// (in binary files the byte).
MeshFile read_mesh_file(const std::string& path);

/// Returns what a body or a frame takes of the file: the elements of the group `part` (empty: all), only volumes with
/// the surfaces that name faces of theirs, or, if `volume` is false, only surfaces: of a group
/// of faces of volumes these faces. Volumes come first; nodes without
/// an element are left out; groups keep what is left of them, and the nodes of elements that are gone. Throws
/// err_argument if there is no such group, err_mesh if it has no such elements.
MeshFile part_of(const MeshFile& file, const std::string& path, const std::string& part, bool volume);

/// Calls f(type, n, connectivity, tag) for each run of elements of one type and tag.
template <class F>
void each_run(const MeshFile& file, F&& f) {
  for (std::size_t from = 0, to = 0; from < file.type.size(); from = to) {
    while (to < file.type.size() && file.type[to] == file.type[from] && file.tag[to] == file.tag[from]) ++to;
    f(file.type[from], static_cast<std::int64_t>(to - from), file.connectivity.data() + file.offset[from],
      file.tag[from]);
  }
}

/// Compares names whatever the case of their letters is.
bool same_name(const std::string& a, const std::string& b);
/// Lists names for messages: "top, bottom, ..."; "none" if there are none.
template <class Group>
std::string names_of(const std::vector<Group>& group) {
  constexpr std::size_t most_named = 16;
  std::string names;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (i == most_named) return names + ", ...";
    names += (i > 0 ? ", " : "") + printable(group[i].name);
  }
  return names.empty() ? "none" : names;
}

}  // namespace rollcon
