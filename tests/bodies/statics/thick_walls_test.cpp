// Tests Lame's thick sphere and thick cylinder under pressure from inside, of boundary and of finite elements: error,
// observed order, and what happens as nu tends to 1/2.

#include "support/error.hpp"
#include "support/static_cases.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;

namespace walls = statics::walls;

StaticBody hollow_sphere(ElementType type, int n, double poisson) {
  return {surfaces::with_cavity(surfaces::cube_sphere(type, n, walls::outer, 1),
                                surfaces::cube_sphere(type, n, walls::inner, 2)),
          walls::young, poisson};
}

/// Returns the sphere's error: boundary elements mesh the whole of it, finite ones a part between planes and a cone.
double sphere_error(AnyElement type, int n, double poisson) {
  const auto exact = [poisson](const Vec3& x) { return walls::sphere_displacement(x, poisson); };
  if (is_finite_element(type)) {
    StaticBody body(walls::part_of_sphere(n), type, walls::young, poisson);
    walls::press_sphere(body, poisson);
    return body.solve().displacement_error(exact);
  }
  StaticBody body = hollow_sphere(std::get<ElementType>(type), n, poisson);
  return body.pressure(2, walls::pressure).hold_statically(exact).solve().displacement_error(exact);
}

double cylinder_error(AnyElement type, int n, double poisson) {
  StaticBody body(walls::quarter_cylinder(n), type, walls::young, poisson);
  walls::press_cylinder(body);
  return body.solve().displacement_error([poisson](const Vec3& x) { return walls::cylinder_displacement(x, poisson); });
}

/// Holds as n the parts of the coarse mesh through the wall, and bounds of its error, of that of the mesh twice as
/// fine, and of the order.
struct Bounds {
  int n;
  double coarse, fine, order;
};
/// Six slender tetrahedra fill what is one hexahedron.
struct Quality {
  AnyElement type;
  Bounds sphere, cylinder;
  Quality(AnyElement element, const Bounds& s, const Bounds& c) : type(element), sphere(s), cylinder(c) {}
  Quality(AnyElement element, const Bounds& both) : Quality(element, both, both) {}
};

class ThickWalls : public ::testing::TestWithParam<Quality> {
 protected:
  void SetUp() override {
    if (absent(GetParam().type)) GTEST_SKIP() << "not in this build";
  }
  template <class Check>
  void for_both(Check&& check) const {
    check(name_of(GetParam().type) + " thick sphere", sphere_error, GetParam().sphere);
    check(name_of(GetParam().type) + " thick cylinder", cylinder_error, GetParam().cylinder);
  }
};

class NearlyIncompressibleWalls : public ThickWalls {};

TEST_P(ThickWalls, converge_to_lame) {
  for_both([](const std::string& what, auto error, const Bounds& bound) {
    const double e1 = error(GetParam().type, bound.n, 0.3), e2 = error(GetParam().type, 2 * bound.n, 0.3);
    expect_error(what + ", coarse", e1, bound.coarse);
    expect_error(what + ", fine", e2, bound.fine);
    expect_order(what, observed_order(e1, e2, 2, 1), bound.order);
  });
}

// Errors have the size that they have at 0.3, and fall as the mesh is refined.
TEST_P(NearlyIncompressibleWalls, do_not_lock) {
  const AnyElement type = GetParam().type;
  for_both([type](const std::string& what, auto error, const Bounds& bound) {
    const double usual = error(type, bound.n, 0.3);
    for (const double poisson : {0.0, 0.49, 0.499, 0.4999})
      expect_error(what + ", nu " + std::to_string(poisson) + ": error over that at 0.3",
                   error(type, bound.n, poisson) / usual, 2);
    const double e1 = error(type, bound.n, 0.4999), e2 = error(type, 2 * bound.n, 0.4999);
    expect_order(what + ", nu 0.4999", observed_order(e1, e2, 2, 1), is_quadratic_element(type) ? 2 : 1.7);
  });
}

// Linear boundary elements on so coarse a sphere are better by chance.
constexpr Bounds linear_sphere{4, 0.02, 0.0085, 0.9}, linear_cylinder{2, 0.065, 0.015, 1.7},
    quadratic_sphere{2, 0.045, 4e-3, 2.2}, tri6_sphere{2, 0.045, 8e-3, 2.2}, quadratic_cylinder{1, 4e-3, 6e-4, 2.2};
constexpr auto element_name = [](const auto& param) { return name_of(param.param.type); };
const Quality hex8{VolumeType::hex8, {4, 0.03, 0.01, 1.8}}, tet10{VolumeType::tet10, {2, 0.05, 0.01, 2.2}},
    hex20{VolumeType::hex20, {2, 2e-3, 2e-4, 3.3}}, wedge15{VolumeType::wedge15, {2, 4e-3, 3e-4, 3.3}};
INSTANTIATE_TEST_SUITE_P(Bodies, ThickWalls,
                         ::testing::Values(Quality{ElementType::tri6, tri6_sphere, quadratic_cylinder}, hex8, tet10),
                         element_name);
INSTANTIATE_TEST_SUITE_P(Bodies_long, ThickWalls,
                         ::testing::Values(Quality{ElementType::tri3, linear_sphere, linear_cylinder},
                                           Quality{ElementType::quad4, linear_sphere, linear_cylinder},
                                           Quality{ElementType::quad8, quadratic_sphere, quadratic_cylinder},
                                           Quality{ElementType::quad9, quadratic_sphere, quadratic_cylinder}, hex20,
                                           wedge15, Quality{VolumeType::wedge6, {4, 0.06, 0.02, 1.8}},
                                           Quality{VolumeType::tet4, {4, 0.25, 0.1, 1.3}}),
                         element_name);
INSTANTIATE_TEST_SUITE_P(Bodies, NearlyIncompressibleWalls, ::testing::Values(hex8, tet10), element_name);
INSTANTIATE_TEST_SUITE_P(Bodies_long, NearlyIncompressibleWalls, ::testing::Values(hex20, wedge15), element_name);

void expect_refused(const std::string& words, double (*error)(AnyElement, int, double), AnyElement type, int n,
                    double poisson) {
  try {
    error(type, n, poisson);
    ADD_FAILURE() << name_of(type) << " with nu " << poisson << " was taken";
  } catch (const Error& refusal) {
    EXPECT_EQ(refusal.status(), Status::err_unsupported);
    EXPECT_NE(std::string(refusal.what()).find(words), std::string::npos) << refusal.what();
  }
}

TEST(ThickWallsMaterials, from_cork_to_incompressible) {
  if (absent(ElementType::tri6)) GTEST_SKIP() << "not in this build";
  for (const double poisson : {0.0, 0.49, 0.4999, 0.5})
    expect_error("tri6 thick cylinder, nu " + std::to_string(poisson), cylinder_error(ElementType::tri6, 2, poisson),
                 8e-4);
}

// The equation loses its hold on a cavity's volume as nu -> 0.5 if tractions are given on its surface: the single layer
// of a normal traction vanishes, errors grow like 1 / (1 - 2 nu).
TEST(ThickWallsMaterials, a_pressed_cavity_needs_compressible_material) {
  if (absent(ElementType::quad8)) GTEST_SKIP() << "not in this build";
  expect_error("quad8 thick sphere, nu 0", sphere_error(ElementType::quad8, 4, 0), 4e-3);
  expect_error("quad8 thick sphere, nu 0.45", sphere_error(ElementType::quad8, 4, 0.45), 1e-2);
  expect_refused("cavity of element 96", sphere_error, ElementType::quad8, 4, 0.491);
  // A held cavity is no trouble.
  StaticBody body = hollow_sphere(ElementType::quad8, 4, 0.5);
  body.hold_tags({2}, 7, [](const Vec3& x) { return (1 / std::pow(length(x), 3)) * x; });
  EXPECT_NO_THROW(body.solve());
}

TEST(ThickWallsMaterials, an_incompressible_body_needs_a_free_face) {
  if (absent(ElementType::quad8)) GTEST_SKIP() << "not in this build";
  const auto held_everywhere = [](AnyElement type, int n, double poisson) {
    StaticBody body = hollow_sphere(std::get<ElementType>(type), n, poisson);
    const auto bent = [](const Vec3& x) { return Vec3{x[1], 0, x[0] * x[1]}; };
    return body.hold_tags({1, 2}, 7, bent).solve().displacement_error(bent);
  };
  EXPECT_EQ(held_everywhere(ElementType::quad8, 1, 0.4999), 0);
  expect_refused("every node of the body is held", held_everywhere, ElementType::quad8, 1, 0.5);
}

TEST(ThickWallsMaterials, tet4_near_incompressibility_is_refused_and_the_better_element_named) {
  if (absent(VolumeType::tet4)) GTEST_SKIP() << "not in this build";
  for (const double poisson : {0.499, 0.5}) expect_refused("tet10", cylinder_error, VolumeType::tet4, 2, poisson);
}

}  // namespace
}  // namespace rollcon
