// Tests which loads friction can carry: a convex set, told by its extent in every direction of motion.

#include "contact/newton/friction_limit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

struct Loaded {
  Problem problem;
  Prescribed given;
  std::vector<double> lambda[3];
};

/// Makes an ellipsoid of pressure off the middle of a frame.
Loaded loaded(const SurfaceMesh& mesh, const std::array<bool, motion_count>& by_force) {
  Loaded l;
  Problem& p = l.problem;
  const Frame frame = build_frame(mesh, {});
  take_frame(p, frame);
  p.convection.slip_x = frame.x;
  p.convection.slip_y = frame.y;
  p.mu.assign(frame.x.size(), 0.3);
  l.given.by_force = by_force;
  for (auto& v : l.lambda) v.assign(frame.x.size(), 0.0);
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    const double depth = 1 - std::pow(frame.x[k] - 0.1, 2) / 0.8 - std::pow(frame.y[k] + 0.2, 2);
    if (depth > 0) l.lambda[2][k] = -std::sqrt(depth);
  }
  return l;
}

SurfaceMesh mesh_of(ElementType type, int n, bool irregular) {
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, n);
  const SurfaceMesh mesh = frames::rectangle(type, lines, lines);
  return irregular ? frames::perturb(mesh, 0.2, 5) : mesh;
}

constexpr std::array<std::array<bool, motion_count>, 7> combinations{{{true, false, false, false},
                                                                      {false, true, false, false},
                                                                      {false, false, false, true},
                                                                      {true, true, false, false},
                                                                      {true, false, false, true},
                                                                      {false, true, false, true},
                                                                      {true, true, false, true}}};

// Tractions along each node's part of a motion are as far as friction reaches in that direction.
TEST(friction_limit, full_sliding_is_the_limit) {
  constexpr double bound = 1e-6;
  double worst = 0, worst_sliding = 0;
  frames::Random random(7);
  for (const auto& by_force : combinations)
    for (const ElementType type : {ElementType::quad4, ElementType::tri3, ElementType::quad9})
      for (const bool irregular : {false, true}) {
        Loaded l = loaded(mesh_of(type, 10, irregular), by_force);
        Problem& p = l.problem;
        for (int draw = 0; draw < 5; ++draw) {
          MotionValues a{};
          for (const int m : {xi1, xi2, spin})
            if (by_force[static_cast<std::size_t>(m)]) a[static_cast<std::size_t>(m)] = random();
          for (std::size_t k = 0; k < p.mu.size(); ++k) {
            double v[2] = {};
            for (const int m : {xi1, xi2, spin})
              for (std::size_t c = 0; c < 2; ++c) v[c] += a[static_cast<std::size_t>(m)] * p.load_row(m, k)[c];
            const double size = std::hypot(v[0], v[1]);
            for (std::size_t c = 0; c < 2; ++c) l.lambda[c][k] = size > 0 ? -p.mu[k] * l.lambda[2][k] * v[c] / size : 0;
          }
          for (const double part : {1.0, 0.25}) {
            for (const int m : {xi1, xi2, spin})
              l.given.value[static_cast<std::size_t>(m)] = part * load_on_body1(p, m, l.lambda).value;
            const FrictionShare share = share_of_friction(p, l.given, l.lambda);
            worst = std::max(worst, std::abs(share.together / part - 1));
            worst_sliding = std::max(worst_sliding, 1 - share.sliding / part);
            if (!by_force[spin]) {
              EXPECT_NEAR(share_of_forces(p, l.given, l.lambda), part, 1e-12);
              EXPECT_EQ(share.together, share.force);
            }
          }
        }
      }
  std::printf("share of full sliding: off by %.1e (bound %.0e); by motion of nodes at most %.1e less\n", worst, bound,
              worst_sliding);
  EXPECT_LT(worst, bound);
  EXPECT_LT(worst_sliding, bound);
}

// Tractions that friction allows have loads within the limit, and no direction tells more.
TEST(friction_limit, no_admissible_tractions_are_beyond) {
  double most = 0, missed = 0;
  frames::Random random(11);
  for (const auto& by_force : combinations)
    for (const ElementType type : {ElementType::quad4, ElementType::tri3})
      for (int draw = 0; draw < 10; ++draw) {
        Loaded l = loaded(mesh_of(type, 7, true), by_force);
        Problem& p = l.problem;
        const double centre = 0.3 * random(), turn = 3 * random();
        for (std::size_t k = 0; k < p.mu.size(); ++k) {
          const double angle =
              std::atan2(p.convection.slip_y[k] - centre, p.convection.slip_x[k]) + turn + 0.2 * random();
          l.lambda[0][k] = -p.mu[k] * l.lambda[2][k] * std::cos(angle);
          l.lambda[1][k] = -p.mu[k] * l.lambda[2][k] * std::sin(angle);
        }
        for (const int m : {xi1, xi2, spin})
          l.given.value[static_cast<std::size_t>(m)] = load_on_body1(p, m, l.lambda).value;
        const FrictionShare share = share_of_friction(p, l.given, l.lambda);
        most = std::max(most, share.together);
        for (int sample = 0; sample < 300; ++sample) {
          MotionValues a{};
          double asked = 0, power = 0;
          for (const int m : {xi1, xi2, spin}) {
            const auto i = static_cast<std::size_t>(m);
            a[i] = by_force[i] ? random() : 0;
            asked += a[i] * l.given.value[i];
          }
          for (std::size_t k = 0; k < p.mu.size(); ++k) {
            double v[2] = {};
            for (const int m : {xi1, xi2, spin})
              for (std::size_t c = 0; c < 2; ++c) v[c] += a[static_cast<std::size_t>(m)] * p.load_row(m, k)[c];
            power -= p.mu[k] * l.lambda[2][k] * std::hypot(v[0], v[1]);
          }
          missed = std::max(missed, asked / power - share.together);
        }
      }
  std::printf("greatest share %.6f (bound 1), directions tell %.1e more (bound 1e-6)\n", most, missed);
  EXPECT_LE(most, 1 + 1e-12);
  EXPECT_LT(missed, 1e-6);
}

// Corners of quad8 have negative weights: friction reaches to mu Fn of the integrated pressure.
TEST(friction_limit, quadratic_frames_carry_mu_times_the_integrated_pressure) {
  for (const ElementType type : {ElementType::quad8, ElementType::quad9, ElementType::tri6}) {
    Loaded l = loaded(mesh_of(type, 5, false), {true, true, false, false});
    Problem& p = l.problem;
    const double most = 0.3 * load_on_body1(p, approach, l.lambda).value;
    l.given.value = {0.6 * most, 0.8 * most, 0, 0};
    EXPECT_NEAR(share_of_friction(p, l.given, l.lambda).together, 1, 1e-12);
    EXPECT_NEAR(share_of_forces(p, l.given, l.lambda), 1, 1e-12);
    EXPECT_EQ(friction_overdrawn(p, l.given, l.lambda), type == ElementType::quad8);
    l.given.value[xi1] *= 0.99;
    l.given.value[xi2] *= 0.99;
    EXPECT_FALSE(friction_overdrawn(p, l.given, l.lambda));
  }
}

/// Holds the status, the Newton steps, and the text of an error.
struct Ended {
  Status status = Status::ok;
  std::string text;
  std::int64_t steps = 0;
};

Ended solve(Pair& pair) {
  Ended e;
  pair.contact->set_progress(
      [](const Event&, void* user) -> std::int32_t {
        ++*static_cast<std::int64_t*>(user);
        return 0;
      },
      &e.steps);
  try {
    e.status = pair.contact->solve();
  } catch (const Error& error) {
    e.status = error.status();
    e.text = error.what();
  }
  pair.contact->set_progress(nullptr, nullptr);
  return e;
}

struct Loads {
  double force[3] = {}, moment[3] = {};
};

Loads loads(const Pair& pair) {
  Loads l;
  pair.contact->resultant(InAxes::local, l.force, l.moment);
  return l;
}

// Each load alone is carried, both together are not: they are refused soon, and the text says so.
TEST(friction_limit, force_and_moment_together) {
  for (const double young2 : {2.1e5, 1e4})
    for (const bool by_force : {true, false}) {
      Pair pair(2.1e5, 0.3, young2, 0.3);
      standard_scene(pair, 14);
      Scene& scene = pair.contact->scene;
      pair.friction(0.25);
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      const double load = -loads(pair).force[2], most = 0.25 * load, radius = 1;
      if (by_force) scene.prescribe(3, 2, load);
      scene.prescribe(1, 2, 0.8 * most);
      scene.prescribe(4, 2, 0.2 * most * radius);
      pair.contact->reset();
      const Ended good = solve(pair);
      EXPECT_EQ(good.status, Status::ok) << young2;
      scene.prescribe(4, 2, 0.45 * most * radius);
      pair.contact->reset();
      const Ended bad = solve(pair);
      std::printf("E2 %.0e, normal by %s: %lld steps to solve, %lld to refuse: %s\n", young2,
                  by_force ? "force" : "motion", static_cast<long long>(good.steps), static_cast<long long>(bad.steps),
                  bad.text.c_str());
      EXPECT_EQ(bad.status, Status::err_load);
      EXPECT_NE(bad.text.find("tangential force and spin moment together"), std::string::npos);
      EXPECT_LE(bad.steps, young2 == 2.1e5 ? good.steps : 4 * good.steps);
      scene.prescribe(1, 2, 0);
      scene.prescribe(1, 1, 0);
      scene.prescribe(4, 2, 0.8 * most * radius);
      const Ended moment = solve(pair);
      EXPECT_EQ(moment.status, Status::err_load);
      EXPECT_NE(moment.text.find("the prescribed spin moment is"), std::string::npos) << moment.text;
      scene.prescribe(4, 1, 0);
      scene.prescribe(1, 2, 1.2 * most);
      const Ended force = solve(pair);
      EXPECT_EQ(force.status, Status::err_load);
      EXPECT_NE(force.text.find("|Ft| must be less than mu Fn"), std::string::npos) << force.text;
    }
}

// A moment that a spin produced is carried when it is prescribed, also where moments of shape functions are greater
// than weight times distance of the node.
TEST(friction_limit, a_moment_that_a_spin_produced_is_carried) {
  int beyond_nodes = 0, meshes = 0;
  for (const ElementType type : {ElementType::quad4, ElementType::tri3})
    for (const int n : {7, 9})
      for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        Pair pair(2.1e5, 0.3, 2.1e5, 0.3);
        const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, n);
        pair.frame(frames::perturb(frames::rectangle(type, lines, lines), 0.2, seed));
        Scene& scene = pair.contact->scene;
        scene.set_gap_quadratic(0.01, 0.012, 0.001);
        pair.friction(0.06);
        scene.prescribe(3, 1, 0.006);
        scene.prescribe(4, 1, 1e3);
        (void)pair.contact->solve();
        const double all = loads(pair).moment[2];
        scene.prescribe(4, 1, 3e-2);
        (void)pair.contact->solve();
        const double moment = loads(pair).moment[2];
        if (!(std::abs(moment) < 0.999 * std::abs(all))) continue;
        ++meshes;
        const std::vector<double> t = pair.tractions();
        const Frame frame = build_frame(scene.mesh(), {});
        double nodes = 0;
        for (std::size_t k = 0; k < frame.x.size(); ++k)
          nodes -= 0.06 * t[3 * k + 2] * frame.weight[k] * std::hypot(frame.x[k], frame.y[k]);
        beyond_nodes += std::abs(moment) >= nodes;
        scene.prescribe(4, 2, moment);
        pair.contact->reset();
        const Ended e = solve(pair);
        EXPECT_TRUE(e.status == Status::ok || e.status == Status::rim_contact || e.status == Status::coarse)
            << n << ", seed " << seed << ": " << e.text;
      }
  std::printf("%d meshes, moments of %d beyond weight times distance\n", meshes, beyond_nodes);
  EXPECT_GT(beyond_nodes, 0) << "other meshes are wanted";
}

TEST(friction_limit, quad8_frames_do_not_carry_more_than_mu_fn) {
  for (const bool by_force : {true, false})
    for (const double share : {0.9, 1.02, 1.1}) {
      Pair pair(2e5, 0.3, 1e4, 0.45);
      const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 7);
      pair.frame(frames::rectangle(ElementType::quad8, lines, lines));
      Scene& scene = pair.contact->scene;
      scene.set_gap_quadratic(0.01, 0.012, 0.001);
      pair.friction(0.25);
      scene.prescribe(3, 1, 0.008);
      (void)pair.contact->solve();
      const double load = -loads(pair).force[2];
      if (by_force) scene.prescribe(3, 2, load);
      scene.prescribe(1, 2, share * 0.25 * load);
      pair.contact->reset();
      const Ended e = solve(pair);
      std::printf("quad8, normal by %s, %.2f mu Fn: status %d\n", by_force ? "force" : "motion", share,
                  static_cast<int>(e.status));
      EXPECT_EQ(e.status, share < 1 ? Status::coarse : Status::err_load) << e.text;
    }
}

// A node at the origin has no moment: a moment of none is carried whatever the spin, any other is not.
TEST(friction_limit, one_node_at_the_origin_has_no_moment) {
  for (const double young2 : {2.1e5, 1e4})
    for (const int n : {20, 32})
      for (const double moment : {0.0, 1e-5}) {
        Pair pair(2.1e5, 0.3, young2, 0.3);
        const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, n);
        pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
        Scene& scene = pair.contact->scene;
        scene.set_gap_quadratic(0.01, 0.011, 0.001);
        pair.friction(0.25);
        scene.prescribe(3, 2, 1e-3);
        scene.prescribe(1, 2, 0.2 * 0.25 * 1e-3);
        scene.prescribe(4, 2, moment);
        const Ended e = solve(pair);
        if (moment != 0) {
          EXPECT_EQ(e.status, Status::err_load) << n << ": " << e.text;
          continue;
        }
        ASSERT_EQ(e.status, Status::coarse) << n << ": " << e.text;
        const auto carried = loads(pair);
        std::printf("%d x %d cells, E2 %g: F1 off by %.1e, moment %.1e of F1 length, %lld steps\n", n, n, young2,
                    std::abs(carried.force[0] / 5e-5 - 1), std::abs(carried.moment[2] / 5e-5),
                    static_cast<long long>(e.steps));
        EXPECT_NEAR(carried.force[0] / 5e-5, 1, 1e-9);
        EXPECT_NEAR(carried.moment[2] / 5e-5, 0, 1e-9);
        EXPECT_LE(e.steps, 30);
      }
}

// The bodies are unlike and an approach is given, so friction changes the load that bounds it.
TEST(friction_limit, refusals_do_not_take_many_times_a_solve) {
  for (const double share : {1.1, 1.5}) {
    Pair pair(512, 0.22, 1, -2);
    const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 20);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    Scene& scene = pair.contact->scene;
    scene.set_gap_quadratic(0.01, 0.012, 0);
    pair.friction(0.84);
    scene.prescribe(3, 1, 0.01);
    (void)pair.contact->solve();
    const double most = 0.84 * -loads(pair).force[2];
    scene.prescribe(1, 2, 0.9 * most);
    pair.contact->reset();
    const Ended good = solve(pair);
    EXPECT_EQ(good.status, Status::ok);
    scene.prescribe(1, 2, share * most);
    pair.contact->reset();
    const Ended bad = solve(pair);
    std::printf("%.1f mu Fn: %lld steps, 0.9 mu Fn: %lld (bound 4 times)\n", share, static_cast<long long>(bad.steps),
                static_cast<long long>(good.steps));
    EXPECT_EQ(bad.status, Status::err_load);
    EXPECT_LE(bad.steps, 4 * good.steps);
  }
}

}  // namespace
}  // namespace rollcon
