// Tests wear in random scenes: nothing is lost, mirrored scenes wear alike, and neither the mesh nor the step shows.

#include <random>

#include "fixture.hpp"

namespace {

using namespace capi_test;

/// Describes half-spaces that roll on one another under a gap of x^2 and y^2, worn across the rolling direction.
struct Scene {
  double force, gap[2], mu, creep[3], young2;
  bool by_energy;
};

Scene draw(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(random);
  };
  const auto creepage = [&](double size) {
    return (between(0, 1) < 0.5 ? -1 : 1) * size * std::pow(10, between(-1.3, 0.5));
  };
  Scene s{between(100, 400), {between(0.02, 0.04), between(0.008, 0.04)}, between(0.15, 0.6), {}, 0, false};
  s.creep[0] = creepage(2e-3);
  s.creep[1] = between(0, 1) < 0.5 ? 0 : creepage(1e-3);
  s.creep[2] = between(0, 1) < 0.5 ? 0 : creepage(4e-3);
  s.young2 = between(0, 1) < 0.5 ? 2e5 : between(8e4, 4e5);
  s.by_energy = between(0, 1) < 0.4;
  return s;
}

class wear_scenes : public ::testing::Test {
 protected:
  static constexpr double half_x = 0.42, half_y = 0.6, young = 2e5, speed = 3;

  void SetUp() override { ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context)); }
  void TearDown() override {
    end();
    rollcon_context_release(context);
  }
  void end() {
    rollcon_contact_release(contact);
    for (rollcon_body*& b : body) {
      rollcon_body_release(b);
      b = nullptr;
    }
    contact = nullptr;
  }
  /// Begins the scene; side -1 mirrors it.
  void begin(const Scene& s, int along, int across, double side) {
    end();
    scene = s;
    for (rollcon_body*& b : body) ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &b));
    ASSERT_OK(rollcon_body_set_elastic(body[0], 0, young, 0.3));
    ASSERT_OK(rollcon_body_set_elastic(body[1], 0, s.young2, 0.3));
    ASSERT_OK(rollcon_contact_create(context, body[0], body[1], &contact));
    ASSERT_OK(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, along, across, -half_x, half_x, -half_y, half_y));
    ASSERT_OK(rollcon_contact_set_rolling(contact, speed));
    ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &s.mu));
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, s.force));
    ASSERT_OK(rollcon_contact_set_creep(contact, s.creep[0], side * s.creep[1], side * s.creep[2]));
    x.clear(), y.clear();
    for (int i = 0; i <= along; ++i) x.push_back(half_x * (2.0 * i / along - 1));
    for (int j = 0; j <= across; ++j) y.push_back(half_y * (2.0 * j / across - 1));
    worn.assign(y.size(), 0.0);
  }
  bool solve() {
    std::vector<double> gap;
    for (std::size_t j = 0; j < y.size(); ++j)
      for (const double at : x) gap.push_back(scene.gap[0] * at * at + scene.gap[1] * y[j] * y[j] + worn[j]);
    EXPECT_OK(rollcon_contact_set_gap(contact, static_cast<std::int64_t>(gap.size()), gap.data()));
    return rollcon_contact_solve(contact) == ROLLCON_OK;
  }
  std::vector<double> depth(const std::vector<double>& at, double* volume = nullptr) {
    const std::vector<double> law =
        scene.by_energy ? std::vector{5.0, 1e-5, 20.0, 1e-5, 30.0, 8e-5} : std::vector{2e-6};
    std::vector<double> d(at.size());
    EXPECT_OK(rollcon_contact_get_wear(contact, scene.by_energy ? "t_gamma" : "archard",
                                       static_cast<std::int32_t>(law.size()), law.data(),
                                       static_cast<std::int64_t>(at.size()), at.data(), d.data(), volume));
    return d;
  }
  /// Wears over a distance in steps of at most `deepest`.
  bool wear(double distance, double deepest) {
    for (int step = 0; distance > 0 && step < 400; ++step) {
      if (!solve()) return false;
      const std::vector<double> rate = depth(y);
      std::vector<double> yz;
      for (const double at : y) yz.insert(yz.end(), {at, 0.0});
      double taken = 0;
      EXPECT_OK(rollcon_wear_profile(static_cast<std::int64_t>(y.size()), yz.data(), rate.data(), 1, distance, deepest,
                                     0, yz.data(), &taken));
      for (std::size_t j = 0; j < y.size(); ++j) worn[j] += yz[2 * j + 1];
      distance -= taken;
    }
    return distance <= 0;
  }
  static double volume_of(const std::vector<double>& d, const std::vector<double>& at) {
    double sum = 0;
    for (std::size_t j = 0; j + 1 < at.size(); ++j) sum += 0.5 * (at[j + 1] - at[j]) * (d[j] + d[j + 1]);
    return sum;
  }
  /// Returns the amplitude of what changes its sign from line to line, over the greatest depth.
  static double saw(const std::vector<double>& d) {
    double most = 0;
    for (std::size_t j = 2; j + 2 < d.size(); ++j)
      most = std::max(most, std::abs(d[j - 2] - 4 * d[j - 1] + 6 * d[j] - 4 * d[j + 1] + d[j + 2]) / 16);
    return most / *std::max_element(d.begin(), d.end());
  }

  struct Worst {
    double mass = 0, power = 0, mirror = 0, mesh = 0, step = 0, saw = 0;
    int scenes = 0, left_out = 0, far = 0;
  };
  void run(unsigned seed, int count, int loops) {
    std::mt19937 random(seed);
    Worst worst;
    for (int k = 0; k < count; ++k) {
      const Scene s = draw(random);
      begin(s, 14, 20, 1);
      if (!solve()) {
        ++worst.left_out;
        continue;
      }
      ++worst.scenes;
      double whole = 0, mirrored = 0, power = 0;
      std::vector<double> at;
      for (int j = 0; j < 30; ++j) at.push_back(-0.65 + 1.3 * j / 29 + 0.01 * std::sin(7.0 * j * (k + 1)));
      worst.mass = std::max(worst.mass, std::abs(volume_of(depth(at, &whole), at) / whole - 1));
      const std::vector<double> here = depth(y);
      EXPECT_OK(rollcon_contact_get_stat(contact, "friction_power_balance", &power));
      if (!s.by_energy) worst.power = std::max(worst.power, std::abs(whole / (2e-6 * power / (s.mu * speed)) - 1));
      begin(s, 14, 20, -1);
      EXPECT_TRUE(solve());
      const std::vector<double> there = depth(y, &mirrored);
      for (std::size_t j = 0; j < here.size(); ++j)
        worst.mirror = std::max(worst.mirror, std::abs(there[j] - here[here.size() - 1 - j]) / (whole / 0.5));
      begin(s, 28, 40, 1);
      EXPECT_TRUE(solve());
      double fine = 0;
      depth(y, &fine);
      worst.far += std::abs(whole / fine - 1) > 0.12;
      worst.mesh = std::max(worst.mesh, std::abs(whole / fine - 1));
      if (k >= loops) continue;
      // The distance wears 4 um in the beginning, in steps of 0.2 and 0.1 um: more than the approach changes by.
      const double distance = 4e-3 / *std::max_element(here.begin(), here.end());
      begin(s, 14, 20, 1);
      if (!wear(distance, 4e-4)) {
        ++worst.left_out;
        continue;
      }
      const std::vector<double> long_steps = worn;
      begin(s, 14, 20, 1);
      EXPECT_TRUE(wear(distance, 2e-4));
      double off = 0, all = 0;
      for (std::size_t j = 0; j < worn.size(); ++j) off += std::abs(long_steps[j] - worn[j]), all += worn[j];
      worst.step = std::max(worst.step, off / all);
      worst.saw = std::max({worst.saw, saw(worn), saw(long_steps)});
    }
    std::printf(
        "%d scenes, %d not on their frame: volume on points %.1e (bound 1e-12), beside the power %.1e (1e-8), mirrored "
        "%.1e (1e-6); half the spacing %.2f (0.4), beyond 0.12 in %d (3 %%); half the step %.1e (0.2), from line to "
        "line "
        "%.1e (0.06)\n",
        worst.scenes, worst.left_out, worst.mass, worst.power, worst.mirror, worst.mesh, worst.far, worst.step,
        worst.saw);
    EXPECT_LE(worst.mass, 1e-12);
    EXPECT_LE(worst.power, 1e-8);
    EXPECT_LE(worst.mirror, 1e-6);
    EXPECT_LE(worst.mesh, 0.4);
    EXPECT_LE(worst.far, 0.03 * worst.scenes);
    EXPECT_LE(worst.step, 0.2);
    EXPECT_LE(worst.saw, 0.06);
    EXPECT_GE(worst.scenes, count / 2);
  }

  rollcon_context* context = nullptr;
  rollcon_body* body[2] = {};
  rollcon_contact* contact = nullptr;
  Scene scene{};
  std::vector<double> x, y, worn;
};

using wear_scenes_long = wear_scenes;

TEST_F(wear_scenes, random_few) {
  run(3, 5, 1);
}
TEST_F(wear_scenes_long, random) {
  run(20, 200, 40);
}

}  // namespace
