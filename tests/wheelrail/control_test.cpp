/// Tests what a caller may take into hand for comparison: slip from creepages alone, when patches merge, spacings.

#include <cmath>

#include "contact/contact.hpp"
#include "wheel_rail_fixture.hpp"

namespace rollcon {
namespace {

class wheel_control : public wheels {
 protected:
  static Vec3 solved(WheelRail& w) {
    EXPECT_EQ(w.solve(), Status::ok);
    Vec3 force{};
    w.resultant(false, force.data(), nullptr);
    return force;
  }
};

// CONTACT takes slip from creepages at the reference, and finds 0.3 and -880 N on the rail (docs/wheelrail.md).
TEST_F(wheel_control, slip_by_creepages_is_contacts) {
  struct Position {
    double y, z, roll, rate, due;
  };
  for (const Position& p : {Position{0, 0.1981, 0, -4.3481181, 0.2783}, {0.5, 0.1938, -2.304e-5, -4.3474134, -880.0}}) {
    const auto w = make();
    w->set_real("accuracy", 0.005);
    const double position[6] = {0, p.y, p.z, p.roll, 0.0024 * p.y, 0}, velocity[6] = {2000, 0, 0, 0, 0, p.rate};
    w->set_position(position);
    w->set_velocity(velocity);
    const double whole = -solved(*w)[0];
    w->set_int("slip_by_creepages", 1);
    const double alone = -solved(*w)[0];
    std::printf("y %.1f: %.1f N by the surfaces, %.1f by creepages\n", p.y, whole, alone);
    expect_error("longitudinal force by creepages, over friction's", (alone - p.due) / 3000, 0.01);
    EXPECT_GT(std::abs(whole - p.due) / 3000, 0.02) << "the surfaces' slip is the same";
    const double step = 1e-4;
    const auto rate = w->derivative(1);
    double by[2];
    for (const int s : {0, 1}) {
      const double there[6] = {0, p.y + (s == 0 ? -step : step), p.z, p.roll, 0.0024 * p.y, 0};
      w->set_position(there);
      by[s] = -solved(*w)[0];
    }
    const double due = -(by[1] - by[0]) / (2 * step);
    expect_error("derivative by y", (rate.force[0] - due) / std::max(std::abs(due), 1000.0), 1e-3);
  }
}

TEST_F(wheel_control, patches_merge_as_the_caller_says) {
  const auto w = make();
  w->prescribe_vertical(2, 10000);
  w->set_real("accuracy", 0.02);
  place(*w, 5.1);
  solved(*w);
  EXPECT_EQ(w->patches(), 2);
  w->set_real("merge_distance", 100);
  w->set_real("merge_angle", 1.5);
  w->solve();
  EXPECT_EQ(w->patches(), 1);
  w->set_real("merge_distance", 0.01);
  w->set_real("merge_angle", 0.01);
  solved(*w);
  EXPECT_EQ(w->patches(), 2);
  refused([&] { w->set_real("merge_angle", 2); }, Status::err_option, {"merge_angle", "1.6"});
}

TEST_F(wheel_control, lattices_have_the_spacing_that_is_given) {
  const auto w = make(), fine = make();
  for (WheelRail* each : {w.get(), fine.get()}) each->prescribe_vertical(2, 10000);
  fine->set_real("accuracy", 0.005);
  const Vec3 due = solved(*fine);
  w->set_real("spacing_along", 0.3);
  w->set_real("spacing_across", 0.4);
  const Vec3 force = solved(*w);
  expect_error("force on a lattice of .3 x .4 mm, over friction's", length(force - due) / 3000, 0.01);
  const auto contact = w->contact(0);
  std::vector<double> point(static_cast<std::size_t>(3 * contact->nodes()));
  contact->field(Field::point, InAxes::local, contact->nodes() * 3, point.data());
  const double along = point[3] - point[0];
  EXPECT_LE(along, 0.3 * (1 + 1e-9));
  EXPECT_GT(along, 0.22);
}

}  // namespace
}  // namespace rollcon
