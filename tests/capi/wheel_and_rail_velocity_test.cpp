/// Compares creepages of wheel and rail from velocities with the Manchester benchmark; tests any axes and units, frames
/// that the library makes, and steps of a time loop.

#include "support/testing.hpp"
#include "wheel_and_rail_fixture.hpp"

using namespace capi_test;

namespace {

struct Answer {
  Vector force{}, moment{}, creep{};
  double power = 0;
};

Answer answer(rollcon_contact* c, std::int32_t status = ROLLCON_OK) {
  Answer a;
  EXPECT_EQ(rollcon_contact_solve(c), status) << rollcon_last_error();
  EXPECT_OK(rollcon_contact_get_resultant(c, ROLLCON_LOCAL, a.force.data(), a.moment.data()));
  EXPECT_OK(rollcon_contact_get_motion(c, nullptr, a.creep.data()));
  EXPECT_OK(rollcon_contact_get_stat(c, "friction_power_balance", &a.power));
  return a;
}

/// Compares forces, moments in mm and creepages per mm, over the largest of each.
double difference(const Answer& a, const Answer& b) {
  double worst = 0;
  for (const auto& [v, w] :
       {std::pair{&a.force, &b.force}, std::pair{&a.moment, &b.moment}, std::pair{&a.creep, &b.creep}}) {
    double largest = 0, off = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      largest = std::max(largest, std::abs((*w)[i]));
      off = std::max(off, std::abs((*v)[i] - (*w)[i]));
    }
    worst = std::max(worst, off / largest);
  }
  return worst;
}

}  // namespace

TEST_F(wheel_and_rail, velocities_give_contacts_creepages_and_forces) {
  for (const Position& p : {positions[1], positions[2]}) {
    const bool flange = p.half_length > p.half_width;
    rollcon_contact* c = contact_at(p, flange ? 160 : 64, flange ? 64 : 128);
    roll(c, p);
    EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_FORCE, p.normal));
    const Answer a = answer(c);
    const std::string at = "wheelset at y = " + std::to_string(p.y);
    // CONTACT's numbers have four digits, positions are known to 5e-5 mm.
    rollcon::expect_error(at + ": longitudinal creepage beside CONTACT's", -a.creep[0] / p.creepage[0] - 1, 5e-4);
    rollcon::expect_error(at + ": lateral creepage", -a.creep[1] / p.creepage[1] - 1, 5e-4);
    rollcon::expect_error(at + ": spin", -a.creep[2] / p.spin - 1, 5e-4);
    rollcon::expect_error(at + ": longitudinal force", -a.force[0] / p.longitudinal - 1, 0.01);
    rollcon::expect_error(at + ": lateral force", -a.force[1] / p.lateral - 1, 0.01);
    // CONTACT sums over elements; its forces times creepages give 28.8 and 404.9 W.
    rollcon::expect_error(at + ": friction power", a.power / 1000 / p.power - 1, 0.02);
    // The creepage is over the mean of the speeds of both surfaces.
    double speed = 0;
    EXPECT_OK(rollcon_contact_get_stat(c, "rolling_speed", &speed));
    rollcon::expect_error(at + ": rolling speed",
                          speed / (forward_speed * (1 - 0.5 * a.creep[0] * speed / forward_speed)) - 1, 1e-12);
    rollcon_contact_release(c);
  }
}

TEST_F(wheel_and_rail, velocities_in_any_axes_units_and_on_the_left_side) {
  const Position& p = positions[2];
  rollcon_contact* c = contact_at(p, 32, 32);
  roll(c, p);
  const Answer right = answer(c);
  rollcon_contact_release(c);

  turn = turned({0.3, -1, 0.7}, 1.1);
  shift = {310, -250, 40};
  c = contact_at(p, 32, 32);
  roll(c, p);
  rollcon::expect_error("turned and shifted scene", difference(answer(c), right), 1e-9);
  rollcon_contact_release(c);
  turn = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  shift = {};

  unit = 1e-3;
  make_bodies();
  c = contact_at(p, 32, 32);
  roll(c, p);
  Answer in_metres = answer(c);
  for (double& m : in_metres.moment) m /= unit;
  in_metres.creep[2] *= unit;
  rollcon::expect_error("in metres", difference(in_metres, right), 1e-9);
  rollcon_contact_release(c);
  unit = 1;

  side = -1;
  make_bodies();
  c = contact_at(p, 32, 32);
  roll(c, p);
  Answer left = answer(c);
  left.force[1] *= -1;
  left.moment[0] *= -1;
  left.moment[2] *= -1;
  left.creep[1] *= -1;
  left.creep[2] *= -1;
  rollcon::expect_error("left wheel", difference(left, right), 1e-9);
  rollcon_contact_release(c);
}

using wheel_and_rail_long = wheel_and_rail;

TEST_F(wheel_and_rail_long, velocities_on_frames_that_the_library_makes) {
  const Position& p = positions[1];
  rollcon_contact *c = contact_without_frame(p), *fine = contact_at(p, 128, 512);
  roll(c, p, 0.9995);
  roll(fine, p, 0.9995);
  const Answer found = answer(c), wanted = answer(fine);
  const double bound = 0.01 * -wanted.force[2];
  rollcon::expect_error("frame found: longitudinal force, over 1 % of the load",
                        (found.force[0] - wanted.force[0]) / bound, 1);
  rollcon::expect_error("frame found: lateral force", (found.force[1] - wanted.force[1]) / bound, 1);
  // The creepages are those over the origin, whatever the frame.
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.creep[i], wanted.creep[i], 1e-12);

  // Another velocity with the frames found before gives what a new contact finds.
  roll(c, p);
  rollcon_contact* fresh = contact_without_frame(p);
  roll(fresh, p);
  const Answer second = answer(c), first = answer(fresh);
  rollcon::expect_error("frames of the step before", difference(second, first), 1e-8);
  EXPECT_GT(std::abs(first.force[0] - found.force[0]), bound);
  for (rollcon_contact* each : {c, fine, fresh}) rollcon_contact_release(each);
}

TEST_F(wheel_and_rail, steps_of_a_time_loop_are_solves_of_new_contacts) {
  const Position& p = positions[1];
  rollcon_contact* c = contact_at(p, 24, 48);
  double worst = 0;
  for (int step = 0; step < 8; ++step) {
    Position now = p;
    // The wheelset moves, turns faster, or is told twice, by turns.
    now.y += 0.01 * (step / 2);
    const double faster = 1 + 1e-3 * (step % 3);
    rollcon_contact* fresh = contact_at(now, 24, 48);
    const Matrix q = attitude(now);
    const Vector at = in_track(0, now.y, now.z - nominal) + q * in_track(0, 750, nominal);
    ASSERT_OK(rollcon_contact_set_pose(c, 1, q.data(), at.data()));
    roll(c, now, faster);
    roll(fresh, now, faster);
    worst = std::max(worst, difference(answer(c), answer(fresh)));
    rollcon_contact_release(fresh);
  }
  rollcon::expect_error("warm steps beside new contacts", worst, 1e-8);
  double slips = 0, gaps = 0;
  ASSERT_OK(rollcon_contact_get_stat(c, "slip_builds", &slips));
  ASSERT_OK(rollcon_contact_get_stat(c, "gap_builds", &gaps));
  EXPECT_EQ(slips, 8);
  EXPECT_EQ(gaps, 4);
  rollcon_contact_release(c);
}
