/// Measured gaps on frames finer than the linear faces of a body, which stand for a smooth surface:
///
/// - No smooth displacement fits into the edges of facets. A gap measured from them is taken from
///   the smooth surface instead.
/// - Finite elements of linear faces move between their nodes as the faces interpolate, and so
///   cannot close a gap that is smooth there. The share of it that such a body closes, by its
///   compliance, keeps the facets.
///
/// Else the difference would come out as ripples of the pressure.

#include "bodies/missed_nodes.hpp"
#include "contact/scene/geometry.hpp"
#include "mesh/shape.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// How far the smooth surface stands out of the body's facet at a point of it, along `out`: half the mean, by the shape
/// functions, of the heights of the tangent planes at the facet's nodes, which is exact for quadratic surfaces.
/// Quadratic faces are smooth enough.
double height_over_facet(const Body& body, const SurfacePoint& p, const Vec3& out) {
  constexpr double steepest = 0.1;
  const SurfaceMesh& mesh = body.mesh().surface;
  const ElementType type = mesh.type[at(p.element)];
  if (is_quadratic(type)) return 0;
  const TractionNodes& fans = body.smooth_fans();
  const auto nodes = mesh.element(p.element);
  const auto first = at(mesh.offset[at(p.element)]);
  Shape shape;
  evaluate_shape(type, p.xi, p.eta, shape);
  double sum = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const Vec3& n = fans.normal[at(fans.of[first + a])];
    const double cosine = dot(out, n);
    if (cosine < steepest) return 0;
    sum += 0.5 * shape.value[a] * dot(mesh.node[at(nodes[a])] - p.x, n) / cosine;
  }
  return sum;
}

bool moves_as_its_faces(const Body& body) {
  const BodyTraits& traits = body.traits();
  return traits.meshed && traits.elastic && (!traits.smooth_difference || body.options().between_nodes == 1);
}

/// Compliance of a half-space of its material.
double softness(const Body& body) {
  if (body.rigid()) return 0;
  return (1 - body.poisson() * body.poisson()) / body.young();
}

}  // namespace

void fit_gap_to_faces(const Frame& frame, const FrameSource& source, const PairOfBodies& pair,
                      std::vector<double>& gap) {
  for (int b = 0; b < 2; ++b) {
    const Body& body = *pair.body[at(b)];
    if (!body.meshed() || source.body == b) continue;
    double part = -1;
    if (moves_as_its_faces(body)) part += softness(body) / (softness(*pair.body[0]) + softness(*pair.body[1]));
    if (part == 0) continue;
    const Pose& pose = pair.pose[at(b)];
    for (std::size_t k = 0; k < gap.size(); ++k) {
      if (!frame.used[k]) continue;
      const Vec3 n = frame.triad(k).n;
      const auto found = meet_contact_faces(frame, k, n, body, pose, b);
      if (found) gap[k] += part * height_over_facet(body, *found, pose.turn_back((b == 0 ? 1.0 : -1.0) * n));
    }
  }
}

}  // namespace rollcon
