/// Copies results of the last solve out to the caller.

#include <algorithm>
#include <cmath>

#include "contact/contact.hpp"
#include "contact/plan.hpp"
#include "contact/results/wear.hpp"
#include "contact/settle/settle_friction.hpp"
#include "contact/solver.hpp"
#include "contact/statistics.hpp"
#include "io/vtu.hpp"

namespace rollcon {
namespace {

// Turns a vector from local directions into global coordinates.
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

/// Returns node k as its law sees it. Slip is known where the law follows it.
FrictionPoint point_of(const Solution& s, const Derived& d, std::size_t k) {
  const Problem& p = s.prepared->problem;
  FrictionPoint point{s.given.coefficient(p.mu, k), std::max(-s.iterate.lambda[2][k], 0.0), s.iterate.lambda[0][k],
                      s.iterate.lambda[1][k]};
  if (p.law->falls()) point.s1 = d.slip[0][k] / s.prepared->speed, point.s2 = d.slip[1][k] / s.prepared->speed;
  return point;
}

// Writes the field's values of node k, displacements apart.
void write_value(const Solution& s, const Derived& d, Field field, InAxes axes, std::size_t k, double* out) {
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
  // Slip as the caller gave it, without what displacements given elsewhere add.
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
      return tangential(d.slip[0][k], d.slip[1][k]);
    case Field::rigid_slip:
      return tangential(own(0, p.rigid_slip1(i, it.motion)), own(1, p.rigid_slip2(i, it.motion)));
    case Field::area:
      *out = p.cell_area[k];
      return;
    case Field::weight:
      *out = p.weight[k];
      return;
    case Field::friction:
      *out = s.frictionless ? s.given.coefficient(p.mu, k) : p.law->coefficient(point_of(s, d, k));
      return;
    case Field::pressure:
      *out = it.lambda[2][k] < 0 ? -it.lambda[2][k] : 0.0;
      return;
    case Field::friction_power:
      *out = -(it.lambda[0][k] * d.slip[0][k] + it.lambda[1][k] * d.slip[1][k]);
      return;
    default:
      return;
  }
}

}  // namespace

void Contact::tractions(InAxes axes, std::int64_t capacity, double* t) const {
  solver->require_solution();
  const Solution& s = solver->solution();
  const Iterate& it = s.iterate;
  require_capacity(capacity, s.prepared->problem.nodes, "nodes");
  for (std::size_t k = 0; k < it.lambda[0].size(); ++k)
    put(s.prepared->frame.triad(k), axes, it.lambda[0][k], it.lambda[1][k], std::min(it.lambda[2][k], 0.0),
        t + 3 * k);  // a node about to open may pull within the tolerance
}

std::int64_t Contact::field(Field field, InAxes axes, std::int64_t capacity, double* v) const {
  solver->require_solution();
  const Solution& s = solver->solution();
  Derived& d = solver->derived();
  const Frame& frame = s.prepared->frame;
  const auto n = static_cast<std::size_t>(s.prepared->problem.nodes);
  const std::int64_t components = components_of(field, axes);
  const std::int64_t needed = components * s.prepared->problem.nodes;
  if (capacity == 0 && v == nullptr) return needed;
  require_capacity(capacity, needed, "doubles");
  const bool at_slip = field == Field::friction && s.prepared->problem.law->falls();
  if (at_slip || field == Field::slip || field == Field::friction_power) derive_fields(s, d);
  if (field == Field::gap) {
    derive_gap(s, v);
    return needed;
  }
  if (field == Field::temperature) {
    node_temperatures(s, d, scene.heat(), {v, 2 * n});
    return needed;
  }
  if (field == Field::displacement1 || field == Field::displacement2) {
    std::vector<double> xy(2 * n);
    for (std::size_t k = 0; k < n; ++k) xy[2 * k] = frame.x[k], xy[2 * k + 1] = frame.y[k];
    displacements_at(field == Field::displacement1 ? 1 : 2, needed / 3, xy.data(), v);
    for (std::size_t k = 0; k < n; ++k) put(frame.triad(k), axes, v[3 * k], v[3 * k + 1], v[3 * k + 2], v + 3 * k);
    return needed;
  }
  for (std::size_t k = 0; k < n; ++k, v += components) write_value(s, d, field, axes, k, v);
  return needed;
}

void Contact::node_status(std::int64_t capacity, std::int32_t* status) const {
  solver->require_solution();
  require_capacity(capacity, solver->solution().prepared->problem.nodes, "nodes");
  derive_fields(solver->solution(), solver->derived());
  std::copy(solver->derived().status.begin(), solver->derived().status.end(), status);
}

void Contact::resultant(InAxes axes, double* force, double* moment) const {
  const auto [f, m] = solver->loads();
  const Triad local = triad_of(solver->solution().prepared->frame.axes);
  if (force) put(local, axes, f[0], f[1], f[2], force);
  if (moment) put(local, axes, m[0], m[1], m[2], moment);
}

namespace {

void copy_motions(const MotionValues& m, double* depth, double* creep, double* tilts) {
  if (depth) *depth = m[approach];
  if (creep) creep[0] = m[xi1], creep[1] = m[xi2], creep[2] = m[spin];
  if (tilts) tilts[0] = m[tilt1], tilts[1] = m[tilt2];
}

}  // namespace

void Contact::motion(double* depth, double* creep, double* tilts) const {
  copy_motions(solver->motions(), depth, creep, tilts);
}

void Contact::sensitivity(Parameter parameter, double* force, double* moment, double* depth, double* creep) const {
  const Rates r = solver->rates(parameter);
  if (force) std::copy(r.force.begin(), r.force.end(), force);
  if (moment) std::copy(r.moment.begin(), r.moment.end(), moment);
  copy_motions(r.motion, depth, creep, nullptr);
}

double Contact::wear(const WearLaw& law, std::span<const double> y, double share, double* volume) const {
  solver->require_solution();
  return add_wear(solver->solution(), solver->derived(), law, y, share, volume);
}

std::array<double, 2> Contact::contact_across() const {
  solver->require_solution();
  return rollcon::contact_across(solver->solution());
}

void Contact::temperatures_at(std::int64_t n, const double* xy, double* temperature) const {
  solver->require_solution();
  const auto points = static_cast<std::size_t>(n);
  std::vector<double> x(points), y(points);
  for (std::size_t k = 0; k < points; ++k) x[k] = xy[2 * k], y[k] = xy[2 * k + 1];
  rollcon::temperatures_at(solver->solution(), solver->derived(), scene.heat(), x, y, {temperature, 2 * points});
}

double Contact::fatigue_index(double shear_yield) const {
  double force[3];
  resultant(InAxes::local, force, nullptr);
  if (!(force[2] < 0)) fail(Status::err_state, "there is no normal force, of which the index is a ratio");
  return (std::hypot(force[0], force[1]) - 2 * shear_yield * stat("contact_area") / 3) / -force[2];
}

EquivalentEllipse Contact::equivalent_ellipse() const {
  solver->require_solution();
  return rollcon::equivalent_ellipse(solver->solution(), stat("contact_area"));
}

double Contact::stat(const char* name) const {
  return find_statistic(*solver, name);
}

std::span<const double> Contact::history() const {
  return solver->effort().history;
}

std::span<const double> Contact::error_function() const {
  return solver->effort().merit;
}

std::string Contact::plan() const {
  solver->require_solution();
  return describe_plan(*solver, *body1_, *body2_);
}

void Contact::write(const char* path) const {
  solver->require_solution();
  const Prepared& on = *solver->solution().prepared;
  const auto n = static_cast<std::size_t>(on.problem.nodes);
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
  derive_fields(solver->solution(), solver->derived());
  arrays.push_back({"status", 1, nullptr, solver->derived().status.data()});
  write_vtu(path, on.frame.mesh, arrays);
}

}  // namespace rollcon
