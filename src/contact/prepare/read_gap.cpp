/// Reads gaps of the prepared scene: given, of surfaces, or measured between meshes; and what bodies' own loads add.

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/prepare/preparation.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/scene/known_gap.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using Poses = Preparation::Poses;

// Makes gaps count from first touch; `changes` tells warm starts how far the datum moved.
void set_datum(Preparation& preparation) {
  constexpr double steepest = 0.01;  // nodes as steep as that say little about the approach
  Prepared& on = *preparation.made;
  Problem& p = on.problem;
  double least = INFINITY;
  for (std::size_t k = 0; k < p.gap.size(); ++k)
    if (on.frame.used[k] && p.closing(k) > steepest) least = std::min(least, p.gap[k] / p.closing(k));
  const double datum = std::isfinite(least) ? least : 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) p.gap[k] -= p.closing(k) * datum;
  preparation.changes.datum += datum - p.datum;
  p.datum = datum;
}

}  // namespace

Poses poses_of_surfaces(const Scene& scene, const PairOfBodies& pair) {
  Poses poses{-1, -1};
  for (std::size_t b = 0; b < 2; ++b)
    if (pair.body[b]->has_surface()) poses[b] = scene.revision.pose[b];
  return poses;
}

// Finds displacements without contact tractions; profiles need no key here, as they change the gap alone.
void find_offset(Preparation& preparation) {
  Prepared& on = *preparation.made;
  if (!preparation.offset.enter(preparation.convection.version())) return;
  if (!on.offset_depth.empty()) ++preparation.offset_change;
  on.offset_depth.clear();
  for (auto& v : on.offset_slip) v.clear();
  const Frame& frame = on.frame;
  const Convection& convection = on.problem.convection;
  const std::size_t n = frame.x.size();
  std::vector<double> u(3 * n), ahead;
  if (!on.compliance->offset({frame.x, frame.y}, u.data())) return;
  ++preparation.offset_change;
  if (!convection.ahead.empty()) {
    ahead.resize(3 * n);
    std::vector<double> x = frame.x;
    for (std::size_t k = 0; k < n; ++k) x[k] += convection.ahead[k];
    on.compliance->offset({x, frame.y}, ahead.data());
  }
  if (on.scheme != Scheme::time_step) convect(convection, u.data(), ahead.data(), on.offset_slip);
  on.offset_depth.resize(n);
  for (std::size_t k = 0; k < n; ++k) on.offset_depth[k] = u[3 * k + 2];
}

void read_gap(Preparation& preparation, const Scene& scene) {
  Prepared& on = *preparation.made;
  const bool measured = !scene.has_gap();
  if (!preparation.gap.enter(preparation.frame.version(), preparation.place.version(), preparation.offset_change,
                             scene.revision.gap, measured ? poses_of_surfaces(scene, on.pair) : Poses{-1, -1}))
    return;
  ++preparation.builds.gaps;
  Problem& p = on.problem;
  // Gaps of meshes count along their local normals.
  const bool between_planes = !scene.frame_given() && !(measured && on.pair.meshed());
  const bool known = between_planes && fill_known_gap(scene, on.pair, on.frame, p.gap);
  if (!known && measured) {
    p.gap = undeformed_gap(on.frame, on.frame_source, on.pair);
    refuse_deep_overlap(on.frame, p.gap, on.pair);
    if (is_turned(p.gap, on.frame.rim)) fail(Status::err_argument, "%s", exchange_bodies);
  } else if (!known) {
    p.gap.resize(at(p.nodes));
    for (std::size_t k = 0; k < p.gap.size(); ++k)
      p.gap[k] = scene.gap(static_cast<std::int64_t>(k), on.frame.x[k], on.frame.y[k]);
  }
  for (std::size_t k = 0; k < on.offset_depth.size(); ++k) p.gap[k] -= on.offset_depth[k];
  set_datum(preparation);
}

}  // namespace rollcon
