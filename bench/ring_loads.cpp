// The ring of the paper's first example under a patch of pressure, as a body by itself: against its
// Fourier series in the angle, over meshes and elements.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

Solved press(scenes::MeshedBody shape, const Reference& reference, int threads) {
  const double poisson = reference.poisson;
  const SurfaceMesh& mesh = shape.mesh;
  shape.material =
      scenes::Elastic{.shear = example1::young / (2 * (1 + poisson)), .poisson = poisson};
  shape.held_tag = {3};
  shape.contact_tag = {2};
  rollcon_context* context = nullptr;
  must(rollcon_context_create(ROLLCON_ABI, &context), "context_create");
  must(rollcon_context_set_threads(context, threads), "set_threads");
  rollcon_body* body = scenes::make_body(context, shape);
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
  for (const char* phase : {"assembly", "order", "factor"})
    solved.phase_seconds.emplace_back(phase, stat((std::string("seconds_") + phase).c_str()));
  rollcon_body_release(body);
  rollcon_context_release(context);
  return solved;
}

/// What is meshed, by which method, and how it is called.
struct Meshed {
  scenes::MeshedBody body;
  std::string method, mesh;
};

/// across: elements along and across the patch.
surfaces::Ring shape_of(int across, int around, int deep, double largest, double top_layer) {
  return {.zone = 2,
          .around = around,
          .zone_around = across,
          .across = across,
          .deep = deep,
          .largest = largest,
          .top_layer = top_layer};
}

std::string patch_name(const std::string& elements, int across) {
  const std::string n = std::to_string(across);
  return elements + ", patch of " + n + " x " + n;
}

Meshed by(ElementType type, int across) {
  Meshed m{{}, "BEM", patch_name(surfaces::name_of(type), across)};
  m.body.mesh = surfaces::ring(shape_of(across, 5 * across, across / 2, 16, 1.2), type);
  return m;
}

/// Finite elements want them to be fine below the patch as well, and fewer far from it.
Meshed by(VolumeType type, int across) {
  volumes::Mesh mesh = volumes::ring(
      shape_of(across, 4 * across, across, example1::longest(3 * across), 2.0 / across), type);
  Meshed m{{}, "FEM", patch_name(volumes::name_of(type), across)};
  m.body.mesh = std::move(mesh.surface);
  m.body.volume = std::move(mesh.volume);
  return m;
}

using Maker = std::function<Meshed()>;

/// The first mesh only when `quick`.
template <class Type>
void add(std::vector<Maker>& all, bool quick, Type type, const std::vector<int>& across) {
  for (const int n : across) {
    all.push_back([type, n] { return by(type, n); });
    if (quick) return;
  }
}

std::vector<Maker> boundary_element_meshes(bool quick) {
  std::vector<Maker> all;
  add(all, quick, ElementType::quad4, {8, 12, 16});
  add(all, quick, ElementType::quad8, {4, 8});
  if (quick) return all;
  add(all, quick, ElementType::tri3, {8, 12});
  add(all, quick, ElementType::quad9, {4, 8});
  add(all, quick, ElementType::tri6, {4, 8});
  return all;
}

std::vector<Maker> finite_element_meshes(bool quick) {
  std::vector<Maker> all;
  add(all, quick, VolumeType::hex8, {8, 12, 16, 20});
  add(all, quick, VolumeType::hex20, {4, 6, 8, 10});
  if (quick) return all;
  add(all, quick, VolumeType::wedge6, {8, 12, 16});
  add(all, quick, VolumeType::wedge15, {4, 6, 8});
  add(all, quick, VolumeType::tet4, {8, 12, 16});
  add(all, quick, VolumeType::tet10, {4, 6, 8});
  return all;
}

/// Near incompressibility tet4 and wedge6 are refused.
bool refused(const scenes::MeshedBody& body, double poisson) {
  if (body.volume.elements() == 0 || poisson < 0.45) return false;
  const VolumeType type = body.volume.type.front();
  return type == VolumeType::tet4 || type == VolumeType::wedge6;
}

void run(Runner& runner, const char* case_name, const std::vector<Maker>& meshes) {
  for (const auto& make : meshes) {
    const Meshed meshed = make();
    for (const Reference& reference : references) {
      if (refused(meshed.body, reference.poisson)) continue;
      Record record{.case_name = case_name, .method = meshed.method, .model = "pressure"};
      record.mesh = meshed.mesh;
      record.threads = runner.threads;
      record.quantity = "worst of 4 inward displacements";
      record.against = "Fourier series";
      const double began = now();
      const Solved solved = press(meshed.body, reference, runner.threads);
      record.seconds = now() - began;
      record.value = solved.first;
      record.error = solved.worst;
      record.nodes = meshed.body.mesh.nodes();
      record.elements = std::max(meshed.body.volume.elements(), meshed.body.mesh.elements());
      record.unknowns = solved.unknowns;
      record.peak_bytes = solved.peak_bytes;
      record.phase_seconds = solved.phase_seconds;
      record.extra = {{"nu", reference.poisson}};
      runner.emit(record);
    }
  }
}

}  // namespace

std::vector<Case> ring_load_cases() {
  return {{"ring_loads", "a ring under a patch of pressure, by itself: boundary elements",
           [](Runner& r) { run(r, "ring_loads", boundary_element_meshes(r.quick)); }},
          {"fem_ring_loads", "the same by finite elements",
           [](Runner& r) { run(r, "fem_ring_loads", finite_element_meshes(r.quick)); }}};
}

}  // namespace rollcon::bench
