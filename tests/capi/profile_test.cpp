/// Tests profiles of bodies through the public interface: gaps from surfaces and poses, inputs, files.

#include <random>

#include "fixture.hpp"
#include "space.hpp"
#include "support/testing.hpp"

using namespace capi_test;

namespace {

constexpr double zero[3] = {0, 0, 0}, up[3] = {0, 0, 1}, ahead[3] = {1, 0, 0}, aside[3] = {0, 1, 0};

/// Holds two elastic half-spaces; n = e_z points out of body 1, below, into body 2. The whole scene stands anywhere.
class profile : public ::testing::Test {
 protected:
  static constexpr int n = 32;

  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    for (rollcon_body** b : {&lower, &upper}) {
      ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, b));
      ASSERT_OK(rollcon_body_set_elastic(*b, 0, 2.1e5, 0.3));
    }
  }
  void TearDown() override {
    rollcon_body_release(lower);
    rollcon_body_release(upper);
    rollcon_context_release(context);
  }

  rollcon_contact* make(double half_x, double half_y, double approach) {
    rollcon_contact* c = nullptr;
    const double mu = 0.3;
    EXPECT_OK(rollcon_contact_create(context, lower, upper, &c));
    const Vector rolling = place * Vector{1, 0, 0}, normal = place * Vector{0, 0, 1};
    EXPECT_OK(rollcon_contact_set_axes(c, shift.data(), rolling.data(), normal.data()));
    EXPECT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, n, n, -half_x, half_x, -half_y, half_y));
    EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
    EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, approach));
    EXPECT_OK(rollcon_contact_set_creep(c, 1e-4, 0, 0));
    EXPECT_OK(rollcon_contact_set_pose(c, 1, place.data(), shift.data()));
    EXPECT_OK(rollcon_contact_set_pose(c, 2, place.data(), shift.data()));
    return c;
  }
  Vector force(rollcon_contact* c) {
    Vector f{};
    EXPECT_OK(rollcon_contact_solve(c));
    EXPECT_OK(rollcon_contact_get_resultant(c, ROLLCON_LOCAL, f.data(), nullptr));
    return f;
  }
  /// Returns the force with gap(x, y) given node by node.
  template <class Gap>
  Vector force_of(double half_x, double half_y, double approach, Gap gap) {
    rollcon_contact* c = make(half_x, half_y, approach);
    std::vector<double> h;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) h.push_back(gap(half_x * (2.0 * i / n - 1), half_y * (2.0 * j / n - 1)));
    EXPECT_OK(rollcon_contact_set_gap(c, static_cast<std::int64_t>(h.size()), h.data()));
    const Vector f = force(c);
    rollcon_contact_release(c);
    return f;
  }
  void expect_alike(const std::string& what, const Vector& f, const Vector& due, double bound) {
    EXPECT_LT(due[2], 0);
    rollcon::expect_error(what + ": normal force", (f[2] - due[2]) / due[2], bound);
    rollcon::expect_error(what + ": tangential force over normal force", (f[0] - due[0]) / due[2], bound);
  }
  void anywhere(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    place = turned({any(random), any(random), any(random)}, 3 * any(random));
    shift = {100 * any(random), 100 * any(random), 100 * any(random)};
  }

  rollcon_context* context = nullptr;
  rollcon_body *lower = nullptr, *upper = nullptr;
  Matrix place{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Vector shift{};
};

}  // namespace

TEST_F(profile, sphere_on_plane_is_hertz_at_any_pose) {
  constexpr double radius = 100, approach = 0.01;
  const double below[3] = {0, 0, -radius}, shape[2] = {radius, radius}, a = std::sqrt(radius * approach);
  ASSERT_OK(rollcon_body_set_profile_shape(lower, "arc", 2, shape));
  ASSERT_OK(rollcon_body_revolve_profile(lower, below, aside, radius));
  for (unsigned seed = 1; seed < 6; ++seed) {
    anywhere(seed);
    rollcon_contact* c = make(1.2 * a, 1.2 * a, approach);
    const Vector f = force(c);
    rollcon_contact_release(c);
    const double hertz = 4.0 / 3 * 2.1e5 / (2 * 0.91) * std::sqrt(radius) * std::pow(approach, 1.5);
    rollcon::expect_error("sphere: force over Hertz's", f[2] / -hertz - 1, 0.01);
    const auto gap = [&](double x, double y) {
      return (x * x + y * y) / (radius + std::sqrt(radius * radius - x * x - y * y));
    };
    expect_alike("sphere", f, force_of(1.2 * a, 1.2 * a, approach, gap), 1e-9);
    // The quadratic gap differs by (x^2 + y^2)^2 / 8 R^3, that is by a^2 / 4 R^2 of the approach at most.
    c = make(1.2 * a, 1.2 * a, approach);
    ASSERT_OK(rollcon_contact_set_gap_quadratic(c, 0.5 / radius, 0.5 / radius, 0));
    expect_alike("sphere, quadratic gap", f, force(c), 2 * a * a / (4 * radius * radius));
    rollcon_contact_release(c);
  }
}

TEST_F(profile, crossed_cylinders_have_the_gap_of_their_circles) {
  constexpr double r1 = 60, r2 = 90, angle = 0.8, approach = 0.01;
  const double below[3] = {0, 0, -r1}, above[3] = {0, 0, r2}, line[2] = {30, 0};
  const double axis2[3] = {-std::sin(angle), std::cos(angle), 0};
  ASSERT_OK(rollcon_body_set_profile_shape(lower, "line", 2, line));
  ASSERT_OK(rollcon_body_revolve_profile(lower, below, aside, r1));
  ASSERT_OK(rollcon_body_set_profile_shape(upper, "line", 2, line));
  ASSERT_OK(rollcon_body_revolve_profile(upper, above, axis2, r2));
  const auto height = [](double r, double d) { return d * d / (r + std::sqrt(r * r - d * d)); };
  const auto gap = [&](double x, double y) {
    return height(r1, x) + height(r2, x * std::cos(angle) + y * std::sin(angle));
  };
  for (unsigned seed = 11; seed < 14; ++seed) {
    anywhere(seed);
    rollcon_contact* c = make(1.5, 2.5, approach);
    const Vector f = force(c);
    expect_alike("crossed cylinders", f, force_of(1.5, 2.5, approach, gap), 1e-9);
    // The second body as an extruded half circle gives the same.
    rollcon_contact_release(c);
    rollcon_body* other = nullptr;
    const double half[2] = {-r2, r2};
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &other));
    ASSERT_OK(rollcon_body_set_elastic(other, 0, 2.1e5, 0.3));
    ASSERT_OK(rollcon_body_set_profile_shape(other, "arc", 2, half));
    ASSERT_OK(rollcon_body_extrude_profile(other, zero, axis2, up));
    std::swap(upper, other);
    c = make(1.5, 2.5, approach);
    expect_alike("crossed cylinders, one extruded", force(c), f, 1e-9);
    rollcon_contact_release(c);
    std::swap(upper, other);
    rollcon_body_release(other);
  }
}

// A roller crowned by a circle, tilted and skewed, rolls on a groove along the rolling direction.
TEST_F(profile, tilted_crowned_roller_on_a_raceway) {
  constexpr double radius = 12, crown = 800, groove = 1000, half = 6, tilt = 1e-3, skew = 5e-3, approach = 0.012;
  const double shape[2] = {crown, half}, hollow[2] = {groove, 10}, centre[3] = {0, 0, radius};
  const double down[3] = {0, 0, 1};
  ASSERT_OK(rollcon_body_set_profile_shape(lower, "arc", 2, hollow));
  ASSERT_OK(rollcon_body_extrude_profile(lower, zero, ahead, down));
  ASSERT_OK(rollcon_body_set_profile_shape(upper, "arc", 2, shape));
  ASSERT_OK(rollcon_body_revolve_profile(upper, centre, aside, radius));
  const Matrix q1 = turned({1, 0, 0}, tilt), q2 = turned({0, 0, 1}, skew);
  Matrix q{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) q[3 * i + j] += q1[3 * i + k] * q2[3 * k + j];
  rollcon_contact* c = make(0.5, 5.5, approach);
  ASSERT_OK(rollcon_contact_set_pose(c, 2, q.data(), zero));
  const Vector f = force(c);

  // The height at each node is that at which the distance from the roller's tilted axis is that of its crown, halved.
  const Vector axis = q * Vector{0, 1, 0}, origin = q * Vector{0, 0, radius};
  const auto outside = [&](double x, double y, double z) {
    const Vector r{x - origin[0], y - origin[1], z - origin[2]};
    const double a = r[0] * axis[0] + r[1] * axis[1] + r[2] * axis[2];
    const double away = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] - a * a);
    return away - (radius - crown + std::sqrt(crown * crown - a * a));
  };
  const auto gap = [&](double x, double y) {
    double low = -2, high = 2;
    for (int i = 0; i < 100; ++i) (outside(x, y, (low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    return low - (std::sqrt(groove * groove - y * y) - groove);
  };
  expect_alike("tilted roller", f, force_of(0.5, 5.5, approach, gap), 1e-9);
  // Another pose counts at once, and makes the gap alone anew; the old pose brings the first force back.
  ASSERT_OK(rollcon_contact_set_pose(c, 2, place.data(), zero));
  EXPECT_GT(std::abs(force(c)[2] / f[2] - 1), 1e-3);
  ASSERT_OK(rollcon_contact_set_pose(c, 2, q.data(), zero));
  expect_alike("tilted roller, again", force(c), f, 1e-8);
  for (const char* built : {"frame_builds", "compliance_builds"}) {
    double times = 0;
    ASSERT_OK(rollcon_contact_get_stat(c, built, &times));
    EXPECT_EQ(times, 1) << built;
  }
  // A given gap goes before the profiles'.
  ASSERT_OK(rollcon_contact_set_gap_quadratic(c, 1 / (2 * radius), 1e-3, 0));
  EXPECT_GT(std::abs(force(c)[2] / f[2] - 1), 1e-3);
  rollcon_contact_release(c);
}

TEST_F(profile, points_shapes_and_saved_bodies_agree) {
  constexpr double crown = 800, half = 6, radius = 12, approach = 0.01;
  const double shape[2] = {crown, half}, above[3] = {0, 0, radius};
  std::vector<double> points;
  for (int i = 0; i <= 200; ++i) {
    const double y = half * (i / 100.0 - 1);
    points.insert(points.end(), {y, std::sqrt(crown * crown - y * y) - crown});
  }
  ASSERT_OK(rollcon_body_set_profile_shape(upper, "arc", 2, shape));
  ASSERT_OK(rollcon_body_revolve_profile(upper, above, aside, radius));
  double length = 0;
  ASSERT_OK(rollcon_body_get_profile_length(upper, &length));
  rollcon::expect_error("length of the profile", length / (2 * crown * std::asin(half / crown)) - 1, 1e-14);
  double point[2], tangent[2], curvature = 0;
  ASSERT_OK(rollcon_body_get_profile_point(upper, length / 2, point, tangent, &curvature));
  rollcon::expect_error("middle of the profile", std::hypot(point[0], point[1]), 1e-12);
  rollcon::expect_error("tangent there", std::hypot(tangent[0] - 1, tangent[1]), 1e-12);
  rollcon::expect_error("curvature there", curvature * crown + 1, 1e-12);
  rollcon_contact* c = make(0.5, 5.5, approach);
  const Vector f = force(c);
  rollcon_contact_release(c);

  const std::string path = ::testing::TempDir() + "profile.rcb";
  ASSERT_OK(rollcon_body_save(upper, path.c_str()));
  rollcon_body_release(upper);
  ASSERT_OK(rollcon_body_load(context, path.c_str(), &upper));
  std::remove(path.c_str());
  c = make(0.5, 5.5, approach);
  expect_alike("saved and loaded", force(c), f, 1e-15);
  rollcon_contact_release(c);

  rollcon_body_release(upper);
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &upper));
  ASSERT_OK(rollcon_body_set_elastic(upper, 0, 2.1e5, 0.3));
  ASSERT_OK(rollcon_body_set_profile(upper, 201, points.data(), 0));
  ASSERT_OK(rollcon_body_revolve_profile(upper, above, aside, radius));
  c = make(0.5, 5.5, approach);
  expect_alike("through points", force(c), f, 1e-8);
  EXPECT_NE(plan_of(c).find("half-space"), std::string::npos);
  rollcon_contact_release(c);
}

// Wheels and rails are read with z downwards, however their files count.
TEST_F(profile, z_may_be_turned_over_by_its_shape) {
  const double unit = 1;
  for (const char* shape : {"s1002", "60e1"}) {
    ASSERT_OK(rollcon_body_set_profile_shape(upper, shape, 1, &unit));
    const std::string path = ::testing::TempDir() + shape + ".txt";
    ASSERT_OK(rollcon_body_write_profile(upper, path.c_str(), 1));
    double due[2], x[2], tangent[2], curvature = 0;
    ASSERT_OK(rollcon_body_get_profile_point(upper, 5, due, tangent, &curvature));
    for (const int upwards : {0, 1}) {
      ASSERT_OK(rollcon_body_read_profile(lower, path.c_str(), 1, 4, 0));
      ASSERT_OK(rollcon_body_get_profile_point(lower, 5, x, tangent, &curvature));
      rollcon::expect_error(std::string(shape) + (upwards ? " upwards" : " downwards"),
                            std::hypot(x[0] - due[0], x[1] - due[1]), 1e-9);
      ASSERT_OK(rollcon_body_read_profile(lower, path.c_str(), 1, 2, 0));
      ASSERT_OK(rollcon_body_write_profile(lower, path.c_str(), 1));
    }
    std::remove(path.c_str());
  }
}

// The profile is written and read again, in either format, in metres, mirrored twice.
TEST_F(profile, files_round_trip) {
  const double metre = 1e-3, circle[2] = {0.3, 0.02};
  ASSERT_OK(rollcon_body_set_profile_shape(upper, "arc", 2, circle));
  double length = 0;
  ASSERT_OK(rollcon_body_get_profile_length(upper, &length));
  for (const std::string name : {"profile.txt", "profile.prr"}) {
    const std::string path = ::testing::TempDir() + name;
    ASSERT_OK(rollcon_body_write_profile(upper, path.c_str(), metre));
    ASSERT_OK(rollcon_body_read_profile(lower, path.c_str(), metre, 3, 0));
    ASSERT_OK(rollcon_body_write_profile(lower, path.c_str(), metre));
    ASSERT_OK(rollcon_body_read_profile(lower, path.c_str(), metre, 3, 0));
    double error = 0;
    for (const double s : {0.0, 0.013, 0.0317}) {
      double x[2], y[2], t[2], k = 0;
      ASSERT_OK(rollcon_body_get_profile_point(upper, s, x, t, &k));
      ASSERT_OK(rollcon_body_get_profile_point(lower, s, y, t, &k));
      error = std::max(error, std::hypot(x[0] - y[0], x[1] - y[1]));
      rollcon::expect_error(name + ": curvature", k * 0.3 + 1, 1e-4);
    }
    rollcon::expect_error(name + ": points over size", error / length, 1e-9);
    std::remove(path.c_str());
  }
  const std::string path = ::testing::TempDir() + "turns_back.txt";
  std::FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  std::fputs("! y z\n0 0\n1 0\n2 0\n1 1\n", file);
  std::fclose(file);
  EXPECT_FAILS(rollcon_body_read_profile(lower, path.c_str(), 1, 0, 0), ARGUMENT, "turns back at line 4 of", path);
  std::remove(path.c_str());
  EXPECT_FAILS(rollcon_body_read_profile(lower, path.c_str(), 1, 0, 0), IO, path, "no such file");
  EXPECT_FAILS(rollcon_body_read_profile(lower, nullptr, 1, 0, 0), ARGUMENT, "path is NULL");
  EXPECT_FAILS(rollcon_body_read_profile(lower, path.c_str(), 0, 0, 0), ARGUMENT, "unit is 0");
  EXPECT_FAILS(rollcon_body_read_profile(lower, path.c_str(), 1, 6, 0), ARGUMENT, "mirror is 6", "4 (z where");
  EXPECT_FAILS(rollcon_body_write_profile(upper, "/nowhere/at/all.txt", 1), IO, "/nowhere/at/all.txt");
  rollcon_body* bare = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &bare));
  EXPECT_FAILS(rollcon_body_write_profile(bare, path.c_str(), 1), STATE, "no profile");
  rollcon_body_release(bare);
}

TEST_F(profile, inputs_are_checked) {
  const double point[6] = {0, 0, 1, 0, 2, 0}, bad[4] = {0, 0, NAN, 1}, line[2] = {5, 0},
               back[8] = {0, 0, 1, 0, 2, 0, 1, 1};
  EXPECT_FAILS(rollcon_body_set_profile(upper, -1, point, 0), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_body_set_profile(upper, 3, nullptr, 0), ARGUMENT, "points is NULL");
  EXPECT_FAILS(rollcon_body_set_profile(upper, 1, point, 0), ARGUMENT, "1 point(s); allowed: 2 or more");
  EXPECT_FAILS(rollcon_body_set_profile(upper, 100'000'000, point, 0), ARGUMENT, "n is 100000000", "10000000");
  EXPECT_FAILS(rollcon_body_set_profile(upper, 2, bad, 0), NONFINITE, "y of point 1 (counting from 0)");
  EXPECT_FAILS(rollcon_body_set_profile(upper, 4, back, 0), ARGUMENT, "turns back at point 2 (counting from 0)");
  EXPECT_FAILS(rollcon_body_set_profile(upper, 3, point, -1), ARGUMENT, "filter_length is -1");
  EXPECT_FAILS(rollcon_body_set_profile(upper, 3, point, NAN), NONFINITE, "filter_length");
  EXPECT_FAILS(rollcon_body_set_profile_shape(upper, nullptr, 0, nullptr), ARGUMENT, "shape is NULL");
  EXPECT_FAILS(rollcon_body_set_profile_shape(upper, "wheel", 0, nullptr), ARGUMENT, "\"wheel\"", "s1002");
  EXPECT_FAILS(rollcon_body_set_profile_shape(upper, "s1002", 1, nullptr), ARGUMENT, "parameters is NULL");
  EXPECT_FAILS(rollcon_body_extrude_profile(upper, zero, ahead, up), STATE, "no profile");
  double length = 0, x[2], t[2], k = 0;
  EXPECT_FAILS(rollcon_body_get_profile_length(upper, &length), STATE, "no profile");
  ASSERT_OK(rollcon_body_set_profile_shape(upper, "line", 2, line));
  EXPECT_FAILS(rollcon_body_get_profile_length(upper, nullptr), ARGUMENT, "length is NULL");
  EXPECT_FAILS(rollcon_body_get_profile_point(upper, 11, x, t, &k), ARGUMENT, "s is 11", "0 to 10");
  EXPECT_FAILS(rollcon_body_get_profile_point(upper, NAN, x, t, &k), NONFINITE, "s is");
  EXPECT_FAILS(rollcon_body_get_profile_point(upper, 1, nullptr, t, &k), ARGUMENT, "point is NULL");
  EXPECT_FAILS(rollcon_body_prepare(upper), STATE, "no place");
  EXPECT_FAILS(rollcon_body_extrude_profile(upper, zero, ahead, ahead), ARGUMENT, "parallel");
  EXPECT_FAILS(rollcon_body_extrude_profile(upper, zero, zero, up), ARGUMENT, "along is (0, 0, 0)");
  EXPECT_FAILS(rollcon_body_extrude_profile(upper, nullptr, ahead, up), ARGUMENT, "origin is NULL");
  EXPECT_FAILS(rollcon_body_revolve_profile(upper, zero, zero, 1), ARGUMENT, "axis is (0, 0, 0)");
  EXPECT_FAILS(rollcon_body_revolve_profile(upper, zero, aside, -1), ARGUMENT, "crosses its axis", "from 0 on");
  EXPECT_FAILS(rollcon_body_revolve_profile(upper, zero, aside, NAN), NONFINITE, "radius");
  ASSERT_OK(rollcon_body_revolve_profile(upper, zero, aside, 1));
  ASSERT_OK(rollcon_body_prepare(upper));
  EXPECT_FAILS(rollcon_body_set_profile_shape(upper, "line", 2, line), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_extrude_profile(upper, zero, ahead, up), STATE, "prepared");

  rollcon_body* rigid = nullptr;
  const double node[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &rigid));
  ASSERT_OK(rollcon_body_set_nodes(rigid, 3, node, 3, 1));
  EXPECT_FAILS(rollcon_body_set_profile_shape(rigid, "line", 2, line), STATE, "has a mesh");
  rollcon_body_release(rigid);
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &rigid));
  ASSERT_OK(rollcon_body_set_profile_shape(rigid, "line", 2, line));
  EXPECT_FAILS(rollcon_body_set_nodes(rigid, 3, node, 3, 1), STATE, "has a profile");
  rollcon_body_release(rigid);
  if (rollcon_has_feature("bem") == 0) return;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_BEM, &rigid));
  EXPECT_FAILS(rollcon_body_set_profile_shape(rigid, "line", 2, line), STATE, "takes no profile");
  rollcon_body_release(rigid);
}

TEST_F(profile, frames_beyond_its_ends_are_told) {
  const double line[2] = {2, 0}, above[3] = {0, 0, 10};
  ASSERT_OK(rollcon_body_set_profile_shape(upper, "line", 2, line));
  ASSERT_OK(rollcon_body_revolve_profile(upper, above, aside, 10));
  rollcon_contact* c = make(1, 3, 0.01);
  EXPECT_FAILS(rollcon_contact_solve(c), MESH, "do not lie over the profile of body 2", "beyond its ends");
  // The frame may go to the roller's ends, where it is no rim.
  ASSERT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, n, n, -1, 1, -2, 2));
  EXPECT_EQ(rollcon_contact_solve(c), ROLLCON_INACCURATE) << "sharp ends are told";
  ASSERT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, n, n, -1, 1, -1.9, 2));
  EXPECT_EQ(rollcon_contact_solve(c), ROLLCON_RIM_CONTACT);
  rollcon_contact_release(c);
}

// A rigid body takes a profile, too, and the frame stays flat: the result is that with the elastic one's gap.
TEST_F(profile, rigid_bodies_take_profiles) {
  constexpr double radius = 100, approach = 0.01, a = 1;
  const double shape[2] = {radius, radius}, above[3] = {0, 0, radius};
  rollcon_body_release(upper);
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &upper));
  ASSERT_OK(rollcon_body_set_profile_shape(upper, "arc", 2, shape));
  ASSERT_OK(rollcon_body_revolve_profile(upper, above, aside, radius));
  rollcon_contact* c = make(1.2 * a, 1.2 * a, approach);
  const Vector f = force(c);
  rollcon_contact_release(c);
  const auto gap = [&](double x, double y) {
    return (x * x + y * y) / (radius + std::sqrt(radius * radius - x * x - y * y));
  };
  expect_alike("rigid sphere", f, force_of(1.2 * a, 1.2 * a, approach, gap), 1e-9);
}
