// Lame's thick sphere and thick cylinder of finite elements under pressure from inside: error, observed order, and no
// locking as nu tends to 1/2.

#include <gtest/gtest.h>

#include <string>

#include "support/error.hpp"
#include "support/static_cases.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

namespace walls = statics::walls;
using statics::StaticBody;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;

double sphere_error(VolumeType type, int n, double poisson) {
  StaticBody body(volumes::block(walls::part_of_sphere(n), type), walls::young, poisson);
  walls::press_sphere(body, poisson);
  return body.solve().displacement_error([poisson](const Vec3& x) { return walls::sphere_displacement(x, poisson); });
}

double cylinder_error(VolumeType type, int n, double poisson) {
  StaticBody body(volumes::block(walls::quarter_cylinder(n), type), walls::young, poisson);
  walls::press_cylinder(body);
  return body.solve().displacement_error([poisson](const Vec3& x) { return walls::cylinder_displacement(x, poisson); });
}

struct Walls {
  const char* name;
  double (*error)(VolumeType, int, double);
};
constexpr Walls walls_of_both_kinds[] = {{"sphere", sphere_error}, {"cylinder", cylinder_error}};

/// Bounds of the error of the coarse mesh and of the one twice as fine, and of the order; n: parts of the coarse mesh
/// through the wall. Six slender tetrahedra fill what is one hexahedron.
struct Quality {
  VolumeType type;
  int n;
  double coarse, fine, order;
};

class FemThickWalls : public ::testing::TestWithParam<Quality> {};

TEST_P(FemThickWalls, converge_to_lame) {
  const Quality& q = GetParam();
  for (const Walls& w : walls_of_both_kinds) {
    const std::string what = volumes::name_of(q.type) + " thick " + w.name;
    const double e1 = w.error(q.type, q.n, 0.3), e2 = w.error(q.type, 2 * q.n, 0.3);
    expect_error(what + ", coarse", e1, q.coarse);
    expect_error(what + ", fine", e2, q.fine);
    expect_order(what, observed_order(e1, e2, 2, 1), q.order);
  }
}

// Errors are of the size that they have at 0.3 and fall as the mesh is refined.
TEST_P(FemThickWalls, do_not_lock) {
  const Quality& q = GetParam();
  if (q.type == VolumeType::tet4 || q.type == VolumeType::wedge6) GTEST_SKIP() << "refused there";
  for (const Walls& w : walls_of_both_kinds) {
    const double usual = w.error(q.type, q.n, 0.3);
    for (const double poisson : {0.0, 0.49, 0.499, 0.4999})
      expect_error(volumes::name_of(q.type) + " thick " + w.name + ", nu " + std::to_string(poisson) +
                       ": error over that at 0.3",
                   w.error(q.type, q.n, poisson) / usual, 2);
    const double e1 = w.error(q.type, q.n, 0.4999), e2 = w.error(q.type, 2 * q.n, 0.4999);
    expect_order(volumes::name_of(q.type) + " thick " + w.name + ", nu 0.4999", observed_order(e1, e2, 2, 1),
                 is_quadratic(q.type) ? 2 : 1.7);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, FemThickWalls,
                         ::testing::Values(Quality{VolumeType::hex8, 4, 0.03, 0.01, 1.8},
                                           Quality{VolumeType::tet10, 2, 0.05, 0.01, 2.2}),
                         [](const auto& param) { return volumes::name_of(param.param.type); });
INSTANTIATE_TEST_SUITE_P(Bodies_long, FemThickWalls,
                         ::testing::Values(Quality{VolumeType::hex20, 2, 2e-3, 2e-4, 3.3},
                                           Quality{VolumeType::wedge6, 4, 0.06, 0.02, 1.8},
                                           Quality{VolumeType::wedge15, 2, 4e-3, 3e-4, 3.3},
                                           Quality{VolumeType::tet4, 4, 0.25, 0.1, 1.3}),
                         [](const auto& param) { return volumes::name_of(param.param.type); });

TEST(FemLimits, tet4_near_incompressibility_is_refused_and_the_better_element_named) {
  for (const double poisson : {0.499, 0.4999, 0.5}) try {
      cylinder_error(VolumeType::tet4, 2, poisson);
      ADD_FAILURE() << "tet4 with nu " << poisson << " was taken";
    } catch (const Error& error) {
      std::printf("%s\n", error.what());
      EXPECT_EQ(error.status(), Status::err_unsupported);
      EXPECT_NE(std::string(error.what()).find("tet10"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace rollcon
