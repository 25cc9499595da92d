/// Finds displacements, strains and stresses in and on the bodies under the last solution.

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "bodies/body_results.hpp"
#include "bodies/nodal_loads.hpp"
#include "contact/contact.hpp"
#include "contact/prepare/lattice_scene.hpp"
#include "contact/results/stress_search.hpp"
#include "contact/results/stresses.hpp"
#include "contact/solver.hpp"
#include "io/load_file.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

/// Returns t[3 * node + component] in the local directions.
std::vector<double> tractions_by_node(const Solution& s) {
  std::vector<double> t(3 * static_cast<std::size_t>(s.prepared->problem.nodes));
  for (std::size_t k = 0; k < t.size() / 3; ++k)
    for (std::size_t c = 0; c < 3; ++c) t[3 * k + c] = s.iterate.lambda[c][k];
  return t;
}

void require_elements(const Body& body, std::int32_t number) {
  if (body.traits().make_response) return;
  fail(Status::err_unsupported,
       "body %d is a %s body: displacements of all nodes are those of finite and boundary elements (inside "
       "half-spaces: rollcon_contact_get_fields_at)",
       number, body.traits().name);
}

Pose pose_of(const Axes& a) {
  return {{{{a.t1[0], a.t2[0], a.n[0]}, {a.t1[1], a.t2[1], a.n[1]}, {a.t1[2], a.t2[2], a.n[2]}}}, a.origin};
}

void turn_vector_back(const Pose& pose, double* u) {
  const Vec3 turned = pose.turn_back({u[0], u[1], u[2]});
  std::copy(turned.begin(), turned.end(), u);
}

// Turns stresses 11, 22, 33, 12, 13, 23: columns first, then rows.
void turn_stress_back(const Pose& pose, double* s) {
  const Vec3 column[3] = {pose.turn_back({s[0], s[3], s[4]}), pose.turn_back({s[3], s[1], s[5]}),
                          pose.turn_back({s[4], s[5], s[2]})};
  Vec3 row[3];
  for (std::size_t i = 0; i < 3; ++i) row[i] = pose.turn_back({column[0][i], column[1][i], column[2][i]});
  const double turned[] = {row[0][0], row[1][1], row[2][2], row[0][1], row[0][2], row[1][2]};
  std::copy(std::begin(turned), std::end(turned), s);
}

}  // namespace

void Contact::displacements_at(std::int32_t body, std::int64_t n, const double* xy, double* u) const {
  solver->require_solution();
  const Solution& s = solver->solution();
  const Body& which = this->body(body);
  const auto points = static_cast<std::size_t>(n);
  std::fill(u, u + 3 * points, 0.0);
  if (which.rigid()) return;
  const Compliance& compliance = solver->compliance_of(body);
  std::vector<double> x(points), y(points);
  for (std::size_t k = 0; k < points; ++k) x[k] = xy[2 * k], y[k] = xy[2 * k + 1];
  const std::vector<double> t = tractions_by_node(s);
  Derived& derived = solver->derived();
  derived.displacements = true;
  ++derived.computed.displacements;
  ++derived.computed.applications;
  const bool at_nodes = s.prepared->problem.op->on_lattice() && x == s.prepared->frame.x && y == s.prepared->frame.y;
  if (!at_nodes || !displacements_on_lattice(s, compliance, s.iterate.lambda, u)) compliance.apply({x, y}, t.data(), u);
  std::vector<double> own(3 * points);
  if (compliance.offset({x, y}, own.data()))
    for (std::size_t k = 0; k < own.size(); ++k) u[k] += own[k];
  // A lambda is u1 - u2, so the second body's part carries the opposite sign.
  if (body == 2)
    for (std::size_t k = 0; k < 3 * points; ++k) u[k] = -u[k];
}

SurfaceState Contact::surface_state(std::int32_t body, bool loads_alone) const {
  solver->require_solution();
  require_elements(this->body(body), body);
  SurfaceState state;
  state.loads_alone = loads_alone && this->body(body).traits().section;
  solver->compliance_of(body).everywhere(tractions_by_node(solver->solution()).data(), state);
  return state;
}

StressesInside Contact::stresses_inside(std::int32_t body) const {
  return {solver->solution(), body, scene.options.stress_accuracy, solver->host.context->threads()};
}

std::int64_t Contact::body_displacements(std::int32_t body, double* u) const {
  solver->require_solution();
  const Body& which = this->body(body);
  require_elements(which, body);
  if (!u) return 3 * which.mesh().surface.nodes();
  const std::vector<double> moved = rollcon::body_displacements(which, surface_state(body, false));
  std::copy(moved.begin(), moved.end(), u);
  return std::ssize(moved);
}

std::vector<double> Contact::body_power(std::int32_t body) const {
  solver->require_solution();
  const Body& which = this->body(body);
  if (!which.traits().section || !which.creeps())
    fail(Status::err_unsupported,
         "body %d is %s %s body: power by harmonics is that of viscoelastic sections; statistic body_power has that of "
         "all bodies",
         body, which.creeps() ? "a viscoelastic" : "an elastic or rigid", which.traits().name);
  return solver->power_lost(body);
}

void Contact::write_body(std::int32_t body, const char* path) const {
  solver->require_solution();
  const Body& which = this->body(body);
  if (!which.traits().half_space)
    return rollcon::write_body(which, surface_state(body, which.get_int("sector") > 0), path);
  const BlockInside block(solver->solution(), body);
  const std::vector<Vec3>& node = block.surface.node;
  SurfaceMesh placed = block.surface;
  const Pose given = relative(scene.pose(at(body - 1)), pose_of(solver->solution().prepared->frame.axes));
  for (Vec3& x : placed.node) x = given.place(x);
  std::vector<double> u(3 * node.size()), stress(6 * node.size());
  fields_at(body, true, std::ssize(node), placed.node.front().data(), which.creeps() ? nullptr : u.data(),
            stress.data());
  write_fields(path, placed, &block.volume, u, std::move(stress));
}

double Contact::find_stress(std::int32_t body, const char* measure, std::span<const double> parameter,
                            Vec3& place) const {
  solver->require_solution();
  StressesInside inside = stresses_inside(body);
  return largest_stress(solver->solution(), body, inside, measure, parameter, place);
}

void Contact::write_loads(std::int32_t body, const char* path) const {
  if (body != 1 && body != 2) fail(Status::err_argument, "which is %d; allowed: 1, 2", body);
  require_pointer(path, "path");
  const auto [force, moment] = solver->loads();
  const Solution& s = solver->solution();
  const NodalLoads loads =
      nodal_loads(s.prepared->frame, s.prepared->pair, body - 1, tractions_by_node(s), {force, moment});
  const Vec3 &f = loads.sum.force, &m = loads.sum.moment;
  char title[400];
  std::snprintf(title, sizeof title,
                "Contact of rollcon on body %d: force %.9e %.9e %.9e\nmoment about the origin %.9e %.9e %.9e; to have "
                "them, forces moved by up to %.1e of the largest",
                body, f[0], f[1], f[2], m[0], m[1], m[2], loads.moved);
  rollcon::write_loads(path, loads.force, this->body(body).node_numbers(), title);
}

void Contact::fields_at(std::int32_t body, bool in_body, std::int64_t n, const double* xyz, double* u,
                        double* stress) const {
  solver->require_solution();
  const Solution& s = solver->solution();
  const bool of_elements = this->body(body).traits().make_response != nullptr;
  const Pose &own = scene.pose(static_cast<std::size_t>(body - 1)), contact = pose_of(s.prepared->frame.axes);
  // Fields of elements are found in the body's axes, those of half-spaces in the contact's.
  const bool turned = in_body != of_elements;
  const Pose given = of_elements ? relative(own, contact) : relative(contact, own);
  std::vector<double> moved;
  for (std::int64_t i = 0; turned && i < n; ++i) {
    const Vec3 x = given.place({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
    moved.insert(moved.end(), x.begin(), x.end());
  }
  if (turned) xyz = moved.data();
  if (of_elements)
    rollcon::body_fields_at(this->body(body), surface_state(body, true), n, xyz, u, stress);
  else
    stresses_inside(body).find({n, xyz}, stress, u);
  for (std::int64_t i = 0; turned && i < n; ++i) {
    if (u) turn_vector_back(given, u + 3 * i);
    if (stress) turn_stress_back(given, stress + 6 * i);
  }
}

}  // namespace rollcon
