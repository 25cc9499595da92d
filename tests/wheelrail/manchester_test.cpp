/// Compares the patches of the Manchester benchmark with CONTACT's.

#include "manchester.hpp"

#include "geometry/profile_surface.hpp"

using namespace rollcon;
using namespace rollcon::manchester;

TEST(contact_search, manchester_reference_points) {
  ContactSearch search(wheel(), rail());
  std::vector<OverlapPatch> patch;
  for (const Position& p : positions) {
    // A left wheel is a right one in the mirror.
    search.find(placed(p.side * p.y, p.side * p.roll, p.side * 2.4e-3 * p.y, p.z), patch);
    const std::string at = p.wheel;
    if (p.y == 5) {
      // CONTACT solves two overlaps as one, 6.8 mm apart; their middle is weighted by the depth to the power of 2.5.
      ASSERT_EQ(patch.size(), 2U);
      double weight = 0, y = 0;
      for (const OverlapPatch& f : patch) {
        const double w = std::pow(f.overlap, 2.5) * (f.high - f.low);
        weight += w;
        y += w * f.reference[1];
      }
      expect_error(at + ": y of the reference, mm", y / weight - p.reference[1], 0.05);
      continue;
    }
    ASSERT_EQ(patch.size(), 1U) << p.wheel;
    const OverlapPatch& f = patch[0];
    expect_error(at + ": share", f.share - 1, 0);
    expect_error(at + ": x of the reference, mm", f.reference[0] - p.reference[0], 0.01);
    expect_error(at + ": y of the reference, mm", p.side * f.reference[1] - p.reference[1], 0.01);
    expect_error(at + ": z of the reference, mm", f.reference[2] - p.reference[2], 0.01);
    expect_error(at + ": contact angle", p.side * f.angle - p.angle, 1e-4);
    EXPECT_FALSE(f.cut);
  }
}

/// Returns the lowest point of the wheel's surface in the plane of this y, by lines along z.
Vec3 lowest(const RevolvedProfile& surface, const Pose& pose, const Vec3& near) {
  const Vec3 down = pose.turn_back({0, 0, 1});
  const auto at = [&](double x) {
    const auto t = surface.distance(pose.to_body({x, near[1], near[2]}), down, {0, 0, 0});
    return Vec3{x, near[1], near[2] + t.value_or(-1e30)};
  };
  double a = near[0] - 5, b = near[0] + 5;
  for (int i = 0; i < 100; ++i) {
    const double p = a + (b - a) / 3, q = b - (b - a) / 3;
    (at(p)[2] < at(q)[2] ? a : b) = at(p)[2] < at(q)[2] ? p : q;
  }
  return at(a);
}

TEST(contact_search, rolling_radius_is_that_of_the_outline_above_the_reference) {
  const WheelShape shape = wheel();
  const RevolvedProfile surface(shape.curve, shape.centre, shape.axis, shape.radius);
  ContactSearch search(shape, rail());
  std::vector<OverlapPatch> patch;
  for (const Position& p : positions) {
    if (p.side < 0) continue;
    const Pose pose = placed(p.y, p.roll, 2.4e-3 * p.y, p.z);
    search.find(pose, patch);
    ASSERT_GE(patch.size(), 1U) << p.wheel;
    const Vec3 x = pose.to_body(lowest(surface, pose, patch[0].reference)) - shape.centre;
    const std::string at = p.wheel;
    // A search by values alone has x to the root of rounding only, 1e-5 mm.
    expect_error(at + ": rolling radius, mm", patch[0].rolling_radius - std::hypot(x[0], x[2]), 1e-6);
    expect_error(at + ": y of the wheel's profile, mm", patch[0].wheel_y - x[1], 1e-6);
  }
}
