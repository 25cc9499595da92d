// Lame's thick sphere and thick cylinder under pressure from inside: error and observed order.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/error.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;

constexpr double young = 1000, inner = 1, outer = 2, pressure = 10;
constexpr double pi = std::numbers::pi;

double sphere_displacement(double r, double poisson) {
  const double a3 = inner * inner * inner, b3 = outer * outer * outer;
  return pressure * a3 / (young * (b3 - a3)) *
         ((1 - 2 * poisson) * r + (1 + poisson) * b3 / (2 * r * r));
}

/// Plane strain.
double cylinder_displacement(double r, double poisson) {
  const double a2 = inner * inner, b2 = outer * outer;
  return pressure * a2 * (1 + poisson) / (young * (b2 - a2)) * ((1 - 2 * poisson) * r + b2 / r);
}

double sphere_error(ElementType type, int n, double poisson) {
  const auto exact = [poisson](const Vec3& x) {
    const double r = length(x);
    return (sphere_displacement(r, poisson) / r) * x;
  };
  StaticBody body(surfaces::with_cavity(surfaces::cube_sphere(type, n, outer, 1),
                                        surfaces::cube_sphere(type, n, inner, 2)),
                  young, poisson);
  body.pressure(2, pressure).hold_statically(exact).solve();
  return body.displacement_error(exact);
}

/// A quarter between planes of symmetry, all of which slide.
double cylinder_error(ElementType type, int n, double poisson) {
  const auto exact = [poisson](const Vec3& x) {
    const double r = std::hypot(x[0], x[2]);
    return (cylinder_displacement(r, poisson) / r) * Vec3{x[0], 0, x[2]};
  };
  surfaces::Block quarter = surfaces::brick({2 * n, n, n}, {pi / 2, 1, outer - inner});
  quarter.map = [](const Vec3& q) {
    return Vec3{(inner + q[2]) * std::sin(q[0]), q[1], (inner + q[2]) * std::cos(q[0])};
  };
  StaticBody body(surfaces::block(quarter, type), young, poisson);
  body.hold_tags({1}, 1).hold_tags({2}, 4).hold_tags({3, 4}, 2).pressure(5, pressure).solve();
  return body.displacement_error(exact);
}

struct Walls {
  const char* name;
  double (*error)(ElementType, int, double);
  int coarse;
  double linear_bound[2], quadratic_bound[2];  ///< coarse, fine
};

class ThickWalls : public ::testing::TestWithParam<ElementType> {};

TEST_P(ThickWalls, converge_to_lame) {
  const ElementType type = GetParam();
  const bool quadratic = is_quadratic(type);
  const double sphere_fine = type == ElementType::tri6 ? 8e-3 : 4e-3;
  const Walls walls[] = {{"sphere", sphere_error, 2, {0.15, 0.045}, {0.045, sphere_fine}},
                         {"cylinder", cylinder_error, 1, {0.065, 0.015}, {4e-3, 6e-4}}};
  for (const Walls& w : walls) {
    const std::string what = surfaces::name_of(type) + " thick " + w.name;
    const int coarse = quadratic ? w.coarse : 2 * w.coarse;
    const double e1 = w.error(type, coarse, 0.3), e2 = w.error(type, 2 * coarse, 0.3);
    expect_error(what + ", coarse", e1, quadratic ? w.quadratic_bound[0] : w.linear_bound[0]);
    expect_error(what + ", fine", e2, quadratic ? w.quadratic_bound[1] : w.linear_bound[1]);
    expect_order(what, observed_order(e1, e2, 2, 1), quadratic ? 2.2 : 1.7);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, ThickWalls, ::testing::ValuesIn(surfaces::all_types),
                         [](const auto& param) { return surfaces::name_of(param.param); });

TEST(ThickWallsMaterials, from_cork_to_incompressible) {
  for (const double poisson : {0.0, 0.49, 0.4999, 0.5})
    expect_error("tri6 thick cylinder, nu " + std::to_string(poisson),
                 cylinder_error(ElementType::tri6, 2, poisson), 8e-4);
}

// With tractions given on a cavity's surface the equation loses its hold on the cavity's volume as
// nu -> 0.5: the single layer of a normal traction vanishes, errors grow like 1 / (1 - 2 nu).
TEST(ThickWallsMaterials, a_pressed_cavity_needs_compressible_material) {
  expect_error("quad8 thick sphere, nu 0", sphere_error(ElementType::quad8, 4, 0), 4e-3);
  expect_error("quad8 thick sphere, nu 0.45", sphere_error(ElementType::quad8, 4, 0.45), 1e-2);
  try {
    sphere_error(ElementType::quad8, 4, 0.491);
    ADD_FAILURE() << "a nearly incompressible body with a free cavity was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_unsupported);
    EXPECT_NE(std::string(error.what()).find("cavity of element 96"), std::string::npos)
        << error.what();
  }
  // Held, it is no trouble.
  const auto exact = [](const Vec3& x) { return (1 / std::pow(length(x), 3)) * x; };
  StaticBody body(surfaces::with_cavity(surfaces::cube_sphere(ElementType::quad8, 4, outer, 1),
                                        surfaces::cube_sphere(ElementType::quad8, 4, inner, 2)),
                  young, 0.5);
  body.hold_tags({2}, 7, exact);
  EXPECT_NO_THROW(body.solve());
}

}  // namespace
}  // namespace rollcon
