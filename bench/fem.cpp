// Measures finite-element bodies: how the phases of their preparation grow, the paper's ring on a half-space, its two
// rings by finite and by boundary elements, one block by both, and the location of a frame on many faces.

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "bench.hpp"
#include "geometry/surface_search.hpp"
#include "support/example1.hpp"
#include "support/example2.hpp"
#include "support/example3.hpp"
#include "support/graded_disc.hpp"
#include "support/hertz_fit.hpp"
#include "support/mid_plane.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;
namespace example2 = scenes::example2;
namespace example3 = scenes::example3;

void add_body(Record& record, const scenes::RollingPair& pair, int which, const std::string& of) {
  for (const char* phase : {"assembly", "order", "factor", "condense"})
    record.phase_seconds.emplace_back(of + phase, pair.body_stat(which, (std::string("seconds_") + phase).c_str()));
  for (const char* name : {"unknowns", "condensed_unknowns", "factor_nonzeros", "condition"})
    record.extra.emplace_back(of + name, pair.body_stat(which, name));
  const double bytes = pair.body_stat(which, "peak_bytes");
  record.extra.emplace_back(of + "peak_bytes", bytes);
  record.peak_bytes += static_cast<std::int64_t>(bytes);
}

/// Makes a block of nx * nx * nz hex8, 1 mm each, held at its bottom, with 400 contact nodes on its top.
scenes::MeshedBody contact_block(int nx, int nz) {
  constexpr int contact = 19;
  surfaces::Block shape = surfaces::brick({nx, nx, nz}, {1.0 * nx, 1.0 * nx, 1.0 * nz});
  const double middle = 0.5 * nx, top = nz;
  shape.map = [middle, top](const Vec3& x) { return x - Vec3{middle, middle, top}; };
  shape.tag = {4, 5, 6, 7, 3, 1};
  shape.zone_from = {(nx - contact) / 2, (nx - contact) / 2};
  shape.zone_to = {shape.zone_from[0] + contact, shape.zone_from[1] + contact};
  shape.zone_tag = 2;
  scenes::MeshedBody body = scenes::meshed(volumes::block(shape, VolumeType::hex8), example1::material);
  body.held_tag = {3};
  body.contact_tag = {2};
  return body;
}

void press_block(Runner& runner, int nx, int nz) {
  const scenes::MeshedBody body = contact_block(nx, nz);
  Record record{.case_name = "fem_growth", .method = "condensed"};
  record.model = "FEM on rigid";
  record.threads = runner.threads;
  const double began = now();
  scenes::RollingPair pair(body, scenes::RigidBody{}, runner.threads);
  const double curvature = 1e-3;
  pair.frame_from_body(1, 2).gap_quadratic(curvature, curvature).friction(0).approach(0.03);
  timed_solve(pair, record, began);
  add_body(record, pair, 1, "");
  double condensed = 0;
  for (const auto& [name, seconds] : record.phase_seconds)
    for (const char* phase : {"assembly", "order", "factor", "condense"})
      if (name == phase) condensed += seconds;
  const auto unknowns = std::llround(pair.body_stat(1, "unknowns"));
  record.mesh = "hex8 block, " + std::to_string(unknowns) + " unknowns";
  record.quantity = "seconds until condensed";
  record.value = condensed;
  runner.emit(record);
}

void growth(Runner& runner) {
  // The sizes (nx, nz) give 3 (nx + 1)^2 nz unknowns, 1200 of them in contact.
  std::vector<std::pair<int, int>> sizes{{19, 4}, {19, 8}, {20, 16}, {24, 24}, {31, 31}, {40, 40}, {45, 47}};
  if (runner.threads > 1) sizes = {{24, 24}, {40, 40}};
  if (runner.quick) sizes.resize(2);
  for (const auto& [nx, nz] : sizes) press_block(runner, nx, nz);
}

void ring_on_halfspace(Runner& runner) {
  struct Mesh {
    VolumeType type;
    int parts;  ///< elements along and across the zone
  };
  std::vector<Mesh> meshes{
      {VolumeType::hex8, 12}, {VolumeType::hex8, 18}, {VolumeType::hex20, 6}, {VolumeType::hex20, 8}};
  if (runner.quick) meshes.resize(1);
  const double creepage = example2::plane_creepage();
  for (const Mesh& mesh : meshes)
    for (const example2::Ground on : {example2::Ground::half_space, example2::Ground::block})
      for (const char* scheme : {"characteristic", "least_squares", "godunov"}) {
        Record record{.case_name = "ring_on_halfspace", .method = scheme};
        record.model = on == example2::Ground::block ? "FEM on BEM block" : "FEM on half-space";
        record.threads = runner.threads;
        const surfaces::Ring shape = example2::ring_of(mesh.parts);
        const double began = now();
        auto pair = example2::pair(shape, mesh.type, on, runner.threads);
        pair->option("convection", scheme);
        const auto s = timed_solve(*pair, record, began);
        const scenes::MidPlane m = scenes::mid_plane(s, shape.zone, example2::width);
        record.mesh = volumes::name_of(mesh.type) + ", " + std::to_string(shape.around * shape.across * shape.deep) +
                      " elements, zone " + std::to_string(mesh.parts) + " x " + std::to_string(mesh.parts);
        record.quantity = "creepage at Ft = 0.5373 mu Fn";
        record.against = "plane problem of the two materials";
        record.value = s.creep[0];
        record.error = s.creep[0] / creepage - 1;
        add_body(record, *pair, 1, "");
        record.extra.emplace_back("p0", m.p0);
        record.extra.emplace_back("p0_over_hertz", m.p0 / example2::hertz.p0);
        record.extra.emplace_back("half_width", m.half_width);
        record.extra.emplace_back("slip", m.slip);
        record.extra.emplace_back("gap", m.gap);
        runner.emit(record);
        if (runner.quick) break;
      }
}

/// Measures two rings of example 1, each by either method; `parts` are the elements along and across the zone.
void ring_pairs(Runner& runner) {
  struct Mesh {
    VolumeType fem;
    ElementType bem;
    int parts;
  };
  std::vector<Mesh> meshes{{VolumeType::hex8, ElementType::quad4, 6},  {VolumeType::hex8, ElementType::quad4, 12},
                           {VolumeType::hex8, ElementType::quad4, 18}, {VolumeType::hex20, ElementType::quad8, 4},
                           {VolumeType::hex20, ElementType::quad8, 6}, {VolumeType::hex20, ElementType::quad8, 8}};
  if (runner.quick) meshes.resize(1);
  for (const Mesh& mesh : meshes) {
    for (const char* kinds : {"FEM on FEM", "FEM on BEM", "BEM on BEM"}) {
      Record record{.case_name = "ring_pairs", .method = "least_squares", .model = kinds};
      record.threads = runner.threads;
      const scenes::MeshedBody fem = example1::ring_body(example1::fem_ring(mesh.parts), mesh.fem);
      const scenes::MeshedBody bem = example1::ring_body(example1::bem_ring(mesh.parts), mesh.bem);
      const bool first_fem = kinds[0] == 'F', last_fem = kinds[7] == 'F';
      const double began = now();
      auto pair =
          example1::pair(first_fem ? fem : bem, first_fem == last_fem ? scenes::AnyBody{scenes::TwinBody{}} : bem,
                         "least_squares", runner.threads);
      const auto s = timed_solve(*pair, record, began);
      const scenes::MidPlane m = scenes::mid_plane(s, example1::paper_ring().zone, example1::width);
      record.mesh = volumes::name_of(mesh.fem) + ", " + surfaces::name_of(mesh.bem) + ", zone " +
                    std::to_string(mesh.parts) + " x " + std::to_string(mesh.parts);
      record.quantity = "creepage at Ft = 0.6271 mu Fn";
      record.against = "finite elements, 36 x 12 hex20 in the zone";
      record.value = s.creep[0];
      record.error = s.creep[0] / example1::fine_creepage - 1;
      record.extra = {{"p0", m.p0},
                      {"p0_over_fine", m.p0 / example1::fine_p0},
                      {"unknowns1", pair->body_stat(1, "unknowns")},
                      {"unknowns2", pair->body_stat(2, "unknowns")},
                      {"slip", m.slip}};
      runner.emit(record);
    }
  }
}

scenes::MeshedBody elastic_block(ElementType type, int n) {
  return scenes::meshed(surfaces::zone_block({10, 5, 2.5, n, n / 2, n / 2}, type), example3::sphere);
}

scenes::MeshedBody elastic_block(VolumeType type, int n) {
  return scenes::meshed(volumes::zone_block({10, 5, 2.5, n, n / 2, n}, type), example3::sphere);
}

/// Presses a rigid sphere on a block of finite and of boundary elements, with one frame laid on all meshes.
void same_block(Runner& runner) {
  std::vector<std::pair<std::string, std::function<scenes::MeshedBody(int)>>> elements;
  const auto add = [&](auto type, const std::string& name) {
    elements.emplace_back(name, [type](int n) { return elastic_block(type, n); });
  };
  for (const ElementType type : {ElementType::quad4, ElementType::quad8}) add(type, "BEM " + surfaces::name_of(type));
  for (const VolumeType type : {VolumeType::hex8, VolumeType::hex20, VolumeType::wedge15, VolumeType::tet10})
    add(type, "FEM " + volumes::name_of(type));
  const closed_forms::Hertz hertz = example3::hertz();
  const SurfaceMesh frame = scenes::graded_disc(hertz.a, hertz.a, 10);
  const auto press = [&](scenes::MeshedBody body, Record& record) {
    body.held_tag = {3};
    body.contact_tag = {2};
    const double began = now();
    scenes::RollingPair pair(body, scenes::RigidBody{}, runner.threads);
    const double curvature = 1 / (2 * example3::radius);
    pair.frame(frame).gap_quadratic(curvature, curvature).friction(0).load(example3::load);
    const auto s = timed_solve(pair, record, began);
    add_body(record, pair, 1, "");
    record.value = s.approach;
    const scenes::FittedEllipse fit = scenes::fit_hertz(s, hertz.a, hertz.a);
    record.extra.emplace_back("p0", fit.p0);
    record.extra.emplace_back("a", std::sqrt(fit.a * fit.b));
    return fit.p0;
  };
  std::vector<int> sizes{4, 6, 8, 12};
  if (runner.quick) sizes = {4};
  Record reference;
  const double p0 = press(elastic_block(ElementType::quad8, runner.quick ? 6 : 12), reference);
  for (const auto& [name, make] : elements)
    for (const int n : sizes) {
      if (!runner.quick && name == "BEM quad8" && n == sizes.back()) continue;
      Record record{.case_name = "same_block", .method = name, .model = "on a rigid sphere"};
      record.mesh = name + ", zone " + std::to_string(n) + " x " + std::to_string(n);
      record.threads = runner.threads;
      record.quantity = "approach";
      record.against = "BEM quad8, zone 12 x 12";
      const double found = press(make(n), record);
      record.extra.emplace_back("p0_error", found / p0 - 1);
      record.error = record.value / reference.value - 1;
      runner.emit(record);
    }
}

/// Measures the seconds to find 5,000 frame nodes on 20,000 faces.
void location(Runner& runner) {
  const int parts = runner.quick ? 30 : 100;
  const auto bent = [](SurfaceMesh mesh) {
    for (Vec3& x : mesh.node) x[2] = 0.1 * (1 - x[0] * x[0]) * (1 - x[1] * x[1]);
    return mesh;
  };
  const auto square = [&](ElementType type, int n, int m, double half) {
    return bent(frames::rectangle(type, frames::uniform_lines(-half, half, n), frames::uniform_lines(-half, half, m)));
  };
  const SurfaceMesh frame = square(ElementType::quad4, parts * 7 / 10 - 1, parts * 7 / 10 + 1, 0.9);
  for (const ElementType type : surfaces::all_types) {
    const bool triangles = corner_count(type) == 3;
    const SurfaceMesh body = square(type, parts, triangles ? parts : 2 * parts, 1);
    Record record{.case_name = "location", .method = surfaces::name_of(type)};
    record.model = "nodes of a frame on the faces of a body";
    record.mesh = std::to_string(body.elements()) + " faces";
    record.nodes = frame.nodes();
    record.elements = body.elements();
    record.quantity = "largest distance";
    const double began = now();
    const SurfaceSearch search(body, {});
    const double built = now();
    double worst = 0;
    for (const Vec3& x : frame.node) {
      const auto hit = search.along(x, {0, 0, 1}, {0, 0, 1});
      if (!hit) throw std::runtime_error("location: a node was missed");
      worst = std::max(worst, std::abs(hit->distance));
    }
    record.seconds = now() - began;
    record.value = worst;
    record.phase_seconds = {{"tree", built - began}, {"search", now() - built}};
    runner.emit(record);
  }
}

}  // namespace

std::vector<Case> fem_cases() {
  return {{"fem_growth", "finite elements from 5,000 to 300,000 unknowns", growth},
          {"ring_on_halfspace", "ring of finite elements on a half-space, beside long cylinders", ring_on_halfspace},
          {"ring_pairs", "the paper's example 1 by finite and by boundary elements", ring_pairs},
          {"same_block", "one block by finite and by boundary elements: refinement", same_block},
          {"location", "5,000 frame nodes on 20,000 faces", location}};
}

}  // namespace rollcon::bench
