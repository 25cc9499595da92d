// Compares the ring of the paper's first example under loads on a patch, as a body by itself, with its Fourier series
// in the angle, over meshes and elements.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>

#include "bench.hpp"
#include "support/example1.hpp"
#include "support/loaded_ring.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;
namespace loaded_ring = statics::loaded_ring;
using loaded_ring::Load;

struct LoadCase {
  Load load;
  double poisson;
  const char* name;
};
constexpr LoadCase load_cases[] = {{Load::normal, 0.3, "pressure"},
                                   {Load::tangential, 0.3, "shear"},
                                   {Load::axial, 0.3, "axial"},
                                   {Load::normal, 0.49, "pressure"}};

struct Solved {
  double worst = 0, first = 0;
  std::size_t listed = 0;
  std::int64_t unknowns = 0, peak_bytes = 0;
  std::vector<std::pair<std::string, double>> phase_seconds;
};

void must(std::int32_t status, const char* what) {
  if (status < 0) throw std::runtime_error(what);
}

/// Gives each column of elements along the patch a tag of its own, because the faces of a tag have one traction. What
/// that leaves of the load's turning within a column has no resultant.
std::map<std::int32_t, Vec3> tag_columns(SurfaceMesh& mesh) {
  constexpr std::int32_t first_tag = 100;
  std::map<std::int64_t, std::int32_t> tag_of_place;
  std::map<std::int32_t, Vec3> middle_of_tag;
  for (const std::int64_t e : loaded_ring::patch_of(mesh)) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::int32_t k : mesh.element(e)) {
      const Vec3& x = mesh.node[static_cast<std::size_t>(k)];
      low = std::min(low, std::atan2(x[0], x[2]));
      high = std::max(high, std::atan2(x[0], x[2]));
    }
    const double angle = (low + high) / 2;
    const auto tag = first_tag + static_cast<std::int32_t>(tag_of_place.size());
    const auto place = tag_of_place.try_emplace(std::llround(1e6 * angle), tag).first;
    mesh.tag[static_cast<std::size_t>(e)] = place->second;
    middle_of_tag[place->second] = loaded_ring::outer * Vec3{std::sin(angle), 0, std::cos(angle)};
  }
  return middle_of_tag;
}

Solved press(scenes::MeshedBody shape, const LoadCase& load, int threads) {
  const std::map<std::int32_t, Vec3> columns = tag_columns(shape.mesh);
  const SurfaceMesh& mesh = shape.mesh;
  shape.material = scenes::Elastic{.shear = loaded_ring::young / (2 * (1 + load.poisson)), .poisson = load.poisson};
  shape.held_tag = {3};
  shape.contact_tag = {columns.begin()->first};
  rollcon_context* context = nullptr;
  must(rollcon_context_create(ROLLCON_ABI, &context), "context_create");
  must(rollcon_context_set_threads(context, threads), "set_threads");
  rollcon_body* body = scenes::make_body(context, shape);
  for (const auto& [tag, middle] : columns) {
    if (load.load == Load::normal)
      must(rollcon_body_set_pressure(body, tag, loaded_ring::load), "set_pressure");
    else
      must(rollcon_body_set_traction(body, tag, loaded_ring::traction(load.load, middle).data()), "set_traction");
  }
  must(rollcon_body_prepare(body), "prepare");
  std::vector<double> u(3 * mesh.node.size());
  must(rollcon_body_get_displacements(body, mesh.nodes(), u.data()), "get_displacements");

  loaded_ring::Answer answer;
  answer.mesh = &mesh;
  answer.node = loaded_ring::nodes_near_patch(mesh);
  for (const std::int32_t node : answer.node) {
    const double* at = u.data() + 3 * static_cast<std::size_t>(node);
    answer.u.push_back({at[0], at[1], at[2]});
  }
  answer.find_mean();
  Solved solved;
  solved.first = answer.at(0, 0)[load.load == Load::normal ? 2 : load.load == Load::axial ? 1 : 0];
  const auto errors = loaded_ring::listed_errors(answer, load.load, load.poisson);
  solved.listed = errors.size();
  for (const auto& [what, error] : errors)
    if (std::abs(error) > std::abs(solved.worst)) solved.worst = error;
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

/// Says what is meshed, by which method, and how it is called.
struct Meshed {
  scenes::MeshedBody body;
  std::string method, mesh;
};

/// Holds the elements on half of the zone |s| <= 2 (as many along the patch |s| <= 1), on half of the rest, on half of
/// the width, and from hub to rim. Edges lie at the patch's ends, so `along` is even.
struct BemMesh {
  int along, far, across, deep;
};

Meshed by(ElementType type, const BemMesh& n) {
  Meshed m{{},
           "BEM",
           surfaces::name_of(type) + ", patch of " + std::to_string(n.along) + " x " + std::to_string(2 * n.across)};
  m.body.mesh = surfaces::ring({.zone = 4,
                                .around = 2 * (n.along + n.far),
                                .zone_around = 2 * n.along,
                                .across = 2 * n.across,
                                .deep = n.deep,
                                .largest = 0,
                                .top_layer = 2.0 / n.along,
                                .side_grading = 1},
                               type);
  return m;
}

/// Makes finite elements, which have to be fine below the patch as well, and may be fewer far from it.
Meshed by(VolumeType type, int across) {
  volumes::Mesh mesh = volumes::ring({.zone = 2,
                                      .around = 4 * across,
                                      .zone_around = across,
                                      .across = across,
                                      .deep = across,
                                      .largest = example1::longest(3 * across),
                                      .top_layer = 2.0 / across},
                                     type);
  const std::string n = std::to_string(across);
  Meshed m{{}, "FEM", volumes::name_of(type) + ", patch of " + n + " x " + n};
  m.body.mesh = std::move(mesh.surface);
  m.body.volume = std::move(mesh.volume);
  return m;
}

using Maker = std::function<Meshed()>;

/// Adds the first mesh only when `quick`.
template <class Type, class Size>
void add(std::vector<Maker>& all, bool quick, Type type, const std::vector<Size>& sizes) {
  for (const Size& n : sizes) {
    all.push_back([type, n] { return by(type, n); });
    if (quick) return;
  }
}

std::vector<Maker> boundary_element_meshes(bool quick) {
  std::vector<Maker> all;
  using Sizes = std::vector<BemMesh>;
  const Sizes linear{{4, 16, 3, 8}, {6, 20, 4, 10}, {8, 24, 5, 12}, {10, 28, 5, 14}};
  const Sizes quadratic{{2, 8, 3, 5}, {4, 10, 3, 6}, {4, 12, 4, 10}};
  const Sizes with_middles{{2, 8, 3, 5}, {4, 10, 3, 6}, {4, 12, 3, 8}};
  add(all, quick, ElementType::quad4, linear);
  add(all, quick, ElementType::quad8, quadratic);
  if (quick) return all;
  add(all, quick, ElementType::tri3, Sizes(linear.begin(), linear.end() - 1));
  add(all, quick, ElementType::quad9, with_middles);
  add(all, quick, ElementType::tri6, with_middles);
  return all;
}

std::vector<Maker> finite_element_meshes(bool quick) {
  std::vector<Maker> all;
  add<VolumeType, int>(all, quick, VolumeType::hex8, {8, 12, 16, 20});
  add<VolumeType, int>(all, quick, VolumeType::hex20, {4, 6, 8, 10});
  if (quick) return all;
  add<VolumeType, int>(all, quick, VolumeType::wedge6, {8, 12, 16});
  add<VolumeType, int>(all, quick, VolumeType::wedge15, {4, 6, 8});
  add<VolumeType, int>(all, quick, VolumeType::tet4, {8, 12, 16});
  add<VolumeType, int>(all, quick, VolumeType::tet10, {4, 6, 8});
  return all;
}

/// Says whether the mesh is refused: tet4 and wedge6 are near incompressibility.
bool refused(const scenes::MeshedBody& body, double poisson) {
  if (body.volume.elements() == 0 || poisson < 0.45) return false;
  const VolumeType type = body.volume.type.front();
  return type == VolumeType::tet4 || type == VolumeType::wedge6;
}

void run(Runner& runner, const char* case_name, const std::vector<Maker>& meshes) {
  for (const auto& make : meshes) {
    const Meshed meshed = make();
    for (const LoadCase& load : load_cases) {
      if (refused(meshed.body, load.poisson)) continue;
      Record record{.case_name = case_name, .method = meshed.method, .model = load.name};
      record.mesh = meshed.mesh;
      record.threads = runner.threads;
      record.against = "Fourier series";
      const double began = now();
      const Solved solved = press(meshed.body, load, runner.threads);
      record.quantity = "worst of " + std::to_string(solved.listed) + " displacements";
      record.seconds = now() - began;
      record.value = solved.first;
      record.error = solved.worst;
      record.nodes = meshed.body.mesh.nodes();
      record.elements = std::max(meshed.body.volume.elements(), meshed.body.mesh.elements());
      record.unknowns = solved.unknowns;
      record.peak_bytes = solved.peak_bytes;
      record.phase_seconds = solved.phase_seconds;
      record.extra = {{"nu", load.poisson}};
      runner.emit(record);
    }
  }
}

}  // namespace

std::vector<Case> ring_load_cases() {
  return {{"ring_loads", "a ring under pressure, shear and axial load on a patch: boundary elements",
           [](Runner& r) { run(r, "ring_loads", boundary_element_meshes(r.quick)); }},
          {"fem_ring_loads", "the same by finite elements",
           [](Runner& r) { run(r, "fem_ring_loads", finite_element_meshes(r.quick)); }},
          {"ring_sections", "two rings by sections, finite and boundary elements: errors over time", ring_sections}};
}

}  // namespace rollcon::bench
