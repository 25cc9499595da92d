// Tests wear through the public interface: volumes to rounding, symmetry, published discs, the limit of a flat-worn
// strip, profiles that wear, a wheel on its rail.

#include <numeric>

#include "fixture.hpp"

namespace {

using namespace capi_test;

std::vector<double> even(double from, double to, std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t j = 0; j < n; ++j) x[j] = from + (to - from) * static_cast<double>(j) / static_cast<double>(n - 1);
  return x;
}

/// Sums depth times the points' lengths along x.
double volume_of(const std::vector<double>& depth, const std::vector<double>& x) {
  double sum = 0;
  for (std::size_t j = 0; j + 1 < x.size(); ++j) sum += 0.5 * (x[j + 1] - x[j]) * (depth[j] + depth[j + 1]);
  return sum;
}

double asymmetry(const std::vector<double>& v) {
  double most = 0;
  for (std::size_t j = 0; j < v.size(); ++j) most = std::max(most, std::abs(v[j] - v[v.size() - 1 - j]));
  return most / *std::max_element(v.begin(), v.end());
}

/// Rolls steel on steel along x, on a rectangle; the gap is curved along x, wear is across it.
class wear : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    for (rollcon_body*& b : body) ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &b));
    for (rollcon_body* b : body) ASSERT_OK(rollcon_body_set_elastic(b, 0, 2.08e5, 0.3));
    ASSERT_OK(rollcon_contact_create(context, body[0], body[1], &contact));
  }
  void TearDown() override {
    rollcon_contact_release(contact);
    for (rollcon_body* b : body) rollcon_body_release(b);
    rollcon_context_release(context);
  }
  void press(int along, int across, double length, double width, double force, double creep) {
    nx = along;
    y = even(-width, width, static_cast<std::size_t>(across) + 1);
    x = even(-length, length, static_cast<std::size_t>(along) + 1);
    worn.assign(y.size(), 0.0);
    ASSERT_OK(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, along, across, -length, length, -width, width));
    ASSERT_OK(rollcon_contact_set_rolling(contact, 3));
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, force));
    ASSERT_OK(rollcon_contact_set_creep(contact, creep, 0, 0));
  }
  std::int32_t solve(double cx, double cy) {
    std::vector<double> gap;
    for (std::size_t j = 0; j < y.size(); ++j)
      for (const double at : x) gap.push_back(cx * at * at + cy * y[j] * y[j] + worn[j]);
    EXPECT_OK(rollcon_contact_set_gap(contact, static_cast<std::int64_t>(gap.size()), gap.data()));
    return rollcon_contact_solve(contact);
  }
  std::vector<double> depth(const char* law, const std::vector<double>& parameters, const std::vector<double>& at,
                            double* volume = nullptr) {
    std::vector<double> d(at.size());
    EXPECT_OK(rollcon_contact_get_wear(contact, law, static_cast<std::int32_t>(parameters.size()), parameters.data(),
                                       static_cast<std::int64_t>(at.size()), at.data(), d.data(), volume));
    return d;
  }
  /// Takes one step of at most `deepest`; returns what is taken of the distance.
  double wear_on(const std::vector<double>& rate, double distance, double deepest, double smoothing) {
    std::vector<double> yz;
    for (std::size_t j = 0; j < y.size(); ++j) yz.insert(yz.end(), {y[j], 0.0});
    double taken = 0;
    EXPECT_OK(rollcon_wear_profile(static_cast<std::int64_t>(y.size()), yz.data(), rate.data(), 1, distance, deepest,
                                   smoothing, yz.data(), &taken));
    for (std::size_t j = 0; j < y.size(); ++j) worn[j] += yz[2 * j + 1];
    return taken;
  }

  rollcon_context* context = nullptr;
  rollcon_body* body[2] = {};
  rollcon_contact* contact = nullptr;
  int nx = 0;
  std::vector<double> x, y, worn;
};

TEST_F(wear, volumes_are_those_of_the_law_on_any_points) {
  const double mu = 0.3, i = 2e-6;
  press(16, 20, 0.34, 0.55, 300, -5e-3);
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  ASSERT_OK(solve(0.5 * (1 / 32.5 + 1 / 32.3), 0.5 / 32.5));
  double power = 0, speed = 3, worst = 0, whole = 0;
  ASSERT_OK(rollcon_contact_get_stat(contact, "friction_power_balance", &power));
  for (const std::size_t points : {2U, 7U, 21U, 23U, 500U}) {
    const std::vector<double> at = even(-0.6, 0.58, points), d = depth("archard", {i}, at, &whole);
    worst = std::max({worst, std::abs(volume_of(d, at) / whole - 1), std::abs(whole / (i * power / (mu * speed)) - 1)});
  }
  std::printf("volume by points, and against frictional power: %.1e (bound 1e-12)\n", worst);
  EXPECT_LE(worst, 1e-12);
  const std::vector<double> at = even(-0.55, 0.55, 201);
  const double unlike = asymmetry(depth("archard", {i}, at));
  std::printf("symmetric to %.1e (bound 1e-9)\n", unlike);
  EXPECT_LE(unlike, 1e-9);
  // Depth is linear between the frame's lines, whatever the points.
  const std::vector<double> coarse = depth("archard", {i}, y), fine = depth("archard", {i}, even(-0.55, 0.55, 401));
  double wave = 0;
  for (std::size_t j = 1; j + 1 < fine.size(); ++j)
    wave = std::max(wave, std::abs(fine[j - 1] - 2 * fine[j] + fine[j + 1]) / coarse[10]);
  std::printf("second difference of 401 points over the depth %.1e (bound 0.02)\n", wave);
  EXPECT_LE(wave, 0.02);
  EXPECT_NEAR(fine[200], coarse[10], 0.02 * coarse[10]);

  // Equal coefficients give one wear; an ellipse lies between.
  double two = 0, one = 0, less = 0;
  depth("archard", {i, i, 0.3}, y, &two);
  depth("archard", {i, 0, 0}, y, &one);
  depth("archard", {i, 0, std::numbers::pi / 3}, y, &less);
  EXPECT_NEAR(two, whole, 1e-12 * whole);
  EXPECT_LE(one, whole);
  EXPECT_LT(less, 0.6 * whole);
  // Pairs on a line through the origin are wear by energy, in proportion.
  double line = 0, steep = 0;
  depth("t_gamma", {5, 5e-6, 20, 2e-5}, y, &line);
  depth("t_gamma", {5, 5e-6, 20, 2e-5, 30, 1}, y, &steep);
  EXPECT_NEAR(line, 1e-6 * power / speed, 1e-12 * line);
  EXPECT_GE(steep, line);
}

using wear_long = wear;

// A crowned disc on a cylinder, orthotropic friction and wear (Rodriguez-Tembleque, Abascal, Aliabadi), are read off a
// figure to 3 %, and sums over nodes miss 3 to 6 % on a mesh of that kind (docs/wear.md).
TEST_F(wear_long, published_discs) {
  press(32, 80, 0.34, 1.7, 300, -5e-3);
  const double published[] = {0.0242, 0.0194, 0.0154}, angle[] = {0, std::numbers::pi / 4, std::numbers::pi / 2};
  for (std::size_t k = 0; k < 3; ++k) {
    const double mu[] = {0.6, 0.3, angle[k]};
    ASSERT_OK(rollcon_contact_set_friction(contact, "orthotropic", 3, mu));
    double deepest[2] = {};
    for (const int steps : {40, 80}) {
      std::fill(worn.begin(), worn.end(), 0.0);
      for (double left = 15000; left > 0;) {
        ASSERT_OK(solve(0.5 * (1 / 32.5 + 1 / 32.3), 0.5 / 32.5));
        left -= wear_on(depth("archard", {2e-6, 1e-6, angle[k]}, y), left, 0.024 / steps, 0);
      }
      deepest[steps / 80] = *std::max_element(worn.begin(), worn.end());
    }
    std::printf("axes turned by %.0f degrees: worn %.4f mm, published %.4f (7 %%); half as many steps %.1e off\n",
                angle[k] * 180 / std::numbers::pi, deepest[1], published[k], std::abs(deepest[0] / deepest[1] - 1));
    EXPECT_LE(std::abs(deepest[1] / published[k] - 1), 0.07);
    EXPECT_LE(std::abs(deepest[0] / deepest[1] - 1), 2e-3);
    if (k != 1) {
      EXPECT_LE(asymmetry(worn), 1e-9);
    }
  }
}

// A strip between two edges wears until its load is the same everywhere; its pressure was singular at the edges.
TEST_F(wear, strip_ends_with_an_even_load) {
  const double mu = 0.3;
  for (const int across : {16, 32}) {
    press(12, across, 0.3, 1, 600, -0.02);
    ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
    double first = 0, last = 0, whole = 0;
    for (int step = 0; step < 40; ++step) {
      ASSERT_EQ(solve(0.5 / 20, 0), ROLLCON_RIM_CONTACT);
      const std::vector<double> rate = depth("archard", {1e-6}, y, &whole);
      const auto [low, high] = std::minmax_element(rate.begin(), rate.end());
      last = (*high - *low) / (whole / 2);
      if (step == 0) first = last;
      wear_on(rate, 1e30, 4e-4, 0.1);
    }
    std::printf("strip of %d elements: rates differ by %.2f of their mean at first, by %.1e in the end (bound 5e-3)\n",
                across, first, last);
    EXPECT_GT(first, 1);
    EXPECT_LE(last, 5e-3);
    EXPECT_LE(asymmetry(worn), 1e-9);
  }
}

TEST_F(wear, profiles_keep_volumes_and_steps) {
  const std::size_t n = 401;
  std::vector<double> yz, rate, worn_yz(2 * n);
  for (std::size_t j = 0; j < n; ++j) {
    const double t = static_cast<double>(j) / 400;
    yz.insert(yz.end(), {20 * t + std::sin(3 * t), 2 * t * t});
    rate.push_back(1e-6 * (j > 150 && j < 250 ? 1 + 0.5 * std::cos(0.9 * static_cast<double>(j)) : 0));
  }
  std::vector<double> s(n, 0.0);
  for (std::size_t j = 1; j < n; ++j)
    s[j] = s[j - 1] + std::hypot(yz[2 * j] - yz[2 * j - 2], yz[2 * j + 1] - yz[2 * j - 1]);
  double taken = 0, most = 0, up = 0;
  for (const double smoothing : {0.0, 0.3, 3.0, 30.0}) {
    ASSERT_OK(rollcon_wear_profile(n, yz.data(), rate.data(), -1, 1e5, 1e-2, smoothing, worn_yz.data(), &taken));
    std::vector<double> d;
    for (std::size_t j = 0; j < n; ++j) {
      d.push_back(std::hypot(worn_yz[2 * j] - yz[2 * j], worn_yz[2 * j + 1] - yz[2 * j + 1]));
      up = std::max(up, worn_yz[2 * j + 1] - yz[2 * j + 1]);
    }
    most = std::max(most, std::abs(volume_of(d, s) / (taken * volume_of(rate, s)) - 1));
    EXPECT_LE(*std::max_element(d.begin(), d.end()), 1e-2 * (1 + 1e-12));
    EXPECT_LT(taken, 1e5);
  }
  std::printf("volume of a smoothed step: %.1e (bound 1e-10)\n", most);
  EXPECT_LE(most, 1e-10);
  EXPECT_LE(up, 0);  // into the body, which lies at lesser z
  // A wave as long as the smoothing keeps a half.
  std::vector<double> flat;
  for (std::size_t j = 0; j < n; ++j) {
    flat.insert(flat.end(), {0.1 * static_cast<double>(j), 0});
    rate[j] = 1 + std::cos(2 * std::numbers::pi * static_cast<double>(j) / 100);
  }
  ASSERT_OK(rollcon_wear_profile(n, flat.data(), rate.data(), 1, 1, 10, 10, worn_yz.data(), &taken));
  EXPECT_NEAR(worn_yz[2 * 200 + 1], 1.5, 1e-3);
  EXPECT_EQ(taken, 1);
}

TEST_F(wear, refuses_what_makes_no_sense) {
  const double mu = 0.3, i[] = {1e-6, 1e-6}, nan = std::nan(""), table[] = {2, 1e-6, 1, 1e-6};
  const double below[] = {1, 1e-6, 2, 1e-6, 3, -1e-6};
  press(8, 8, 0.34, 0.55, 300, -5e-3);
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  std::vector<double> d(y.size());
  const auto n = static_cast<std::int64_t>(y.size());
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "archard", 1, i, n, y.data(), d.data(), nullptr), STATE, "solution");
  ASSERT_GE(solve(0.03, 0.015), 0);
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "rust", 1, i, n, y.data(), d.data(), nullptr), OPTION, "rust");
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "archard", 2, i, n, y.data(), d.data(), nullptr), ARGUMENT, "n is 2");
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "archard", 1, &nan, n, y.data(), d.data(), nullptr), NONFINITE,
               "parameter 0");
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "t_gamma", 2, i, n, y.data(), d.data(), nullptr), ARGUMENT, "pairs");
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "t_gamma", 4, table, n, y.data(), d.data(), nullptr), ARGUMENT,
               "energy 1");
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "t_gamma", 6, below, n, y.data(), d.data(), nullptr), ARGUMENT,
               "pair 2 (counting from 0) is 3, -1e-06");
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "archard", 1, i, 1, y.data(), d.data(), nullptr), ARGUMENT,
               "points is 1");
  const double narrow[] = {-0.1, 0.1}, back[] = {0.5, -0.5};
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "archard", 1, i, 2, narrow, d.data(), nullptr), ARGUMENT, "-0.1");
  EXPECT_FAILS(rollcon_contact_get_wear(contact, "archard", 1, i, 2, back, d.data(), nullptr), ARGUMENT, "entry 1");
  const double yz[] = {0, 0, 1, 0}, same[] = {0, 0, 0, 0}, rate[] = {1, -1};
  double out[4];
  EXPECT_FAILS(rollcon_wear_profile(2, yz, rate, 1, 1, 1, 0, out, nullptr), ARGUMENT, "entry 1 of rate");
  EXPECT_FAILS(rollcon_wear_profile(2, same, i, 1, 1, 1, 0, out, nullptr), ARGUMENT, "point 1");
  EXPECT_FAILS(rollcon_wear_profile(2, yz, i, 0, 1, 1, 0, out, nullptr), ARGUMENT, "side is 0");
  EXPECT_FAILS(rollcon_wear_profile(2, yz, i, 1, 1, 0, 0, out, nullptr), ARGUMENT, "most_depth is 0");
}

// The wheel S1002 stands on 60E1 in two positions, through tread and flange.
TEST_F(wear, wheel_and_rail_lose_what_the_law_says) {
  const double unit = 1, i = 1e-9, weights[] = {2, 0.5};
  rollcon_body *wheel = nullptr, *rail = nullptr;
  for (rollcon_body** b : {&wheel, &rail}) {
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, b));
    ASSERT_OK(rollcon_body_set_elastic(*b, 0, 2.1e5, 0.28));
  }
  ASSERT_OK(rollcon_body_set_profile_shape(wheel, "s1002", 1, &unit));
  ASSERT_OK(rollcon_body_set_profile_shape(rail, "60e1", 1, &unit));
  constexpr std::int64_t points = 1301;
  std::vector<double> of_wheel[2], of_rail[2];
  double volumes[2] = {};
  std::int32_t status[2] = {};
  const auto depths_of = [&](std::int32_t side, int threads, std::vector<double>& w, std::vector<double>& r) {
    const double s = side == ROLLCON_RIGHT ? 1 : -1;
    const double positions[] = {0, s * 2,   0.1529,  s * -1.128e-4, s * 4.8e-3,  0,
                                0, s * 6.5, -3.0468, s * -4.376e-3, s * 15.6e-3, 0};
    const double velocities[] = {2000, 0, 0, 0, 0, -4.3459197, 2000, 0, 0, 0, 0, -4.2748834};
    rollcon_wheelrail* one = nullptr;
    ASSERT_OK(rollcon_context_set_threads(context, threads));
    ASSERT_OK(rollcon_wheelrail_create(context, wheel, rail, side, &one));
    ASSERT_OK(rollcon_wheelrail_set_track(one, 1435, 14, std::atan(1.0 / 40)));
    ASSERT_OK(rollcon_wheelrail_set_wheelset(one, 1360, -70, 460));
    const double mu = 0.3;
    ASSERT_OK(rollcon_wheelrail_set_friction(one, "coulomb", 1, &mu));
    w.resize(points), r.resize(points);
    ASSERT_GE(rollcon_wheelrail_find_wear(one, 2, positions, velocities, weights, "archard", 1, &i, points, w.data(),
                                          r.data(), volumes, status),
              0);
    rollcon_wheelrail_release(one);
  };
  depths_of(ROLLCON_RIGHT, 2, of_wheel[0], of_rail[0]);
  depths_of(ROLLCON_LEFT, 1, of_wheel[1], of_rail[1]);
  EXPECT_EQ(of_wheel[0], of_wheel[1]);  // the mirror, and another number of threads: the same bits
  EXPECT_EQ(of_rail[0], of_rail[1]);
  double worst = std::abs(volumes[0] / volumes[1] - 1);
  double deepest_at[2] = {};
  for (const int b : {0, 1}) {
    const std::vector<double>& depth = b == 0 ? of_wheel[0] : of_rail[0];
    std::vector<double> s(points, 0.0);
    double length = 0, at[2], before[2];
    ASSERT_OK(rollcon_body_get_profile_length(b == 0 ? wheel : rail, &length));
    for (std::size_t j = 0; j < depth.size(); ++j) {
      double tangent[2], curvature = 0;
      ASSERT_OK(rollcon_body_get_profile_point(b == 0 ? wheel : rail, length * (static_cast<double>(j) / (points - 1)),
                                               at, tangent, &curvature));
      if (j > 0) s[j] = s[j - 1] + std::hypot(at[0] - before[0], at[1] - before[1]);
      std::copy_n(at, 2, before);
      if (depth[j] == *std::max_element(depth.begin(), depth.end())) deepest_at[b] = at[0];
    }
    worst = std::max(worst, std::abs(volume_of(depth, s) / volumes[b] - 1));
  }
  std::printf("volume on both profiles: %.1e (bound 1e-9); deepest at y %.2f of the wheel, %.2f of the rail\n", worst,
              deepest_at[0], deepest_at[1]);
  EXPECT_LE(worst, 1e-9);
  EXPECT_NEAR(deepest_at[0], -38, 4);  // the flange's root
  rollcon_body_release(rail);
  rollcon_body_release(wheel);
}

}  // namespace
