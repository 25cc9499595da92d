/// Tests that loads and motions are two views of one solution, that scales and linear solvers do not change it, that
/// warm starts are cheap, and that statuses are right.

#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double rigid = -2;

struct Materials {
  const char* name;
  double poisson1, poisson2;
};
constexpr Materials pairs[] = {{"identical", 0.3, 0.3}, {"on rigid", 0.3, rigid}};

TEST(newton, forces_found_give_the_motions_back) {
  for (const Materials& m : pairs) {
    Pair pair(1e4, m.poisson1, 1e4, m.poisson2);
    standard_scene(pair, 16);
    Scene& scene = pair.contact->scene;
    scene.set_creep(-1.2e-3, 4e-4, 3e-4);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const std::vector<double> by_motion = pair.tractions();
    double force[3], moment[3], depth, creep[3];
    pair.contact->resultant(InAxes::local, force, moment);
    scene.prescribe(3, 2, -force[2]);
    scene.prescribe(1, 2, force[0]);
    scene.prescribe(2, 2, force[1]);
    scene.prescribe(4, 2, moment[2]);
    pair.contact->reset();
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    pair.contact->motion(&depth, creep);
    const double error = std::max({std::abs(depth / 0.02 - 1), std::abs(creep[0] / -1.2e-3 - 1),
                                   std::abs(creep[1] / 4e-4 - 1), std::abs(creep[2] / 3e-4 - 1)});
    const double difference = largest_difference(pair.tractions(), by_motion);
    std::printf("%s: motions from forces: error %.1e, tractions %.1e (bounds 1e-7)\n", m.name, error, difference);
    EXPECT_LT(error, 1e-7);
    EXPECT_LT(difference, 1e-7);
    EXPECT_LT(pair.worst_law(), 1e-8);
  }
}

TEST(newton, linear_solvers_do_not_change_the_solution) {
  for (const Materials& m : pairs) {
    Pair pair(1e4, m.poisson1, 1e4, m.poisson2);
    standard_scene(pair, 14);
    Scene& scene = pair.contact->scene;
    scene.set_creep(-8e-4, -5e-4, 5e-4);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const std::vector<double> reference = pair.tractions();
    double worst = 0;
    for (const char* solver : {"lu", "gmres", "gmres_adaptive"}) {
      scene.options.set_text("linear_solver", solver);
      pair.contact->reset();
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      worst = std::max(worst, largest_difference(pair.tractions(), reference));
    }
    std::printf("%s: LU and GMRES: difference %.1e (bound 1e-8)\n", m.name, worst);
    EXPECT_LT(worst, 1e-8);
  }
}

TEST(newton, warm_start_costs_a_few_iterations_and_no_assembly) {
  for (const Materials& m : pairs) {
    Pair pair(1e4, m.poisson1, 1e4, m.poisson2);
    standard_scene(pair, 20);
    Scene& scene = pair.contact->scene;
    scene.options.set_text("operators", "dense");
    scene.set_creep(-1e-3, 0, 0);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double cold = pair.contact->stat("iterations");
    scene.set_creep(-1.01e-3, 0, 0);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double warm = pair.contact->stat("iterations");
    std::printf("%s: %g iterations cold (bound 12), %g warm (bound 4)\n", m.name, cold, warm);
    EXPECT_LE(cold, 12);
    EXPECT_LE(warm, 4);
    EXPECT_EQ(pair.contact->stat("compliance_assemblies"), 1);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    EXPECT_EQ(pair.contact->stat("iterations"), 0) << "nothing changed";
  }
}

TEST(newton, a_warm_start_ends_where_a_cold_one_does) {
  Pair pair(1e4, 0.3, 1e4, rigid);
  standard_scene(pair, 14);
  Scene& scene = pair.contact->scene;
  scene.set_creep(2e-2, -1e-2, 5e-3);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  scene.set_creep(-2e-4, 1e-4, 0);
  scene.prescribe(3, 1, 0.012);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  const std::vector<double> warm = pair.tractions();
  scene.options.set_int("warm_start", 0);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  const double difference = largest_difference(warm, pair.tractions());
  std::printf("warm against cold: %.1e (bound 1e-8)\n", difference);
  EXPECT_LT(difference, 1e-8);
}

TEST(newton, every_change_of_the_scene_is_seen) {
  // One input changes after a solve; the answer must be that of a fresh contact.
  const auto change = [](int which, Pair& pair) {
    Scene& s = pair.contact->scene;
    switch (which) {
      case 0:
        s.set_gap_quadratic(0.012, 0.009, 0.001);
        break;
      case 1:
        pair.friction(0.1);
        break;
      case 2:
        s.set_creep(3e-4, 0, 1e-3);
        break;
      case 3:
        s.options.set_text("convection", "godunov");
        break;
      case 4:
        s.options.set_text("convection", "characteristic");
        break;
      case 5:
        s.options.set_real("accuracy", 1e-9);
        break;
      case 6: {
        const double origin[3] = {0.1, 0, 0}, rolling[3] = {0.6, 0.8, 0}, normal[3] = {0, 0, 1};
        s.set_axes(origin, rolling, normal);
        break;
      }
      case 7:
        pair.friction(0);
        break;
      case 8: {  // the scheme changes while there is no friction to need it
        pair.friction(0);
        ASSERT_GE(static_cast<int>(pair.contact->solve()), 0);
        s.options.set_text("convection", "characteristic");
        ASSERT_GE(static_cast<int>(pair.contact->solve()), 0);
        pair.friction(0.3);
        break;
      }
      default: {
        const std::vector<double> lines = frames::uniform_lines(-1.4, 1.4, 9);
        pair.frame(frames::rectangle(ElementType::tri3, lines, lines));
      }
    }
  };
  double worst = 0;
  for (int which = 0; which <= 9; ++which) {
    Pair used(1e4, 0.3, 1e4, rigid), fresh(1e4, 0.3, 1e4, rigid);
    for (Pair* pair : {&used, &fresh}) {
      standard_scene(*pair, 10);
      pair->contact->scene.set_creep(-1e-3, 2e-4, 0);
    }
    ASSERT_GE(static_cast<int>(used.contact->solve()), 0);
    change(which, used);
    change(which, fresh);
    ASSERT_GE(static_cast<int>(used.contact->solve()), 0) << which;
    ASSERT_GE(static_cast<int>(fresh.contact->solve()), 0) << which;
    worst = std::max(worst, largest_difference(used.tractions(), fresh.tractions()));
    ASSERT_LT(worst, 1e-8) << which;
  }
  std::printf("changed scene against a fresh one: %.1e (bound 1e-8)\n", worst);
}

TEST(newton, statuses) {
  Pair pair(1e4, 0.3, 1e4, rigid);
  standard_scene(pair, 10);
  Scene& scene = pair.contact->scene;
  scene.prescribe(3, 1, -0.01);
  EXPECT_EQ(pair.contact->solve(), Status::no_contact);
  for (const double t : pair.tractions()) EXPECT_EQ(t, 0);
  scene.prescribe(3, 2, 0);
  EXPECT_EQ(pair.contact->solve(), Status::no_contact);
  scene.prescribe(3, 1, 0.2);
  EXPECT_EQ(pair.contact->solve(), Status::rim_contact);
  EXPECT_GT(pair.contact->stat("nodes_rim"), 0);
  scene.prescribe(3, 2, 300);
  scene.options.set_int("max_iterations", 1);
  pair.contact->reset();
  EXPECT_EQ(pair.contact->solve(), Status::not_converged);
  EXPECT_GT(pair.contact->stat("max_pressure"), 0);
  scene.options.set_int("max_iterations", 100);
  for (const double fraction : {1.0, 1.5, -2.0}) {
    scene.prescribe(1, 2, fraction * 0.3 * 300);
    try {
      pair.contact->solve();
      ADD_FAILURE() << "no steady solution at " << fraction;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_load);
    }
  }
  scene.prescribe(1, 2, 0.9 * 0.3 * 300);
  EXPECT_EQ(pair.contact->solve(), Status::ok) << "usable after a refused load";
}

TEST(newton, no_load_after_a_loaded_solve_leaves_nothing_behind) {
  Pair pair(1e4, 0.3, 1e4, rigid);
  standard_scene(pair, 10);
  Scene& scene = pair.contact->scene;
  scene.set_gap_quadratic(0.01, 0.01, 0);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  scene.prescribe(3, 2, 0);
  ASSERT_EQ(pair.contact->solve(), Status::no_contact);
  double force[3], depth = 1;
  pair.contact->resultant(InAxes::local, force, nullptr);
  pair.contact->motion(&depth, nullptr);
  EXPECT_EQ(force[2], 0);
  EXPECT_EQ(depth, 0) << "the bodies just touch";
}

TEST(newton, a_far_start_is_not_held_against_the_load) {
  // The small patch of the last solution could not carry the spin moment, but the new one can.
  for (const double moment : {5.0, 10.0}) {
    Pair pair(1e4, 0.3, 1e4, rigid);
    standard_scene(pair, 12);
    Scene& scene = pair.contact->scene;
    scene.prescribe(3, 2, 3);
    ASSERT_EQ(pair.contact->solve(), Status::coarse);
    scene.prescribe(3, 2, 300);
    scene.prescribe(4, 2, moment);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    EXPECT_LT(pair.worst_law(), 1e-8);
  }
}

TEST(newton, a_creep_field_that_is_a_spin_acts_like_the_spin) {
  for (const char* scheme : {"godunov", "least_squares", "characteristic"}) {
    Pair by_spin(1e4, 0.3, 1e4, 0.3), by_field(1e4, 0.3, 1e4, 0.3);
    const double spin = 2e-3, speed = 7;
    for (Pair* pair : {&by_spin, &by_field}) {
      standard_scene(*pair, 14);
      pair->contact->scene.set_speed(speed);
      pair->contact->scene.options.set_text("convection", scheme);
    }
    by_spin.contact->scene.set_creep(0, 0, spin);
    std::vector<double> field;
    for (const Vec3& node : by_field.contact->scene.mesh().node) {
      field.push_back(-speed * spin * node[1]);
      field.push_back(speed * spin * node[0]);
    }
    by_field.contact->scene.set_creep_field(by_field.contact->nodes(), field.data());
    ASSERT_EQ(by_spin.contact->solve(), Status::ok);
    ASSERT_EQ(by_field.contact->solve(), Status::ok);
    const double difference = largest_difference(by_field.tractions(), by_spin.tractions());
    std::printf("%s: spin as a field: difference %.1e (bound 1e-8)\n", scheme, difference);
    EXPECT_LT(difference, 1e-8);
  }
}

TEST(newton, loads_that_the_first_nodes_cannot_carry_are_found_from_the_approach) {
  // One corner node of a serendipity element is in contact: its weight is negative, so that no compressive pressure
  // there carries the load.
  Pair pair(1e4, 0.3, 1e4, 0.3);
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 4);
  pair.frame(frames::rectangle(ElementType::quad8, lines, lines));
  Scene& scene = pair.contact->scene;
  scene.set_gap_quadratic(0.01, 0.01, 0);
  pair.friction(0.3);
  scene.set_creep(1e-3, 0, 0);
  scene.prescribe(3, 2, 0.1);
  ASSERT_EQ(pair.contact->solve(), Status::coarse);
  std::printf("%g nodes carry it, %g fallbacks, worst law residual %.1e (bound 1e-8)\n",
              pair.contact->stat("nodes_contact"), pair.contact->stat("fallbacks"), pair.worst_law());
  EXPECT_GT(pair.contact->stat("nodes_contact"), 1);
  EXPECT_GE(pair.contact->stat("fallbacks"), 1);
  EXPECT_LT(pair.worst_law(), 1e-8);
}

TEST(newton, what_is_not_needed_is_not_assembled) {
  Pair identical(1e4, 0.3, 1e4, 0.3);
  standard_scene(identical, 10);
  identical.friction(0);
  ASSERT_EQ(identical.contact->solve(), Status::ok);
  const double frictionless = identical.contact->stat("peak_bytes");
  EXPECT_NE(identical.contact->plan().find("no tangential unknowns"), std::string::npos);
  identical.friction(0.3);
  ASSERT_EQ(identical.contact->solve(), Status::ok);
  EXPECT_NE(identical.contact->plan().find("normal problem first"), std::string::npos);
  EXPECT_EQ(identical.contact->stat("full_iterations"), 0);
  EXPECT_GT(identical.contact->stat("peak_bytes"), frictionless);
}

}  // namespace
}  // namespace rollcon
