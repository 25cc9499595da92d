// Statistics of the laws at an unfinished iterate: large, and the same in all units.

#include "contact/scene_fixture.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr std::array<const char*, 4> laws{"law_normal", "law_friction", "law_slip", "law_equilibrium"};

/// The laws after `iterations` of a scene whose stresses and lengths are multiplied.
std::array<double, 4> unfinished(double stress, double length, std::int64_t iterations) {
  Pair pair(1e4 * stress, 0.3, 2e4 * stress, 0.1);
  const std::vector<double> lines = frames::uniform_lines(-1.3 * length, 1.3 * length, 10);
  pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
  Scene& s = pair.contact->scene;
  std::vector<double> gap;  // bumpy: the first active nodes are the wrong ones
  for (const Vec3& node : s.mesh().node) {
    const double x = node[0] / length, y = node[1] / length;
    gap.push_back(length * (0.01 * (x * x + y * y) + 0.008 * std::cos(9 * x) * std::cos(7 * y)));
  }
  s.set_gap(pair.contact->nodes(), gap.data());
  pair.friction(0.3);
  s.prescribe(3, 1, 0.02 * length);
  s.set_creep(-1e-3, 4e-4, 5e-4 / length);
  s.prescribe(1, 2, 20 * stress * length * length);
  s.options.set_int("max_iterations", iterations);
  pair.contact->solve();
  std::array<double, 4> found{};
  for (std::size_t k = 0; k < laws.size(); ++k) found[k] = pair.contact->stat(laws[k]);
  return found;
}

TEST(law_statistics, of_unfinished_iterates_do_not_depend_on_units) {
  for (const std::int64_t iterations : {1, 2, 3}) {
    const auto reference = unfinished(1, 1, iterations);
    double error = 0;
    for (const double stress : {1e-6, 1e9})
      for (const double length : {1e-4, 1e3}) {
        const auto found = unfinished(stress, length, iterations);
        for (std::size_t k = 0; k < laws.size(); ++k)
          error = std::max(error, std::abs(found[k] - reference[k]) / (reference[k] + 1e-9));
      }
    std::printf(
        "after %lld iterations: normal %.1e, friction %.1e, slip %.1e, equilibrium %.1e; in other units off by %.1e "
        "(bound 1e-6)\n",
        static_cast<long long>(iterations), reference[0], reference[1], reference[2], reference[3], error);
    EXPECT_LE(error, 1e-6);
    EXPECT_GT(*std::max_element(reference.begin(), reference.end()), 1e-4);
  }
}

}  // namespace
}  // namespace rollcon
