/// Tests profiles with sharp edges and overhanging lips, and bad input.

#include "manchester.hpp"
#include "support/error.hpp"

using namespace rollcon;

namespace {

std::shared_ptr<const ProfileCurve> shape(const char* name, std::vector<double> parameter) {
  return std::make_shared<const ProfileCurve>(profile_of_shape(name, parameter));
}

RailShape round_rail(double radius) {
  return {shape("arc", {radius, radius}), {0, 0, 0}, {-1, 0, 0}, {0, 0, -1}};
}

/// Returns the least value of a function with one minimum.
template <class Value>
double least(double a, double b, Value value) {
  for (int i = 0; i < 200; ++i) {
    const double p = a + (b - a) / 3, q = b - (b - a) / 3;
    (value(p) < value(q) ? b : a) = value(p) < value(q) ? q : p;
  }
  return value((a + b) / 2);
}

}  // namespace

/// Two cones meet in a circle, which is all that touches.
TEST(first_touch, sharp_edge_of_a_wheel) {
  constexpr double radius = 300, rail = 80, slant = 0.6, length = 20;
  const double c = std::cos(slant), s = std::sin(slant);
  const std::vector<Vec2> corner{{-length * c, -length * s}, {0, 0}, {length * c, -length * s}};
  std::vector<ProfilePiece> piece(2);
  for (std::size_t i = 0; i < 2; ++i) {
    piece[i].start = corner[i];
    piece[i].along = (1 / length) * (corner[i + 1] - corner[i]);
    piece[i].length = length;
  }
  ContactSearch search({std::make_shared<const ProfileCurve>(piece), {}, {0, 1, 0}, radius}, round_rail(rail));
  std::vector<OverlapPatch> patch;
  for (const double yaw : {0.0, 0.01, -0.03, 0.1})
    for (const double roll : {0.0, 0.05, -0.1}) {
      Pose pose = manchester::turned(roll, yaw);
      pose.translation = {0, 5, -radius};
      const auto gap = [&](double angle) {
        const Vec3 x = pose.place({radius * std::sin(angle), 0, radius * std::cos(angle)});
        return rail - std::sqrt(rail * rail - x[1] * x[1]) - x[2];
      };
      const double due = least(-0.2, 0.2, gap);
      expect_error("edge at yaw " + std::to_string(yaw) + ", roll " + std::to_string(roll) + ": first touch",
                   search.first_touch(pose) - due, 1e-12);
      pose.translation[2] += due + 0.01;
      search.find(pose, patch);
      ASSERT_EQ(patch.size(), 1U);
      EXPECT_FALSE(patch[0].cut);
    }
}

/// The rail's flow of metal hangs over: what lies below the lip is not to be seen.
TEST(first_touch, rolled_over_lip) {
  const double half = std::numbers::pi;
  RailShape rail;
  rail.curve = shape("arcs", {-20, 0, 0, 30, 0, 2 * half, -0.5, 3, 0, half, 1, 8, 0});
  const double radius = 3;
  const WheelShape ball{shape("arc", {radius, radius}), {}, {0, 1, 0}, radius};
  const ContactSearch search(ball, rail);
  Pose pose;
  const struct {
    double y, due;  ///< z of the ball's centre where it touches: the plain, the lip's tip, the lip's top
  } places[] = {{0, -3}, {4, -5 - std::sqrt(16 - 9)}, {6, -5 - std::sqrt(16 - 1)}, {9, -9}};
  for (const auto& p : places) {
    pose.translation = {0, p.y, -20};
    expect_error("ball at y " + std::to_string(p.y) + " by a lip: first touch", search.first_touch(pose) - 20 - p.due,
                 1e-12);
  }
}

TEST(contact_search, bad_shapes_are_refused) {
  const auto message = [](const WheelShape& wheel, const RailShape& rail) {
    try {
      const ContactSearch search(wheel, rail);
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_argument);
      return std::string(e.what());
    }
    return std::string();
  };
  RailShape rail = manchester::rail();
  rail.along = {0, 1, 0};
  EXPECT_NE(message(manchester::wheel(), rail).find("allowed: along x"), std::string::npos);
  WheelShape wheel = manchester::wheel();
  wheel.radius = 1;
  EXPECT_NE(message(wheel, manchester::rail()).find("radius is 1"), std::string::npos);
  wheel = manchester::wheel();
  std::vector<ProfilePiece> upright(1);
  upright[0].along = {0, 1};
  upright[0].length = 5;
  wheel.curve = std::make_shared<const ProfileCurve>(upright);
  EXPECT_NE(message(wheel, manchester::rail()).find("length 5"), std::string::npos);
}

TEST(contact_search, poses_without_sense_have_no_patch) {
  ContactSearch search(manchester::wheel(), manchester::rail());
  std::vector<OverlapPatch> patch;
  Pose pose = manchester::placed(NAN, 0, 0, 0);
  search.find(pose, patch);
  EXPECT_TRUE(patch.empty());
  EXPECT_EQ(search.first_touch(pose), INFINITY);
  // The axle lies along the track.
  pose = manchester::turned(0, std::numbers::pi / 2);
  pose.translation = {0, 717, 0};
  search.find(pose, patch);
  EXPECT_TRUE(patch.empty());
}
