// The ring of the paper's first example under a patch of pressure, as a body by itself: against its
// Fourier series in the angle, over meshes and elements.

#include <array>
#include <cmath>
#include <stdexcept>

#include "bench.hpp"
#include "support/example1.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;

/// Inward displacement at (s, y), s along the circumference, under 100 MPa on |s| <= 1.
struct Reference {
  double poisson;
  std::array<double, 4> u;
};
constexpr double point[4][2] = {{0, 0}, {1, 0}, {0, 2}, {0, 4}};
constexpr Reference references[] = {{0.3, {.0474826, .0394575, .0480571, .0522833}},
                                    {0.49, {.0440806, .0372047, .0453897, .0541693}}};

struct Solved {
  double worst = 0, first = 0;
  std::int64_t unknowns = 0, peak_bytes = 0;
  std::vector<std::pair<std::string, double>> phase_seconds;
};

void must(std::int32_t status, const char* what) {
  if (status < 0) throw std::runtime_error(what);
}

Solved press(const SurfaceMesh& mesh, const Reference& reference, int threads) {
  rollcon_context* context = nullptr;
  rollcon_body* body = nullptr;
  must(rollcon_context_create(ROLLCON_ABI, &context), "context_create");
  must(rollcon_context_set_threads(context, threads), "set_threads");
  must(rollcon_body_create(context, ROLLCON_BODY_BEM, &body), "body_create");
  must(rollcon_body_set_elastic(body, 0, example1::young, reference.poisson), "set_elastic");
  must(rollcon_body_set_nodes(body, mesh.nodes(), mesh.node[0].data(), 3, 1), "set_nodes");
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    must(rollcon_body_add_elements(
             body, static_cast<std::int32_t>(mesh.type[static_cast<std::size_t>(e)]), 1,
             mesh.element(e).data(), 0, mesh.tag[static_cast<std::size_t>(e)]),
         "add_elements");
  const std::vector<std::int32_t> hub = surfaces::nodes_with_tag(mesh, std::array{3});
  must(rollcon_body_set_support(body, static_cast<std::int64_t>(hub.size()), hub.data(), 0, 7,
                                nullptr),
       "set_support");
  must(rollcon_body_set_pressure(body, 2, 100), "set_pressure");
  must(rollcon_body_prepare(body), "prepare");
  std::vector<double> u(3 * mesh.node.size());
  must(rollcon_body_get_displacements(body, mesh.nodes(), u.data()), "get_displacements");
  Solved solved;
  for (std::size_t p = 0; p < 4; ++p) {
    const double angle = point[p][0] / example1::radius;
    const Vec3 n{std::sin(angle), 0, std::cos(angle)};
    const auto k = static_cast<std::size_t>(
        surfaces::node_at(mesh, example1::radius * n + Vec3{0, point[p][1], 0}));
    const double inward = -(u[3 * k] * n[0] + u[3 * k + 2] * n[2]);
    const double error = inward / reference.u[p] - 1;
    if (p == 0) solved.first = inward;
    if (std::abs(error) > std::abs(solved.worst)) solved.worst = error;
  }
  const auto stat = [&](const char* name) {
    double value = 0;
    must(rollcon_body_get_stat(body, name, &value), name);
    return value;
  };
  solved.unknowns = std::llround(stat("unknowns"));
  solved.peak_bytes = std::llround(stat("peak_bytes"));
  for (const char* phase : {"assembly", "factor"})
    solved.phase_seconds.emplace_back(phase, stat((std::string("seconds_") + phase).c_str()));
  rollcon_body_release(body);
  rollcon_context_release(context);
  return solved;
}

void run(Runner& runner) {
  struct Mesh {
    ElementType type;
    int across;
  };
  std::vector<Mesh> meshes{
      {ElementType::quad4, 8}, {ElementType::quad4, 12}, {ElementType::quad4, 16},
      {ElementType::tri3, 8},  {ElementType::tri3, 12},  {ElementType::quad8, 4},
      {ElementType::quad8, 8}, {ElementType::quad9, 4},  {ElementType::quad9, 8},
      {ElementType::tri6, 4},  {ElementType::tri6, 8}};
  if (runner.quick) meshes = {{ElementType::quad4, 8}, {ElementType::quad8, 4}};
  for (const Mesh& mesh : meshes)
    for (const Reference& reference : references) {
      surfaces::Ring shape;
      shape.zone = 2;
      shape.zone_around = mesh.across;
      shape.across = mesh.across;
      shape.around = 5 * mesh.across;
      shape.deep = mesh.across / 2;
      const SurfaceMesh surface = surfaces::ring(shape, mesh.type);
      Record record{.case_name = "ring_loads", .method = "BEM", .model = "BEM body, pressure"};
      record.mesh = surfaces::name_of(mesh.type) + ", patch of " + std::to_string(mesh.across) +
                    " x " + std::to_string(mesh.across);
      record.threads = runner.threads;
      record.quantity = "worst of 4 inward displacements";
      record.against = "Fourier series";
      const double began = now();
      const Solved solved = press(surface, reference, runner.threads);
      record.seconds = now() - began;
      record.value = solved.first;
      record.error = solved.worst;
      record.nodes = surface.nodes();
      record.elements = surface.elements();
      record.unknowns = solved.unknowns;
      record.peak_bytes = solved.peak_bytes;
      record.phase_seconds = solved.phase_seconds;
      record.extra = {{"nu", reference.poisson}};
      runner.emit(record);
    }
}

}  // namespace

std::vector<Case> ring_load_cases() {
  return {{"ring_loads", "a ring under a patch of pressure, by itself: elements and meshes", run}};
}

}  // namespace rollcon::bench
