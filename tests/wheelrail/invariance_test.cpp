/// Tests that what the search finds depends neither on where, on which side and in what units, nor on the turning of
/// the wheel.

#include "manchester.hpp"

using namespace rollcon;
using namespace rollcon::manchester;

namespace {

struct Case {
  double y, sunk;
  std::size_t patches;  ///< number of patches, with those that share a region
};
/// The cases have one patch, two that are one, two that share a region with one, and tread and flange.
constexpr Case cases[] = {{0.3, 0.03, 1}, {5.0, 0.03, 3}, {4.9, 0.03, 2}, {6.5, 0.03, 2}};

Pose pose_of(const Case& c) {
  static const ContactSearch search(wheel(), rail());
  Pose pose = placed(c.y, 0, 2.4e-3 * c.y, 0);
  pose.translation[2] += search.first_touch(pose) + c.sunk;
  return pose;
}

using Patches = std::vector<OverlapPatch>;

Patches found(const WheelShape& w, const RailShape& r, const Pose& pose) {
  ContactSearch search(w, r);
  Patches patch;
  search.find(pose, patch);
  return patch;
}

/// Returns the difference of patches in another place, mirrored (side -1) or not, in another unit; relative to the
/// wheel's radius.
double difference(const Patches& a, const Patches& b, double unit, double side, const Vec3& shift) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0;
  const auto compare = [&](double p, double q, double scale) { worst = std::max(worst, std::abs(p - q) / scale); };
  const double size = radius * unit;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const OverlapPatch &p = a[i], &q = b[i];
    for (std::size_t c = 0; c < 3; ++c)
      compare((c == 1 ? side : 1) * unit * p.reference[c] + shift[c], q.reference[c], size);
    compare(side * p.angle, q.angle, 1);
    compare(unit * p.overlap, q.overlap, size);
    compare(unit * (side > 0 ? p.low : -p.high), q.low, size);
    compare(unit * (side > 0 ? p.high : -p.low), q.high, size);
    compare(unit * p.back, q.back, size);
    compare(unit * p.front, q.front, size);
    compare(p.share, q.share, 1);
    compare(unit * p.rolling_radius, q.rolling_radius, size);
    compare(unit * p.wheel_y, q.wheel_y, size);
    compare(p.curvature.along, unit * q.curvature.along, 1 / size);
    compare(p.curvature.across, unit * q.curvature.across, 1);
    compare(side * p.curvature.twist, unit * q.curvature.twist, 1 / size);
    EXPECT_EQ(p.cut, q.cut);
  }
  return worst;
}

/// Depths lose digits: z of 460 and y of 750 are added to overlaps of 0.03, and widths go with their root.
constexpr double bound = 1e-9;

}  // namespace

TEST(contact_search_elsewhere, mirrored) {
  for (const Case& c : cases) {
    const Pose pose = pose_of(c);
    const Patches right = found(wheel(), rail(), pose);
    ASSERT_EQ(right.size(), c.patches);
    // The points of the profiles are on the other side: y of both is turned round.
    WheelShape w = wheel();
    RailShape r = rail();
    w.axis = {0, -1, 0};
    r.along = {-1, 0, 0};
    r.origin[1] *= -1;
    r.down[1] *= -1;
    Pose mirrored = turned(0, -2.4e-3 * c.y);
    mirrored.translation = {pose.translation[0], -pose.translation[1], pose.translation[2]};
    Patches left = found(w, r, mirrored);
    std::reverse(left.begin(), left.end());
    // Patches that share a region are ordered by their ends.
    const auto by_place = [](Patches& p, double side) {
      std::sort(p.begin(), p.end(), [side](const OverlapPatch& a, const OverlapPatch& b) {
        return side * a.reference[1] < side * b.reference[1];
      });
    };
    Patches sorted = right;
    by_place(sorted, 1);
    by_place(left, -1);
    expect_error("mirrored at y " + std::to_string(c.y), difference(sorted, left, 1, -1, {0, 0, 0}), bound);
  }
}

TEST(contact_search_elsewhere, shifted_and_in_other_units) {
  const Vec3 shift{13, -2.5, 7};
  for (const Case& c : cases) {
    Pose pose = pose_of(c);
    const Patches here = found(wheel(), rail(), pose);
    RailShape r = rail();
    r.origin = r.origin + shift;
    pose.translation = pose.translation + shift;
    const std::string at = " at y " + std::to_string(c.y);
    expect_error("shifted" + at, difference(here, found(wheel(), r, pose), 1, 1, shift), bound);
    constexpr double unit = 1e-3;
    pose = pose_of(c);
    pose.translation = unit * pose.translation;
    expect_error("in m" + at, difference(here, found(wheel(unit), rail(unit), pose), unit, 1, {0, 0, 0}), bound);
  }
}

TEST(contact_search_elsewhere, wheel_turned_about_its_axle) {
  for (const Case& c : cases) {
    Pose pose = pose_of(c);
    const Patches here = found(wheel(), rail(), pose);
    const Vec3 centre = pose.place(wheel().centre);
    Pose turn;
    turn.rotation = {{{std::cos(2.0), 0, std::sin(2.0)}, {0, 1, 0}, {-std::sin(2.0), 0, std::cos(2.0)}}};
    Pose rolled = pose;
    const std::array<Vec3, 3> q = pose.rotation;
    for (std::size_t i = 0; i < 3; ++i) rolled.rotation[i] = turn.turn_back(q[i]);
    rolled.translation = {0, 0, 0};
    rolled.translation = centre - rolled.place(wheel().centre);
    expect_error("turned at y " + std::to_string(c.y),
                 difference(here, found(wheel(), rail(), rolled), 1, 1, {0, 0, 0}), bound);
  }
}

/// The place where outlines cross does not depend on what is vertical: track and wheelset are rolled together.
TEST(contact_search_elsewhere, rolled_with_the_track) {
  constexpr double roll = 0.05;
  const double c = std::cos(roll), s = std::sin(roll);
  Pose track;
  track.rotation = {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
  for (const Case& k : cases) {
    if (k.patches == 3) continue;  // weights go by what is measured along z
    const Pose pose = pose_of(k);
    const Patches here = found(wheel(), rail(), pose);
    RailShape r = rail();
    r.origin = track.turn(r.origin);
    r.down = track.turn(r.down);
    Pose rolled = pose;
    for (std::size_t j = 0; j < 3; ++j) {
      Vec3 column{pose.rotation[0][j], pose.rotation[1][j], pose.rotation[2][j]};
      column = track.turn(column);
      for (std::size_t i = 0; i < 3; ++i) rolled.rotation[i][j] = column[i];
    }
    rolled.translation = track.turn(pose.translation);
    const Patches there = found(wheel(), r, rolled);
    ASSERT_EQ(here.size(), there.size());
    double ends = 0, deep = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      const auto ends_of = [](const OverlapPatch& p) { return p.high - p.low; };
      ends = std::max(ends, std::abs(ends_of(here[i]) / ends_of(there[i]) - 1));
      deep = std::max(deep, std::abs(here[i].overlap / there[i].overlap - 1));
    }
    // The ends lie along the lateral axes, which differ a little like the means of the angles; depths go by depth over
    // radius.
    expect_error("rolled at y " + std::to_string(k.y) + ": widths", ends, 2e-3);
    expect_error("rolled at y " + std::to_string(k.y) + ": overlaps", deep, 1e-3);
  }
}
