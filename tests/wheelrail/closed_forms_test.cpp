/// Compares first touch and overlap of spheres and cylinders, in any yaw and roll, with closed forms.

#include <random>

#include "manchester.hpp"
#include "mesh/surface_geometry.hpp"

using namespace rollcon;

namespace {

std::shared_ptr<const ProfileCurve> shape(const char* name, std::vector<double> parameter) {
  return std::make_shared<const ProfileCurve>(profile_of_shape(name, parameter));
}

/// Returns a round rail whose top is at (y, z).
RailShape round_rail(double radius, double y, double z) {
  return {shape("arc", {radius, radius}), {0, y, z}, {-1, 0, 0}, {0, 0, -1}};
}

struct Draw {
  std::mt19937 random{5};
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
};

}  // namespace

TEST(first_touch, sphere_on_a_round_rail) {
  Draw draw;
  double error = 0;
  constexpr int draws = 2000;
  for (int i = 0; i < draws; ++i) {
    const double radius = draw.between(0.5, 500), rail = draw.between(0.5, 500), y = draw.between(-800, 800);
    const ContactSearch search({shape("arc", {radius, radius}), {0, 0, 0}, {0, 1, 0}, radius}, round_rail(rail, y, 0));
    Pose pose = manchester::turned(draw.between(-0.2, 0.2), draw.between(-0.5, 0.5));
    // The wheel is not so far aside that the touching points are on the steep ends.
    const double off = 0.7 * (radius + rail) * draw.between(-1, 1);
    pose.translation = {draw.between(-10, 10), y + off, draw.between(-2, 0) * radius};
    const double reach = std::sqrt((radius + rail + off) * (radius + rail - off));
    const double size = radius + rail + std::abs(y);
    const double due = rail - reach - pose.translation[2];
    error = std::max(error, std::abs(search.first_touch(pose) - due) / size);
  }
  expect_error("spheres on round rails, 2000 draws: first touch over size", error, 1e-14);
}

TEST(first_touch, cylinders_crossed_at_any_angle) {
  Draw draw;
  double error = 0;
  int within = 0;
  constexpr int draws = 2000;
  for (int i = 0; i < draws; ++i) {
    const double radius = draw.between(0.5, 500), rail = draw.between(0.5, 500), half = 0.4 * radius;
    const ContactSearch search({shape("line", {half, 0}), {0, 0, 0}, {0, 1, 0}, radius}, round_rail(rail, 0, 0));
    Pose pose = manchester::turned(draw.between(-0.3, 0.3), draw.between(-0.8, 0.8));
    pose.translation = {draw.between(-10, 10), draw.between(-0.3, 0.3) * half, draw.between(-2, 0) * radius};
    const Vec3 axis = pose.turn({0, 1, 0}), normal = normalized(cross({1, 0, 0}, axis));
    const Vec3 between = pose.translation - Vec3{0, 0, rail};
    const double due = (-(radius + rail) - dot(between, normal)) / normal[2];
    // The point is where the axes are nearest to each other, along the wheel's.
    const Vec3 sunk = between + Vec3{0, 0, due};
    const double at = -(dot(sunk, axis) - dot(sunk, {1, 0, 0}) * axis[0]) / (1 - axis[0] * axis[0]);
    if (std::abs(at) > 0.99 * half) continue;
    ++within;
    error = std::max(error, std::abs(search.first_touch(pose) - due) / (radius + rail));
  }
  std::printf("%d draws touch on the cylinder, not on its rim\n", within);
  EXPECT_GE(within, draws / 2);
  expect_error("crossed cylinders: first touch over size", error, 1e-14);
}

/// The outlines are two circles in the plane of y and z.
TEST(contact_search, overlap_of_a_sphere_and_a_round_rail) {
  Draw draw;
  double at_ends = 0, deep = 0, front = 0, symmetry = 0, angle = 0, lateral = 0, curved = 0;
  constexpr int draws = 500;
  std::vector<OverlapPatch> patch;
  for (int i = 0; i < draws; ++i) {
    const double radius = draw.between(100, 500), rail = draw.between(100, 500), sum = radius + rail;
    ContactSearch search({shape("arc", {radius, radius}), {0, 0, 0}, {0, 1, 0}, radius}, round_rail(rail, 0, 0));
    const double slant = draw.between(-1, 1), depth = 1e-5 * sum;
    Pose pose = manchester::turned(draw.between(-0.2, 0.2), draw.between(-0.1, 0.1));
    const double aside = (sum - depth) * std::sin(slant), above = (sum - depth) * std::cos(slant);
    pose.translation = {3, aside, rail - above};
    search.find(pose, patch);
    ASSERT_EQ(patch.size(), 1U);
    const OverlapPatch& f = patch[0];
    // The values are half of the chord in which the circles cross, and where along the line of centres it is.
    const double d = sum - depth, along = (d * d + rail * rail - radius * radius) / (2 * d);
    const double half = std::sqrt((rail - along) * (rail + along));
    at_ends = std::max(at_ends, std::abs((f.high - f.low) / (2 * half) - 1));
    symmetry = std::max(symmetry, std::abs(f.high + f.low) / half);
    deep = std::max(deep, std::abs(f.overlap / depth - 1));
    angle = std::max(angle, std::abs(f.angle - slant));
    lateral = std::max(lateral, std::abs(f.reference[0] - 3) / half);
    front = std::max(front, std::abs((f.front - f.back) / (2 * std::sqrt(2 * radius * depth)) - 1));
    EXPECT_NEAR(f.share, 1, 0);
    EXPECT_NEAR(length(f.normal), 1, 1e-15);
    EXPECT_NEAR(dot(f.normal, f.lateral), 0, 1e-15);
    curved = std::max({curved, std::abs(f.curvature.along * radius - 1), std::abs(f.curvature.twist * radius),
                       std::abs(f.curvature.across / (1 / radius + 1 / rail) - 1)});
  }
  // The mean angle is not quite that of the line of centres.
  expect_error("circles: greatest overlap", deep, 1e-8);
  expect_error("circles: width of the overlap", at_ends, 1e-4);
  expect_error("circles: reference in the middle, over half the width", symmetry, 3e-2);
  // The rail's curvature is taken within a millionth of a cell of 0.02 radians beside the point.
  expect_error("circles: relative curvatures", curved, 1e-7);
  expect_error("circles: contact angle", angle, 1e-4);
  expect_error("circles: x of the reference over half the width", lateral, 1e-9);
  // The length is the greatest at 24 points of a rule, 0.07 of half the width apart.
  expect_error("circles: length of the overlap", front, 0.07 * 0.07 / 2);
}

TEST(contact_search, lifted_wheels_and_wheels_beside_the_rail_have_no_patch) {
  ContactSearch search(manchester::wheel(), manchester::rail());
  std::vector<OverlapPatch> patch(3);
  Pose pose = manchester::placed(0, 0, 0, 0);
  const double down = search.first_touch(pose);
  pose.translation[2] += down - 1e-9;
  search.find(pose, patch);
  EXPECT_TRUE(patch.empty());
  expect_error("lifted by 1e-9 mm: first touch, mm", search.first_touch(pose) - 1e-9, 1e-12);
  pose.translation[2] += 2e-9;
  search.find(pose, patch);
  ASSERT_EQ(patch.size(), 1U);
  expect_error("sunk by 1e-9 mm: overlap, mm", patch[0].overlap - 1e-9 * std::cos(patch[0].angle), 1e-12);
  EXPECT_FALSE(patch[0].cut);
  for (const double y : {-200.0, 200.0}) {
    pose = manchester::placed(y, 0, 0, 0);
    EXPECT_EQ(search.first_touch(pose), INFINITY);
    search.find(pose, patch);
    EXPECT_TRUE(patch.empty());
  }
}

TEST(contact_search, overlap_that_ends_where_a_profile_does_is_told) {
  // The narrow wheel's rim is on the rail's crown.
  ContactSearch search({shape("line", {20, 0}), {0, 0, -460}, {0, 1, 0}, 460}, round_rail(300, 0, 0));
  std::vector<OverlapPatch> patch;
  Pose pose;
  for (const double y : {0.0, 19.0, 21.0, -21.0}) {
    pose.translation = {0, y, 0};
    pose.translation[2] = search.first_touch(pose) + 0.03;
    search.find(pose, patch);
    ASSERT_EQ(patch.size(), 1U) << y;
    EXPECT_EQ(patch[0].cut, std::abs(y) > 10) << y;
    // The least gap between a horizontal line and a circle is over the crown or at the rim.
    const double off = std::max(std::abs(y) - 20, 0.0);
    pose.translation[2] = 0;
    expect_error("rim at y of the crown: first touch", search.first_touch(pose) - (300 - std::sqrt(9e4 - off * off)),
                 1e-12);
  }
}
