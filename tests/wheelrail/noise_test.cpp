/// Tests measured profiles: noise on the points of wheel and rail, and the filter that takes it away.

#include <random>

#include "wheel_rail_fixture.hpp"

using namespace rollcon;

namespace {

class noise : public wheels {
 protected:
  static std::vector<Vec2> points_of(const char* shape, double distance) {
    const auto curve = manchester::curve(shape);
    const double length = curve->length();
    const auto n = static_cast<std::size_t>(length / distance);
    std::vector<Vec2> point;
    for (std::size_t i = 0; i <= n; ++i)
      point.push_back(curve->at(length * static_cast<double>(i) / static_cast<double>(n)).x);
    return point;
  }
  /// Returns the largest pressure under 10 kN with the profiles through these points.
  double pressure(const std::vector<Vec2>& on_wheel, const std::vector<Vec2>& on_rail, double filter_length) {
    wheel->set_profile(std::ssize(on_wheel), on_wheel[0].data(), filter_length);
    rail->set_profile(std::ssize(on_rail), on_rail[0].data(), filter_length);
    const auto w = make();
    w->prescribe_vertical(2, 10000);
    EXPECT_EQ(w->solve(), Status::ok);
    double most = 0;
    for (std::int64_t i = 0; i < w->patches(); ++i) most = std::max(most, w->patch_stat(i, "max_pressure"));
    return most;
  }
};

}  // namespace

using noise_long = noise;

// The pressures are compared with what the same filter makes of the profiles without noise, which is what its length
// costs.
TEST_F(noise_long, pressures_within_five_percent) {
  const struct {
    double micrometre, distance, filter_length, mean, worst;
  } cases[] = {{5, 0.1, 12, 0.0135, 0.04},  {5, 0.5, 20, 0.023, 0.05},  {20, 0.1, 20, 0.045, 0.05},
               {20, 0.5, 30, 0.016, 0.045}, {50, 0.1, 30, 0.025, 0.05}, {50, 0.25, 36, 0.044, 0.05}};
  std::mt19937 random(11);
  std::normal_distribution<double> unit;
  constexpr int draws = 8;
  for (const auto& c : cases) {
    const auto on_wheel = points_of("s1002", c.distance), on_rail = points_of("60e1", c.distance);
    const double smooth = pressure(on_wheel, on_rail, c.filter_length);
    double sum = 0, worst = 0;
    for (int k = 0; k < draws; ++k) {
      auto noisy_wheel = on_wheel, noisy_rail = on_rail;
      for (auto* points : {&noisy_wheel, &noisy_rail})
        for (Vec2& x : *points) x[1] += 1e-3 * c.micrometre * unit(random);
      const double off = std::abs(pressure(noisy_wheel, noisy_rail, c.filter_length) / smooth - 1);
      sum += off;
      worst = std::max(worst, off);
    }
    char name[96];
    std::snprintf(name, sizeof name, "%g um every %g mm, filter %g mm: largest pressure", c.micrometre, c.distance,
                  c.filter_length);
    expect_error(std::string(name) + ", mean", sum / draws, c.mean);
    expect_error(std::string(name) + ", worst", worst, c.worst);
  }
}
