/// From scene to discrete problem, redoing only what a change made stale.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/halfspace/halfspace.hpp"
#include "contact/moments.hpp"
#include "contact/state.hpp"
#include "support/clock.hpp"

namespace rollcon {
namespace {

Scheme scheme_of(const std::string& name) {
  if (name == "godunov") return Scheme::godunov;
  return name == "characteristic" ? Scheme::characteristic : Scheme::least_squares;
}

HalfspaceConstants constants_of(const Body& body, int sign) {
  if (body.rigid()) return {};
  return halfspace_constants(body.young(), body.poisson(), sign);
}

void build_frame_part(SolverState& state, const Scene& scene) {
  if (state.mesh_revision == scene.revision.mesh && state.axes_revision == scene.revision.axes)
    return;
  Frame frame = build_frame(scene.mesh(), scene.axes());
  const bool same_size =
      frame.nodes() == state.frame.nodes() && state.mesh_revision == scene.revision.mesh;
  state.frame = std::move(frame);
  state.mesh_revision = scene.revision.mesh;
  state.axes_revision = scene.revision.axes;
  state.compliance.reset();
  state.body_compliance[0].reset();
  state.body_compliance[1].reset();
  Problem& p = state.problem;
  p.nodes = state.frame.nodes();
  p.weight = state.frame.weight;
  p.cell_area = state.frame.cell_area;
  p.used = state.frame.used;
  p.length = std::sqrt(state.frame.area);
  moment_weights(state.frame, p.moment_x, p.moment_y);
  state.gap_revision = state.kinematics_revision = state.friction_revision = -1;
  if (!same_size) {
    state.iterate.resize(p.nodes);
    state.warm_usable = false;
  }
}

void build_compliance(SolverState& state, const Scene& scene, const Body& body1, const Body& body2,
                      int threads) {
  if (state.compliance && state.accuracy == scene.options.accuracy) {
    state.compliance->set_threads(threads);
    return;
  }
  const Stopwatch watch(state.timings.compliance);
  const HalfspaceConstants c1 = constants_of(body1, 1), c2 = constants_of(body2, -1);
  HalfspaceConstants sum{c1.cn + c2.cn, c1.cv + c2.cv, c1.ck + c2.ck};
  // Equal (1 - 2 nu)/G decouples; rounding of two equal materials must not couple them again.
  if (std::abs(sum.ck) <= 1e-14 * (std::abs(c1.ck) + std::abs(c2.ck))) sum.ck = 0;
  state.compliance = make_halfspace_compliance(state.frame, sum, scene.options.accuracy, threads);
  state.body_compliance[0].reset();
  state.body_compliance[1].reset();
  state.accuracy = scene.options.accuracy;
  state.problem.stiffness = 1 / (std::numbers::pi * sum.cn);
  state.problem.op = ContactOperators{};
  state.scheme.reset();
}

void build_operators(SolverState& state, const Scene& scene) {
  ContactOperators& op = state.problem.op;
  const Scheme scheme = scheme_of(scene.options.convection);
  const double step = scene.options.characteristic_step;
  const bool other_scheme = !state.scheme || *state.scheme != scheme ||
                            (scheme == Scheme::characteristic && step != state.characteristic_step);
  if (other_scheme) {
    const Stopwatch watch(state.timings.convection);
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c) op.block[r][c].release();
    op.tangential = false;
    prepare_convection(state.frame, scheme, step, op);
    state.scheme = scheme;
    state.characteristic_step = step;
    state.friction_revision = -1;  // the inflow rim may be another one
    state.kinematics_revision = -1;
    state.field_rows = {};
  }
  const bool missing = !op.normal || (!state.frictionless && !op.tangential);
  const Options& o = scene.options;
  if (missing) {
    const Stopwatch watch(state.timings.compliance);
    assemble_operators(state.frame, *state.compliance, !state.frictionless, op);
    ++state.assemblies;
    state.iterate.invalidate();
  }
  if (missing || o.normal_scale != state.normal_scale ||
      o.tangential_scale != state.tangential_scale) {
    set_scales(state.problem, o.normal_scale, o.tangential_scale);
    state.normal_scale = o.normal_scale;
    state.tangential_scale = o.tangential_scale;
    state.newton.operators_changed();
  }
}

void read_friction(SolverState& state, const Scene& scene) {
  if (state.friction_revision == scene.revision.friction) return;
  Problem& p = state.problem;
  p.mu.resize(static_cast<std::size_t>(p.nodes));
  bool frictionless = true;
  for (std::int64_t i = 0; i < p.nodes; ++i) {
    const double mu = scene.friction(i);
    p.mu[static_cast<std::size_t>(i)] = mu;
    frictionless = frictionless && !(mu > 0);
  }
  if (frictionless && !state.frictionless) {
    std::fill(state.iterate.lambda[0].begin(), state.iterate.lambda[0].end(), 0.0);
    std::fill(state.iterate.lambda[1].begin(), state.iterate.lambda[1].end(), 0.0);
    state.iterate.invalidate();
  }
  state.frictionless = frictionless;
  state.friction_revision = scene.revision.friction;
  state.inflow_masked = false;
}

void mask_inflow_rim(SolverState& state) {
  const SparseRows& d = state.problem.op.convection;
  if (state.inflow_masked || d.start.empty()) return;
  for (std::size_t i = 0; i + 1 < d.start.size(); ++i)
    if (d.start[i] == d.start[i + 1]) state.problem.mu[i] = 0;
  state.inflow_masked = true;
}

// A creep field is given at the nodes, but the characteristic scheme takes slip half a step
// upstream: c(x + delta/2 e) = c - delta/2 (v . grad c), exact for linear fields such as spin.
void shift_field(SolverState& state) {
  Problem& p = state.problem;
  SparseRows& d = state.field_rows;
  if (d.start.empty()) d = least_squares(state.frame, 1, 0);
  for (std::vector<double>* field : {&p.slip1, &p.slip2}) {
    state.field_copy = *field;
    for (std::size_t i = 0; i < field->size(); ++i) {
      double derivative = 0;
      for (auto k = static_cast<std::size_t>(d.start[i]);
           k < static_cast<std::size_t>(d.start[i + 1]); ++k)
        derivative += d.value[k] * state.field_copy[static_cast<std::size_t>(d.column[k])];
      (*field)[i] -= 0.5 * p.op.upstream[i] * derivative;
    }
  }
}

void read_kinematics(SolverState& state, const Scene& scene) {
  Problem& p = state.problem;
  if (state.gap_revision != scene.revision.gap) {
    p.gap.resize(static_cast<std::size_t>(p.nodes));
    for (std::int64_t i = 0; i < p.nodes; ++i) {
      const auto k = static_cast<std::size_t>(i);
      p.gap[k] = scene.gap(i, state.frame.x[k], state.frame.y[k]);
    }
    state.gap_revision = scene.revision.gap;
  }
  if (state.kinematics_revision != scene.revision.kinematics) {
    const auto& field = scene.creep_field();
    const std::size_t n = field.size() / 2;
    p.slip1.resize(n);
    p.slip2.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      p.slip1[k] = field[2 * k] / scene.speed();
      p.slip2[k] = field[2 * k + 1] / scene.speed();
    }
    if (n > 0 && !p.op.upstream.empty()) shift_field(state);
    state.kinematics_revision = scene.revision.kinematics;
  }
  for (const Direction d :
       {Direction::longitudinal, Direction::lateral, Direction::normal, Direction::spin}) {
    const auto m = static_cast<std::size_t>(d) - 1;
    p.by_force[m] = scene.load(d).how == How::by_force;
    p.value[m] = scene.load(d).value;
  }
}

}  // namespace

std::size_t SolverState::bytes() const {
  const auto n = static_cast<std::size_t>(problem.nodes);
  return problem.op.bytes() + newton.bytes() + (compliance ? compliance->bytes() : 0) +
         n * sizeof(double) * 30 + history.capacity() * sizeof(double);
}

void prepare(SolverState& state, const Scene& scene, Body& body1, Body& body2, int threads) {
  scene.require_complete();
  body1.prepare();
  body2.prepare();
  build_frame_part(state, scene);
  read_friction(state, scene);
  build_compliance(state, scene, body1, body2, threads);
  build_operators(state, scene);
  read_friction(state, scene);
  mask_inflow_rim(state);
  read_kinematics(state, scene);
  state.speed = scene.speed();
}

}  // namespace rollcon
