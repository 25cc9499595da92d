#include "bodies/nodal_loads.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/frame_on_body.hpp"
#include "geometry/surface_coupling.hpp"
#include "linalg/lapack.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

Resultant resultant_of(const std::vector<Vec3>& force, const std::vector<Vec3>& node) {
  Resultant sum;
  for (std::size_t k = 0; k < force.size(); ++k) {
    sum.force = sum.force + force[k];
    sum.moment = sum.moment + cross(node[k], force[k]);
  }
  return sum;
}

SurfaceCoupling coupling_of(const FrameOnBody& on_body, const BodyMesh& mesh) {
  if (on_body.of_faces()) return couple_faces(mesh.surface, on_body.face);
  const SurfaceMesh& layer = on_body.layer;
  Vec3 normal{0, 0, 0};
  for (std::int64_t e = 0; e < layer.elements(); ++e)
    normal = normal + element_area(layer, e) * unit_normal(layer, e, 1.0 / 3, 1.0 / 3);
  return couple_layer(mesh.surface, contact_elements_facing(mesh, normalized(normal)), layer);
}

/// Adds forces a + b x (x - middle) on the loaded nodes that make up for what their resultant misses; returns the
/// largest one.
double add_missing(const std::vector<Vec3>& node, const Resultant& missing, const std::vector<std::int32_t>& loaded,
                   std::vector<Vec3>& force) {
  Vec3 middle{0, 0, 0};
  for (const std::int32_t k : loaded) middle = middle + (1.0 / static_cast<double>(loaded.size())) * node[at(k)];
  double size = 0, inertia[9] = {};
  for (const std::int32_t k : loaded) {
    const Vec3 d = node[at(k)] - middle;
    size += dot(d, d);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) inertia[3 * j + i] += (i == j ? dot(d, d) : 0) - d[i] * d[j];
  }
  if (!(size > 0)) return 0;
  const Vec3 a = (1.0 / static_cast<double>(loaded.size())) * missing.force;
  Vec3 b = missing.moment - cross(middle, missing.force);
  const int three = 3, one = 1;
  int pivot[3], info = 0;
  dgetrf_(&three, &three, inertia, &three, pivot, &info);
  if (info != 0) return 0;  // all nodes stand on one line
  dgetrs_("N", &three, &one, inertia, &three, pivot, b.data(), &three, &info);
  double most = 0;
  for (const std::int32_t k : loaded) {
    const Vec3 more = a + cross(b, node[at(k)] - middle);
    force[at(k)] = force[at(k)] + more;
    most = std::max(most, length(more));
  }
  return most;
}

}  // namespace

NodalLoads nodal_loads(const Frame& frame, const PairOfBodies& pair, int which, std::span<const double> traction,
                       const Resultant& contact) {
  const Body& body = *pair.body[at(which)];
  const Pose& pose = pair.pose[at(which)];
  if (!body.meshed())
    fail(Status::err_unsupported, "body %d is a %s body without a mesh: it has no nodes to put forces on", which + 1,
         body.traits().name);
  const std::vector<Vec3>& node = body.mesh().surface.node;
  const FrameOnBody on_body = lay_on_body(frame, body, pose, which);
  const SurfaceCoupling coupling = coupling_of(on_body, body.mesh());
  // The coupling's columns are nodes of the body under faces, of the frame under a layer.
  std::vector<Vec3> acting(on_body.of_faces() ? node.size() : at(frame.nodes()), Vec3{0, 0, 0});
  const double sign = which == 0 ? 1 : -1;
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    const std::int64_t to = on_body.of_faces() ? on_body.node[at(k)] : k;
    if (!frame.used[at(k)] || to < 0) continue;
    const Triad t = frame.triad(at(k));
    const double* own = traction.data() + 3 * k;
    acting[at(to)] = sign * pose.turn_back(own[0] * t.t1 + own[1] * t.t2 + own[2] * t.n);
  }
  NodalLoads loads;
  loads.force.assign(node.size(), Vec3{0, 0, 0});
  std::vector<std::int32_t> loaded;
  for (std::size_t r = 0; r < coupling.node.size(); ++r) {
    Vec3& force = loads.force[at(coupling.node[r])];
    for (std::int64_t k = coupling.start[r]; k < coupling.start[r + 1]; ++k)
      force = force + coupling.value[at(k)] * acting[at(coupling.row[at(k)])];
    if (force != Vec3{0, 0, 0}) loaded.push_back(coupling.node[r]);
  }
  const Axes& axes = frame.axes;
  const auto in_body = [&](const Vec3& v) {
    return sign * pose.turn_back(v[0] * axes.t1 + v[1] * axes.t2 + v[2] * axes.n);
  };
  loads.sum.force = in_body(contact.force);
  loads.sum.moment = in_body(contact.moment) + cross(pose.to_body(axes.origin), loads.sum.force);
  const Resultant own = resultant_of(loads.force, node);
  double most = 0;
  for (const Vec3& f : loads.force) most = std::max(most, length(f));
  const Resultant missing{loads.sum.force - own.force, loads.sum.moment - own.moment};
  if (most > 0) loads.moved = add_missing(node, missing, loaded, loads.force) / most;
  return loads;
}

}  // namespace rollcon
