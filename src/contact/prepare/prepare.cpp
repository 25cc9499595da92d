/// From scene to discrete problem, redoing only what a change made stale.

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/prepare/lattice_scene.hpp"
#include "contact/prepare/reach.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solution.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

Scheme scheme_of(const std::string& name) {
  if (name == "godunov") return Scheme::godunov;
  return name == "characteristic" ? Scheme::characteristic : Scheme::least_squares;
}

// A pose matters to bodies with a mesh only, and that of a rigid body which neither carries the
// frame nor gives its normals changes the gap alone.
bool poses_leave_frame(SolverState& state, const Scene& scene, const PairOfBodies& pair) {
  const int normals = normal_source(pair);
  bool leave = true;
  for (std::size_t b = 0; b < 2; ++b) {
    if (state.pose_revision[b] == scene.revision.pose[b]) continue;
    const Body& body = *pair.body[b];
    if (!body.meshed()) continue;
    if (!scene.has_gap()) state.gap_revision = -1;
    const bool own =
        static_cast<int>(b) == normals || static_cast<int>(b) == scene.frame_source().body;
    leave = leave && body.rigid() && !own;
  }
  state.pose_revision = scene.revision.pose;
  return leave;
}

// A body may have got another mesh between the call that took a frame from it and its preparation:
// the frame is then one of its own.
FrameSource present_source(const Scene& scene, const PairOfBodies& pair) {
  const FrameSource& source = scene.frame_source();
  if (source.body < 0) return {};
  const SurfaceMesh& mesh = pair.body[static_cast<std::size_t>(source.body)]->mesh().surface;
  for (std::size_t k = 0; k < source.node.size(); ++k) {
    if (source.node[k] >= mesh.nodes() ||
        mesh.node[static_cast<std::size_t>(source.node[k])] != source.place[k])
      return {};
  }
  if (source.element.back() >= mesh.elements()) return {};
  std::vector<std::uint8_t> known(static_cast<std::size_t>(mesh.nodes()), 0);
  for (const std::int32_t k : source.node) known[static_cast<std::size_t>(k)] = 1;
  // Of a frame of corners, those of the faces.
  for (std::size_t i = 0; i < source.element.size(); ++i) {
    const auto own = scene.mesh().element(static_cast<std::int64_t>(i));
    const auto face = mesh.element(source.element[i]);
    if (face.size() < own.size()) return {};
    for (const std::int32_t k : face.first(own.size()))
      if (!known[static_cast<std::size_t>(k)]) return {};
  }
  return source;
}

void build_frame_part(SolverState& state, const Scene& scene, const PairOfBodies& pair) {
  const std::array<std::int64_t, 2> poses_before = state.pose_revision;
  const bool same_poses = poses_leave_frame(state, scene, pair);
  if (state.mesh_revision == scene.revision.mesh && state.axes_revision == scene.revision.axes &&
      same_poses) {
    if (state.pose_revision != poses_before) find_rim(state.frame, pair);
    return;
  }
  ++state.work.frames;
  Frame frame = build_frame(scene.mesh(), scene.axes());
  state.frame_source = present_source(scene, pair);
  if (normal_source(pair) >= 0)
    curve_frame(frame, surface_normals(frame, state.frame_source, pair));
  find_rim(frame, pair);
  const bool same_size =
      frame.nodes() == state.frame.nodes() && state.mesh_revision == scene.revision.mesh;
  state.frame = std::move(frame);
  state.mesh_revision = scene.revision.mesh;
  state.axes_revision = scene.revision.axes;
  state.lattice_known = false;
  state.compliance.reset();
  state.body_compliance[0].reset();
  state.body_compliance[1].reset();
  Problem& p = state.problem;
  take_frame(p, state.frame);
  state.normal_scale = 0;  // outside the option's range: scales are made anew
  state.gap_revision = state.kinematics_revision = state.friction_revision = -1;
  if (!same_size) {
    state.iterate.resize(p.nodes);
    state.warm_usable = false;
  }
}

void build_compliance(SolverState& state, const Scene& scene, const PairOfBodies& pair,
                      int threads) {
  if (state.compliance && state.accuracy == scene.options.accuracy) {
    state.compliance->set_threads(threads);
    return;
  }
  const Stopwatch watch(state.timings.compliance);
  ++state.work.compliances;
  state.compliance = make_pair_compliance(state.frame, pair, scene.options.accuracy, threads);
  state.body_compliance[0].reset();
  state.body_compliance[1].reset();
  state.accuracy = scene.options.accuracy;
  state.problem.stiffness = contact_modulus(pair);
  state.problem.op = ContactOperators{};
  state.scheme.reset();
  state.published.reset();
  state.offset_known = false;
}

// A node that a support keeps from moving along its normal can carry any pressure: Newton's
// iteration would not end.
void refuse_held_nodes(const Frame& frame, const ContactOperators& op) {
  constexpr double rounding = 1e-12;
  const auto diagonal = [&](std::size_t k) {
    // A corner function of a quad8 has a negative mean: its node may even rise under pressure.
    return std::abs(op.block[2][2].row(static_cast<std::int64_t>(k))[k]);
  };
  double largest = 0;
  for (std::size_t k = 0; k < frame.used.size(); ++k)
    if (frame.used[k] && op.has_row(k)) largest = std::max(largest, diagonal(k));
  long long held = 0, first = -1;
  for (std::size_t k = 0; k < frame.used.size(); ++k)
    if (frame.used[k] && op.has_row(k) && !(diagonal(k) > rounding * largest) && held++ == 0)
      first = static_cast<long long>(k) + frame.mesh.index_base;
  if (held > 0)
    fail(Status::err_state,
         "node %lld of the frame (counting from %d) does not move along its normal under pressure: "
         "a support holds the body there; %lld such node(s); end the frame before them or hold the "
         "body elsewhere",
         first, frame.mesh.index_base, held);
}

// A support that keeps a node from moving along one tangent (a plane of symmetry) leaves its slip
// equation without unknowns. A little compliance of its own lets the traction be found: none where
// no slip is forced on it, friction's bound where there is.
void loosen_held_tangents(const Frame& frame, ContactOperators& op) {
  if (!op.tangential) return;
  constexpr double rounding = 1e-12, looseness = 1e-6;
  const std::int64_t n = frame.nodes();
  const auto row_norm = [&](int r, std::int64_t k) {
    return std::hypot(norm2(op.block[r][0].row(k), n), norm2(op.block[r][1].row(k), n));
  };
  const auto there = [&](std::int64_t k) {
    return frame.used[static_cast<std::size_t>(k)] && op.has_row(static_cast<std::size_t>(k));
  };
  double largest = 0;
  for (std::int64_t k = 0; k < n; ++k)
    if (there(k)) largest = std::max({largest, row_norm(0, k), row_norm(1, k)});
  for (std::int64_t k = 0; k < n; ++k) {
    if (!there(k)) continue;
    const double norm[2] = {row_norm(0, k), row_norm(1, k)};
    for (int r = 0; r < 2; ++r)  // both vanish at the inflow rim of upwind schemes
      if (norm[r] <= rounding * largest && norm[1 - r] > rounding * largest)
        op.block[r][r].row(k)[k] = looseness * largest;
  }
}

bool rows_missing(const ContactOperators& op, std::span<const std::uint8_t> wanted) {
  if (op.rows == op.nodes) return false;
  if (wanted.empty()) return true;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (wanted[k] && !op.has_row(k)) return true;
  return false;
}

// Of the nodes with wanted[k] != 0; empty: of all.
void assemble_missing(SolverState& state, std::span<const std::uint8_t> wanted) {
  ContactOperators& op = state.problem.op;
  if (op.normal && (state.frictionless || op.tangential) && !rows_missing(op, wanted)) return;
  const Stopwatch watch(state.timings.compliance);
  if (!fill_from_table(state))
    assemble_operators(state.frame, *state.compliance, !state.frictionless, op, wanted);
  take_reach(state);
  refuse_held_nodes(state.frame, op);
  loosen_held_tangents(state.frame, op);
  ++state.assemblies;
  state.iterate.invalidate();
  if (!state.scales_estimated) state.normal_scale = 0;  // scales follow the operators
  state.newton.operators_changed();
  if (!state.procedure.monolithic) state.published.reset();
}

void choose_scales(SolverState& state, const Options& o) {
  const bool estimate = !state.procedure.standard();
  if (o.normal_scale == state.normal_scale && o.tangential_scale == state.tangential_scale &&
      estimate == state.scales_estimated)
    return;
  if (estimate)
    estimate_scales(state.problem, o.normal_scale, o.tangential_scale);
  else
    set_scales(state.problem, o.normal_scale, o.tangential_scale);
  ++state.work.scales;
  state.normal_scale = o.normal_scale;
  state.tangential_scale = o.tangential_scale;
  state.scales_estimated = estimate;
  state.newton.operators_changed();
  state.published.reset();
}

void build_stencils(SolverState& state, const Scene& scene) {
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
    ++state.work.stencils;
    state.scheme = scheme;
    state.characteristic_step = step;
    state.friction_revision = -1;  // the inflow rim may be another one
    state.kinematics_revision = -1;
    state.field_rows = {};
    state.published.reset();
    state.offset_known = false;
  }
  op.nodes = state.frame.nodes();
}

void build_operators(SolverState& state, const Scene& scene) {
  build_lattice_operators(state, scene.options);
  choose_reach(state, scene.options);
  if (!state.procedure.monolithic) assemble_missing(state, state.reach.wanted);
  choose_scales(state, scene.options);
}

void read_friction(SolverState& state, const Scene& scene) {
  if (state.friction_revision == scene.revision.friction) return;
  ++state.work.frictions;
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

// What loads and given displacements of the bodies do to gap and slip, whatever the tractions.
void find_offset(SolverState& state) {
  if (state.offset_known) return;
  state.offset_known = true;
  if (!state.offset_depth.empty()) state.gap_revision = state.kinematics_revision = -1;
  state.offset_depth.clear();
  for (auto& v : state.offset_slip) v.clear();
  const Frame& frame = state.frame;
  const ContactOperators& op = state.problem.op;
  const std::size_t n = frame.x.size();
  std::vector<double> u(3 * n), ahead;
  if (!state.compliance->offset({frame.x, frame.y}, u.data())) return;
  state.gap_revision = state.kinematics_revision = -1;
  if (!op.upstream.empty()) {
    ahead.resize(3 * n);
    std::vector<double> x = frame.x;
    for (std::size_t k = 0; k < n; ++k) x[k] += op.upstream[k];
    state.compliance->offset({x, frame.y}, ahead.data());
  }
  convect(op, u.data(), ahead.data(), state.offset_slip);
  state.offset_depth.resize(n);
  for (std::size_t k = 0; k < n; ++k) state.offset_depth[k] = u[3 * k + 2];
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

// The new gaps count from no approach; warm starts from the datum before.
void set_datum(SolverState& state) {
  constexpr double steepest = 0.01;  // nodes as steep as that say little about the approach
  Problem& p = state.problem;
  double least = INFINITY;
  for (std::size_t k = 0; k < p.gap.size(); ++k)
    if (state.frame.used[k] && p.closing(k) > steepest)
      least = std::min(least, p.gap[k] / p.closing(k));
  const double datum = std::isfinite(least) ? least : 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) p.gap[k] -= p.closing(k) * datum;
  state.iterate.motion[approach] -= datum - p.datum;
  state.newton.move_datum(datum - p.datum);
  p.datum = datum;
}

void read_gap(SolverState& state, const Scene& scene, const PairOfBodies& pair) {
  if (state.gap_revision == scene.revision.gap) return;
  ++state.work.gaps;
  Problem& p = state.problem;
  if (scene.has_gap()) {
    p.gap.resize(static_cast<std::size_t>(p.nodes));
    for (std::int64_t i = 0; i < p.nodes; ++i) {
      const auto k = static_cast<std::size_t>(i);
      p.gap[k] = scene.gap(i, state.frame.x[k], state.frame.y[k]);
    }
  } else {
    p.gap = undeformed_gap(state.frame, state.frame_source, pair);
    refuse_deep_overlap(state.frame, p.gap, pair);
    fit_gap_to_faces(state.frame, state.frame_source, pair, p.gap);
  }
  for (std::size_t k = 0; k < state.offset_depth.size(); ++k) p.gap[k] -= state.offset_depth[k];
  set_datum(state);
  state.gap_revision = scene.revision.gap;
}

void read_kinematics(SolverState& state, const Scene& scene) {
  Problem& p = state.problem;
  if (state.kinematics_revision != scene.revision.kinematics) {
    ++state.work.slips;
    const auto& field = scene.creep_field();
    const std::size_t n = field.size() / 2;
    p.slip1.resize(n);
    p.slip2.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      p.slip1[k] = field[2 * k] / scene.speed();
      p.slip2[k] = field[2 * k + 1] / scene.speed();
    }
    if (n > 0 && !p.op.upstream.empty()) shift_field(state);
    for (std::size_t k = 0; k < state.offset_depth.size(); ++k) {
      if (k == 0) p.slip1.resize(state.offset_depth.size()), p.slip2.resize(p.slip1.size());
      p.slip1[k] += state.offset_slip[0][k];
      p.slip2[k] += state.offset_slip[1][k];
    }
    state.kinematics_revision = scene.revision.kinematics;
  }
  Prescribed& given = state.given;
  for (const Direction d :
       {Direction::longitudinal, Direction::lateral, Direction::normal, Direction::spin}) {
    const auto m = static_cast<std::size_t>(d) - 1;
    given.by_force[m] = scene.load(d).how == How::by_force;
    given.value[m] = scene.load(d).value;
    if (d == Direction::normal) given.prescribe_normal(given.by_force[m], given.value[m], p.datum);
  }
}

// Which of the two bodies a message speaks of.
void prepare_body(Body& body, int which, Work& work) {
  try {
    const bool before = body.prepared();
    body.prepare();
    if (!before && body.response() && !body.shared() && !body.loaded()) ++work.bodies;
  } catch (const Error& error) {
    throw Error(error.status(), "body " + std::to_string(which) + ": " + error.what());
  }
}

}  // namespace

std::size_t SolverState::bytes() const {
  const auto n = static_cast<std::size_t>(problem.nodes);
  const std::size_t system = published ? published->bytes() : 0;
  return problem.op.bytes() + newton.bytes() + system + (compliance ? compliance->bytes() : 0) +
         n * sizeof(double) * 30 + history.capacity() * sizeof(double);
}

void require_rows(SolverState& state, const Options& options,
                  std::span<const std::uint8_t> wanted) {
  try {
    assemble_missing(state, wanted);
    choose_scales(state, options);
  } catch (...) {
    // Not during a solve: nothing else would drop what was half assembled.
    ContactOperators& op = state.problem.op;
    for (auto& row : op.block)
      for (auto& block : row) block.release();
    op.normal = op.tangential = false;
    state.newton.operators_changed();
    throw;
  }
  state.images_known = false;
}

void require_operators(SolverState& state, const Options& options) {
  require_rows(state, options, state.reach.wanted);
}

void prepare(SolverState& state, const Scene& scene, Body& body1, Body& body2, int threads) {
  state.work_before = state.work;
  state.assemblies_before = state.assemblies;
  state.procedure = choose_procedure(scene.options);
  scene.require_complete(body1.meshed() || body2.meshed());
  if (!body1.prepared() || !body2.prepared()) {
    const Stopwatch watch(state.timings.compliance);
    prepare_body(body1, 1, state.work);
    prepare_body(body2, 2, state.work);
  }
  state.pair = {{&body1, &body2}, {scene.pose(0), scene.pose(1)}};
  const PairOfBodies& pair = state.pair;
  build_frame_part(state, scene, pair);
  build_compliance(state, scene, pair, threads);
  build_stencils(state, scene);
  find_offset(state);
  read_friction(state, scene);
  mask_inflow_rim(state);
  read_gap(state, scene, pair);
  read_kinematics(state, scene);
  build_operators(state, scene);
  state.speed = scene.speed();
}

}  // namespace rollcon
