// Tests statistics of the laws at an unfinished iterate: they are large, and the same in all units.

#include "contact/scene_fixture.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr std::array<const char*, 4> laws{"law_normal", "law_friction", "law_slip", "law_equilibrium"};

/// Returns the laws after `iterations` of a scene whose stresses and lengths are multiplied.
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

std::vector<double> field(const Pair& pair, Field which) {
  std::vector<double> v(static_cast<std::size_t>(pair.contact->field(which, InAxes::local, 0, nullptr)));
  pair.contact->field(which, InAxes::local, static_cast<std::int64_t>(v.size()), v.data());
  return v;
}

// Slip counts against the greatest slip velocity, because friction is little. Where nodes slide, the part of it that is
// across their traction or along it counts; elsewhere all of it.
TEST(law_statistics, slip_of_unfinished_iterates_is_that_of_the_fields) {
  double worst = 0;
  for (const std::int64_t iterations : {2, 3}) {
    Pair pair(1e4, 0.3, 2e4, 0.1);
    standard_scene(pair, 10);
    pair.friction(0.05);
    Scene& s = pair.contact->scene;
    s.set_creep(-2e-2, 8e-3, 3e-2);
    s.options.set_text("convection", "least_squares");
    s.options.set_int("max_iterations", iterations);
    pair.contact->solve();
    const std::vector<double> t = pair.tractions(), slip = field(pair, Field::slip),
                              rigid = field(pair, Field::rigid_slip);
    std::vector<std::int32_t> status(t.size() / 3);
    pair.contact->node_status(pair.contact->nodes(), status.data());
    double fastest = 0, across = 0, along = 0, sticking = 0;
    for (std::size_t k = 0; k < status.size(); ++k) {
      if (!(t[3 * k + 2] < 0)) continue;
      const double *v = &slip[2 * k], *c = &rigid[2 * k], length = std::hypot(t[3 * k], t[3 * k + 1]);
      fastest = std::max({fastest, std::hypot(c[0], c[1]), std::hypot(v[0] - c[0], v[1] - c[1])});
      if (status[k] != static_cast<std::int32_t>(NodeStatus::slip)) {
        sticking = std::max(sticking, std::hypot(v[0], v[1]));
      } else if (length > 0) {
        across = std::max(across, std::abs(v[0] * t[3 * k + 1] - v[1] * t[3 * k]) / length);
        along = std::max(along, (v[0] * t[3 * k] + v[1] * t[3 * k + 1]) / length);
      }
    }
    const double expected = std::max({across, along, sticking}) / fastest, told = pair.contact->stat("law_slip");
    std::printf("after %lld iterations: across %.2e, along %.2e, sticking %.2e; law_slip %.6e (%.6e)\n",
                static_cast<long long>(iterations), across / fastest, along / fastest, sticking / fastest, told,
                expected);
    EXPECT_NEAR(told, expected, 1e-9);
    worst = std::max(worst, expected);
  }
  EXPECT_GT(worst, 1e-3);
}

}  // namespace
}  // namespace rollcon
