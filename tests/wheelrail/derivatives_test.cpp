/// Compares derivatives of the totals by position and velocity with differences of solves.

#include <algorithm>
#include <array>
#include <cmath>

#include "wheel_rail_fixture.hpp"

namespace rollcon {
namespace {

class derivatives : public wheels {
 protected:
  using Row = std::array<double, 7>;

  void put(WheelRail& w, double y, double z, std::size_t entry, double by) {
    std::array<double, 6> position{0, y, z, -5e-5 * y, 2.4e-3 * y, 0}, velocity{2000, 1, 0.5, 2e-3, 1e-3, -4.3459};
    (entry < 6 ? position : velocity)[entry % 6] += by;
    w.set_position(position.data());
    w.set_velocity(velocity.data());
  }
  static Row totals(const WheelRail& w) {
    Row t{};
    w.resultant(false, t.data(), t.data() + 3);
    t[6] = w.stat("z");
    return t;
  }
  static Row derivative(WheelRail& w, std::size_t entry) {
    const WheelRail::Derivative d = w.derivative(static_cast<std::int32_t>(entry));
    return {d.force[0], d.force[1], d.force[2], d.moment[0], d.moment[1], d.moment[2], d.z};
  }
  /// Returns the greatest difference of derivatives from central differences over such steps of lengths (angles: over
  /// the radius; velocities in lengths a second), over the greatest of them: forces over mu N, moments over that times
  /// the radius, z over a tenth. It takes six entries from `first` on.
  double worst(WheelRail& w, int how, double y, double z, std::size_t first, double step) {
    double most = 0;
    for (std::size_t entry = first; entry < first + 6; ++entry) {
      const bool none = entry == 0 || entry == 5 || (entry == 2 && how == 2);
      const double by = entry % 6 < 3 ? step : step / 460;
      put(w, y, z, entry, 0);
      EXPECT_EQ(w.solve(), Status::ok);
      const Row own = derivative(w, entry);
      if (none) {
        EXPECT_EQ(own, Row{});
        continue;
      }
      Row side[2];
      for (std::size_t s = 0; s < 2; ++s) {
        put(w, y, z, entry, s == 0 ? -by : by);
        EXPECT_EQ(w.solve(), Status::ok);
        side[s] = totals(w);
      }
      double scale = 1e-3, off = 0;
      for (std::size_t c = 0; c < 7; ++c) {
        const double unit = c < 3 ? mu * 10000 : c < 6 ? mu * 10000 * 460 : 0.1;
        const double difference = (side[1][c] - side[0][c]) / (2 * by);
        scale = std::max(scale, std::abs(difference) / unit);
        off = std::max(off, std::abs(own[c] - difference) / unit);
      }
      most = std::max(most, off / scale);
    }
    return most;
  }
};

// Strips move with the contact, as they do in differences. By force these have the error to which the force is met, a
// millionth.
TEST_F(derivatives, are_those_of_differences) {
  for (const double y : {2.0, 5.0}) {
    auto w = make();
    w->set_real("accuracy", 0.02);
    w->prescribe_vertical(2, 10000);
    put(*w, y, 0, 0, 0);
    ASSERT_EQ(w->solve(), Status::ok);
    const double z = w->stat("z");
    const std::string at = "y " + std::to_string(y);
    w->prescribe_vertical(1, 0);
    expect_error(at + ", by height: velocity", worst(*w, 1, y, z, 6, 0.02), 1e-4);
    expect_error(at + ", by height: position", worst(*w, 1, y, z, 0, 1e-3), 2e-3);
    if (y != 2) continue;
    w->prescribe_vertical(2, 10000);
    expect_error(at + ", by force: velocity", worst(*w, 2, y, z, 6, 0.5), 5e-3);
    expect_error(at + ", by force: position", worst(*w, 2, y, z, 0, 1e-3), 0.04);
  }
}

TEST_F(derivatives, by_table_are_those_of_differences) {
  auto w = make();
  w->set_table(std::shared_ptr<const ForceTable>(ForceTable::standard(context)));
  w->set_int("hertzian", 1);
  w->prescribe_vertical(2, 10000);
  put(*w, 2, 0, 0, 0);
  ASSERT_EQ(w->solve(), Status::ok);
  const double z = w->stat("z");
  w->prescribe_vertical(1, 0);
  // The steps are others than the library's own (0.02). Coefficients of tables are in single precision, which is 1e-4
  // of the smallest of these derivatives; truncation is as much.
  expect_error("velocity", worst(*w, 1, 2, z, 6, 0.05), 5e-4);
  expect_error("position", worst(*w, 1, 2, z, 0, 1e-3), 5e-3);
}

// The derivatives agree in the mirror, to rounding, and asking changes nothing that follows.
TEST_F(derivatives, of_a_left_wheel_are_mirrored) {
  auto right = make(), left = make(-1);
  for (WheelRail* w : {right.get(), left.get()}) {
    const double side = w == right.get() ? 1 : -1;
    const double position[6] = {0, 2 * side, 0, 0, 4e-3 * side, 0}, velocity[6] = {2000, side, 0, 0, 0, -4.3459};
    w->set_position(position);
    w->set_velocity(velocity);
    w->prescribe_vertical(2, 10000);
    ASSERT_EQ(w->solve(), Status::ok);
  }
  const double before = right->patch_stat(0, "lateral_force");
  for (std::size_t entry = 0; entry < 12; ++entry) {
    const Row r = derivative(*right, entry), l = derivative(*left, entry);
    const double own = entry % 6 == 1 || entry % 6 == 3 || entry % 6 == 4 ? -1 : 1, sign[7] = {1, -1, 1, -1, 1, -1, 1};
    for (std::size_t c = 0; c < 7; ++c) EXPECT_NEAR(l[c], own * sign[c] * r[c], 1e-9 * std::abs(r[c]) + 1e-12);
  }
  EXPECT_EQ(right->patch_stat(0, "lateral_force"), before);
  auto other = right->copy();
  for (WheelRail* w : {right.get(), other.get()}) {
    place(*w, 3);
    ASSERT_EQ(w->solve(), Status::ok);
  }
  EXPECT_EQ(right->patch_stat(0, "lateral_force"), other->patch_stat(0, "lateral_force"));
}

TEST_F(derivatives, are_refused_by_name) {
  auto w = make();
  refused([&] { w->derivative(0); }, Status::err_state, {"rollcon_wheelrail_solve"});
  place(*w, 2);
  ASSERT_GE(static_cast<int>(w->solve()), 0);
  refused([&] { w->derivative(12); }, Status::err_argument, {"12", "0 to 5"});
}

}  // namespace
}  // namespace rollcon
