/// Wheel S1002 on rail 60E1 from their profiles and positions: two positions of the Manchester benchmark, beside
/// CONTACT's results on elements of 0.2 mm (case, right wheel at lateral displacements of 0 and 2 mm).

#include "fixture.hpp"
#include "support/testing.hpp"

using namespace capi_test;

namespace {

/// What the benchmark prescribes, and CONTACT's answers; mm and N, x forward, y to the right, z down.
struct Position {
  double y, roll, yaw, z;  ///< of the wheelset
  double at[3], angle;     ///< of the contact
  double normal, largest_pressure, area;
};
constexpr Position positions[] = {
    {0, 0, 0, 0.1981, {0, 751.8726, 0.1252}, -0.0290, 9997, 338.3, 51.6},
    {2, -1.128e-4, 4.8e-3, 0.1529, {-3.368, 740.9147, 0.6548}, -0.0806, 9799, 744.8, 20.2}};

class wheel_and_rail : public ::testing::Test {
 protected:
  void SetUp() override {
    constexpr double shear = 82000, poisson = 0.28, unit = 1;
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    for (rollcon_body** b : {&wheel, &rail}) {
      ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, b));
      ASSERT_OK(rollcon_body_set_elastic(*b, 0, 2 * shear * (1 + poisson), poisson));
    }
    const double centre[3] = {0, 0, -radius}, axis[3] = {0, 1, 0}, ahead[3] = {1, 0, 0};
    ASSERT_OK(rollcon_body_set_profile_shape(wheel, "s1002", 1, &unit));
    ASSERT_OK(rollcon_body_revolve_profile(wheel, centre, axis, radius));
    ASSERT_OK(rollcon_body_set_profile_shape(rail, "60e1", 1, &unit));
    const double origin[3] = {0, 1435.0 / 2 - gauge_side(), 300 * (1 - std::cos(cant))};
    const double down[3] = {0, std::sin(cant), std::cos(cant)};
    ASSERT_OK(rollcon_body_extrude_profile(rail, origin, ahead, down));
  }
  void TearDown() override {
    rollcon_body_release(wheel);
    rollcon_body_release(rail);
    rollcon_context_release(context);
  }

  /// y of the canted rail, turned about its upright top, where it is 14 mm below its highest point.
  double gauge_side() {
    double low = 0, high = 0, point[2], tangent[2], curvature = 0;
    EXPECT_OK(rollcon_body_get_profile_length(rail, &high));
    high /= 2;
    const double c = std::cos(cant), s = std::sin(cant), top = 300 * (c - 1);
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      EXPECT_OK(rollcon_body_get_profile_point(rail, middle, point, tangent, &curvature));
      (point[1] * c - point[0] * s - top > 14 ? low : high) = middle;
    }
    return point[0] * c + point[1] * s;
  }

  rollcon_contact* contact_at(const Position& p, bool framed = true) {
    const double cr = std::cos(p.roll), sr = std::sin(p.roll), cy = std::cos(p.yaw), sy = std::sin(p.yaw);
    const double q[9] = {cy, -sy * cr, sy * sr, sy, cy * cr, -cy * sr, 0, sr, cr};
    double place[3] = {0, p.y, p.z - radius};
    for (std::size_t i = 0; i < 3; ++i) place[i] += 750 * q[3 * i + 1] + radius * q[3 * i + 2];
    const double normal[3] = {0, std::sin(-p.angle), std::cos(p.angle)}, ahead[3] = {1, 0, 0}, mu = 0.3;
    rollcon_contact* c = nullptr;
    EXPECT_OK(rollcon_contact_create(context, wheel, rail, &c));
    EXPECT_OK(rollcon_contact_set_axes(c, p.at, ahead, normal));
    if (framed) {
      EXPECT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, 64, 128, -4, 4, -12, 12));
    }
    EXPECT_OK(rollcon_contact_set_pose(c, 1, q, place));
    EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
    return c;
  }

  static constexpr double radius = 460;
  const double cant = std::atan(1.0 / 40);
  rollcon_context* context = nullptr;
  rollcon_body *wheel = nullptr, *rail = nullptr;
};

}  // namespace

TEST_F(wheel_and_rail, manchester_positions_give_contacts_forces) {
  for (const Position& p : positions) {
    // The position says how far the bodies overlap: nothing else is prescribed.
    rollcon_contact* c = contact_at(p);
    const double force = -solved_force(c)[2];
    double pressure = 0, area = 0;
    EXPECT_OK(rollcon_contact_get_stat(c, "max_pressure", &pressure));
    EXPECT_OK(rollcon_contact_get_stat(c, "contact_area", &area));
    const std::string at = "wheelset at y = " + std::to_string(p.y);
    // z is known to 5e-5 mm, the approaches are 0.016 and 0.025 mm: 0.5 and 0.3 % of the force.
    rollcon::expect_error(at + ": normal force beside CONTACT's", force / p.normal - 1, 0.005);
    rollcon::expect_error(at + ": largest pressure", pressure / p.largest_pressure - 1, 0.005);
    // Boundaries of elements: half an element of CONTACT's around, 0.1 mm of 20.2 mm2 is 8 %, of 51.6 mm2 6 %.
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

// Tread and flange: the library finds the patches on the surfaces and lays the frames.
TEST_F(wheel_and_rail, manchester_positions_without_a_frame) {
  struct Rolling {
    Position position;
    double creep[3], force[3];
    double bound;
  };
  // z is known to 5e-5 mm: the normal force to 0.3 %; on the flange the sideways slope of the profiles counts.
  const Rolling rows[] = {
      {positions[1], {8.752e-4, 4.818e-3, 1.746e-4}, {-517.3, -2893, 9799}, 0.005},
      {{6.5, -4.376e-3, 2.4e-3 * 6.5, -3.0468, {5.801, 718.4931, 10.365}, -1.1591, 15440, 2603, 10.0},
       {1.828e-2, 3.905e-2, 1.937e-3},
       {-1987, -4170, 15440},
       0.012},
  };
  for (const Rolling& r : rows) {
    rollcon_contact* c = contact_at(r.position, false);
    ASSERT_OK(rollcon_contact_set_creep(c, r.creep[0], r.creep[1], r.creep[2]));
    ASSERT_EQ(rollcon_contact_solve(c), ROLLCON_OK) << rollcon_last_error();
    const std::array<double, 3> force = solved_force(c);
    const std::string at = "no frame, wheelset at y = " + std::to_string(r.position.y);
    rollcon::expect_error(at + ": normal force", -force[2] / r.force[2] - 1, r.bound);
    for (const std::size_t i : {0, 1})
      rollcon::expect_error(at + (i == 0 ? ": longitudinal" : ": lateral") + " force over mu Fn",
                            (force[i] - r.force[i]) / (0.3 * r.force[2]), r.bound);
    double pressure = 0, area = 0;
    EXPECT_OK(rollcon_contact_get_stat(c, "max_pressure", &pressure));
    EXPECT_OK(rollcon_contact_get_stat(c, "contact_area", &area));
    rollcon::expect_error(at + ": largest pressure", pressure / r.position.largest_pressure - 1, 0.01);
    // The flange's patch is slender: half an element of CONTACT's more of its edge counts.
    rollcon::expect_error(at + ": area of contact", area / r.position.area - 1, 0.12);
    rollcon_contact_release(c);
  }
}
