/// Compares wheel S1002 on rail 60E1 from their profiles and positions, at positions of the Manchester benchmark, with
/// CONTACT's results on elements of 0.2 mm.

#include "support/testing.hpp"
#include "wheel_and_rail_fixture.hpp"

using namespace capi_test;

TEST_F(wheel_and_rail, manchester_positions_give_contacts_forces) {
  for (const Position& p : {positions[0], positions[1]}) {
    // The position says how far the bodies overlap; nothing else is prescribed.
    rollcon_contact* c = contact_at(p);
    const double force = -solved_force(c)[2];
    double pressure = 0, area = 0;
    EXPECT_OK(rollcon_contact_get_stat(c, "max_pressure", &pressure));
    EXPECT_OK(rollcon_contact_get_stat(c, "contact_area", &area));
    const std::string at = "wheelset at y = " + std::to_string(p.y);
    // The value z is known to 5e-5 mm, the approaches are 0.016 and 0.025 mm: 0.5 and 0.3 % of the force.
    rollcon::expect_error(at + ": normal force beside CONTACT's", force / p.normal - 1, 0.005);
    rollcon::expect_error(at + ": largest pressure", pressure / p.largest_pressure - 1, 0.005);
    // The boundaries are those of elements: half an element of CONTACT's around, 0.1 mm of 20.2 mm2 is 8 %, of 51.6 mm2
    // 6 %.
    rollcon::expect_error(at + ": area of contact", area / p.area - 1, 0.06);
    rollcon_contact_release(c);
  }
}

TEST_F(wheel_and_rail, lateral_force_of_the_spin) {
  rollcon_contact* c = contact_at(positions[0]);
  ASSERT_OK(rollcon_contact_set_creep(c, -5.665e-5, 0, 6.302e-5));
  const std::array<double, 3> force = solved_force(c);
  rollcon::expect_error("lateral force beside CONTACT's", force[1] / -253.6 - 1, 0.03);
  rollcon_contact_release(c);
}

// Tread and flange touch; the library finds the patches on the surfaces and lays the frames.
TEST_F(wheel_and_rail, manchester_positions_without_a_frame) {
  for (const Position& p : {positions[1], positions[2]}) {
    // The value z is known to 5e-5 mm, which gives the normal force to 0.3 %; on the flange the sideways slope of the
    // profiles counts.
    const double bound = p.y < 5 ? 0.005 : 0.012;
    rollcon_contact* c = contact_without_frame(p);
    ASSERT_OK(rollcon_contact_set_creep(c, p.creepage[0], p.creepage[1], p.spin));
    ASSERT_EQ(rollcon_contact_solve(c), ROLLCON_OK) << rollcon_last_error();
    const std::array<double, 3> force = solved_force(c);
    const std::string at = "no frame, wheelset at y = " + std::to_string(p.y);
    rollcon::expect_error(at + ": normal force", -force[2] / p.normal - 1, bound);
    rollcon::expect_error(at + ": longitudinal force over mu Fn", (force[0] - p.longitudinal) / (0.3 * p.normal),
                          bound);
    rollcon::expect_error(at + ": lateral force over mu Fn", (force[1] - p.lateral) / (0.3 * p.normal), bound);
    double pressure = 0, area = 0;
    EXPECT_OK(rollcon_contact_get_stat(c, "max_pressure", &pressure));
    EXPECT_OK(rollcon_contact_get_stat(c, "contact_area", &area));
    rollcon::expect_error(at + ": largest pressure", pressure / p.largest_pressure - 1, 0.01);
    // The flange's patch is slender: half an element of CONTACT's more of its edge counts.
    rollcon::expect_error(at + ": area of contact", area / p.area - 1, 0.12);
    rollcon_contact_release(c);
  }
}
