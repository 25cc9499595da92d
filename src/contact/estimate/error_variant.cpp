#include "contact/estimate/error_variant.hpp"

#include <algorithm>
#include <cmath>

#include "contact/operators/dense_operators.hpp"
#include "contact/operators/hierarchical/hierarchical_operator.hpp"
#include "contact/solution.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Estimates need two digits. An iteration that ends in a cycle of a few nodes has found the forces.
constexpr double tolerance = 1e-6;
constexpr double good_enough = 1e-2;
constexpr std::int64_t max_iterations = 60;

struct Silent final : Monitor {
  bool step(const StepRecord&) override { return false; }
};

// Picks rows over the space's nodes; where a sample is none, the difference at the node itself.
Convection pick(const TractionSpace& space, const Convection& whole) {
  Convection c;
  c.factor = pick(space, whole.factor);
  c.ahead = pick(space, whole.ahead);
  c.slip_x = pick(space, whole.slip_x);
  c.slip_y = pick(space, whole.slip_y);
  const std::size_t n = whole.ahead.size(), own = c.ahead.size();
  std::vector<std::int32_t> place(n, -1);
  for (std::size_t i = 0; i < own; ++i) place[at(space.node[i])] = static_cast<std::int32_t>(i);
  const auto add = [&](std::size_t sample, double value) {
    c.rows.column.push_back(static_cast<std::int32_t>(sample));
    c.rows.value.push_back(value);
  };
  c.rows.start.push_back(0);
  for (std::size_t i = 0; i < own; ++i) {
    const std::size_t k = at(space.node[i]), from = at(whole.rows.start[k]), to = at(whole.rows.start[k + 1]);
    const auto there = [&](std::int32_t sample) { return place[at(sample) % n] >= 0; };
    if (std::all_of(whole.rows.column.data() + from, whole.rows.column.data() + to, there)) {
      for (std::size_t j = from; j < to; ++j) {
        const std::size_t sample = at(whole.rows.column[j]), at_node = at(place[sample % n]);
        add(sample < n ? at_node : own + at_node, whole.rows.value[j]);
      }
    } else {
      add(i, 1);
      add(own + i, -1);
      c.slip_x[i] = space.frame.x[i] + c.ahead[i] / 2;
    }
    c.rows.start.push_back(static_cast<std::int64_t>(c.rows.column.size()));
  }
  return c;
}

}  // namespace

void Variant::take_problem(const Solution& s) {
  const Problem& from = s.prepared->problem;
  Problem& p = problem_;
  p.nodes = space_->frame.nodes();
  p.used.assign(at(p.nodes), 1);
  p.length = from.length;
  p.motion_scale = from.motion_scale;
  p.stiffness = from.stiffness;
  p.law = from.law;
  p.own_law = from.own_law;
  p.weight = gather(*space_, from.weight);
  p.moment_x = gather(*space_, from.moment_x);
  p.moment_y = gather(*space_, from.moment_y);
  p.moment_z = gather(*space_, from.moment_z);
  for (std::size_t t = 0; t < 2; ++t) p.tilting[t] = pick(*space_, from.tilting[t]);
  p.cell_area = gather(*space_, from.cell_area);
  p.gap = pick(*space_, from.gap);
  std::vector<double> mu = from.mu;  // the solution's coefficients, where friction follows it
  for (std::size_t k = 0; k < mu.size() && !s.given.utilisation.empty(); ++k) mu[k] *= s.given.utilisation[k];
  p.mu = pick(*space_, mu);
  p.slip1 = pick(*space_, from.slip1);
  p.slip2 = pick(*space_, from.slip2);
  p.before_touch = pick(*space_, from.before_touch);
  if (!from.turn.empty())
    for (const std::int32_t k : space_->node) p.turn.push_back(from.turn[at(k)]);
  compliance_ = compliance_of(*s.prepared->compliance, *space_);
  newton_ = std::make_unique<Newton>();
  iterate_.resize(p.nodes);
  iterate_.motion = s.iterate.motion;
}

// Takes a step in time on these nodes, from what the step before left on the fine frame.
void Variant::take_step(const Solution& s) {
  const Convection& fine = s.prepared->problem.convection;
  problem_.convection = make_convection(space_->frame, Scheme::time_step, false);
  problem_.convection.slip_x = pick(*space_, fine.slip_x);
  problem_.convection.slip_y = pick(*space_, fine.slip_y);
}

// Takes slip that is given at nodes where the characteristic scheme takes slip: half a step upstream.
void Variant::move_given_slip(const Solution& s) {
  Problem& p = problem_;
  if (p.slip1.empty()) return;
  const SparseRows d = least_squares(s.prepared->frame, 1, 0);
  const std::vector<double>& there = s.prepared->problem.convection.slip_x;
  const auto derivative = [&](const std::vector<double>& field, std::size_t k) {
    double sum = 0;
    for (auto j = at(d.start[k]); j < at(d.start[k + 1]); ++j) sum += d.value[j] * field[at(d.column[j])];
    return sum;
  };
  for (std::size_t i = 0; i < p.slip1.size(); ++i) {
    const std::size_t k = at(space_->node[i]);
    const double further = p.convection.slip_x[i] - there[k];
    p.slip1[i] -= further * derivative(s.prepared->problem.slip1, k);
    p.slip2[i] -= further * derivative(s.prepared->problem.slip2, k);
  }
}

bool applies_half_spaces(const Solution& s) {
  return s.prepared->problem.op->all_at_once() && s.prepared->compliance->translation() != nullptr;
}

void Variant::assemble(const Solution& s, bool tangential) {
  frictionless_ = !tangential;
  if (applies_half_spaces(s)) {
    compliance_ = s.prepared->compliance->on_part(space_->frame);
    problem_.op = std::make_shared<HierarchicalOperator>(space_->frame, *compliance_, problem_.convection, tangential,
                                                         good_enough * tolerance, 1);
    if (tangential) move_given_slip(s);
    return set_scales(problem_);
  }
  const auto op = std::make_shared<DenseOperators>();
  // A monolithic solve has no rows to take, and neither have corrected lattices.
  const Operators& rows = *s.prepared->problem.op;
  if (rows.normal && !rows.all_at_once()) take_normal_rows(rows, *space_, *op);
  assemble_operators(space_->frame, *compliance_, problem_.convection, tangential, *op);
  op->loosen_held_tangents(problem_.used, !problem_.convection.ahead.empty());
  if (tangential && s.prepared->scheme != Scheme::time_step) move_given_slip(s);
  problem_.op = op;
  set_scales(problem_);
}

Variant Variant::same_nodes(const Solution& s, bool tangential, double step) {
  Variant v;
  v.space_ = std::make_unique<TractionSpace>(loaded_space(s.prepared->frame, s.iterate.lambda[2]));
  v.take_problem(s);
  if (s.prepared->scheme == Scheme::time_step) {
    v.take_step(s);
  } else if (tangential) {
    v.problem_.convection =
        pick(*v.space_, make_convection(s.prepared->frame, Scheme::characteristic, s.prepared->ends_at_edge, step));
  }
  v.assemble(s, tangential);
  for (std::size_t c = 0; c < 3; ++c) v.iterate_.lambda[c] = pick(*v.space_, s.iterate.lambda[c]);
  if (!tangential) {
    std::fill(v.iterate_.lambda[0].begin(), v.iterate_.lambda[0].end(), 0.0);
    std::fill(v.iterate_.lambda[1].begin(), v.iterate_.lambda[1].end(), 0.0);
  }
  v.iterate_.invalidate();
  return v;
}

Variant Variant::other_step(const Solution& s, double step) {
  Variant v;
  const Frame& frame = s.prepared->frame;
  v.space_ = std::make_unique<TractionSpace>(whole_space(frame));
  v.take_problem(s);
  v.problem_.convection = make_convection(frame, Scheme::characteristic, s.prepared->ends_at_edge, step);
  v.assemble(s, true);
  for (std::size_t c = 0; c < 3; ++c) v.iterate_.lambda[c] = s.iterate.lambda[c];
  v.iterate_.invalidate();
  return v;
}

Variant Variant::coarse(const Solution& s, double step) {
  Variant v;
  v.space_ = std::make_unique<TractionSpace>(coarse_space(s.prepared->frame));
  v.take_problem(s);
  if (s.prepared->scheme == Scheme::time_step)
    v.take_step(s);
  else if (!s.frictionless)
    v.problem_.convection = make_convection(v.space_->frame, Scheme::characteristic, s.prepared->ends_at_edge, step);
  v.assemble(s, !s.frictionless);
  return v;
}

bool Variant::solve(const Solution& s, bool given_load) {
  given_ = s.given;
  given_.utilisation.clear();
  given_.value = s.iterate.motion;
  given_.by_force = {};
  given_.by_force[approach] = given_load;
  if (given_load) given_.value[approach] = s.given.value[approach];
  Silent silent;
  const NewtonReport report =
      newton_->solve(problem_, given_, iterate_, frictionless_, tolerance, max_iterations, silent);
  for (std::size_t c = 0; c < 3; ++c) traction_[c] = spread(*space_, iterate_.lambda[c]);
  return report.outcome == Outcome::converged || report.outcome == Outcome::no_contact ||
         std::max(report.residual_normal, report.residual_tangential) < good_enough;
}

bool Variant::pressure_rate(std::vector<double>& rate) {
  const Problem& p = problem_;
  given_.by_force[approach] = false;
  newton_->operators_changed();
  ReducedSystem& system = newton_->linearise(p, given_, iterate_, Part::normal);
  const std::size_t active = at(system.active());
  std::vector<double> gap(active), none(active, 0.0), b, x;
  for (std::size_t a = 0; a < active; ++a) gap[a] = -p.closing(at(system.nodes()[a]));
  system.rate_side(gap, none, none, none, none, {}, b);
  if (!newton_->linear().solve(system, p.nodes, b, good_enough, x)) return false;
  std::vector<double> own(at(p.nodes), 0.0);
  for (std::size_t a = 0; a < active; ++a) own[at(system.nodes()[a])] = x[a];
  rate = spread(*space_, own);
  return true;
}

}  // namespace rollcon
