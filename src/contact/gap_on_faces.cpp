/// Gaps on frames finer than the linear faces of a body. What the bodies' displacements cannot
/// close between nodes of a body would come out as ripples of the pressure:
///
/// - A body of linear faces is a smooth one with facets. Measured from the facets, the gap has
/// their
///   edges, into which no smooth displacement fits: it is measured from the smooth surface instead.
/// - Finite elements of linear faces move between their nodes as the faces interpolate: the share
/// of
///   the gap that such a body closes, by its compliance, is interpolated on its faces likewise,
///   whether the gap was measured or given.

#include <algorithm>
#include <array>
#include <optional>

#include "bodies/missed_nodes.hpp"
#include "contact/geometry.hpp"
#include "contact/quadratic_fit.hpp"
#include "mesh/shape.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Where the frame's nodes lie on a body.
class NodesOnFaces {
 public:
  NodesOnFaces(const Frame& frame, const Body& body, const Pose& pose, int which)
      : frame_(frame),
        body_(body),
        pose_(pose),
        out_(which == 0 ? 1.0 : -1.0),
        point_(at(frame.nodes())) {
    for (std::size_t k = 0; k < point_.size(); ++k) {
      if (!frame.used[k]) continue;
      const auto found = meet_contact_faces(frame, k, frame.triad(k).n, body, pose, which);
      if (found && !is_quadratic(mesh().type[at(found->element)])) point_[k] = *found;
    }
  }

  /// How far the smooth surface stands out of the facet at node k: half the mean, by the shape
  /// functions, of the heights of the tangent planes at the facet's nodes, exact for quadratic
  /// surfaces.
  double height(std::size_t k) const {
    const SurfacePoint& p = point_[k];
    if (p.element < 0) return 0;
    constexpr double steepest = 0.1;
    const auto nodes = mesh().element(p.element);
    const auto first = at(mesh().offset[at(p.element)]);
    const Shape shape = functions(p);
    const Vec3 out = pose_.turn_back(out_ * frame_.triad(k).n);
    double sum = 0;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Vec3& n = body_.smooth_fans().normal[at(body_.smooth_fans().of[first + a])];
      const double cosine = dot(out, n);
      if (cosine < steepest) return 0;
      sum += 0.5 * shape.value[a] * dot(mesh().node[at(nodes[a])] - p.x, n) / cosine;
    }
    return sum;
  }

  /// For each node: the gap interpolated on the body's faces less the gap itself.
  std::vector<double> interpolated_less(const std::vector<double>& gap) const {
    const std::vector<std::vector<std::int32_t>> over = nodes_by_face();
    std::vector<std::vector<std::int64_t>> around(at(mesh().nodes()));
    for (std::size_t e = 0; e < over.size(); ++e)
      for (const std::int32_t a : mesh().element(static_cast<std::int64_t>(e)))
        if (!over[e].empty()) around[at(a)].push_back(static_cast<std::int64_t>(e));
    std::vector<double> result(gap.size(), 0.0);
    std::vector<std::int32_t> patch;
    QuadraticFit fit;
    for (std::size_t e = 0; e < over.size(); ++e) {
      if (over[e].empty()) continue;
      patch.clear();
      for (const std::int32_t a : mesh().element(static_cast<std::int64_t>(e)))
        for (const std::int64_t f : around[at(a)])
          patch.insert(patch.end(), over[at(f)].begin(), over[at(f)].end());
      std::sort(patch.begin(), patch.end());
      patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
      const auto k0 = at(over[e].front());
      if (!fit.fit(frame_, patch, frame_.x[k0], frame_.y[k0], gap)) continue;
      for (const std::int32_t k : over[e]) result[at(k)] = sag(at(k), fit);
    }
    return result;
  }

 private:
  const SurfaceMesh& mesh() const { return body_.mesh().surface; }
  Shape functions(const SurfacePoint& p) const {
    Shape shape;
    evaluate_shape(mesh().type[at(p.element)], p.xi, p.eta, shape);
    return shape;
  }
  std::vector<std::vector<std::int32_t>> nodes_by_face() const {
    std::vector<std::vector<std::int32_t>> over(at(mesh().elements()));
    for (std::size_t k = 0; k < point_.size(); ++k)
      if (point_[k].element >= 0)
        over[at(point_[k].element)].push_back(static_cast<std::int32_t>(k));
    return over;
  }
  double sag(std::size_t k, const QuadraticFit& fit) const {
    const Shape shape = functions(point_[k]);
    const auto nodes = mesh().element(point_[k].element);
    double sum = 0;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Vec3 d = pose_.turn(mesh().node[at(nodes[a])] - point_[k].x);
      sum += 0.5 * shape.value[a] * fit.curvature(dot(d, frame_.axes.t1), dot(d, frame_.axes.t2));
    }
    return sum;
  }

  const Frame& frame_;
  const Body& body_;
  const Pose& pose_;
  double out_;                       ///< 1 where the frame's normals look out of the body, else -1
  std::vector<SurfacePoint> point_;  ///< element < 0: none, or a quadratic one
};

bool moves_as_its_faces(const Body& body) {
  return body.kind() == BodyKind::fem ||
         (body.kind() == BodyKind::bem && body.options().between_nodes == 1);
}

/// Compliance of a half-space of its material.
double softness(const Body& body) {
  if (body.rigid()) return 0;
  return (1 - body.poisson() * body.poisson()) / body.young();
}

}  // namespace

void fit_gap_to_faces(const Frame& frame, const FrameSource& source, const PairOfBodies& pair,
                      bool measured, std::vector<double>& gap) {
  std::array<std::optional<NodesOnFaces>, 2> on;
  for (int b = 0; b < 2; ++b) {
    const Body& body = *pair.body[at(b)];
    if (!body.meshed() || source.body == b || !(measured || moves_as_its_faces(body))) continue;
    on[at(b)].emplace(frame, body, pair.pose[at(b)], b);
    for (std::size_t k = 0; measured && k < gap.size(); ++k)
      if (frame.used[k]) gap[k] -= on[at(b)]->height(k);
  }
  if (!on[0] && !on[1]) return;
  const std::vector<double> smooth = gap;
  for (int b = 0; b < 2; ++b) {
    const Body& body = *pair.body[at(b)];
    if (!on[at(b)] || !moves_as_its_faces(body)) continue;
    const double share = softness(body) / (softness(*pair.body[0]) + softness(*pair.body[1]));
    const std::vector<double> less = on[at(b)]->interpolated_less(smooth);
    for (std::size_t k = 0; k < gap.size(); ++k) gap[k] += share * less[k];
  }
}

}  // namespace rollcon
