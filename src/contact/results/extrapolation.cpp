#include "contact/results/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "support/error.hpp"
#include "support/index.hpp"
#include "support/small_system.hpp"

namespace rollcon {
namespace {

struct Results {
  Vec3 force{}, moment{};
  MotionValues motion{};
  double overlap = 0;  ///< approach from first touch on, which does not depend on where gaps count from
  double area = 0;
  double carried = 0;   ///< integral of |tangential traction|
  double friction = 0;  ///< integral of friction's bound
};

Results results_of(const Solution& s) {
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  Results r;
  sum_tractions(p, it.lambda, r.force, r.moment);
  r.motion = it.motion;
  r.overlap = it.motion[approach];
  r.motion[approach] = s.given.approach_of(it.motion, p.datum);
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!(it.lambda[2][k] < 0)) continue;
    r.area += p.cell_area[k];
    r.carried += p.weight[k] * std::hypot(it.lambda[0][k], it.lambda[1][k]);
    r.friction -= p.weight[k] * s.given.coefficient(p.mu, k) * it.lambda[2][k];
  }
  return r;
}

// Extrapolates; left_over: part of the difference by which the finer frame is off.
double beyond(double fine, double coarse, double left_over) {
  return fine + left_over * (fine - coarse);
}

/// Returns the moment about the middle of the pressure (x, y), wherever the axes are.
double spin_moment(const Results& r, double x, double y) {
  return r.moment[2] - (x * r.force[1] - y * r.force[0]);
}

double relative(double part, double whole) {
  return whole > 0 ? part / whole : part > 0 ? 1 : 0;
}

// Limits the step to extrapolated creepages: near the limit of friction they grow beyond measure, and those of two
// frames differ by a multiple, but the way on from the finer frame's does not lead through zero.
void limit_creepages(const Results& fine, double length, MotionValues& motion) {
  constexpr double farthest = 0.5;
  const auto size = [&](const MotionValues& m) { return std::hypot(m[xi1], m[xi2], length * m[spin]); };
  MotionValues step = motion;
  for (std::size_t m = 0; m < motion_count; ++m) step[m] -= fine.motion[m];
  const double whole = size(fine.motion), way = size(step);
  if (!(way > farthest * whole)) return;
  for (const int m : {xi1, xi2, spin}) motion[at(m)] = fine.motion[at(m)] + farthest * whole / way * step[at(m)];
}

using Three = std::array<double, 3>;
constexpr std::array<Motion, 3> slips{xi1, xi2, spin};

// Returns forces and moment over `length` that change the motions found by `off`; lengths of motions count as those of
// forces. Nothing: no forces do, or they cannot be told.
std::optional<Three> forces_of(const Solution& fine, const std::function<const Rates&(Parameter)>& rates_by,
                               const Three& off, double length) {
  if (!fine.procedure.standard() || fine.prepared->problem.law->of_field()) return std::nullopt;
  std::array<Three, 3> yields{};
  Three forces{};
  constexpr std::array<Parameter, 3> parameter{Parameter::longitudinal, Parameter::lateral, Parameter::spin};
  const Three unit{1, 1, length};
  for (std::size_t j = 0; j < 3; ++j) {
    if (!fine.given.by_force[at(slips[j])]) {
      yields[j][j] = 1;
      continue;
    }
    forces[j] = off[j];
    try {
      const Rates& rates = rates_by(parameter[j]);
      for (std::size_t i = 0; i < 3; ++i)
        if (fine.given.by_force[at(slips[i])]) yields[i][j] = unit[i] * unit[j] * rates.motion[at(slips[i])];
    } catch (const Error&) {
      return std::nullopt;
    }
  }
  Three needed{};
  if (!solve_small(3, yields, forces, needed)) return std::nullopt;
  return needed;
}

}  // namespace

Rates beyond(const Extrapolated& results, const Rates& fine, const Rates& coarse) {
  const double left_over = results.left_over;
  Rates r;
  for (std::size_t i = 0; i < 3; ++i) {
    r.force[i] = beyond(fine.force[i], coarse.force[i], left_over);
    r.moment[i] = beyond(fine.moment[i], coarse.moment[i], left_over);
  }
  for (std::size_t m = 0; m < motion_count; ++m) r.motion[m] = beyond(fine.motion[m], coarse.motion[m], left_over);
  return r;
}

Extrapolation extrapolate(const Solution& fine, const Solution& coarse, const FrameFamily& family,
                          const std::function<const Rates&(Parameter)>& rates) {
  const Results f = results_of(fine), c = results_of(coarse);
  // Halving leaves a quarter of errors of second order.
  const double left_over = 1 / (std::exp2(family.order) - 1);
  Extrapolated e;
  e.left_over = left_over;
  for (std::size_t i = 0; i < 3; ++i) {
    e.force[i] = beyond(f.force[i], c.force[i], left_over);
    e.moment[i] = beyond(f.moment[i], c.moment[i], left_over);
  }
  for (std::size_t m = 0; m < motion_count; ++m) e.motion[m] = beyond(f.motion[m], c.motion[m], left_over);
  limit_creepages(f, std::sqrt(f.area / std::numbers::pi), e.motion);
  e.area = family.cover * beyond(f.area, c.area, left_over);
  // Friction's bound holds for both; what lies beyond both of them may pass it by the error of either.
  const double bound = beyond(f.friction, c.friction, left_over), force = std::hypot(e.force[0], e.force[1]);
  if (fine.prepared->problem.turn.empty() && force > bound)
    for (std::size_t i = 0; i < 2; ++i) e.force[i] *= bound / force;
  // Given loads are met exactly; frames carry parts of them.
  for (const auto& [m, result] : {std::pair{xi1, &e.force[0]}, {xi2, &e.force[1]}, {spin, &e.moment[2]}})
    if (!fine.frictionless && fine.given.by_force[static_cast<std::size_t>(m)])
      *result = fine.given.value[static_cast<std::size_t>(m)] / fine.load_factor;

  // The radius of a disc as large as the contact turns moments into forces and spins into creepages.
  const double length = std::sqrt(f.area / std::numbers::pi);
  const double counted = family.counted * left_over;
  const auto off = [&](double a, double b) { return std::abs(a - b) * counted; };
  const auto load_off = [&](int m, double a, double b) {
    return fine.given.by_force[static_cast<std::size_t>(m)] ? 0 : off(a, b);
  };
  const double force_off = std::hypot(load_off(xi1, f.force[0], c.force[0]), load_off(xi2, f.force[1], c.force[1]));
  ErrorEstimate estimate;
  estimate.known = true;
  const double normal = std::abs(f.force[2]);
  const double x = normal > 0 ? -f.moment[1] / f.force[2] : 0, y = normal > 0 ? f.moment[0] / f.force[2] : 0;
  const double moment_off = load_off(spin, spin_moment(f, x, y), spin_moment(c, x, y)) / length;
  estimate.normal = fine.given.by_force[approach]
                        ? relative(1.5 * off(f.motion[approach], c.motion[approach]), std::abs(f.overlap))
                        : relative(off(f.force[2], c.force[2]), normal);
  if (!fine.frictionless) {
    estimate.tangential = relative(std::max(force_off, moment_off), f.carried);
    if (fine.given.tangential_load()) {
      const auto motion_off = [&](Motion m) { return counted * (f.motion[m] - c.motion[m]); };
      const Three motions_off{motion_off(xi1), motion_off(xi2), length * motion_off(spin)};
      const double motion = std::hypot(f.motion[xi1], f.motion[xi2], length * f.motion[spin]);
      // Errors of vanishing forces vanish only up to rounding: lesser forces count as this fraction of friction.
      constexpr double least = 1e-3;
      if (const auto forces = forces_of(fine, rates, motions_off, length))
        estimate.tangential = std::max(
            estimate.tangential, relative(std::max(std::hypot((*forces)[0], (*forces)[1]), std::abs((*forces)[2])),
                                          std::max(f.carried, least * f.friction)));
      else
        estimate.tangential =
            std::max(estimate.tangential, relative(std::hypot(motions_off[0], motions_off[1], motions_off[2]), motion));
    }
  }
  estimate.normal = std::max(estimate.normal, family.least_error);
  if (!fine.frictionless)
    estimate.tangential = std::max({estimate.tangential, family.least_error, family.least_tangential});
  estimate.tractions = relative(off(f.friction, c.friction) + off(f.carried, c.carried), f.friction + f.carried);
  return {e, estimate};
}

}  // namespace rollcon
