/// Tests that equivalent conicities and nonlinearity parameters are those of EN 15302:2021 for its reference profiles,
/// which are straight lines and arcs in closed form; mm.

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "wheel_rail_fixture.hpp"
#include "wheelrail/wheelset_geometry.hpp"

namespace rollcon {
namespace {

/// Describes a zone from the one before to `to`: a straight line z = c + m y, or, with a radius r, z = c - r / |r|
/// sqrt(r^2 - (y - m)^2).
struct Zone {
  double to, c, m, radius;
};
struct Reference {
  double from;
  std::vector<Zone> zone;

  std::vector<double> points(double step) const {
    std::vector<double> yz;
    double begin = from;
    for (const Zone& zone_here : zone) {
      const auto n = static_cast<int>(std::ceil((zone_here.to - begin) / step));
      for (int i = yz.empty() ? 0 : 1; i <= n; ++i) {
        const double y = begin + (zone_here.to - begin) * i / n, r = zone_here.radius;
        const double away = y - zone_here.m;
        yz.push_back(y);
        yz.push_back(r == 0 ? zone_here.c + zone_here.m * y
                            : zone_here.c - std::copysign(std::sqrt(r * r - away * away), r));
      }
      begin = zone_here.to;
    }
    return yz;
  }
};

// Flanges begin at y = -62.7647: what is behind their tops touches nothing.
const Reference rail_a{-32.634,
                       {{-23.2401, 15.899044, -19.63949, 13},
                        {-7.8749, 80.277908, -1.0825, 80},
                        {13.0989, 299.48349, 17.5966, 300},
                        {28.6709, 79.508225, 14.29829, 80},
                        {39.2705, 13.598369, 26.33535, 13}}};
const Reference wheel_a{-62.7647,
                        {{-49.6625, 16.00065, -55, -12},
                         {-39.7645, 8.83556, -58.5583, -20},
                         {-38.7372, -93.57685, -2.7475, 0},
                         {-29.4591, 17.64215, -25.5816, 14},
                         {-10.8749, 97.16493, -2.6594, 96.76055},
                         {18.4173, 344.50806, 18.4173, 345},
                         {30, -0.49194, 0, 0},
                         {60, 1.50804, -0.066666, 0}}};
const Reference wheel_b{-62.7647,
                        {{-49.6625, 16, -55, -12},
                         {-39.764, 8.8349, -58.5583, -20},
                         {-38.7879, -93.5767, -2.7475, 0},
                         {-29.3505, 17.7814, -25.6322, 14},
                         {-0.4787, 119.9745, 2.5204, 120},
                         {30, 0, -0.025, 0},
                         {60, 0.75, -0.05, 0}}};
const Reference wheel_c{-69.4027,
                        {{-59.5, 20.00006, -59.5, -10},
                         {-43.8048, 12.02753, -60.4941, -18},
                         {-41.0534, 11.96051 - 2.47508685 * 41.05339, -2.47508685, 0},
                         {-32.3621, 16.830365, -29, 13},
                         {-17.587, 100.870534, -6.5, 100},
                         {19, 329.45258, 19, 330},
                         {29, -0.54742374, 0, 0},
                         {59, -0.54742374 + 2.9, -0.1, 0}}};
const Reference wheel_h{-62.7647,
                        {{-49.6625, 16, -55, -12},
                         {-39.7645, 8.8349, -58.5583, -20},
                         {-38.722, -93.5767, -2.7475, 0},
                         {-28.3119, 17.6003, -25.5663, 14},
                         {-10.2297, -1.7902, -0.2, 0},
                         {30, 0, -0.025, 0},
                         {60, 1.251, -0.0667, 0}}};
const Reference wheel_i{-62.7647,
                        {{-49.6625, 16.00054, -55, -12},
                         {-39.764, 8.83545, -58.5583, -20},
                         {-39.0486, -93.5767, -2.7475, 0},
                         {-29.9231, 18.49733, -25.8929, 14},
                         {5, std::sqrt(14375.0), 5, 120},
                         {30, std::sqrt(14375.0) - 120, 0, 0},
                         {60, 1.89679, -0.0667, 0}}};

constexpr double amplitudes[] = {1, 2, 3, 4, 5};
/// Holds the standard's results at these amplitudes, to three digits. The wheel on the left has radius_left, the one on
/// the right 460.
struct Case {
  const char* name;
  const Reference *left, *right;
  double radius_left;
  double conicity[std::size(amplitudes)];
};
const Case cases[] = {{"A", &wheel_a, &wheel_a, 460, {.125, .155, .188, .216, .254}},
                      {"B", &wheel_b, &wheel_b, 460, {.025, .025, .030, .236, .280}},
                      {"C", &wheel_c, &wheel_c, 460, {.515, .365, .271, .221, .191}},
                      {"H", &wheel_h, &wheel_h, 460, {.025, .025, .260, .323, .307}},
                      {"I", &wheel_i, &wheel_i, 460, {.000, .301, .493, .488, .476}},
                      {"B, left 1 mm less", &wheel_b, &wheel_b, 459, {.667, .377, .278, .228, .289}},
                      {"A right, B left", &wheel_b, &wheel_a, 460, {.136, .104, .124, .222, .270}}};

class en_15302 : public ::testing::Test {
 protected:
  std::unique_ptr<WheelRail> make(std::int32_t side, const Reference& profile, double radius) const {
    std::shared_ptr<Body> body[2];
    const Reference* const shape[2] = {&profile, &rail_a};
    for (std::size_t b = 0; b < 2; ++b) {
      body[b] = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
      body[b]->set_elastic(0, 2.1e5, 0.28);
      const std::vector<double> yz = shape[b]->points(0.1);
      body[b]->set_profile(std::ssize(yz) / 2, yz.data(), 0);
    }
    auto w = std::make_unique<WheelRail>(context, body[0], body[1], side);
    w->set_track(1500, 0, 0);  // distance of the profiles' origins; the gauge is 1435.16
    w->set_wheelset(1360, -70, radius);
    return w;
  }
  std::shared_ptr<Context> context = std::make_shared<Context>();
};

}  // namespace

// The standard allows a difference of 0.05, and of half of the conicity where that is less.
TEST_F(en_15302, reference_profiles_have_its_conicities) {
  for (const Case& c : cases) {
    const auto left = make(-1, *c.left, c.radius_left), right = make(1, *c.right, 460);
    WheelsetGeometry geometry(*left, *right);
    double found[std::size(amplitudes)], worst = 0;
    for (std::size_t i = 0; i < std::size(amplitudes); ++i) {
      double wavelength = 0;
      found[i] = geometry.motion(amplitudes[i], wavelength).conicity;
      const double off = found[i] - c.conicity[i];
      EXPECT_LE(std::abs(off), std::min(0.05, std::max(0.5 * c.conicity[i], 5e-4))) << c.name << ", " << amplitudes[i];
      worst = std::max(worst, std::abs(off));
      report(std::string(c.name) + ", " + std::to_string(amplitudes[i]) + " mm", found[i]);
    }
    expect_error(std::string(c.name) + ": conicity, worst of 1 to 5 mm", worst, 0.015);
    const double parameter = 0.5 * (found[3] - found[1]), due = 0.5 * (c.conicity[3] - c.conicity[1]);
    expect_error(std::string(c.name) + ": nonlinearity parameter, 1/mm", parameter - due, 0.006);
  }
}

}  // namespace rollcon
