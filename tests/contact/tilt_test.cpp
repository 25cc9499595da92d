/// Tests that tilts of body 1, given or found for moments, follow closed forms of paraboloids and of a flat punch, are
/// reciprocal, and come out alike by all ways to solve.

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/scene_fixture.hpp"
#include "contact/solution.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr std::int32_t normal = 3, first = 6, second = 7, by_motion = 1, by_force = 2;
constexpr double half_width = 2.2, curvature[] = {0.02, 0.01};

struct Found {
  double approach = 0;
  std::array<double, 2> tilt{};
  Vec3 force{}, moment{};
};

Found solve(Pair& pair) {
  const Status status = pair.contact->solve();
  EXPECT_EQ(status, Status::ok);
  Found f;
  pair.contact->motion(&f.approach, nullptr, f.tilt.data());
  pair.contact->resultant(InAxes::local, f.force.data(), f.moment.data());
  return f;
}

/// Presses paraboloids together by a load.
void scene(Pair& pair, ElementType type, int n, double load) {
  const std::vector<double> lines = frames::uniform_lines(-half_width, half_width, n);
  pair.frame(frames::rectangle(type, lines, lines));
  pair.contact->scene.set_gap_quadratic(curvature[0] / 2, curvature[1] / 2, 0);
  pair.friction(0.3);
  pair.contact->scene.prescribe(normal, by_force, load);
}

/// Asks for the moments of a load that acts at (x, y).
void press_at(Pair& pair, double load, double x, double y) {
  pair.contact->scene.prescribe(first, by_force, -load * y);
  pair.contact->scene.prescribe(second, by_force, load * x);
}

Pair steel() {
  return {2.1e5, 0.28, 2.1e5, 0.28};
}
Pair unlike() {
  return {2.1e5, 0.28, 7e4, 0.1};
}

// A paraboloid that is tilted by the slope of the gap at (x, y) touches there the way it does at the origin.
TEST(tilt, carries_a_contact_of_paraboloids_along_the_surface) {
  constexpr double load = 800, x = 0.33, y = -0.47;
  const double expected[] = {curvature[1] * y, -curvature[0] * x};
  const double lost = (curvature[0] * x * x + curvature[1] * y * y) / 2;
  for (const ElementType type : {ElementType::quad4, ElementType::tri3, ElementType::quad8}) {
    double error[2];
    for (int i = 0; i < 2; ++i) {
      const int n = (type == ElementType::quad4 ? 22 : 18) << i;
      Pair straight = steel(), tilted = steel();
      scene(straight, type, n, load);
      scene(tilted, type, n, load);
      press_at(tilted, load, x, y);
      const Found from = solve(straight), to = solve(tilted);
      error[i] = std::hypot(to.tilt[0] - expected[0], to.tilt[1] - expected[1]) / std::hypot(expected[0], expected[1]);
      const double approach = std::abs(from.approach - lost - to.approach) / from.approach;
      const double moment = std::hypot(to.moment[0] + load * y, to.moment[1] - load * x) / load;
      std::printf(
          "type %d, %d elements a side: tilts off by %.1e, approach by %.1e (bound 1e-2), moments by %.1e "
          "(bound 1e-9)\n",
          static_cast<int>(type), n, error[i], approach, moment);
      EXPECT_LT(approach, 1e-2);
      EXPECT_LT(moment, 1e-9);
    }
    std::printf("type %d: %.1e with twice as many elements (bound 1e-2)\n", static_cast<int>(type), error[1]);
    EXPECT_LT(error[1], 1e-2);
  }
}

TEST(tilt, given_as_found_gives_the_moments_back) {
  constexpr double load = 800;
  for (const bool friction : {false, true}) {
    Pair pair = unlike();
    scene(pair, ElementType::quad4, 24, load);
    if (friction) pair.contact->scene.set_creep(1e-3, 5e-4, 1e-3);
    if (!friction) pair.friction(0);
    press_at(pair, load, -0.2, 0.4);
    const Found found = solve(pair);
    for (const int t : {0, 1})
      pair.contact->scene.prescribe(first + t, by_motion, found.tilt[static_cast<std::size_t>(t)]);
    const Found again = solve(pair);
    const double off = std::hypot(again.moment[0] + load * 0.4, again.moment[1] - load * -0.2) / load;
    std::printf("friction %d: moments off by %.1e (bound 1e-7), laws by %.1e (bound 1e-8)\n", friction, off,
                pair.worst_law());
    EXPECT_LT(off, 1e-7);
    EXPECT_LT(pair.worst_law(), 1e-8);
  }
}

// The moment over the tilt of a rigid disc on a half-space is 4/3 E* a^3 (Johnson, 3.34).
TEST(tilt, of_a_rigid_disc_follows_its_closed_form) {
  constexpr double a = 1, load = 1000, moment = 100, young = 2.1e5, poisson = 0.3;
  double error[2];
  for (int i = 0; i < 2; ++i) {
    Pair pair(young, poisson, 1, -2);
    const int n = 24 << i;
    const std::vector<double> lines = frames::uniform_lines(-1.2, 1.2, n);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    const SurfaceMesh& mesh = pair.contact->scene.mesh();
    std::vector<double> gap;
    for (const Vec3& node : mesh.node) gap.push_back(std::hypot(node[0], node[1]) <= a + 1e-9 ? 0 : 1);
    pair.contact->scene.set_gap(mesh.nodes(), gap.data());
    pair.friction(0);
    pair.contact->scene.prescribe(normal, by_force, load);
    pair.contact->scene.prescribe(first, by_force, moment);
    const Found found = solve(pair);
    // Each node of the disc stands for a cell.
    const double area = static_cast<double>(std::count(gap.begin(), gap.end(), 0.0)) * std::pow(2.4 / n, 2);
    const double radius = std::sqrt(area / 3.14159265358979);
    const double stiffness = 4.0 / 3 * young / (1 - poisson * poisson) * std::pow(radius, 3);
    // The load presses at y = -moment / load, where a negative tilt takes gap away.
    error[i] = std::abs(-found.tilt[0] * stiffness / moment - 1);
    std::printf("%d elements a side: tilt %.6e, off by %.2f %%\n", n, found.tilt[0], 100 * error[i]);
    EXPECT_LT(std::abs(found.tilt[1]), 1e-6 * std::abs(found.tilt[0]));
  }
  std::printf("bound 3 %%\n");
  EXPECT_LT(error[1], 0.03);
}

// The bodies' response without friction has a potential: a moment changes the approach in the way that the load changes
// the tilt (the pressures' moment is minus that of the tractions on body 1).
TEST(tilt, and_approach_respond_to_each_other_alike) {
  constexpr double load = 500;
  Pair pair = steel();
  scene(pair, ElementType::quad4, 28, load);
  pair.contact->scene.options.set_real("tolerance", 1e-13);
  pair.friction(0);
  press_at(pair, load, 0.3, -0.4);
  solve(pair);
  double by_moment = 0, by_load[2];
  pair.contact->sensitivity(Parameter::tilt1, nullptr, nullptr, &by_moment, nullptr);
  constexpr double step = 1e-3 * load;
  for (int i = 0; i < 2; ++i) {
    Pair moved = steel();
    scene(moved, ElementType::quad4, 28, load + (i == 0 ? step : -step));
    moved.contact->scene.options.set_real("tolerance", 1e-13);
    moved.friction(0);
    press_at(moved, load, 0.3, -0.4);
    by_load[i] = solve(moved).tilt[0];
  }
  const double other = (by_load[0] - by_load[1]) / (2 * step), off = std::abs(by_moment + other) / std::abs(other);
  std::printf("approach by moment %.6e, tilt by load %.6e: off by %.1e (bound 1e-4)\n", by_moment, other, off);
  EXPECT_LT(off, 1e-4);
}

TEST(tilt, derivatives_are_the_slope_of_solves) {
  constexpr double load = 800, moment = 320, step = 0.05;
  for (const std::int32_t how : {by_force, by_motion}) {
    const double at = how == by_force ? moment : -4e-3, change = how == by_force ? step : 1e-6;
    const auto make = [&](double value) {
      Pair pair = unlike();
      scene(pair, ElementType::quad4, 24, load);
      pair.contact->scene.options.set_real("tolerance", 1e-13);
      pair.contact->scene.set_creep(1e-3, 5e-4, 1e-3);
      pair.contact->scene.prescribe(first, how, value);
      return pair;
    };
    Pair middle = make(at);
    solve(middle);
    Found rate;
    Vec3 creep{};
    middle.contact->sensitivity(Parameter::tilt1, rate.force.data(), rate.moment.data(), &rate.approach, creep.data());
    Pair up = make(at + change), down = make(at - change);
    const Found a = solve(up), b = solve(down);
    double worst = 0, size = 0, size_moment = 0;
    for (std::size_t i = 0; i < 2; ++i) size = std::max(size, std::abs(rate.force[i]));
    for (std::size_t i = 0; i < 3; ++i) size_moment = std::max(size_moment, std::abs(rate.moment[i]));
    for (std::size_t i = 0; i < 2; ++i)
      worst = std::max(worst, std::abs((a.force[i] - b.force[i]) / (2 * change) - rate.force[i]) / size);
    for (std::size_t i = 0; i < 3; ++i)
      worst = std::max(worst, std::abs((a.moment[i] - b.moment[i]) / (2 * change) - rate.moment[i]) / size_moment);
    worst =
        std::max(worst, std::abs((a.approach - b.approach) / (2 * change) - rate.approach) / std::abs(rate.approach));
    std::printf("by %s: derivatives off differences by %.1e (bound 1e-5)\n", how == by_force ? "moment" : "tilt",
                worst);
    EXPECT_LT(worst, 1e-5);
  }
}

TEST(tilt, is_the_same_by_every_way_that_solves) {
  constexpr double load = 800;
  const auto make = [](void (*set)(Options&)) {
    Pair pair = unlike();
    scene(pair, ElementType::quad4, 20, load);
    pair.contact->scene.set_creep(1e-3, 5e-4, 1e-3);
    pair.contact->scene.options.set_text("convection", "godunov");
    pair.contact->scene.options.set_real("tolerance", 1e-10);
    set(pair.contact->scene.options);
    press_at(pair, load, 0.3, -0.5);
    return pair;
  };
  Pair standard = make([](Options&) {});
  const Found found = solve(standard);
  struct Way {
    const char* name;
    void (*set)(Options&);
  };
  const Way ways[] = {
    {"dense", [](Options& o) { o.set_text("operators", "dense"); }},
    {"GMRES", [](Options& o) { o.set_text("linear_solver", "gmres"); }},
#if ROLLCON_BUILD_PROCEDURES
    {"monolithic", [](Options& o) { o.set_procedure("system=monolithic"); }},
#endif
  };
  for (const Way& way : ways) {
    Pair pair = make(way.set);
    const Found other = solve(pair);
    const double off = std::hypot(other.tilt[0] - found.tilt[0], other.tilt[1] - found.tilt[1]) /
                       std::hypot(found.tilt[0], found.tilt[1]);
    const double moment = std::hypot(other.moment[0] - 400, other.moment[1] - 240) / 400;
    std::printf("%s: tilts off by %.1e, moments by %.1e (bound 1e-7)\n", way.name, off, moment);
    EXPECT_LT(std::max(off, moment), 1e-7);
  }
}

TEST(tilt, of_random_scenes_carries_load_and_moments) {
  frames::Random random(7);
  int solved = 0;
  double worst = 0;
  for (int i = 0; i < 20; ++i) {
    const double load = std::pow(10, random.between(2.3, 2.9)), x = random.between(-0.7, 0.7),
                 y = random.between(-0.7, 0.7);
    Pair pair(2.1e5, 0.28, std::pow(10, random.between(4.3, 5.5)), random.between(0, 0.49));
    const ElementType type = i % 2 == 0 ? ElementType::quad4 : ElementType::tri3;
    scene(pair, type, type == ElementType::quad4 ? 30 : 24, load);
    pair.friction(std::pow(10, random.between(-1.5, 0.3)));
    pair.contact->scene.set_creep(random.between(-3e-3, 3e-3), random.between(-3e-3, 3e-3),
                                  random.between(-1e-3, 1e-3));
    press_at(pair, load, x, y);
    const Status status = pair.contact->solve();
    Found f;
    pair.contact->resultant(InAxes::local, f.force.data(), f.moment.data());
    if (status == Status::ok) ++solved;
    EXPECT_TRUE(status == Status::ok || status == Status::rim_contact || status == Status::coarse)
        << i << ": " << static_cast<int>(status);
    worst = std::max({worst, std::abs(f.force[2] + load) / load,
                      std::hypot(f.moment[0] + load * y, f.moment[1] - load * x) / load, pair.worst_law()});
  }
  std::printf("%d of 20 contacts off the rim and fine enough; loads, moments and laws off by %.1e (bound 1e-8)\n",
              solved, worst);
  EXPECT_GE(solved, 12);
  EXPECT_LT(worst, 1e-8);
}

TEST(tilt, refusals_name_what_is_wrong) {
  Pair pair = steel();
  scene(pair, ElementType::quad4, 12, 100);
  const auto text = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const Error& e) {
      return e.what();
    }
    return "none";
  };
  EXPECT_EQ(text([&] { pair.contact->scene.prescribe(5, by_force, 1); }),
            "direction is 5; allowed: 1 (longitudinal), 2 (lateral), 3 (normal), 4 (spin), 6 (tilt 1), 7 (tilt 2)");
  press_at(pair, 100, 3, 0);
  EXPECT_EQ(text([&] { pair.contact->solve(); }),
            "normal load and moments act at x = 3; nodes that may touch have -2.2 to 2.2");
  press_at(pair, 100, 0, 0);
  EXPECT_EQ(text([&] { pair.contact->solve(); }), "none");
}

}  // namespace
}  // namespace rollcon
