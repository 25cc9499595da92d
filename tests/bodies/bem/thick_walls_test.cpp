// Lame's thick sphere and thick cylinder under pressure from inside: error and observed order.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/error.hpp"
#include "support/static_cases.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;

namespace walls = statics::walls;

double sphere_error(ElementType type, int n, double poisson) {
  const auto exact = [poisson](const Vec3& x) { return walls::sphere_displacement(x, poisson); };
  StaticBody body(surfaces::with_cavity(surfaces::cube_sphere(type, n, walls::outer, 1),
                                        surfaces::cube_sphere(type, n, walls::inner, 2)),
                  walls::young, poisson);
  body.pressure(2, walls::pressure).hold_statically(exact).solve();
  return body.displacement_error(exact);
}

double cylinder_error(ElementType type, int n, double poisson) {
  StaticBody body(surfaces::block(walls::quarter_cylinder(n), type), walls::young, poisson);
  walls::press_cylinder(body);
  body.solve();
  return body.displacement_error([poisson](const Vec3& x) { return walls::cylinder_displacement(x, poisson); });
}

struct Walls {
  const char* name;
  double (*error)(ElementType, int, double);
  int coarse;
  double linear_bound[2], quadratic_bound[2];  ///< coarse, fine
  double linear_order;
};

class ThickWalls : public ::testing::TestWithParam<ElementType> {};

TEST_P(ThickWalls, converge_to_lame) {
  const ElementType type = GetParam();
  const bool quadratic = is_quadratic(type);
  const double sphere_fine = type == ElementType::tri6 ? 8e-3 : 4e-3;
  const Walls cases[] = {// Linear elements on so coarse a sphere are better by chance.
                         {"sphere", sphere_error, 2, {0.02, 0.0085}, {0.045, sphere_fine}, 0.9},
                         {"cylinder", cylinder_error, 1, {0.065, 0.015}, {4e-3, 6e-4}, 1.7}};
  for (const Walls& w : cases) {
    const std::string what = surfaces::name_of(type) + " thick " + w.name;
    const int coarse = quadratic ? w.coarse : 2 * w.coarse;
    const double e1 = w.error(type, coarse, 0.3), e2 = w.error(type, 2 * coarse, 0.3);
    expect_error(what + ", coarse", e1, quadratic ? w.quadratic_bound[0] : w.linear_bound[0]);
    expect_error(what + ", fine", e2, quadratic ? w.quadratic_bound[1] : w.linear_bound[1]);
    expect_order(what, observed_order(e1, e2, 2, 1), quadratic ? 2.2 : w.linear_order);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, ThickWalls, ::testing::Values(ElementType::tri6, ElementType::quad4),
                         [](const auto& param) { return surfaces::name_of(param.param); });
INSTANTIATE_TEST_SUITE_P(Bodies_long, ThickWalls,
                         ::testing::Values(ElementType::tri3, ElementType::quad8, ElementType::quad9),
                         [](const auto& param) { return surfaces::name_of(param.param); });

TEST(ThickWallsMaterials, from_cork_to_incompressible) {
  for (const double poisson : {0.0, 0.49, 0.4999, 0.5})
    expect_error("tri6 thick cylinder, nu " + std::to_string(poisson), cylinder_error(ElementType::tri6, 2, poisson),
                 8e-4);
}

// With tractions given on a cavity's surface the equation loses its hold on the cavity's volume as nu -> 0.5: the
// single layer of a normal traction vanishes, errors grow like 1 / (1 - 2 nu).
TEST(ThickWallsMaterials, a_pressed_cavity_needs_compressible_material) {
  expect_error("quad8 thick sphere, nu 0", sphere_error(ElementType::quad8, 4, 0), 4e-3);
  expect_error("quad8 thick sphere, nu 0.45", sphere_error(ElementType::quad8, 4, 0.45), 1e-2);
  try {
    sphere_error(ElementType::quad8, 4, 0.491);
    ADD_FAILURE() << "a nearly incompressible body with a free cavity was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_unsupported);
    EXPECT_NE(std::string(error.what()).find("cavity of element 96"), std::string::npos) << error.what();
  }
  // Held, it is no trouble.
  const auto exact = [](const Vec3& x) { return (1 / std::pow(length(x), 3)) * x; };
  StaticBody body(surfaces::with_cavity(surfaces::cube_sphere(ElementType::quad8, 4, walls::outer, 1),
                                        surfaces::cube_sphere(ElementType::quad8, 4, walls::inner, 2)),
                  walls::young, 0.5);
  body.hold_tags({2}, 7, exact);
  EXPECT_NO_THROW(body.solve());
}

}  // namespace
}  // namespace rollcon
