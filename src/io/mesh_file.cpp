#include "io/mesh_file.hpp"

#include <algorithm>

#include "io/abaqus_file.hpp"
#include "io/gmsh_file.hpp"
#include "mesh/element_type.hpp"
#include "mesh/volume_shape.hpp"
#include "mesh/volume_type.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

using Choice = std::vector<std::uint8_t>;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

const MeshGroup& group_named(const MeshFile& file, const std::string& path, const std::string& name) {
  for (const MeshGroup& g : file.group)
    if (same_name(g.name, name)) return g;
  fail(Status::err_argument, "part is '%s', which %s does not have; its groups: %s", printable(name).c_str(),
       path.c_str(), names_of(file.group).c_str());
}

/// Returns the faces of volume elements that a group names as a mesh of their own; other groups keep their nodes.
MeshFile mesh_of_faces(const MeshFile& file, const MeshGroup& group) {
  MeshFile result;
  result.node = file.node;
  result.number = file.number;
  result.told = file.told;
  for (const MeshGroup::Face& f : group.face) {
    const VolumeFace& side = faces_of(static_cast<VolumeType>(file.type[at(f.element)]))[at(f.side)];
    result.type.push_back(static_cast<std::int32_t>(side.type));
    result.tag.push_back(0);
    for (int k = 0; k < node_count(side.type); ++k)
      result.connectivity.push_back(file.connectivity[at(file.offset[at(f.element)] + side.node[at(k)])]);
    result.offset.push_back(std::ssize(result.connectivity));
  }
  for (const MeshGroup& g : file.group)
    if (!g.node.empty()) result.group.push_back({.name = g.name, .node = g.node});
  return result;
}

/// Chooses the elements of the part that have the wanted dimension.
Choice chosen_elements(const MeshFile& file, const std::string& path, const std::string& part, bool volume) {
  Choice chosen(file.type.size(), part.empty() ? 1 : 0);
  if (!part.empty())
    for (const std::int32_t e : group_named(file, path, part).element) chosen[at(e)] = 1;
  bool any = false;
  for (std::size_t e = 0; e < chosen.size(); ++e) {
    if (!(volume ? is_volume_type(file.type[e]) : is_element_type(file.type[e]))) chosen[e] = 0;
    any = any || chosen[e] != 0;
  }
  if (!any)
    fail(Status::err_mesh, "%s%s%s has no %s", path.c_str(), part.empty() ? "" : ", group ", printable(part).c_str(),
         volume ? "volume elements (tetrahedra, prisms, hexahedra)" : "surface elements (triangles, quadrilaterals)");
  return chosen;
}

/// Returns the number of nodes taken from an element: the boundary of volumes has no QUAD9.
std::int64_t taken_nodes(const MeshFile& file, std::int64_t e, bool volume) {
  const std::int64_t n = file.offset[at(e) + 1] - file.offset[at(e)];
  return volume && file.type[at(e)] == static_cast<std::int32_t>(ElementType::quad9) ? n - 1 : n;
}

/// Adds surface elements that volumes have all nodes of, if a name or a tag was given to them; others say nothing.
void add_naming_surfaces(const MeshFile& file, const Choice& node, Choice& chosen) {
  Choice named(file.type.size(), 0);
  for (const MeshGroup& g : file.group)
    for (const std::int32_t e : g.element) named[at(e)] = 1;
  for (std::int64_t e = 0; e < file.elements(); ++e) {
    if (!is_element_type(file.type[at(e)]) || (named[at(e)] == 0 && file.tag[at(e)] == 0)) continue;
    bool all = true;
    for (std::int64_t k = 0; k < taken_nodes(file, e, true); ++k)
      all = all && node[at(file.connectivity[at(file.offset[at(e)] + k)])] != 0;
    if (all) chosen[at(e)] = 1;
  }
}

}  // namespace

MeshFile read_mesh_file(const std::string& path) {
  const std::string name = in_lower_case(path);
  if (name.ends_with(".inp")) return read_abaqus_file(path);
  if (name.ends_with(".msh")) return read_gmsh_file(path);
  fail(Status::err_io, "%s: the name ends in neither .msh (Gmsh) nor .inp (Abaqus, CalculiX)", path.c_str());
}

MeshFile part_of(const MeshFile& file, const std::string& path, const std::string& part, bool volume) {
  if (!volume && !part.empty())
    if (const MeshGroup& g = group_named(file, path, part); !g.face.empty())
      return part_of(mesh_of_faces(file, g), path, "", false);
  Choice chosen = chosen_elements(file, path, part, volume), used(file.node.size(), 0);
  const auto nodes_of = [&](std::int64_t e, auto&& visit) {
    for (std::int64_t k = 0; k < taken_nodes(file, e, volume); ++k)
      visit(file.connectivity[at(file.offset[at(e)] + k)]);
  };
  for (std::int64_t e = 0; e < file.elements(); ++e)
    if (chosen[at(e)] != 0) nodes_of(e, [&](std::int32_t node) { used[at(node)] = 1; });
  if (volume) add_naming_surfaces(file, used, chosen);

  MeshFile result;
  result.told = file.told;
  std::vector<std::int32_t> node(file.node.size(), -1), element(file.type.size(), -1);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] == 0) continue;
    node[i] = static_cast<std::int32_t>(result.nodes());
    result.node.push_back(file.node[i]);
    result.number.push_back(file.number[i]);
  }
  for (const bool surfaces : {false, true}) {  // volumes first
    for (std::int64_t e = 0; e < file.elements(); ++e) {
      if (chosen[at(e)] == 0 || is_element_type(file.type[at(e)]) != surfaces) continue;
      element[at(e)] = static_cast<std::int32_t>(result.elements());
      const std::int64_t whole = file.offset[at(e) + 1] - file.offset[at(e)];
      const bool cut = taken_nodes(file, e, volume) < whole;
      result.type.push_back(cut ? static_cast<std::int32_t>(ElementType::quad8) : file.type[at(e)]);
      result.tag.push_back(file.tag[at(e)]);
      nodes_of(e, [&](std::int32_t n) { result.connectivity.push_back(node[at(n)]); });
      result.offset.push_back(static_cast<std::int64_t>(result.connectivity.size()));
    }
  }
  for (const MeshGroup& g : file.group) {
    MeshGroup kept{.name = g.name};
    for (const std::int32_t n : g.node)
      if (node[at(n)] >= 0) kept.node.push_back(node[at(n)]);
    for (const MeshGroup::Face& f : g.face)
      if (element[at(f.element)] >= 0) kept.face.push_back({element[at(f.element)], f.side});
    for (const std::int32_t e : g.element) {
      if (element[at(e)] >= 0)
        kept.element.push_back(element[at(e)]);
      else
        nodes_of(e, [&](std::int32_t n) {
          if (node[at(n)] >= 0) kept.node.push_back(node[at(n)]);
        });
    }
    std::sort(kept.element.begin(), kept.element.end());
    std::sort(kept.node.begin(), kept.node.end());
    kept.node.erase(std::unique(kept.node.begin(), kept.node.end()), kept.node.end());
    if (!kept.element.empty() || !kept.node.empty() || !kept.face.empty())
      result.group.push_back(std::move(kept));
    else if (part.empty() && volume)
      result.told += (result.told.empty() ? "" : "; ") + ("group without anything of the mesh: " + printable(g.name));
  }
  return result;
}

bool same_name(const std::string& a, const std::string& b) {
  return in_lower_case(a) == in_lower_case(b);
}

}  // namespace rollcon
