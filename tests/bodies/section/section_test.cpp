// Tests bodies given by sections against closed forms and Fourier series.

#include <cmath>
#include <numbers>

#include "bodies/body.hpp"
#include "support/loaded_ring.hpp"
#include "support/section_bodies.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace loaded_ring = statics::loaded_ring;
using loaded_ring::Load;
using sections::SectionBody;

constexpr double pi = std::numbers::pi;

loaded_ring::Answer loaded(SectionBody& ring, Load kind, int parts) {
  // The layer is the patch |s| <= 1 over the whole width, as fine as wanted, at the top.
  SurfaceMesh layer;
  layer.offset = {0};
  const int n = 2 * parts;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double a = (2.0 * i / n - 1) / loaded_ring::outer, y = loaded_ring::side * (2.0 * j / n - 1);
      layer.node.push_back({loaded_ring::outer * std::sin(a), y, loaded_ring::outer * std::cos(a)});
    }
  const auto id = [&](int i, int j) { return static_cast<std::int32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; i += 2)
    for (int j = 0; j < n; j += 2)
      surfaces::add_element(layer, ElementType::quad9,
                            {id(i, j), id(i + 2, j), id(i + 2, j + 2), id(i, j + 2), id(i + 1, j), id(i + 2, j + 1),
                             id(i + 1, j + 2), id(i, j + 1), id(i + 1, j + 1)});
  loaded_ring::Answer a;
  a.mesh = &ring.surface();
  a.node = loaded_ring::nodes_near_patch(ring.surface());
  const auto rows = ring.body().response()->rows({{}, layer, a.node}, 1);
  std::vector<double> t;
  for (const Vec3& x : layer.node) {
    const Vec3 value = loaded_ring::traction(kind, x);
    t.insert(t.end(), value.begin(), value.end());
  }
  std::vector<double> u(3 * a.node.size());
  multiply(rows->u.data(), rows->u.rows(), rows->u.columns(), t.data(), 0, u.data());
  for (std::size_t k = 0; k < a.node.size(); ++k) a.u.push_back({u[3 * k], u[3 * k + 1], u[3 * k + 2]});
  return a;
}

TEST(Section, moves_the_ring_under_a_patch_as_listed) {
  const sections::Rectangle shape{sections::fine_at_ends(12, -4, 4), sections::fine_at_ends(12, 25, 50)};
  for (const double poisson : {0.3, 0.49}) {
    SectionBody ring(sections::rectangle(shape, ElementType::quad8), loaded_ring::young, poisson);
    ring.tag_sides(shape).contact(4).turn_about_y();
    ring.hold([](const Vec3& x) { return x[2] < 25 + 1e-9; }).prepare();
    report("surface nodes", static_cast<double>(ring.surface().nodes()));
    for (const Load kind : {Load::normal, Load::tangential, Load::axial}) {
      if (poisson > 0.3 && kind != Load::normal) continue;
      const auto answer = loaded(ring, kind, 8);
      for (const auto& e : loaded_ring::listed_errors(answer, kind, poisson))
        if (e.what.find("mean") == std::string::npos) expect_error(e.what, e.error, 1e-3);
    }
  }
}

}  // namespace
}  // namespace rollcon
