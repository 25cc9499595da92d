// Tests that the far field's rules, chosen from the distance of a whole pack alone, cost little more than those chosen
// for each point with all that is known of the element.

#include "bodies/bem/integrals/element_reference.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double not_wanted = 1e300, poisson = 0.3;

class FarRules : public ::testing::TestWithParam<ElementType> {};

TEST_P(FarRules, take_few_points_more_than_those_of_a_single_point) {
  for (const int terms : {bem::double_layer, bem::single_layer}) {
    const bool single = terms == bem::single_layer;
    std::int64_t far = 0, pointwise = 0, cases = 0, left = 0;
    for (const double aspect : {1.0, 3.0})
      for (const double curvature : {0.0, is_quadratic(GetParam()) ? 0.15 : 0.0}) {
        const SurfaceMesh element = element_reference::one_element(GetParam(), aspect, 0.05, curvature, 11);
        for (const double distance : {6.0, 10.0, 20.0, 50.0, 200.0})
          for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
            const Vec3 x = element.node[0] + distance * Vec3{0.36, 0.48, 0.8};
            const auto found = element_reference::from_far_field(element, x, poisson, terms, tolerance);
            const auto best = element_reference::from_library(element, x, poisson, single ? not_wanted : tolerance,
                                                              single ? tolerance : not_wanted);
            if (found.points == 0) {
              ++left;
              continue;
            }
            ++cases;
            far += found.points;
            pointwise += best.points;
          }
      }
    std::printf(
        "%d nodes, layer %d: %.1f points, %.1f chosen point by point (bound: 1.7 times as many), %lld of %lld left to "
        "the near field (bound: 1 in 10)\n",
        node_count(GetParam()), terms, static_cast<double>(far) / static_cast<double>(cases),
        static_cast<double>(pointwise) / static_cast<double>(cases), static_cast<long long>(left),
        static_cast<long long>(left + cases));
    EXPECT_LE(static_cast<double>(far), 1.7 * static_cast<double>(pointwise));
    EXPECT_LE(10 * left, left + cases);
  }
}

INSTANTIATE_TEST_SUITE_P(types, FarRules,
                         ::testing::Values(ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                           ElementType::quad9),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });

}  // namespace
}  // namespace rollcon
