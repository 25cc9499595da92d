// Sweeps the selector of rules over distance, direction, aspect ratio and distortion, and compares each integral with
// adaptive brute force.

#include "bodies/halfspace/brute_force.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using brute_force::Element;

/// Returns the reference element stretched to aspect : 1, its nodes moved at random by up to `distortion` of the
/// distance between nodes, turned by an odd angle.
Element distorted(ElementType type, double aspect, double distortion, std::uint32_t seed) {
  static constexpr double square_x[9] = {-1, 1, 1, -1, 0, 1, 0, -1, 0};
  static constexpr double square_y[9] = {-1, -1, 1, 1, -1, 0, 1, 0, 0};
  static constexpr double triangle_x[6] = {-1, 1, 0, 0, 0.5, -0.5};
  static constexpr double triangle_y[6] = {-0.6, -0.6, 1.1, -0.6, 0.25, 0.25};
  const bool triangle = corner_count(type) == 3;
  frames::Random random(seed);
  Element e{type, {}, {}};
  for (int i = 0; i < node_count(type); ++i) {
    const double size = is_quadratic(type) ? 1 : 2;
    const double x = (triangle ? triangle_x[i] : square_x[i]) + distortion * size * random();
    const double y = ((triangle ? triangle_y[i] : square_y[i]) + distortion * size * random()) / aspect;
    e.x.push_back(0.8 * x - 0.6 * y);
    e.y.push_back(0.6 * x + 0.8 * y);
  }
  return e;
}

class RuleSelection : public ::testing::TestWithParam<ElementType> {};

TEST_P(RuleSelection, sweep_of_distance_aspect_and_distortion) {
  const double angle[] = {0.3, 2.2, 3.8};
  const double distance[] = {0.7, 1.02, 1.2, 1.5, 2, 3.5, 8, 25, 200};
  double worst[2] = {0, 0};
  std::uint32_t seed = 1;
  for (const double aspect : {1.0, 4.0, 100.0})
    for (const double distortion : {0.0, 0.05, 0.12}) {
      if (aspect > 10 && distortion > 0.1) continue;  // this would fold
      const Element element = distorted(GetParam(), aspect, distortion, ++seed);
      for (const double d : distance)
        for (const double a : angle) {
          // The observer is on an ellipse around the element; d < 1 may be inside, where other tests look.
          const double u = d * 1.5 * std::cos(a), v = d * 1.5 * std::sin(a) * (d < 3 ? 1 / aspect : 1);
          const double px = 0.8 * u - 0.6 * v, py = 0.6 * u + 0.8 * v;
          const auto reference = brute_force::integrate(element, px, py);
          const double tolerance[] = {1e-6, 1e-9};
          for (std::size_t k = 0; k < 2; ++k)
            worst[k] = std::max(worst[k], brute_force::relative_error(
                                              brute_force::from_library(element, px, py, tolerance[k]), reference));
        }
    }
  std::printf("%d nodes: largest error %.1e (bound 1e-6), %.1e (bound 1e-9)\n", node_count(GetParam()), worst[0],
              worst[1]);
  EXPECT_LE(worst[0], 1e-6);
  EXPECT_LE(worst[1], 1e-9);
}

INSTANTIATE_TEST_SUITE_P(types, RuleSelection, ::testing::Values(ElementType::tri6, ElementType::quad4),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });
INSTANTIATE_TEST_SUITE_P(types_long, RuleSelection,
                         ::testing::Values(ElementType::tri3, ElementType::quad8, ElementType::quad9),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });

}  // namespace
}  // namespace rollcon
