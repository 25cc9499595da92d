/// Results of the last solve, copied out to the caller.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/contact.hpp"
#include "contact/results/extrapolation.hpp"
#include "contact/results/sensitivity.hpp"
#include "contact/results/statistics.hpp"
#include "contact/results/wear.hpp"
#include "contact/settle/settle_friction.hpp"
#include "contact/solution.hpp"
#include "io/vtu.hpp"
#include "linalg/blas_threads.hpp"

namespace rollcon {
namespace {

// Vector from local directions to global coordinates.
Vec3 to_global(const Triad& a, double v1, double v2, double vn) {
  Vec3 g;
  for (std::size_t c = 0; c < 3; ++c) g[c] = v1 * a.t1[c] + v2 * a.t2[c] + vn * a.n[c];
  return g;
}

void put(const Triad& local, InAxes in, double v1, double v2, double vn, double* out) {
  const Vec3 v = in == InAxes::global ? to_global(local, v1, v2, vn) : Vec3{v1, v2, vn};
  std::copy(v.begin(), v.end(), out);
}

Triad triad_of(const Axes& axes) {
  return {axes.t1, axes.t2, axes.n};
}

void require_capacity(std::int64_t capacity, std::int64_t needed, const char* unit) {
  if (capacity < needed)
    fail(Status::err_capacity, "capacity is %lld but %lld %s are needed", static_cast<long long>(capacity),
         static_cast<long long>(needed), unit);
}

std::int64_t components_of(Field field, InAxes axes) {
  switch (field) {
    case Field::point:
    case Field::traction:
    case Field::displacement1:
    case Field::displacement2:
      return 3;
    case Field::slip:
    case Field::rigid_slip:
      return axes == InAxes::local ? 2 : 3;
    case Field::temperature:
      return 2;
    default:
      return 1;
  }
}

/// Node k as its law sees it. Slip is known where the law follows it.
FrictionPoint point_of(const SolverState& s, std::size_t k) {
  const Problem& p = s.prepared->problem;
  FrictionPoint point{s.given.coefficient(p.mu, k), std::max(-s.iterate.lambda[2][k], 0.0), s.iterate.lambda[0][k],
                      s.iterate.lambda[1][k]};
  if (p.law->falls()) point.s1 = s.slip[0][k] / s.prepared->speed, point.s2 = s.slip[1][k] / s.prepared->speed;
  return point;
}

// Of node k; displacements apart.
void write_value(const SolverState& s, Field field, InAxes axes, std::size_t k, double* out) {
  const Prepared& on = *s.prepared;
  const Frame& frame = on.frame;
  const Problem& p = on.problem;
  const Iterate& it = s.iterate;
  const auto tangential = [&](double v1, double v2) {
    if (axes == InAxes::local)
      out[0] = v1, out[1] = v2;
    else
      put(frame.triad(k), axes, v1, v2, 0, out);
  };
  // As given by the caller, without what displacements given elsewhere add.
  const auto own = [&](std::size_t c, double slip) {
    return on.speed * (slip - (on.offset_slip[c].empty() ? 0 : on.offset_slip[c][k]));
  };
  const auto i = static_cast<std::int64_t>(k);
  switch (field) {
    case Field::point:
      if (axes == InAxes::local)
        out[0] = frame.x[k], out[1] = frame.y[k], out[2] = frame.z[k];
      else
        std::copy(frame.mesh.node[k].begin(), frame.mesh.node[k].end(), out);
      return;
    case Field::traction:
      return put(frame.triad(k), axes, it.lambda[0][k], it.lambda[1][k], it.lambda[2][k], out);
    case Field::slip:
      return tangential(s.slip[0][k], s.slip[1][k]);
    case Field::rigid_slip:
      return tangential(own(0, p.rigid_slip1(i, it.motion)), own(1, p.rigid_slip2(i, it.motion)));
    case Field::area:
      *out = p.cell_area[k];
      return;
    case Field::weight:
      *out = p.weight[k];
      return;
    case Field::friction:
      *out = s.frictionless ? s.given.coefficient(p.mu, k) : p.law->coefficient(point_of(s, k));
      return;
    case Field::pressure:
      *out = it.lambda[2][k] < 0 ? -it.lambda[2][k] : 0.0;
      return;
    case Field::friction_power:
      *out = -(it.lambda[0][k] * s.slip[0][k] + it.lambda[1][k] * s.slip[1][k]);
      return;
    default:
      return;
  }
}

}  // namespace

void Contact::require_solution() const {
  if (!state_->solved || state_->revision_solved.mesh != scene.revision.mesh)
    fail(Status::err_state,
         "there is no solution: call rollcon_contact_solve first (inputs that "
         "change the frame, or a failed solve, discard the last one)");
}

void Contact::tractions(InAxes axes, std::int64_t capacity, double* t) const {
  require_solution();
  const Iterate& it = state_->iterate;
  require_capacity(capacity, state_->prepared->problem.nodes, "nodes");
  for (std::size_t k = 0; k < it.lambda[0].size(); ++k)
    put(state_->prepared->frame.triad(k), axes, it.lambda[0][k], it.lambda[1][k], std::min(it.lambda[2][k], 0.0),
        t + 3 * k);  // within the tolerance a node about to open may pull
}

std::int64_t Contact::field(Field field, InAxes axes, std::int64_t capacity, double* v) const {
  SolverState& s = *state_;
  require_solution();
  const Frame& frame = s.prepared->frame;
  const auto n = static_cast<std::size_t>(s.prepared->problem.nodes);
  const std::int64_t components = components_of(field, axes);
  const std::int64_t needed = components * s.prepared->problem.nodes;
  if (capacity == 0 && v == nullptr) return needed;
  require_capacity(capacity, needed, "doubles");
  const bool at_slip = field == Field::friction && s.prepared->problem.law->falls();
  if (at_slip || field == Field::slip || field == Field::friction_power) derive_fields(s);
  if (field == Field::gap) {
    derive_gap(s, v);
    return needed;
  }
  if (field == Field::temperature) {
    node_temperatures(s, scene.heat(), {v, 2 * n});
    return needed;
  }
  if (field == Field::displacement1 || field == Field::displacement2) {
    std::vector<double> xy(2 * n);
    for (std::size_t k = 0; k < n; ++k) xy[2 * k] = frame.x[k], xy[2 * k + 1] = frame.y[k];
    displacements_at(field == Field::displacement1 ? 1 : 2, needed / 3, xy.data(), v);
    for (std::size_t k = 0; k < n; ++k) put(frame.triad(k), axes, v[3 * k], v[3 * k + 1], v[3 * k + 2], v + 3 * k);
    return needed;
  }
  for (std::size_t k = 0; k < n; ++k, v += components) write_value(s, field, axes, k, v);
  return needed;
}

void Contact::node_status(std::int64_t capacity, std::int32_t* status) const {
  require_solution();
  require_capacity(capacity, state_->prepared->problem.nodes, "nodes");
  derive_fields(*state_);
  std::copy(state_->status.begin(), state_->status.end(), status);
}

void Contact::resultant(InAxes axes, double* force, double* moment) const {
  require_solution();
  Vec3 f, m;
  if (state_->extrapolated)
    f = state_->extrapolated->force, m = state_->extrapolated->moment;
  else
    sum_tractions(state_->prepared->problem, state_->iterate.lambda, f, m);
  const Triad local = triad_of(state_->prepared->frame.axes);
  if (force) put(local, axes, f[0], f[1], f[2], force);
  if (moment) put(local, axes, m[0], m[1], m[2], moment);
}

void Contact::motion(double* depth, double* creep, double* tilts) const {
  require_solution();
  auto m = state_->iterate.motion;
  m[approach] = state_->given.approach_of(m, state_->prepared->problem.datum);
  if (state_->extrapolated) m = state_->extrapolated->motion;
  if (depth) *depth = m[approach];
  if (creep) creep[0] = m[xi1], creep[1] = m[xi2], creep[2] = m[spin];
  if (tilts) tilts[0] = m[tilt1], tilts[1] = m[tilt2];
}

namespace {

void require_converged(const SolverState& s) {
  if (s.outcome == Outcome::not_converged || s.outcome == Outcome::cancelled)
    fail(Status::err_state, "the last solve did not converge: only a converged solution has derivatives");
}

}  // namespace

const Rates& Contact::rates(Parameter parameter) const {
  require_operators(*state_);
  return find_rates(*state_, parameter);
}

void Contact::sensitivity(Parameter parameter, double* force, double* moment, double* depth, double* creep) const {
  SolverState& s = *state_;
  require_solution();
  require_converged(s);
  const BlasThreads blas(blas_threads());
  require_operators(s);
  Rates r = find_rates(s, parameter);
  if (s.extrapolated) r = beyond(*state_, r, coarser_->rates(parameter));
  if (force) std::copy(r.force.begin(), r.force.end(), force);
  if (moment) std::copy(r.moment.begin(), r.moment.end(), moment);
  if (depth) *depth = r.motion[approach];
  if (creep) creep[0] = r.motion[xi1], creep[1] = r.motion[xi2], creep[2] = r.motion[spin];
}

void Contact::read_givens(NodeGivens& now) {
  SolverState& s = *state_;
  const BlasThreads blas(blas_threads());
  prepare(s, scene, *body1_, *body2_, context_->threads());
  const Problem& p = s.prepared->problem;
  const auto n = static_cast<std::size_t>(p.nodes);
  now.gap.resize(n);
  for (auto& slip : now.slip) slip.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::int64_t>(k);
    now.gap[k] = p.rigid_gap(k, s.given.value);
    now.slip[0][k] = p.rigid_slip1(i, s.given.value);
    now.slip[1][k] = p.rigid_slip2(i, s.given.value);
  }
  now.mu = p.mu;
}

void Contact::rates_by_givens(const NodeGivens& rate, double* force, double* moment) const {
  SolverState& s = *state_;
  require_solution();
  require_converged(s);
  const BlasThreads blas(blas_threads());
  require_operators(s);
  const Rates r = find_rates(s, rate);
  std::copy(r.force.begin(), r.force.end(), force);
  std::copy(r.moment.begin(), r.moment.end(), moment);
}

double Contact::wear(const WearLaw& law, std::span<const double> y, double share, double* volume) const {
  require_solution();
  return add_wear(*state_, law, y, share, volume);
}

std::array<double, 2> Contact::contact_across() const {
  require_solution();
  return rollcon::contact_across(*state_);
}

void Contact::temperatures_at(std::int64_t n, const double* xy, double* temperature) const {
  require_solution();
  const auto points = static_cast<std::size_t>(n);
  std::vector<double> x(points), y(points);
  for (std::size_t k = 0; k < points; ++k) x[k] = xy[2 * k], y[k] = xy[2 * k + 1];
  rollcon::temperatures_at(*state_, scene.heat(), x, y, {temperature, 2 * points});
}

double Contact::fatigue_index(double shear_yield) const {
  double force[3];
  resultant(InAxes::local, force, nullptr);
  if (!(force[2] < 0)) fail(Status::err_state, "there is no normal force, of which the index is a ratio");
  return (std::hypot(force[0], force[1]) - 2 * shear_yield * stat("contact_area") / 3) / -force[2];
}

EquivalentEllipse Contact::equivalent_ellipse() const {
  require_solution();
  return rollcon::equivalent_ellipse(*state_, stat("contact_area"));
}

std::span<const double> Contact::error_function() const {
  return state_->merit;
}

std::span<const double> Contact::history() const {
  return state_->history;
}

std::string Contact::plan() const {
  require_solution();
  return describe_plan(*state_, scene, *body1_, *body2_);
}

void Contact::write(const char* path) const {
  require_solution();
  const auto n = static_cast<std::size_t>(state_->prepared->problem.nodes);
  struct Column {
    const char* name;
    Field field;
    int components;
  };
  static constexpr Column columns[] = {{"traction", Field::traction, 3},
                                       {"pressure", Field::pressure, 1},
                                       {"gap", Field::gap, 1},
                                       {"slip_velocity", Field::slip, 3},
                                       {"displacement1", Field::displacement1, 3},
                                       {"displacement2", Field::displacement2, 3},
                                       {"friction_power", Field::friction_power, 1},
                                       {"area", Field::area, 1}};
  std::vector<std::vector<double>> values;
  std::vector<PointArray> arrays;
  values.reserve(std::size(columns) + 1);
  for (const Column& c : columns) {
    values.emplace_back(n * static_cast<std::size_t>(c.components));
    field(c.field, InAxes::global, static_cast<std::int64_t>(values.back().size()), values.back().data());
    arrays.push_back({c.name, c.components, values.back().data(), nullptr});
  }
  derive_fields(*state_);
  arrays.push_back({"status", 1, nullptr, state_->status.data()});
  write_vtu(path, state_->prepared->frame.mesh, arrays);
}

std::int64_t Contact::stat_count() {
  return std::ssize(statistics());
}

const char* Contact::stat_name(std::int64_t i) {
  if (i < 0 || i >= stat_count())
    fail(Status::err_argument, "statistic %lld is outside [0, %lld]", static_cast<long long>(i),
         static_cast<long long>(stat_count() - 1));
  return statistics()[static_cast<std::size_t>(i)].name;
}

double Contact::stat(const char* name) const {
  for (const Statistic& s : statistics())
    if (std::strcmp(s.name, name) == 0) {
      if (!state_->solved || state_->revision_solved.mesh != scene.revision.mesh)
        fail(Status::err_state, "there is no solution: call rollcon_contact_solve first");
      const BlasThreads blas(blas_threads());
      return s.value(*state_);
    }
  fail(Status::err_option, "unknown statistic '%.60s'; rollcon_stat_name lists them", name);
}

}  // namespace rollcon
