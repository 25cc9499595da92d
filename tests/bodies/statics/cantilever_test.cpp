// Tests a cantilever with an end load, of boundary and of finite elements.

#include "support/static_cases.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;

namespace beam = statics::beam;

StaticBody body(AnyElement type, double span, int along, int across, double poisson) {
  return {beam::shape(span, along, across), type, beam::young, poisson};
}

double exact_beam_error(AnyElement type, int across) {
  StaticBody cantilever = body(type, beam::span, 4 * across, across, 0);
  return beam::error(cantilever);
}

class Cantilever : public ::testing::TestWithParam<AnyElement> {
 protected:
  void SetUp() override {
    if (absent(GetParam())) GTEST_SKIP() << "not in this build";
  }
};

/// Holds the elements across the coarse mesh, bounds of the errors of it and of the one twice as fine, and their order.
struct Bounds {
  int coarse;
  double first, second, order;
};

TEST_P(Cantilever, converges_to_the_exact_bending_with_shear) {
  const AnyElement type = GetParam();
  const Bounds boundary[] = {{2, 0.45, 0.11, 1.8}, {1, 0.03, 0.002, 2.2}},
               finite[] = {{4, 0.35, 0.1, 1.7}, {1, 0.015, 1.5e-3, 2.5}};
  const Bounds& bound = (is_finite_element(type) ? finite : boundary)[is_quadratic_element(type)];
  const double e1 = exact_beam_error(type, bound.coarse), e2 = exact_beam_error(type, 2 * bound.coarse);
  const std::string what = name_of(type) + " cantilever";
  expect_error(what + ", coarse", e1, bound.first);
  expect_error(what + ", fine", e2, bound.second);
  expect_order(what, observed_order(e1, e2, 2, 1), bound.order);
}

// Boundary elements are judged by the pull's reaction: that of the bent beam's shear force drowns in the errors of its
// bending stresses, fifty times larger.
TEST_P(Cantilever, its_root_carries_the_load) {
  const AnyElement type = GetParam();
  const bool finite = is_finite_element(type);
  StaticBody bent = body(type, beam::span, 6, 2, 0.3);
  const Vec3 t = finite ? Vec3{0.5, -0.2, 1} : Vec3{1, 0, 0};
  const Vec3 force = beam::width * beam::height * t, at{beam::span, 0, 0};
  bent.hold_tags({1}).traction(2, t).solve();
  const Resultant reaction = finite ? bent.reaction() : bent.resultant({1});
  expect_error(name_of(type) + " cantilever, force at the root", length(reaction.force + force) / length(force),
               finite                       ? 1e-10
               : is_quadratic_element(type) ? 6e-3
                                            : 2e-2);
  if (finite)
    expect_error(name_of(type) + " cantilever, moment at the root",
                 length(reaction.moment + cross(at, force)) / length(cross(at, force)), 1e-10);
}

constexpr auto element_name = [](const auto& param) { return name_of(param.param); };
INSTANTIATE_TEST_SUITE_P(Bodies, Cantilever,
                         ::testing::Values(ElementType::tri6, ElementType::quad4, VolumeType::hex8, VolumeType::tet10),
                         element_name);
INSTANTIATE_TEST_SUITE_P(Bodies_long, Cantilever,
                         ::testing::Values(ElementType::tri3, ElementType::quad8, ElementType::quad9, VolumeType::tet4,
                                           VolumeType::wedge6, VolumeType::wedge15, VolumeType::hex20),
                         element_name);

// Clamped flat, with uniform end traction and nu = 0.3, it is Timoshenko's beam except at the root, whose clamped
// section cannot contract or warp (0.9 % stiffer at 8 heights, 0.4 % at 20), and at the end, where shear is uniform.
TEST(CantileverTheory, sinks_as_a_timoshenko_beam) {
  constexpr double poisson = 0.3;
  for (const AnyElement type :
       {AnyElement(ElementType::tri6), AnyElement(ElementType::quad8), AnyElement(ElementType::quad9),
        AnyElement(VolumeType::hex20), AnyElement(VolumeType::wedge15), AnyElement(VolumeType::tet10)}) {
    if (absent(type)) continue;
    const int slender = is_finite_element(type) ? 20 : 8;
    StaticBody bent = body(type, slender, slender, 2, poisson);
    bent.hold_tags({1}).traction(2, {0, 0, beam::force / (beam::width * beam::height)}).solve();
    expect_error(name_of(type) + " cantilever against Timoshenko",
                 relative(bent.displacement(Vec3{1.0 * slender, 0, 0})[2], beam::timoshenko(slender, poisson)),
                 is_finite_element(type) ? 1e-2 : 5e-3);
  }
}

}  // namespace
}  // namespace rollcon
