#include "contact/results/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/results/statistics.hpp"
#include "contact/solution.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

struct Results {
  Vec3 force{}, moment{};
  std::array<double, 4> motion{};
  double overlap = 0;  ///< approach from first touch on: unlike the approach, no matter of where gaps count from
  double area = 0;
  double carried = 0;   ///< integral of |tangential traction|
  double friction = 0;  ///< integral of friction's bound
};

Results results_of(const SolverState& s) {
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  Results r;
  sum_tractions(p, s.prepared->frame, it.lambda, r.force, r.moment);
  r.motion = it.motion;
  r.overlap = it.motion[approach];
  r.motion[approach] = s.given.approach_of(it.motion, p.datum);
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!(it.lambda[2][k] < 0)) continue;
    r.area += p.cell_area[k];
    r.carried += p.weight[k] * std::hypot(it.lambda[0][k], it.lambda[1][k]);
    r.friction -= p.weight[k] * s.given.friction * p.mu[k] * it.lambda[2][k];
  }
  return r;
}

// left_over: part of the difference by which the finer frame is off.
double beyond(double fine, double coarse, double left_over) {
  return fine + left_over * (fine - coarse);
}

/// About the middle of the pressure (x, y), wherever the axes are.
double spin_moment(const Results& r, double x, double y) {
  return r.moment[2] - (x * r.force[1] - y * r.force[0]);
}

double relative(double part, double whole) {
  return whole > 0 ? part / whole : part > 0 ? 1 : 0;
}

}  // namespace

Rates beyond(const SolverState& state, const Rates& fine, const Rates& coarse) {
  const double left_over = state.extrapolated->left_over;
  Rates r;
  for (std::size_t i = 0; i < 3; ++i) {
    r.force[i] = beyond(fine.force[i], coarse.force[i], left_over);
    r.moment[i] = beyond(fine.moment[i], coarse.moment[i], left_over);
  }
  for (std::size_t m = 0; m < 4; ++m) r.motion[m] = beyond(fine.motion[m], coarse.motion[m], left_over);
  return r;
}

void extrapolate(SolverState& fine, const SolverState& coarse, const FrameFamily& family) {
  const Results f = results_of(fine), c = results_of(coarse);
  // Halving leaves a quarter of errors of second order.
  const double left_over = 1 / (std::exp2(family.order) - 1);
  Extrapolated e;
  e.left_over = left_over;
  for (std::size_t i = 0; i < 3; ++i) {
    e.force[i] = beyond(f.force[i], c.force[i], left_over);
    e.moment[i] = beyond(f.moment[i], c.moment[i], left_over);
  }
  for (std::size_t m = 0; m < 4; ++m) e.motion[m] = beyond(f.motion[m], c.motion[m], left_over);
  e.area = family.cover * beyond(f.area, c.area, left_over);
  // Friction's bound holds for both; what lies beyond both of them may pass it by the error of either.
  const double bound = beyond(f.friction, c.friction, left_over), force = std::hypot(e.force[0], e.force[1]);
  if (fine.prepared->problem.turn.empty() && force > bound)
    for (std::size_t i = 0; i < 2; ++i) e.force[i] *= bound / force;
  fine.extrapolated = e;

  // An edge is what the cells of the frame make of it; lengths for moments and spins.
  const double length = std::sqrt(f.area / std::numbers::pi);
  const auto off = [&](double a, double b) { return std::abs(a - b) * left_over; };
  const double force_off = std::hypot(off(f.force[0], c.force[0]), off(f.force[1], c.force[1]));
  ErrorEstimate estimate;
  estimate.known = true;
  const double normal = std::abs(f.force[2]);
  const double x = normal > 0 ? -f.moment[1] / f.force[2] : 0, y = normal > 0 ? f.moment[0] / f.force[2] : 0;
  const double moment_off = off(spin_moment(f, x, y), spin_moment(c, x, y)) / length;
  estimate.normal = fine.given.by_force[approach]
                        ? relative(1.5 * off(f.motion[approach], c.motion[approach]), std::abs(f.overlap))
                        : relative(off(f.force[2], c.force[2]), normal);
  if (!fine.frictionless) {
    estimate.tangential = relative(std::max(force_off, moment_off), f.carried);
    if (fine.given.tangential_load()) {
      const double motion = std::hypot(f.motion[xi1], f.motion[xi2], length * f.motion[spin]),
                   motion_off = std::hypot(off(f.motion[xi1], c.motion[xi1]), off(f.motion[xi2], c.motion[xi2]),
                                           length * off(f.motion[spin], c.motion[spin]));
      estimate.tangential = std::max(estimate.tangential, relative(motion_off, motion));
    }
  }
  estimate.normal = std::max(estimate.normal, family.least_error);
  if (!fine.frictionless) estimate.tangential = std::max(estimate.tangential, family.least_error);
  estimate.tractions = relative(off(f.friction, c.friction) + off(f.carried, c.carried), f.friction + f.carried);
  fine.error_estimate = estimate;
}

}  // namespace rollcon
