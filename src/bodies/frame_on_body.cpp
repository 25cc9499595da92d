#include "bodies/frame_on_body.hpp"

#include <algorithm>

#include "bodies/missed_nodes.hpp"
#include "mesh/topology.hpp"
#include "mesh/turned_over.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

std::vector<SurfacePoint> project(const Frame& frame, const std::vector<std::uint8_t>& belongs, const Body& body,
                                  const Pose& pose, int which) {
  std::vector<SurfacePoint> on_body(at(frame.nodes()));
  MissedNodes missed(frame, body, pose, which);
  for (std::size_t k = 0; k < on_body.size(); ++k) {
    if (!belongs[k]) continue;
    const auto hit = meet_contact_faces(frame, k, frame.axes.n, body, pose, which);
    if (hit)
      on_body[k] = *hit;
    else
      missed.add(k, frame.axes.n);
  }
  missed.fail_if_any();
  return on_body;
}

/// Returns the node of the element found that stands on the line to it; -1: none.
std::int32_t node_at(const SurfaceMesh& mesh, const SurfacePoint& point, const Vec3& from, const Vec3& direction) {
  const double reach = coincidence * element_diameter(mesh, point.element);
  for (const std::int32_t k : mesh.element(point.element)) {
    const Vec3 d = mesh.node[at(k)] - from;
    if (length(d - dot(d, direction) * direction) <= reach && length(mesh.node[at(k)] - point.x) <= 4 * reach) return k;
  }
  return -1;
}

/// Returns the faces of the body that the frame's elements are; empty when one is none.
std::vector<std::int64_t> matching_faces(const Frame& frame, const SurfaceMesh& mesh,
                                         const std::vector<std::int64_t>& candidates,
                                         const std::vector<std::int32_t>& node) {
  // Faces by their nodes with the least number.
  const auto least = [&](std::int64_t e) {
    const auto nodes = mesh.element(e);
    return at(*std::min_element(nodes.begin(), nodes.end()));
  };
  std::vector<std::int64_t> start(at(mesh.nodes()) + 1, 0), of(candidates.size());
  for (const std::int64_t e : candidates) ++start[least(e)];
  for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
  for (const std::int64_t e : candidates) of[at(--start[least(e)])] = e;
  std::vector<std::int64_t> face;
  std::vector<std::int32_t> nodes;
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    nodes.clear();
    for (const std::int32_t k : frame.mesh.element(e)) nodes.push_back(node[at(k)]);
    const auto first = at(*std::min_element(nodes.begin(), nodes.end()));
    std::int64_t found = -1;
    for (std::int64_t i = start[first]; i < start[first + 1]; ++i) {
      const std::int64_t f = of[at(i)];
      const auto own = mesh.element(f);
      if (mesh.type[at(f)] == frame.mesh.type[at(e)] &&
          std::is_permutation(own.begin(), own.end(), nodes.begin(), nodes.end()))
        found = f;
    }
    if (found < 0) return {};
    face.push_back(found);
  }
  std::sort(face.begin(), face.end());
  if (std::adjacent_find(face.begin(), face.end()) != face.end()) return {};
  return face;
}

/// Supports of these components keep the face from moving along its normal.
bool holds_normal(std::uint8_t held, const Vec3& normal) {
  constexpr double rounding = 1e-6;
  double free = 0;
  for (std::size_t c = 0; c < 3; ++c)
    if (!(held >> c & 1)) free += normal[c] * normal[c];
  return free <= rounding * rounding;
}

void refuse_held_faces(const BodyMesh& mesh, const std::vector<SurfacePoint>& point, int which) {
  const std::vector<std::uint8_t> held = held_elements(mesh);
  for (const SurfacePoint& p : point)
    if (p.element >= 0 && holds_normal(held[at(p.element)], p.normal))
      fail(Status::err_state, "the contact frame lies on %s of body %d, which is held by a support",
           face_name(mesh, p.element).c_str(), which + 1);
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
  const std::vector<std::uint8_t> belongs = nodes_of_elements(frame.mesh);
  const std::vector<SurfacePoint> point = project(frame, belongs, body, pose, which);
  refuse_held_faces(body.mesh(), point, which);
  FrameOnBody result;
  result.node.assign(at(frame.nodes()), -1);
  bool all = true;
  const Vec3 direction = pose.turn_back(frame.axes.n);
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    all = all && frame.used[at(k)] == belongs[at(k)];
    if (!frame.used[at(k)]) continue;
    result.node[at(k)] = node_at(mesh, point[at(k)], pose.to_body(frame.mesh.node[at(k)]), direction);
    all = all && result.node[at(k)] >= 0;
  }
  if (all) result.face = matching_faces(frame, mesh, candidates, result.node);
  if (result.of_faces()) return result;
  result.layer = frame.mesh;
  if (which == 1) turn_over(result.layer);  // the frame looks out of body 1
  for (std::int64_t k = 0; k < frame.nodes(); ++k)
    result.layer.node[at(k)] = belongs[at(k)] ? point[at(k)].x : Vec3{0, 0, 0};
  std::vector<std::int64_t> met;
  for (const SurfacePoint& p : point)
    if (p.element >= 0) met.push_back(p.element);
  result.row = nodes_around(mesh, met, candidates);
  return result;
}

}  // namespace rollcon
