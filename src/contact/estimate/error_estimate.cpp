#include "contact/estimate/error_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "contact/derived.hpp"
#include "contact/estimate/error_variant.hpp"
#include "contact/estimate/few_nodes.hpp"
#include "contact/prepare/gap_between_nodes.hpp"
#include "contact/prepare/lattice_scene.hpp"
#include "mesh/topology.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Factor between the step that the characteristic scheme is compared with and its own.
constexpr double longer = 5.0 / 3;

using Tractions = std::vector<double>[3];

double ratio(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

// Holds forces and squared L2 norms of tractions.
struct Sums {
  double normal = 0, tangential = 0;  ///< forces
  double magnitude = 0;               ///< integral of |tangential traction|
  double pressure2 = 0, tangential2 = 0;
};

Sums sums_of(const Solution& s, const Tractions& t) {
  Sums r;
  Vec3 force, moment;
  sum_tractions(s.prepared->problem, t, force, moment);
  r.normal = std::abs(force[2]);
  r.tangential = std::hypot(force[0], force[1]);
  for (std::size_t k = 0; k < t[0].size(); ++k) {
    const double area = s.prepared->problem.cell_area[k], size = std::hypot(t[0][k], t[1][k]);
    r.magnitude += area * size;
    r.tangential2 += area * size * size;
    r.pressure2 += area * t[2][k] * t[2][k];
  }
  return r;
}

Sums difference(const Solution& s, const Tractions& a, const Tractions& b) {
  Tractions d;
  for (std::size_t c = 0; c < 3; ++c) {
    d[c] = a[c];
    for (std::size_t k = 0; k < d[c].size(); ++k) d[c][k] -= b[c][k];
  }
  return sums_of(s, d);
}

// Returns the area of the linear cells that the edge of the contact runs through.
double fringe(const Frame& frame, const std::vector<double>& normal) {
  const LinearCells cells = split_elements(frame.mesh);
  double sum = 0;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    std::size_t touching = 0;
    double twice = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
      const std::size_t a = at(n[i]), b = at(n[(i + 1) % n.size()]);
      touching += normal[a] < 0;
      twice += frame.x[a] * frame.y[b] - frame.x[b] * frame.y[a];
    }
    if (touching > 0 && touching < n.size()) sum += twice / 2;
  }
  return sum;
}

// Solves a variant with the step wished for or, where that finds no solution, the most stable one.
template <class Make>
std::optional<Variant> solved(const Solution& s, bool given_load, double step, Make make) {
  constexpr double stable_step = 1;
  std::optional<Variant> v = make(step);
  if (v->solve(s, given_load)) return v;
  if (s.frictionless || step == stable_step) return std::nullopt;
  v = make(stable_step);
  if (v->solve(s, given_load)) return v;
  return std::nullopt;
}

// Estimates from frames with a half and a quarter of the nodes along each axis: coarser(halvings, tractions) solves
// there and gives tractions at the nodes, or returns false. Errors of forces are of second order in the spacing for
// pressures and of first order for friction; those of tractions are of first order, because of their edges.
template <class Coarser>
void estimate_by_coarser(const Solution& s, ErrorEstimate& e, Coarser coarser) {
  Tractions half, quarter;
  if (!coarser(1, half)) return;
  const Sums whole = sums_of(s, s.iterate.lambda);
  e.normal = ratio(difference(s, half, s.iterate.lambda).normal, whole.normal) / 3;
  // Under a given load friction does not feel that the approach was off.
  const auto carry_the_load = [&](Tractions& t) {
    const double carried = sums_of(s, t).normal;
    if (!s.given.by_force[approach] || !(carried > 0)) return;
    for (auto& component : t)
      for (double& l : component) l *= whole.normal / carried;
  };
  carry_the_load(half);
  const Sums change = difference(s, half, s.iterate.lambda);
  e.tangential = ratio(change.tangential, whole.magnitude);
  // Where the edge of the contact falls between the nodes two frames can agree by accident, three hardly do.
  if (!s.frictionless && coarser(2, quarter)) {
    carry_the_load(quarter);
    const Sums step = difference(s, quarter, half);
    e.tangential = std::max(e.tangential, ratio(step.tangential, whole.magnitude) / 2);
  }
  e.tractions =
      std::sqrt(std::max(ratio(change.pressure2, whole.pressure2), ratio(change.tangential2, whole.tangential2)));
}

void estimate_on_lattice(const Solution& s, ErrorEstimate& e) {
  constexpr double tolerance = 1e-6;
  estimate_by_coarser(s, e, [&](int halvings, Tractions& found) {
    Iterate iterate;
    if (!solve_on_coarser_lattice(s, tolerance, halvings, iterate)) return false;
    for (std::size_t c = 0; c < 3; ++c) found[c] = std::move(iterate.lambda[c]);
    return true;
  });
}

// Estimates where rows are not formed, by another step of the scheme and on a frame of a quarter of the nodes.
void estimate_on_large_frame(const Solution& s, ErrorEstimate& e) {
  estimate_by_coarser(s, e, [&](int halvings, Tractions& found) {
    if (halvings > 1) return false;
    const std::optional<Variant> coarse =
        solved(s, false, characteristic_step, [&](double d) { return Variant::coarse(s, d); });
    for (std::size_t c = 0; coarse && c < 3; ++c) found[c] = coarse->tractions()[c];
    return coarse.has_value();
  });
  if (s.frictionless || s.prepared->scheme != Scheme::characteristic) return;
  Variant other = Variant::other_step(s, longer * characteristic_step);
  if (other.solve(s, false))
    e.tangential +=
        ratio(difference(s, other.tractions(), s.iterate.lambda).tangential, sums_of(s, s.iterate.lambda).magnitude);
}

void estimate(const Solution& s, ErrorEstimate& e) {
  const Tractions& solution = s.iterate.lambda;
  const std::vector<double>& normal = solution[2];
  if (std::none_of(normal.begin(), normal.end(), [](double l) { return l < 0; })) return;
  const bool friction = !s.frictionless;
  e.normal = e.tractions = 1;
  e.tangential = friction ? 1 : 0;
  // A comparison of two discretisations of an edge says nothing about a contact.
  if (too_few_nodes(s)) return;
  if (s.prepared->problem.op->on_lattice()) return estimate_on_lattice(s, e);
  if (applies_half_spaces(s)) return estimate_on_large_frame(s, e);
  const Sums whole = sums_of(s, solution);
  const bool characteristic = s.prepared->scheme == Scheme::characteristic;

  // The first comparison has the same nodes and another scheme.
  std::optional<Variant> same = solved(s, false, characteristic ? longer * characteristic_step : characteristic_step,
                                       [&](double d) { return Variant::same_nodes(s, friction, d); });
  if (!same) return;
  const Sums scheme = friction ? difference(s, same->tractions(), solution) : Sums{};

  // Pressures respond to the gap between nodes as to an approach.
  std::vector<double> rate;
  if (same->pressure_rate(rate)) e.normal = ratio(std::abs(gap_force(s, rate)), whole.normal);

  // The second comparison has fewer nodes and the same scheme.
  const std::optional<Variant> coarse =
      solved(s, s.given.by_force[approach], characteristic_step, [&](double d) { return Variant::coarse(s, d); });
  if (!coarse || coarse->space().node.size() == s.prepared->frame.used.size()) return;
  const Sums change = difference(s, coarse->tractions(), friction && !characteristic ? same->tractions() : solution);
  // Errors come from the edge of the contact, which is known to one spacing of the nodes there, and are taken to be
  // proportional to it. Errors of the forces add up with it; errors of the tractions lie side by side.
  const double spacing =
      ratio(fringe(coarse->space().frame, coarse->iterate().lambda[2]), fringe(s.prepared->frame, normal));
  const double more = std::clamp(spacing - 1, 0.5, 3.0);
  const double beside = std::hypot(1, std::clamp(spacing, 1.5, 10.0));
  if (friction) e.tangential = ratio(scheme.tangential + change.tangential / more, whole.magnitude);
  const auto root = [](double change2, double whole2) { return std::sqrt(ratio(change2, whole2)); };
  e.tractions =
      std::max(root(change.pressure2, whole.pressure2) / beside,
               root(scheme.tangential2, whole.tangential2) + root(change.tangential2, whole.tangential2) / beside);
}

}  // namespace

const ErrorEstimate& find_error_estimate(const Solution& s, Derived& derived) {
  ErrorEstimate& e = derived.error_estimate;
  if (e.known) return e;
  ++derived.computed.estimates;
  e = {};
  {
    const Stopwatch watch(e.seconds);
    try {
      if (s.report.outcome == Outcome::converged)
        estimate(s, e);
      else if (s.report.outcome != Outcome::no_contact)
        e.normal = e.tangential = e.tractions = 1;
    } catch (const Error&) {
      // A coarse frame would be invalid; what is known by then stays.
    }
  }
  e.known = true;
  return e;
}

}  // namespace rollcon
