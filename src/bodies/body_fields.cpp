/// Gives fields inside of finite-element and boundary-element bodies.

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include "bodies/body_results.hpp"
#include "io/vtu.hpp"
#include "mesh/swept_volume.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"
#include "support/stress_invariants.hpp"

namespace rollcon {
namespace {

bool on_surface_alone(const Body& body) {
  return body.traits().make_response && !body.traits().volume;
}

void require_fields(const Body& body) {
  if (!body.traits().make_response)
    fail(Status::err_unsupported, "the body is a %s body: fields inside are those of finite and boundary elements",
         body.traits().name);
  if (!body.prepared()) fail(Status::err_state, "the body is not prepared: call rollcon_body_prepare first");
}

const IntegrationPoints& points_of(const Body& body) {
  if (on_surface_alone(body))
    fail(Status::err_unsupported, "the body is a %s body: integration points are those of finite elements",
         body.traits().name);
  require_fields(body);
  return *body.response()->integration_points();
}

/// Returns the displacements given, or the body's own.
std::vector<double> displacements_of(const Body& body, const NodalDisplacements& given) {
  const std::int64_t nodes = body.mesh().surface.nodes();
  if (given.nodes != nodes)
    fail(Status::err_argument, "nodes is %lld; allowed: %lld, those of the body", static_cast<long long>(given.nodes),
         static_cast<long long>(nodes));
  std::vector<double> u = body.own().displacement;
  u.resize(at(3 * nodes), 0.0);
  if (!given.u) return u;
  require_finite(nodes, 3, given.u, "u", body.mesh().surface.index_base);
  // Layers that cannot pass NULL give the body's own.
  if (on_surface_alone(body) && !std::equal(u.begin(), u.end(), given.u))
    fail(Status::err_unsupported,
         "no stresses follow from displacements of boundary elements alone: u must be NULL, or the body's own "
         "(rollcon_body_get_displacements); under a contact: rollcon_contact_get_fields_at and _write_body");
  u.assign(given.u, given.u + 3 * nodes);
  return u;
}

std::unique_ptr<const BodyFields> fields_of(const Body& body, const NodalDisplacements& given) {
  require_fields(body);
  SurfaceState state;
  state.u = displacements_of(body, given);
  if (on_surface_alone(body)) return body.response()->fields({}, body.own());
  return body.response()->fields(std::move(state), {});
}

std::unique_ptr<const BodyFields> fields_of(const Body& body, SurfaceState&& state) {
  require_fields(body);
  return body.response()->fields(std::move(state), body.own());
}

void require_no_overflow(const std::vector<double>& values) {
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    fail(Status::err_argument, "displacements or loads are too large: stresses overflow");
}

void fields_at(const Body& body, const BodyFields& fields, std::int64_t n, const double* xyz, double* displacement,
               double* stress) {
  std::vector<double> u(displacement ? 3 * at(n) : 0), s(stress ? 6 * at(n) : 0);
  fields.at_points(n, xyz, displacement ? u.data() : nullptr, stress ? s.data() : nullptr, body.context().threads());
  require_no_overflow(u);
  require_no_overflow(s);
  std::copy(u.begin(), u.end(), displacement);
  std::copy(s.begin(), s.end(), stress);
}

std::vector<double> node_stresses(const Body& body, const BodyFields& fields) {
  std::vector<double> stress(6 * at(body.mesh().surface.nodes()));
  fields.at_nodes(stress.data(), body.context().threads());
  require_no_overflow(stress);
  return stress;
}

}  // namespace

void write_fields(const char* path, const SurfaceMesh& surface, const VolumeElements* volume,
                  const std::vector<double>& u, std::vector<double> stress) {
  const std::size_t nodes = at(surface.nodes());
  std::vector<double> von_mises(nodes);
  for (std::size_t k = 0; k < nodes; ++k) von_mises[k] = stress_invariants(stress.data() + 6 * k).von_mises;
  // ParaView counts symmetric tensors xx, yy, zz, xy, yz, xz.
  for (std::size_t k = 0; k < nodes; ++k) std::swap(stress[6 * k + 4], stress[6 * k + 5]);
  const PointArray arrays[] = {{"displacement", 3, u.data(), nullptr},
                               {"stress", 6, stress.data(), nullptr},
                               {"von_mises", 1, von_mises.data(), nullptr}};
  if (!volume) return write_vtu(path, surface, arrays);
  write_vtu(path, surface, *volume, arrays);
}

namespace {

/// Writes fields at the nodes of the mesh, of which displacements are given; sections write a sector, around an angle.
void write_fields(const Body& body, const BodyFields& fields, std::vector<double> u, double middle, const char* path) {
  const double sector = static_cast<double>(body.get_int("sector")) * SweptSection::pi / 180;
  if (!body.traits().section || sector == 0)
    return write_fields(path, body.mesh().surface, on_surface_alone(body) ? nullptr : &body.mesh().volume, u,
                        node_stresses(body, fields));
  const SweptVolume swept = sweep_volume(body.mesh().section, middle, sector);
  const std::int64_t nodes = swept.surface.nodes();
  std::vector<double> stress(6 * at(nodes));
  u.resize(3 * at(nodes));
  fields_at(body, fields, nodes, swept.surface.node.front().data(), u.data(), stress.data());
  write_fields(path, swept.surface, &swept.volume, u, std::move(stress));
}

/// Returns the angle along a section's way around which forces act on its surface.
double middle_of(const SweptSection& section, std::span<const double> force) {
  const std::size_t of_stretch = 9 * section.profile().size();
  const std::int64_t per_face = section.quadratic() ? 2 : 1;
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    const auto first = static_cast<double>(section.station(per_face * static_cast<std::int64_t>(k / of_stretch)));
    sum += std::polar(std::abs(force[k]), section.step() * (first + 0.5 * static_cast<double>(per_face)));
  }
  return std::arg(sum);
}

}  // namespace

std::int64_t body_stress_points(const Body& body) {
  return points_of(body).points();
}

void body_node_stresses(const Body& body, const NodalDisplacements& given, double* stress) {
  const std::vector<double> found = node_stresses(body, *fields_of(body, given));
  std::copy(found.begin(), found.end(), stress);
}

void body_point_stresses(const Body& body, const NodalDisplacements& given, double* stress, double* xyz) {
  const IntegrationPoints& points = points_of(body);
  const std::vector<double> u = displacements_of(body, given);
  std::vector<double> found(stress ? 6 * at(points.points()) : 0);
  if (stress) points.at_points(u.data(), found.data(), nullptr, body.context().threads());
  require_no_overflow(found);
  std::copy(found.begin(), found.end(), stress);
  if (xyz) points.at_points(u.data(), nullptr, xyz, body.context().threads());
}

void body_fields_at(const Body& body, const NodalDisplacements& given, std::int64_t n, const double* xyz,
                    double* displacement, double* stress) {
  fields_at(body, *fields_of(body, given), n, xyz, displacement, stress);
}

void write_body(const Body& body, const NodalDisplacements& given, const char* path) {
  write_fields(body, *fields_of(body, given), displacements_of(body, given), 0, path);
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
  fields_at(body, *fields_of(body, std::move(state)), n, xyz, displacement, stress);
}

void write_body(const Body& body, SurfaceState state, const char* path) {
  std::vector<double> u = state.loads_alone ? std::vector<double>{} : body_displacements(body, state);
  const double middle = body.traits().section ? middle_of(body.mesh().section, state.layer_traction) : 0;
  write_fields(body, *fields_of(body, std::move(state)), std::move(u), middle, path);
}

}  // namespace rollcon
