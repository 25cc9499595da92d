/// Reads meshes of bodies from files, and what the files have names for.

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "bodies/body.hpp"
#include "io/mesh_file.hpp"
#include "mesh/mesh_inputs.hpp"
#include "mesh/volume_faces.hpp"
#include "mesh/volume_shape.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

FaceNaming naming_of(std::int32_t type, std::int64_t n, const std::int32_t* connectivity, std::int32_t tag) {
  const auto t = static_cast<ElementType>(type);
  return {.tag = tag, .connectivity = {connectivity, connectivity + n * node_count(t)}, .type = t};
}

/// Returns the naming of one type in a list, which is made if there is none.
FaceNaming& of_type(std::vector<FaceNaming>& list, ElementType type) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const FaceNaming& n) { return n.type == type; });
  if (found != list.end()) return *found;
  list.push_back({.type = type});
  return list.back();
}

/// Takes out surface elements between two volume elements: files name interfaces of materials, which are no faces of
/// the body.
void drop_inner_faces(BodyMesh& mesh) {
  if (mesh.naming.empty()) return;
  std::vector<std::array<std::int32_t, 4>> inner;  // ascending
  for_each_face(sorted_faces(mesh.volume), [&](std::span<const CornerFace> same) {
    if (same.size() > 1) inner.push_back(same[0].corner);
  });
  for (FaceNaming& n : mesh.naming) {
    const auto nodes = static_cast<std::size_t>(node_count(n.type)),
               corners = static_cast<std::size_t>(corner_count(n.type));
    std::vector<std::int32_t> kept;
    for (std::size_t k = 0; k < n.connectivity.size(); k += nodes) {
      const std::span<const std::int32_t> element(n.connectivity.data() + k, nodes);
      if (!std::binary_search(inner.begin(), inner.end(), sorted_corners(element.first(corners))))
        kept.insert(kept.end(), element.begin(), element.end());
    }
    n.connectivity = std::move(kept);
  }
  std::erase_if(mesh.naming, [](const FaceNaming& n) { return n.connectivity.empty(); });
}

BodyGroup group_of(const MeshGroup& from, const MeshFile& file, const VolumeElements& volume) {
  BodyGroup group{.name = from.name, .node = from.node, .element = {}, .naming = {}};
  const auto volumes = static_cast<std::int32_t>(volume.elements());
  for (const std::int32_t e : from.element) {
    const auto i = static_cast<std::size_t>(e);
    const auto first = file.connectivity.begin() + file.offset[i],
               last = file.connectivity.begin() + file.offset[i + 1];
    group.node.insert(group.node.end(), first, last);
    if (e < volumes || volumes == 0) {
      group.element.push_back(e);
    } else {
      std::vector<std::int32_t>& faces = of_type(group.naming, static_cast<ElementType>(file.type[i])).connectivity;
      faces.insert(faces.end(), first, last);
    }
  }
  if (!from.face.empty()) {
    FaceNaming faces;
    for (const MeshGroup::Face& f : from.face) {
      faces.face.push_back({f.element, f.side});
      const VolumeFace& side =
          faces_of(volume.type[static_cast<std::size_t>(f.element)])[static_cast<std::size_t>(f.side)];
      for (int k = 0; k < node_count(side.type); ++k)
        group.node.push_back(
            volume.element(f.element)[static_cast<std::size_t>(side.node[static_cast<std::size_t>(k)])]);
    }
    group.naming.push_back(std::move(faces));
  }
  std::sort(group.node.begin(), group.node.end());
  group.node.erase(std::unique(group.node.begin(), group.node.end()), group.node.end());
  return group;
}

}  // namespace

void Body::read_mesh(const char* path, const char* part) {
  require_pointer(path, "path");
  require_pointer(part, "part");
  if (!traits_.meshed) fail(Status::err_state, "a %s has no mesh and takes no file of one", traits_.name);
  require_unprepared("mesh is");
  const MeshFile file = part_of(read_mesh_file(path), path, part, traits_.volume);
  if (!file.told.empty()) context_->log(LogLevel::warning, "%s: %s", path, file.told.c_str());
  const std::lock_guard lock(mutex_);
  require_takes_mesh();
  const char* setter = "rollcon_body_read_mesh";
  BodyMesh mesh = empty_mesh(file.nodes(), file.node.data()->data(), 3, 1);
  each_run(file, [&](std::int32_t type, std::int64_t n, const std::int32_t* nodes, std::int32_t tag) {
    if (!traits_.volume)
      append_elements(mesh.surface, type, n, nodes, 0, tag, "body", setter);
    else if (is_volume_type(type))
      append_elements(mesh.volume, file.nodes(), type, n, nodes, 0, tag, setter);
    else if (tag != 0)
      mesh.naming.push_back(naming_of(type, n, nodes, tag));
  });
  drop_inner_faces(mesh);
  mesh.passed_over = file.told;
  std::vector<BodyGroup> groups;
  for (const MeshGroup& g : file.group) groups.push_back(group_of(g, file, mesh.volume));
  std::swap(given(), mesh);
  std::swap(group_, groups);
  number_ = file.number;
}

const BodyGroup& Body::group(const char* name) const {
  require_pointer(name, "group");
  for (const BodyGroup& g : group_)
    if (same_name(g.name, name)) return g;
  fail(Status::err_argument, "the body's mesh has no group '%.60s'; its groups: %s", name, names_of(group_).c_str());
}

void Body::tag_group(const char* name, std::int32_t tag) {
  if (!traits_.meshed) fail(Status::err_state, "a %s has no mesh and takes no tags", traits_.name);
  const std::lock_guard lock(mutex_);
  require_unprepared("mesh is");
  const BodyGroup& g = group(name);
  BodyMesh& mesh = given();
  std::vector<std::int32_t>& tags = traits_.volume ? mesh.volume.tag : mesh.surface.tag;
  std::vector<FaceNaming> naming = g.naming;
  if (g.element.empty() && naming.empty()) naming.push_back({.nodes = g.node});  // the faces between its nodes
  for (FaceNaming& n : naming) {
    n.tag = tag;
    if (traits_.filled())
      mesh.naming.push_back(std::move(n));
    else
      tag_by_nodes(n, mesh.surface);
  }
  for (const std::int32_t e : g.element) tags[static_cast<std::size_t>(e)] = tag;
  mesh.boundary_current = false;
}

std::span<const std::int64_t> Body::node_numbers() const {
  return traits_.section ? std::span<const std::int64_t>{} : number_;  // a section's surface has nodes of its own
}

std::int32_t Body::group_count() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::int32_t>(group_.size());
}

std::string Body::group_name(std::int64_t i) const {
  const std::lock_guard lock(mutex_);
  if (i < 0 || i >= static_cast<std::int64_t>(group_.size()))
    fail(Status::err_argument, "i is %lld; the body's mesh has %lld groups", static_cast<long long>(i),
         static_cast<long long>(group_.size()));
  return group_[static_cast<std::size_t>(i)].name;
}

std::vector<std::int32_t> Body::group_nodes(const char* name) const {
  const std::lock_guard lock(mutex_);
  return group(name).node;
}

}  // namespace rollcon
