/// Finds displacements, strains and stresses in and on the bodies under the last solution.

#include <algorithm>

#include "bodies/body_results.hpp"
#include "contact/contact.hpp"
#include "contact/prepare/lattice_scene.hpp"
#include "contact/results/stresses.hpp"
#include "contact/solver.hpp"
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
       "body %d is a %s body: displacements of all nodes and fields inside are those of finite and boundary elements "
       "(of half-spaces: rollcon_contact_get_stresses_at)",
       number, body.traits().name);
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
  const bool at_nodes = s.prepared->problem.op->influence() && x == s.prepared->frame.x && y == s.prepared->frame.y;
  if (!at_nodes || !displacements_on_lattice(s, compliance, u)) compliance.apply({x, y}, t.data(), u);
  std::vector<double> own(3 * points);
  if (compliance.offset({x, y}, own.data()))
    for (std::size_t k = 0; k < own.size(); ++k) u[k] += own[k];
  // A lambda is u1 - u2, so the second body's part carries the opposite sign.
  if (body == 2)
    for (std::size_t k = 0; k < 3 * points; ++k) u[k] = -u[k];
}

SurfaceState Contact::surface_state(std::int32_t body) const {
  solver->require_solution();
  require_elements(this->body(body), body);
  SurfaceState state;
  solver->compliance_of(body).everywhere(tractions_by_node(solver->solution()).data(), state);
  return state;
}

std::int64_t Contact::body_displacements(std::int32_t body, double* u) const {
  solver->require_solution();
  const Body& which = this->body(body);
  require_elements(which, body);
  if (!u) return 3 * which.mesh().surface.nodes();
  const std::vector<double> moved = rollcon::body_displacements(which, surface_state(body));
  std::copy(moved.begin(), moved.end(), u);
  return std::ssize(moved);
}

void Contact::body_fields_at(std::int32_t body, std::int64_t n, const double* xyz, double* u, double* stress) const {
  rollcon::body_fields_at(this->body(body), surface_state(body), n, xyz, u, stress);
}

void Contact::write_body(std::int32_t body, const char* path) const {
  rollcon::write_body(this->body(body), surface_state(body), path);
}

void Contact::stresses_at(std::int32_t body, std::int64_t n, const double* xyz, double* stress, double* u) const {
  solver->require_solution();
  find_stresses(solver->solution(), body, {n, xyz}, scene.options.stress_accuracy, solver->host.context->threads(),
                stress, u);
}

}  // namespace rollcon
