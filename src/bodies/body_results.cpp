#include "bodies/body_results.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "mesh/quadrature.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

void require_prepared(const Body& body) {
  if (!body.prepared())
    fail(Status::err_state, "the body is not prepared: call rollcon_body_prepare first");
}

void require_prepared_mesh(const Body& body) {
  if (body.kind() == BodyKind::halfspace)
    fail(Status::err_state, "a half-space has no mesh: there is nothing to read");
  require_prepared(body);
}

/// Tractions that supports exert, by node of element e: what is there beyond the given ones. (That
/// of a node held alone is spread over its neighbours, which are not held.)
std::vector<Vec3> support_tractions(const Body& body, std::int64_t e,
                                    std::span<const double> traction) {
  const BodyMesh& mesh = body.mesh();
  const TractionNodes& split = body.traction_nodes();
  const auto element = static_cast<std::size_t>(e);
  const auto load = std::find_if(
      mesh.load.begin(), mesh.load.end(),
      [&](const FaceLoad& candidate) { return candidate.tag == mesh.surface.tag[element]; });
  const auto nodes = mesh.surface.element(e);
  const auto first = static_cast<std::size_t>(mesh.surface.offset[element]);
  std::vector<Vec3> result(nodes.size(), Vec3{0, 0, 0});
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto at = static_cast<std::size_t>(split.of[first + k]);
    Vec3 given{0, 0, 0};
    if (load != mesh.load.end()) given = load->traction - load->pressure * split.normal[at];
    for (std::size_t c = 0; c < 3; ++c) result[k][c] = traction[3 * at + c] - given[c];
  }
  return result;
}

struct Statistic {
  const char* name;
  double (*value)(const BodyStatistics&);
};

template <class T>
double number(T v) {
  return static_cast<double>(v);
}

constexpr Statistic statistics[] = {
    {"unknowns", [](const BodyStatistics& s) { return number(s.unknowns); }},
    {"assemblies", [](const BodyStatistics& s) { return number(s.assemblies); }},
    {"factorizations", [](const BodyStatistics& s) { return number(s.factorizations); }},
    {"condensations", [](const BodyStatistics& s) { return number(s.condensations); }},
    {"kernel_evaluations", [](const BodyStatistics& s) { return number(s.kernel_evaluations); }},
    {"condition", [](const BodyStatistics& s) { return s.condition; }},
    {"seconds_assembly", [](const BodyStatistics& s) { return s.seconds_assembly; }},
    {"seconds_factor", [](const BodyStatistics& s) { return s.seconds_factor; }},
    {"seconds_condense", [](const BodyStatistics& s) { return s.seconds_condense; }},
    {"bytes", [](const BodyStatistics& s) { return number(s.bytes); }},
    {"peak_bytes", [](const BodyStatistics& s) { return number(s.peak_bytes); }},
};

}  // namespace

void body_displacements(const Body& body, std::int64_t capacity, double* u) {
  require_prepared_mesh(body);
  const std::int64_t nodes = body.mesh().surface.nodes();
  if (capacity < nodes)
    fail(Status::err_capacity, "capacity is %lld nodes; needed: %lld",
         static_cast<long long>(capacity), static_cast<long long>(nodes));
  std::span<const double> own;
  if (body.response()) own = body.response()->own_displacement();
  if (own.empty())
    std::fill_n(u, 3 * nodes, 0.0);
  else
    std::copy(own.begin(), own.end(), u);
}

void body_reaction(const Body& body, Vec3& force, Vec3& moment) {
  require_prepared_mesh(body);
  force = moment = {0, 0, 0};
  std::span<const double> own;
  if (body.response()) own = body.response()->own_traction();
  if (own.empty()) return;
  // Exact for plane elements; on curved ones the Jacobian is not a polynomial.
  constexpr int degree = 9;
  const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  const SurfaceMesh& mesh = body.mesh().surface;
  Shape shape;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const std::vector<Vec3> traction = support_tractions(body, e, own);
    const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
      const SurfaceFrame at = evaluate_surface(mesh, e, rule.xi[q], rule.eta[q]);
      Vec3 t{0, 0, 0};
      for (std::size_t k = 0; k < traction.size(); ++k) t = t + shape.value[k] * traction[k];
      const Vec3 part = rule.w[q] * length(at.normal) * t;
      force = force + part;
      moment = moment + cross(at.x, part);
    }
  }
}

double body_statistic(const Body& body, const char* name) {
  const auto* found = std::find_if(std::begin(statistics), std::end(statistics),
                                   [&](const Statistic& s) { return !std::strcmp(s.name, name); });
  if (found == std::end(statistics)) {
    std::string known;
    for (const Statistic& s : statistics)
      known += (known.empty() ? "" : ", ") + std::string(s.name);
    fail(Status::err_option, "unknown statistic '%.64s'; statistics are: %s", name, known.c_str());
  }
  require_prepared(body);
  return body.response() ? found->value(body.response()->statistics()) : 0;
}

std::int64_t body_statistic_count() {
  return static_cast<std::int64_t>(std::size(statistics));
}

const char* body_statistic_name(std::int64_t i) {
  return statistics[static_cast<std::size_t>(i)].name;
}

}  // namespace rollcon
