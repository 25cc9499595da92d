#include "contact/scene/geometry.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/missed_nodes.hpp"
#include "geometry/surface.hpp"
#include "mesh/topology.hpp"

namespace rollcon {
namespace {

/// Returns the direction in which a body's contact faces look, for n out of body 1.
Vec3 outward(int body, const Vec3& n) {
  return body == 0 ? n : -1.0 * n;
}

/// Sums the normals of the faces' fans at each frame node, in the body's axes.
std::vector<Vec3> own_normals(const FrameSource& source, const Body& body) {
  const SurfaceMesh& mesh = body.mesh().surface;
  const TractionNodes& fans = body.smooth_fans();
  std::vector<std::int32_t> number(static_cast<std::size_t>(mesh.nodes()), -1);
  for (std::size_t k = 0; k < source.node.size(); ++k)
    number[static_cast<std::size_t>(source.node[k])] = static_cast<std::int32_t>(k);
  std::vector<Vec3> sum(source.node.size(), Vec3{});
  for (const std::int64_t e : source.element) {
    const auto nodes = mesh.element(e);
    const auto first = static_cast<std::size_t>(mesh.offset[static_cast<std::size_t>(e)]);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto fan = static_cast<std::size_t>(fans.of[first + i]);
      const std::int32_t k = number[static_cast<std::size_t>(nodes[i])];
      if (k < 0) continue;  // frame of the faces' corners
      Vec3& there = sum[static_cast<std::size_t>(k)];
      there = there + fans.normal[fan];
    }
  }
  return sum;
}

}  // namespace

int normal_source(const PairOfBodies& pair) {
  for (int b = 0; b < 2; ++b)
    if (pair.body[static_cast<std::size_t>(b)]->meshed()) return b;
  return -1;
}

std::vector<Vec3> surface_normals(const Frame& frame, const FrameSource& source, const PairOfBodies& pair) {
  const int which = normal_source(pair);
  const Body& body = *pair.body[static_cast<std::size_t>(which)];
  const Pose& pose = pair.pose[static_cast<std::size_t>(which)];
  const NormalField field(frame.axes, pair);
  if (source.body == which) {
    std::vector<Vec3> normal = own_normals(source, body);
    for (Vec3& n : normal) n = field.level(outward(which, pose.turn(n)));
    return normal;
  }
  std::vector<Vec3> normal(static_cast<std::size_t>(frame.nodes()), frame.axes.n);
  MissedNodes missed(frame, body, pose, which);
  const Vec3 direction = pose.turn_back(frame.axes.n);
  const std::vector<std::uint8_t> belongs = nodes_of_elements(frame.mesh);
  for (std::size_t k = 0; k < normal.size(); ++k) {
    if (!belongs[k]) continue;
    const auto n = look_aside(
        pose.to_body(frame.mesh.node[k]), direction, element_size(frame, k),
        [&](const Vec3& from) { return body.surface()->normal(from, direction, outward(which, direction)); });
    if (n)
      normal[k] = field.level(outward(which, pose.turn(*n)));
    else
      missed.add(k, frame.axes.n);
  }
  missed.fail_if_any();
  return normal;
}

std::vector<double> undeformed_gap(const Frame& frame, const FrameSource& source, const PairOfBodies& pair) {
  std::vector<double> gap(static_cast<std::size_t>(frame.nodes()), 0);
  const Plane plane(frame.axes.origin, frame.axes.n);
  const std::vector<std::uint8_t> belongs = nodes_of_elements(frame.mesh);
  for (int b = 0; b < 2; ++b) {
    if (source.body == b) continue;  // the nodes are on it
    const Body& body = *pair.body[static_cast<std::size_t>(b)];
    const Surface& surface = body.surface() ? *body.surface() : plane;
    const Pose pose = body.surface() ? pair.pose[static_cast<std::size_t>(b)] : Pose{};
    const double sign = b == 0 ? -1 : 1;
    MissedNodes missed(frame, body, pose, b);
    for (std::size_t k = 0; k < gap.size(); ++k) {
      if (!belongs[k]) continue;
      // The local normal may leave a body beside its end.
      const Vec3 local = frame.triad(k).n;
      std::optional<double> met;
      for (const Vec3& n : {local, frame.axes.n}) {
        const Vec3 direction = pose.turn_back(n);
        if (!met)
          met = look_aside(pose.to_body(frame.mesh.node[k]), direction, element_size(frame, k),
                           [&](const Vec3& from) { return surface.distance(from, direction, outward(b, direction)); });
      }
      if (met)
        gap[k] += sign * *met;
      else
        missed.add(k, local);
    }
    missed.fail_if_any();
  }
  return gap;
}

bool is_turned(const std::vector<double>& gap, const std::vector<std::uint8_t>& rim) {
  constexpr double rounding = 1e-9;
  double least[] = {INFINITY, INFINITY}, most[] = {-INFINITY, -INFINITY};  // extremes inside and at the rim
  for (std::size_t k = 0; k < gap.size(); ++k) {
    if (!std::isfinite(gap[k])) continue;
    const std::size_t at = rim[k] != 0 ? 1 : 0;
    least[at] = std::min(least[at], gap[k]);
    most[at] = std::max(most[at], gap[k]);
  }
  const double little = rounding * (most[0] - least[0]);
  return least[1] < least[0] - little && most[0] >= most[1] - little;
}

InitialOverlap initial_overlap(const Frame& frame, const std::vector<double>& gap) {
  constexpr double rounding = 1e-9;  // over the distance of nodes
  InitialOverlap overlap;
  for (std::size_t k = 0; k < gap.size(); ++k) {
    if (!frame.used[k] || -gap[k] <= rounding * std::sqrt(frame.cell_area[k])) continue;
    ++overlap.nodes;
    overlap.depth = std::max(overlap.depth, -gap[k]);
  }
  return overlap;
}

void refuse_deep_overlap(const Frame& frame, const std::vector<double>& gap, const PairOfBodies& pair) {
  const double depth = initial_overlap(frame, gap).depth;
  for (std::size_t b = 0; b < 2 && depth > 0; ++b) {
    const Body& body = *pair.body[b];
    if (body.rigid() || !body.meshed()) continue;
    const std::vector<Vec3>& node = body.mesh().surface.node;
    double thickness = INFINITY;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [low, high] =
          std::minmax_element(node.begin(), node.end(), [c](const Vec3& x, const Vec3& y) { return x[c] < y[c]; });
      thickness = std::min(thickness, (*high)[c] - (*low)[c]);
    }
    if (depth > thickness)
      fail(Status::err_argument,
           "before they approach each other the bodies overlap by %g, more than body %d is thick "
           "(%g): check the poses (rollcon_contact_set_pose), the axes' origin and normal "
           "(rollcon_contact_set_axes), and the units of all lengths",
           depth, static_cast<int>(b) + 1, thickness);
  }
}

}  // namespace rollcon
