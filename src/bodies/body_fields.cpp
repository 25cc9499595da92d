/// Fields inside of finite-element and boundary-element bodies.

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "bodies/body_results.hpp"
#include "io/vtu.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"
#include "support/parallel.hpp"
#include "support/stress_invariants.hpp"

namespace rollcon {
namespace {

std::int64_t require_nodes(const Body& body, const NodalDisplacements& given) {
  const std::int64_t nodes = body.mesh().surface.nodes();
  if (given.nodes != nodes)
    fail(Status::err_argument, "nodes is %lld; allowed: %lld, those of the body", static_cast<long long>(given.nodes),
         static_cast<long long>(nodes));
  return nodes;
}

bool on_surface_alone(const Body& body) {
  return body.traits().make_response && !body.traits().volume;
}

void require_fields(const Body& body) {
  if (!body.traits().make_response)
    fail(Status::err_unsupported, "the body is a %s body: fields inside are those of finite and boundary elements",
         body.traits().name);
  if (!body.prepared()) fail(Status::err_state, "the body is not prepared: call rollcon_body_prepare first");
}

const BodyInterior& interior_of(const Body& body) {
  if (on_surface_alone(body))
    fail(Status::err_unsupported, "the body is a %s body: integration points are those of finite elements",
         body.traits().name);
  require_fields(body);
  return *body.response()->interior();
}

/// The displacements given, or the body's own.
std::span<const double> displacements_of(const Body& body, const NodalDisplacements& given, std::vector<double>& zero) {
  const std::int64_t nodes = require_nodes(body, given);
  if (given.u) {
    require_finite(nodes, 3, given.u, "u", body.mesh().surface.index_base);
    return {given.u, at(3 * nodes)};
  }
  const std::span<const double> own = body.own().displacement;
  if (!own.empty()) return own;
  zero.assign(at(3 * nodes), 0.0);
  return zero;
}

/// Of boundary elements under their own loads.
std::unique_ptr<const SurfaceFields> own_fields(const Body& body, const NodalDisplacements& given) {
  std::vector<double> zero;
  const std::span<const double> u = displacements_of(body, given, zero),
                                own = displacements_of(body, {given.nodes, nullptr}, zero);
  // Layers that cannot pass NULL give the body's own.
  if (!std::equal(u.begin(), u.end(), own.begin()))
    fail(Status::err_unsupported,
         "no stresses follow from displacements of boundary elements alone: u must be NULL, or the body's own "
         "(rollcon_body_get_displacements); under a contact: rollcon_contact_get_body_fields_at and _write_body");
  return body.response()->surface_fields({}, body.own());
}

void require_no_overflow(const double* value, std::int64_t n) {
  if (!std::all_of(value, value + n, [](double v) { return std::isfinite(v); }))
    fail(Status::err_argument, "the displacements u are too large: stresses overflow");
}

}  // namespace

std::int64_t body_stress_points(const Body& body) {
  return interior_of(body).points();
}

void body_node_stresses(const Body& body, const NodalDisplacements& given, double* stress) {
  require_fields(body);
  if (on_surface_alone(body)) return own_fields(body, given)->at_nodes(stress);
  const BodyInterior& interior = interior_of(body);
  std::vector<double> zero, found(6 * at(body.mesh().surface.nodes()));
  interior.at_nodes(displacements_of(body, given, zero).data(), found.data(), body.context().threads());
  require_no_overflow(found.data(), std::ssize(found));
  std::copy(found.begin(), found.end(), stress);
}

void body_point_stresses(const Body& body, const NodalDisplacements& given, double* stress, double* xyz) {
  const BodyInterior& interior = interior_of(body);
  std::vector<double> zero, found(stress ? 6 * at(interior.points()) : 0);
  const double* u = displacements_of(body, given, zero).data();
  if (stress) interior.at_points(u, found.data(), nullptr, body.context().threads());
  require_no_overflow(found.data(), std::ssize(found));
  std::copy(found.begin(), found.end(), stress);
  if (xyz) interior.at_points(u, nullptr, xyz, body.context().threads());
}

void body_fields_at(const Body& body, const NodalDisplacements& given, std::int64_t n, const double* xyz,
                    double* displacement, double* stress) {
  require_fields(body);
  if (on_surface_alone(body))
    return own_fields(body, given)->at_points(n, xyz, displacement, stress, body.context().threads());
  const BodyInterior& interior = interior_of(body);
  std::vector<double> zero, of_nodes, u(displacement ? 3 * at(n) : 0), s(stress ? 6 * at(n) : 0);
  const double* moved = displacements_of(body, given, zero).data();
  if (stress && n > 0) {
    of_nodes.resize(6 * at(body.mesh().surface.nodes()));
    interior.at_nodes(moved, of_nodes.data(), body.context().threads());
  }
  std::vector<std::uint8_t> inside(at(n), 0);
  parallel_for(n, 64, body.context().threads(), [&](std::int64_t p, int /*thread*/) {
    const double* x = xyz + 3 * p;
    inside[at(p)] =
        interior.interpolate({x[0], x[1], x[2]}, moved, of_nodes.data(), displacement ? u.data() + 3 * p : nullptr,
                             stress ? s.data() + 6 * p : nullptr);
  });
  const auto out = std::find(inside.begin(), inside.end(), 0);
  if (out != inside.end()) {
    const auto p = out - inside.begin();
    fail(Status::err_argument, "point %lld (counting from 0), at %g %g %g, is outside of the body's elements",
         static_cast<long long>(p), xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]);
  }
  require_no_overflow(s.data(), std::ssize(s));
  std::copy(u.begin(), u.end(), displacement);
  std::copy(s.begin(), s.end(), stress);
}

namespace {

void write_fields(const Body& body, const double* u, std::vector<double>& stress, const char* path) {
  require_no_overflow(stress.data(), std::ssize(stress));
  const std::size_t nodes = at(body.mesh().surface.nodes());
  std::vector<double> von_mises(nodes);
  for (std::size_t k = 0; k < nodes; ++k) von_mises[k] = stress_invariants(stress.data() + 6 * k).von_mises;
  // ParaView counts symmetric tensors xx, yy, zz, xy, yz, xz.
  for (std::size_t k = 0; k < nodes; ++k) std::swap(stress[6 * k + 4], stress[6 * k + 5]);
  const PointArray arrays[] = {{"displacement", 3, u, nullptr},
                               {"stress", 6, stress.data(), nullptr},
                               {"von_mises", 1, von_mises.data(), nullptr}};
  if (on_surface_alone(body)) return write_vtu(path, body.mesh().surface, arrays);
  write_vtu(path, body.mesh().surface, body.mesh().volume, arrays);
}

}  // namespace

void write_body(const Body& body, const NodalDisplacements& given, const char* path) {
  require_fields(body);
  std::vector<double> zero, stress(6 * at(body.mesh().surface.nodes()));
  body_node_stresses(body, given, stress.data());
  write_fields(body, displacements_of(body, given, zero).data(), stress, path);
}

std::vector<double> body_displacements(const Body& body, SurfaceState state) {
  require_fields(body);
  std::vector<double> u = std::move(state.u);
  const std::span<const double> own = body.own().displacement;
  for (std::size_t k = 0; k < own.size(); ++k) u[k] += own[k];
  return u;
}

void body_fields_at(const Body& body, SurfaceState state, std::int64_t n, const double* xyz, double* displacement,
                    double* stress) {
  require_fields(body);
  if (on_surface_alone(body))
    return body.response()
        ->surface_fields(std::move(state), body.own())
        ->at_points(n, xyz, displacement, stress, body.context().threads());
  const std::vector<double> u = body_displacements(body, std::move(state));
  body_fields_at(body, {body.mesh().surface.nodes(), u.data()}, n, xyz, displacement, stress);
}

void write_body(const Body& body, SurfaceState state, const char* path) {
  require_fields(body);
  std::vector<double> stress(6 * at(body.mesh().surface.nodes()));
  const std::vector<double> u = body_displacements(body, state);
  if (on_surface_alone(body))
    body.response()->surface_fields(std::move(state), body.own())->at_nodes(stress.data());
  else
    body_node_stresses(body, {body.mesh().surface.nodes(), u.data()}, stress.data());
  write_fields(body, u.data(), stress, path);
}

}  // namespace rollcon
