#include "contact/results/power.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "contact/derived.hpp"
#include "contact/prepare/lattice_scene.hpp"
#include "contact/prepare/time_step.hpp"
#include "linalg/fft.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Integrates f times the derivative of g along x over one element, both by its shape functions.
double integral_of_slope(const Frame& frame, std::span<const std::int32_t> node, ElementType type,
                         const PlaneRule& rule, const double* f, const double* g) {
  double sum = 0;
  Shape shape;
  for (std::size_t q = 0; q < rule.size(); ++q) {
    evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
    double value = 0, g_xi = 0, g_eta = 0, y_xi = 0, y_eta = 0;
    for (std::size_t i = 0; i < node.size(); ++i) {
      const double y = frame.y[at(node[i])];
      value += shape.value[i] * f[i];
      g_xi += shape.d_xi[i] * g[i];
      g_eta += shape.d_eta[i] * g[i];
      y_xi += shape.d_xi[i] * y;
      y_eta += shape.d_eta[i] * y;
    }
    sum += rule.w[q] * value * (g_xi * y_eta - g_eta * y_xi);  // the Jacobian cancels
  }
  return sum;
}

// Integrates the normal traction times the slope of the elastic normal displacement along the rolling direction. Inside
// the contact that is the rigid gap's; but beside it the gap is not closed, and on coarse elements half of the pressure
// next to the edge is work on such elements: like bodies would seem to lose or gain power by pressure alone.
// displacement: three at each node; null: those of the solution.
double work_of_pressures(const Solution& s, const std::vector<double>* displacement = nullptr) {
  constexpr int degree = 4;
  const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  const std::vector<double>& normal = it.lambda[2];
  double sum = 0;
  double f[max_element_nodes], g[max_element_nodes];
  for (std::int64_t e = 0; e < s.prepared->frame.elements(); ++e) {
    const auto node = s.prepared->frame.mesh.element(e);
    bool loaded = false;
    for (std::size_t i = 0; i < node.size(); ++i) {
      f[i] = std::min(normal[at(node[i])], 0.0);
      loaded = loaded || f[i] < 0;
    }
    if (!loaded) continue;
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (!displacement) it.update_gap(p, node[i]);
      g[i] = displacement ? (*displacement)[3 * at(node[i]) + 2] : it.image[2][at(node[i])];
    }
    const ElementType type = s.prepared->frame.mesh.type[at(e)];
    sum += integral_of_slope(s.prepared->frame, node, type, corner_count(type) == 3 ? triangle : square, f, g);
  }
  return sum;
}

// Returns the work of creepages and spin at node k, per unit of speed.
double work_of_motions(const Problem& p, const Iterate& it, std::size_t k) {
  double work = 0;
  for (const int m : {xi1, xi2, spin}) {
    const auto row = p.load_row(m, k);
    work += p.motion_scale * it.motion[at(m)] * (row[0] * it.lambda[0][k] + row[1] * it.lambda[1][k]);
  }
  return work;
}

// Returns the work of creepages, spin and fields of slip at all nodes.
double work_of_rigid_slip(const Solution& s) {
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  double work = 0;
  for (std::size_t k = 0; k < it.lambda[2].size(); ++k) {
    if (!(it.lambda[2][k] < 0)) continue;
    work += work_of_motions(p, it, k);
    if (!p.slip1.empty()) work += p.weight[k] * (it.lambda[0][k] * p.slip1[k] + it.lambda[1][k] * p.slip2[k]);
  }
  return work;
}

// Sums tangential traction times slip velocity and a weight over the nodes in contact.
double work_of_slip(const Solution& s, Derived& d, const std::vector<double>& weight) {
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  const bool known = (p.op->tangential || s.images_known) && p.before_touch.empty();
  if (!known) derive_fields(s, d);
  double sum = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!(it.lambda[2][k] < 0)) continue;
    std::array<double, 2> slip{known ? 0 : d.slip[0][k], known ? 0 : d.slip[1][k]};
    if (known) {
      const auto i = static_cast<std::int64_t>(k);
      it.update_slip(p, i);
      slip = {s.prepared->speed * (p.rigid_slip1(i, it.motion) + it.image[0][k]),
              s.prepared->speed * (p.rigid_slip2(i, it.motion) + it.image[1][k])};
    }
    sum += weight[k] * (it.lambda[0][k] * slip[0] + it.lambda[1][k] * slip[1]);
  }
  return sum;
}

/// Finds displacements, three at each node, under all tractions of the solution or the pressures alone.
std::vector<double> displacements_by(const Solution& s, const Compliance& compliance, bool pressures_alone) {
  const Prepared& on = *s.prepared;
  std::vector<double> lambda[3] = {s.iterate.lambda[0], s.iterate.lambda[1], s.iterate.lambda[2]};
  for (std::size_t c = 0; pressures_alone && c < 2; ++c) std::fill(lambda[c].begin(), lambda[c].end(), 0.0);
  std::vector<double> u(3 * on.frame.x.size()), traction(u.size());
  if (on.lattice && on.lattice->ey == 0 && has_fft() && displacements_on_lattice(s, compliance, lambda, u.data()))
    return u;
  for (std::size_t k = 0; k < u.size(); ++k) traction[k] = lambda[k % 3][k / 3];
  compliance.apply({on.frame.x, on.frame.y}, traction.data(), u.data());
  return u;
}

/// Returns the power over the speed that bodies lose by creeping under all tractions, or the pressures alone.
double lost_in_bodies(const Solution& s, bool pressures_alone, int which) {
  const Prepared& on = *s.prepared;
  double sum = 0;
  for (const auto& loss : make_losses(on.frame, on.pair, on.accuracy, 1, which)) {
    const std::vector<double> u = displacements_by(s, *loss, pressures_alone);
    for (std::size_t k = 0; k < u.size(); ++k)
      if (!pressures_alone || k % 3 == 2) sum += on.problem.weight[k / 3] * s.iterate.lambda[k % 3][k / 3] * u[k];
  }
  return sum;
}

/// Returns what bodies that creep do not lose of what is put in, over -V. What pressures alone do and what they lose is
/// the same, and far more than friction takes: it is left out of both.
double work_beside_creep(const Solution& s) {
  double work = work_of_rigid_slip(s) + rolling_resistance(s) - lost_in_bodies(s, true, -1);
  if (s.prepared->problem.op->coupled) {
    const std::vector<double> alone = displacements_by(s, *s.prepared->compliance, true);
    work += work_of_pressures(s) - work_of_pressures(s, &alone);
  }
  return work;
}

}  // namespace

// Corrects the sum over nodes of what slip takes, which misses a part on coarse grids, by what such a sum misses of the
// work of tractions on their own displacements carried along, of which the true value is known.
double power_in_step(const Solution& s, Derived& d, Preparation* preparation) {
  if (s.frictionless) return 0;
  const Prepared& on = *s.prepared;
  const Problem& p = on.problem;
  double work = work_of_slip(s, d, p.weight);
  if (on.distance == 0) return -work;
  std::vector<double> change[2];
  find_changes_upstream(s, preparation, change);
  const Iterate& it = s.iterate;
  double missed = on.distance * work_of_pressures(s);
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!(it.lambda[2][k] < 0)) continue;
    // Work of the loads needs no sum over nodes.
    missed += work_of_motions(p, it, k);
    const auto i = static_cast<std::int64_t>(k);
    for (std::size_t c = 0; c < 2; ++c)
      missed += p.weight[k] * it.lambda[c][k] * (change[c][k] - p.motion_slip(c, i, it.motion));
  }
  return -work - on.speed * missed;
}

// Relies on tractions that are carried along a surface that is the same everywhere: they change no elastic energy, so
// what their tangential and normal parts do on the elastic displacements adds up to nothing.
double power_put_in(const Solution& s) {
  if (s.frictionless) return 0;
  if (s.prepared->pair.creeps()) return -s.prepared->speed * work_beside_creep(s);
  return -s.prepared->speed * (work_of_pressures(s) + work_of_rigid_slip(s));
}

double rolling_resistance(const Solution& s, int which) {
  return lost_in_bodies(s, false, which);
}

bool power_is_balanced(const Solution& s) {
  const Prepared& on = *s.prepared;
  return on.pair.half_spaces() && !s.frictionless && on.step == StepKind::steady && nodes_at_rim(s) == 0;
}

double power_at_nodes(const Solution& s, Derived& d) {
  // Cells of strips reach to the contact's edge, where tractions vanish.
  const Problem& p = s.prepared->problem;
  return s.frictionless ? 0 : -work_of_slip(s, d, s.prepared->frame.strips ? p.weight : p.cell_area);
}

}  // namespace rollcon
