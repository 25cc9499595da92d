#include "bodies/frame_on_body.hpp"

#include <algorithm>
#include <map>

#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// Nodes this part of an element's diameter apart are one.
constexpr double coincidence = 1e-6;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

std::vector<SurfacePoint> project(const Frame& frame, const Body& body, const Pose& pose,
                                  int which) {
  const Vec3 direction = pose.turn_back(frame.axes.n);
  const Vec3 facing = (which == 0 ? 1.0 : -1.0) * direction;
  std::vector<SurfacePoint> on_body(at(frame.nodes()));
  std::int64_t missing = 0, first = -1;
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    if (!frame.used[at(k)]) continue;
    const auto hit = body.search().along(pose.to_body(frame.mesh.node[at(k)]), direction, facing);
    if (hit) {
      on_body[at(k)] = *hit;
    } else if (missing++ == 0) {
      first = k;
    }
  }
  if (missing > 0)
    fail(Status::err_mesh,
         "node %lld of the contact frame (counting from %d) and %lld others have no contact face "
         "of body %d above or below them, along the normal of the axes: check axes, poses and "
         "rollcon_body_set_contact_faces",
         static_cast<long long>(first) + frame.mesh.index_base, frame.mesh.index_base,
         static_cast<long long>(missing) - 1, which + 1);
  return on_body;
}

/// The body's node at a point found on it; -1: none.
std::int32_t node_at(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const double reach = coincidence * element_diameter(mesh, point.element);
  for (const std::int32_t k : mesh.element(point.element))
    if (length(mesh.node[at(k)] - point.x) <= reach) return k;
  return -1;
}

/// The faces of the body that the frame's elements are; empty when one is none.
std::vector<std::int64_t> matching_faces(const Frame& frame, const SurfaceMesh& mesh,
                                         const std::vector<std::int64_t>& candidates,
                                         const std::vector<std::int32_t>& node) {
  std::map<std::vector<std::int32_t>, std::int64_t> face_of_nodes;
  const auto sorted = [](std::vector<std::int32_t> nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  };
  for (const std::int64_t e : candidates) {
    const auto nodes = mesh.element(e);
    face_of_nodes[sorted({nodes.begin(), nodes.end()})] = e;
  }
  std::vector<std::int64_t> face;
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    std::vector<std::int32_t> nodes;
    for (const std::int32_t k : frame.mesh.element(e)) nodes.push_back(node[at(k)]);
    const auto found = face_of_nodes.find(sorted(nodes));
    if (found == face_of_nodes.end() || mesh.type[at(found->second)] != frame.mesh.type[at(e)])
      return {};
    face.push_back(found->second);
  }
  std::sort(face.begin(), face.end());
  if (std::adjacent_find(face.begin(), face.end()) != face.end()) return {};
  return face;
}

/// Nodes of the elements found and of all contact elements that touch them, ascending.
std::vector<std::int32_t> nodes_around(const SurfaceMesh& mesh,
                                       const std::vector<std::int64_t>& candidates,
                                       const std::vector<SurfacePoint>& point) {
  std::vector<std::uint8_t> touched(at(mesh.nodes()), 0), wanted(at(mesh.nodes()), 0);
  for (const SurfacePoint& p : point)
    if (p.element >= 0)
      for (const std::int32_t k : mesh.element(p.element)) touched[at(k)] = 1;
  for (const std::int64_t e : candidates) {
    const auto nodes = mesh.element(e);
    if (std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t k) { return touched[at(k)]; }))
      for (const std::int32_t k : nodes) wanted[at(k)] = 1;
  }
  std::vector<std::int32_t> row;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (wanted[k]) row.push_back(static_cast<std::int32_t>(k));
  return row;
}

void refuse_held_faces(const BodyMesh& mesh, const std::vector<SurfacePoint>& point, int which) {
  const std::vector<std::uint8_t> held = held_elements(mesh);
  for (const SurfacePoint& p : point)
    if (p.element >= 0 && held[at(p.element)] == 7)
      fail(Status::err_state,
           "the contact frame lies on element %lld (counting from %d) of body %d, which is held by "
           "a support",
           static_cast<long long>(p.element) + mesh.surface.index_base, mesh.surface.index_base,
           which + 1);
}

}  // namespace

FrameOnBody lay_on_body(const Frame& frame, const Body& body, const Pose& pose, int which) {
  const SurfaceMesh& mesh = body.mesh().surface;
  const std::vector<std::int64_t> candidates = contact_elements(body.mesh());
  if (candidates.empty())
    fail(Status::err_state,
         "body %d has no face that may come into contact: all are held or loaded; "
         "rollcon_body_set_contact_faces names those that may all the same",
         which + 1);
  const std::vector<SurfacePoint> point = project(frame, body, pose, which);
  refuse_held_faces(body.mesh(), point, which);
  FrameOnBody result;
  result.node.assign(at(frame.nodes()), -1);
  bool all = true;
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    if (!frame.used[at(k)]) continue;
    result.node[at(k)] = node_at(mesh, point[at(k)]);
    all = all && result.node[at(k)] >= 0;
  }
  if (all) result.face = matching_faces(frame, mesh, candidates, result.node);
  if (result.matches()) return result;
  result.layer = frame.mesh;
  for (std::int64_t k = 0; k < frame.nodes(); ++k)
    result.layer.node[at(k)] = frame.used[at(k)] ? point[at(k)].x : Vec3{0, 0, 0};
  result.row = nodes_around(mesh, candidates, point);
  return result;
}

}  // namespace rollcon
