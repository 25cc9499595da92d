// Tests fields inside boundary elements, by Somigliana's identities: uniform stresses on bricks of all elements, Lame's
// thick cylinder at all depths, and what is outside.

#include "bodies/body_results.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/index.hpp"
#include "support/static_cases.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace walls = statics::walls;
using statics::StaticBody;
using Stress = std::array<double, 6>;

struct Fields {
  std::vector<double> u, stress;
};

Fields fields_at(StaticBody& body, const std::vector<Vec3>& x) {
  Fields f{std::vector<double>(3 * x.size()), std::vector<double>(6 * x.size())};
  body_fields_at(body.body(), NodalDisplacements{body.mesh().nodes(), nullptr}, std::ssize(x), x.data()->data(),
                 f.u.data(), f.stress.data());
  return f;
}

/// Returns Lame's stresses in plane strain, around the y axis.
Stress lame(const Vec3& x, double poisson) {
  const double r2 = x[0] * x[0] + x[2] * x[2], a2 = walls::inner * walls::inner, b2 = walls::outer * walls::outer;
  const double k = walls::pressure * a2 / (b2 - a2), radial = k * (1 - b2 / r2), hoop = k * (1 + b2 / r2);
  const double c = x[0] / std::sqrt(r2), s = x[2] / std::sqrt(r2);
  return {radial * c * c + hoop * s * s, 2 * poisson * k, radial * s * s + hoop * c * c, 0, (radial - hoop) * c * s, 0};
}

/// Returns points of the surface, moved inwards by `depth`, away from the edges between faces with different tags.
std::vector<Vec3> below(const SurfaceMesh& mesh, double depth, std::initializer_list<std::int32_t> tags) {
  std::vector<Vec3> x;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    if (std::find(tags.begin(), tags.end(), mesh.tag[at(e)]) == tags.end()) continue;
    const bool triangle = corner_count(mesh.type[at(e)]) == 3;
    for (const Vec3& at : {Vec3{0.1, 0.3, 0}, Vec3{0.45, 0.5, 0}}) {
      const SurfaceFrame frame =
          triangle ? evaluate_surface(mesh, e, at[0], at[1]) : evaluate_surface(mesh, e, 2 * at[0] - 1, 2 * at[1] - 1);
      x.push_back(frame.x - depth / length(frame.normal) * frame.normal);
    }
  }
  return x;
}

// The points lie anywhere, near the surface and on it.
TEST(BemInside, uniform_stresses_are_exact) {
  double worst = 0, worst_u = 0;
  for (const ElementType type : surfaces::all_types)
    for (const double size : {1.0, 1e-20}) {
      if (size < 1 && type != ElementType::quad8) continue;
      const auto mesh = surfaces::distort(surfaces::block(surfaces::brick({2, 1, 1}, {1, 1, 1}), type), 0.2, 11);
      StaticBody body(surfaces::transform(mesh,
                                          [size](const Vec3& x) {
                                            return size * (x + Vec3{3, 0, 0});
                                          }),
                      200, 0.3, 1e-8);
      const auto& [name, stress] = statics::uniform_stresses[3];
      const statics::UniformStress field(stress, 200, 0.3);
      const auto exact = [&field, size](const Vec3& x) { return size * field(1 / size * x); };
      std::vector<std::int32_t> all(at(body.mesh().nodes()));
      for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<std::int32_t>(k);
      body.hold(all, 7, exact).solve();
      std::vector<Vec3> x{size * Vec3{3.4, 0.5, 0.6}, size * Vec3{3.001, 1e-4, 1e-3}};
      for (const double depth : {0.0, 1e-8, 1e-3})
        for (const Vec3& p : below(body.mesh(), size * depth, {1, 6})) x.push_back(p);
      const Fields f = fields_at(body, x);
      for (std::size_t p = 0; p < x.size(); ++p) {
        const Stress s{stress[0][0], stress[1][1], stress[2][2], stress[0][1], stress[0][2], stress[1][2]};
        const Vec3 u = exact(x[p]);
        for (std::size_t c = 0; c < 6; ++c) worst = std::max(worst, std::abs(f.stress[6 * p + c] - s[c]));
        for (std::size_t c = 0; c < 3; ++c) worst_u = std::max(worst_u, std::abs(f.u[3 * p + c] - u[c]) / size);
      }
    }
  expect_error("uniform stresses inside boundary elements", worst, 2e-6);
  expect_error("their displacements", worst_u, 1e-8);
}

struct LameError {
  double stress = 0, mean = 0;  ///< greatest error over the pressure, and root of the mean square
  double displacement = 0;      ///< error over the largest displacement
};

/// Returns the errors in Lame's cylinder at a depth below its curved faces.
LameError lame_error(StaticBody& body, double depth) {
  const std::vector<Vec3> x = below(body.mesh(), depth, {5, 6});
  const Fields f = fields_at(body, x);
  LameError error;
  const double largest = length(walls::cylinder_displacement({0, 0, walls::inner}, 0.3));
  for (std::size_t p = 0; p < x.size(); ++p) {
    const Stress s = lame(x[p], 0.3);
    const Vec3 u = walls::cylinder_displacement(x[p], 0.3);
    for (std::size_t c = 0; c < 6; ++c) {
      const double off = std::abs(f.stress[6 * p + c] - s[c]) / walls::pressure;
      error.stress = std::max(error.stress, off);
      error.mean += off * off / (6 * static_cast<double>(x.size()));
    }
    for (std::size_t c = 0; c < 3; ++c)
      error.displacement = std::max(error.displacement, std::abs(f.u[3 * p + c] - u[c]) / largest);
  }
  error.mean = std::sqrt(error.mean);
  return error;
}

struct Bounds {
  ElementType type;
  int n;
  double stress, displacement, order;
};
class BemLame : public ::testing::TestWithParam<Bounds> {};

TEST_P(BemLame, stresses_converge_at_all_depths) {
  const Bounds& b = GetParam();
  StaticBody coarse(walls::quarter_cylinder(b.n), b.type, walls::young, 0.3);
  StaticBody fine(walls::quarter_cylinder(2 * b.n), b.type, walls::young, 0.3);
  for (StaticBody* body : {&coarse, &fine}) {
    walls::press_cylinder(*body);
    body->solve();
  }
  for (const double depth : {0.0, 1e-7, 1e-3, 0.02, 0.1, 0.3}) {
    if (depth > 0.2 && !is_quadratic(b.type)) continue;  // points below tilted faces leave the quarter
    char text[80];
    std::snprintf(text, sizeof text, "%s, depth %g", surfaces::name_of(b.type).c_str(), depth);
    const auto first = lame_error(coarse, depth), second = lame_error(fine, depth);
    expect_error(std::string(text) + ", stress over the pressure", second.stress, b.stress);
    expect_error(std::string(text) + ", displacement", second.displacement, b.displacement);
    expect_order(std::string(text) + ", mean of stress", observed_order(first.mean, second.mean, 2, 1), b.order);
  }
}

constexpr auto type_name = [](const auto& param) { return surfaces::name_of(param.param.type); };
INSTANTIATE_TEST_SUITE_P(Bem, BemLame, ::testing::Values(Bounds{ElementType::quad8, 2, 6e-3, 3e-4, 0.8}), type_name);
INSTANTIATE_TEST_SUITE_P(Bem_long, BemLame,
                         ::testing::Values(Bounds{ElementType::quad8, 4, 1e-3, 5e-5, 1.5},
                                           Bounds{ElementType::quad9, 2, 6e-3, 3e-4, 0.8},
                                           Bounds{ElementType::tri6, 2, 8e-3, 3e-4, 1},
                                           Bounds{ElementType::quad4, 4, 0.1, 5e-3, 1},
                                           Bounds{ElementType::tri3, 4, 0.15, 5e-3, 1}),
                         type_name);

TEST(BemInside, what_is_outside_is_refused) {
  StaticBody shell(surfaces::with_cavity(surfaces::cube_sphere(ElementType::quad8, 2, 2),
                                         surfaces::cube_sphere(ElementType::quad8, 2, 1, 2)),
                   1000, 0.3);
  shell.hold_statically().pressure(1, 5).pressure(2, 5).solve();
  const auto refused = [&](const Vec3& x) {
    try {
      fields_at(shell, {{1.5, 0, 0}, x});
    } catch (const Error& e) {
      return e.status() == Status::err_argument && std::string(e.what()).find("point 1") != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(refused({0.1, 0.2, 0}));
  EXPECT_TRUE(refused({0, 0, 0.99}));
  EXPECT_TRUE(refused({0, 0, 2.01}));
  EXPECT_TRUE(refused({50, 0, 0}));
  const Fields f = fields_at(shell, {{1.5, 0, 0}, {0, 1.001, 0}, {0, 0, 1.99}});
  double worst = 0;
  for (std::size_t k = 0; k < f.stress.size(); ++k)
    worst = std::max(worst, std::abs(f.stress[k] + (k % 6 < 3 ? 5 : 0)) / 5);
  expect_error("a shell under the same pressure from both sides", worst, 0.06);
}

}  // namespace
}  // namespace rollcon
