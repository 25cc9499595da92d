// Tests that solutions that no material bears are reported, whatever the equations say; that bodies may come in the
// wrong order; and that friction may be next to none.

#include "contact/scene_fixture.hpp"
#include "support/last_error.hpp"
#include "support/scene.hpp"

namespace rollcon::contact_test {
namespace {

constexpr double young = 1000, poisson = 0.3, modulus = young / (1 - poisson * poisson);

TEST(doubts, an_approach_beyond_half_of_the_radius_is_too_deep) {
  Pair pair(young, poisson, 0, -2);
  const std::vector<double> lines = frames::uniform_lines(-60, 60, 24);
  pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
  pair.contact->scene.set_gap_quadratic(0.01, 0.01, 0);
  pair.friction(0);
  pair.contact->scene.prescribe(3, 1, 24);
  EXPECT_EQ(pair.contact->solve(), Status::ok);
  pair.contact->scene.prescribe(3, 1, 26);
  EXPECT_EQ(pair.contact->solve(), Status::too_deep);
  EXPECT_NE(pair.contact->plan().find("approach each other by 26"), std::string::npos) << pair.contact->plan();
}

TEST(doubts, pressures_above_the_modulus_are_too_deep) {
  Pair pair(young, poisson, 0, -2);
  const std::vector<double> lines = frames::uniform_lines(-2.5, 2.5, 20);
  const SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
  pair.frame(mesh);
  std::vector<double> ball;  // a ball of radius 1, given as gaps alone
  for (const Vec3& x : mesh.node) ball.push_back(0.5 * (x[0] * x[0] + x[1] * x[1]));
  pair.contact->scene.set_gap(mesh.nodes(), ball.data());
  pair.friction(0);
  pair.contact->scene.prescribe(3, 1, 1);
  EXPECT_EQ(pair.contact->solve(), Status::ok);
  pair.contact->scene.prescribe(3, 1, 3);
  EXPECT_EQ(pair.contact->solve(), Status::too_deep);
  EXPECT_GT(pair.contact->stat("max_pressure"), modulus);
  EXPECT_NE(pair.contact->plan().find("more than the modulus of contact (1099)"), std::string::npos)
      << pair.contact->plan();
}

// Friction whose tractions have squares that vanish counts as none and carries nothing.
TEST(doubts, friction_next_to_none_is_none) {
  Pair none(young, poisson, young, poisson), little(young, poisson, young, poisson);
  for (Pair* pair : {&none, &little}) {
    standard_scene(*pair, 14);
    pair->friction(pair == &none ? 0 : 1e-300);
    pair->contact->scene.set_creep(1e-3, 5e-4, 1e-3);
    EXPECT_EQ(pair->contact->solve(), Status::ok);
  }
  EXPECT_EQ(none.tractions(), little.tractions());
  little.contact->scene.prescribe(1, 2, 1e-3);
  EXPECT_THROW(little.contact->solve(), Error);
}

// A roller in its groove turns the normals by 40 degrees. It is body 2, above, or body 1 with n downwards. Motion and
// force change their signs along t1, but not along t2, which turns, nor about n.
TEST(doubts, a_conformal_contact_rolls_alike_in_the_other_order) {
  Vec3 force[2];
  double approach[2];
  for (const int order : {0, 1}) {
    scenes::RollingPair pair(closed_forms::Elastic{.shear = 8e4, .poisson = 0.28},
                             closed_forms::Elastic{.shear = 8e4, .poisson = 0.28});
    const int groove = order == 0 ? 1 : 2, roller = 3 - groove;
    const double hollow[2] = {-11, 8}, round[2] = {10, 8};
    const double centre[3] = {0, 0, 300}, axis[3] = {0, 1, 0}, origin[3] = {0, 0, 0}, x[3] = {1, 0, 0},
                 z[3] = {0, 0, 1};
    ASSERT_EQ(rollcon_body_set_profile_shape(pair.body(groove), "arc", 2, hollow), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_extrude_profile(pair.body(groove), origin, x, z), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_set_profile_shape(pair.body(roller), "arc", 2, round), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_revolve_profile(pair.body(roller), centre, axis, 300), ROLLCON_OK);
    const double sign = order == 0 ? 1 : -1;
    pair.axes({0, 0, 0}, {1, 0, 0}, {0, 0, sign}).rectangle(ElementType::quad4, 14, 28, 4.5, 7);
    pair.option("conformal", std::int64_t{1}).load(2e4).friction(0.3).speed(1).creep(sign * 1e-3, 5e-4, 2e-4);
    ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
    const scenes::Solution s = pair.solution();
    force[order] = s.force;
    approach[order] = s.approach;
  }
  std::printf("force %.6f %.6f over mu Fn, other order %.6f %.6f\n", force[0][0] / 6e3, force[0][1] / 6e3,
              force[1][0] / 6e3, force[1][1] / 6e3);
  EXPECT_NEAR(force[1][0], -force[0][0], 1e-6 * 6e3);
  EXPECT_NEAR(force[1][1], force[0][1], 1e-6 * 6e3);
  EXPECT_NEAR(approach[1], approach[0], 1e-8);
}

TEST(doubts, bodies_in_the_other_order_are_refused_on_a_given_frame) {
  for (const bool exchanged : {false, true}) {
    scenes::RollingPair pair(closed_forms::Elastic{.shear = 8e4, .poisson = 0.3}, std::nullopt);
    const int wheel = exchanged ? 1 : 2, rail = 3 - wheel;
    const double centre[3] = {0, 0, 40}, axis[3] = {0, 1, 0}, origin[3] = {0, 0, 0}, x[3] = {1, 0, 0}, z[3] = {0, 0, 1};
    const double crown[2] = {250, 15}, head[2] = {180, 15};
    ASSERT_EQ(rollcon_body_set_profile_shape(pair.body(wheel), "arc", 2, crown), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_revolve_profile(pair.body(wheel), centre, axis, 40), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_set_profile_shape(pair.body(rail), "arc", 2, head), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_extrude_profile(pair.body(rail), origin, x, z), ROLLCON_OK);
    pair.rectangle(ElementType::quad4, 20, 20, 1, 2).load(200).friction(0);
    if (!exchanged) {
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_error();
      continue;
    }
    EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_ARGUMENT);
    EXPECT_NE(std::string(rollcon_last_error()).find("body 1 lies on the side of n"), std::string::npos)
        << rollcon_last_error();
  }
}

}  // namespace
}  // namespace rollcon::contact_test
