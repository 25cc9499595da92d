// Tests the field by itself: equilibrium, Hooke's law between displacements and stresses, scaling, instruction sets.

#include <random>

#include "bodies/halfspace/inside/direct.hpp"
#include "bodies/halfspace/interior.hpp"
#include "support/frames.hpp"
#include "support/instruction_set.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using inside::Solid;
using inside::Values;

constexpr double accuracy = 1e-9;

Frame frame_of(double scale) {
  std::vector<double> x{0, 1, 1.8, 3, 4}, y{0, 0.7, 2, 3};
  for (std::vector<double>* lines : {&x, &y})
    for (double& v : *lines) v *= scale;
  return build_frame(frames::perturb(frames::rectangle(ElementType::quad8, x, y), 0.15, 3), Axes{});
}

/// Central differences of fourth order need values at -2h .. 2h along each axis.
constexpr double h = 0.01;
constexpr double weight[] = {1.0 / 12, -8.0 / 12, 0, 8.0 / 12, -1.0 / 12};

struct Derivatives {
  std::array<Values, 3> along;  ///< values by axis
  Values value;
};

std::vector<Derivatives> differentiate(const Frame& frame, const std::vector<double>& t, const Solid& solid,
                                       const std::vector<std::array<double, 3>>& points) {
  std::vector<std::array<double, 3>> all;
  for (const auto& p : points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int k = -2; k <= 2; ++k) {
        all.push_back(p);
        all.back()[axis] += k * h;
      }
  const std::vector<Values> values = inside::from_library(frame, t, solid, all, accuracy);
  std::vector<Derivatives> out(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    out[p].value = values[15 * p + 2];
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t c = 0; c < 9; ++c) {
        double sum = 0;
        for (std::size_t k = 0; k < 5; ++k) sum += weight[k] * values[15 * p + 5 * axis + k][c];
        out[p].along[axis][c] = sum / h;
      }
  }
  return out;
}

std::vector<std::array<double, 3>> random_points() {
  std::mt19937 engine(8);
  std::uniform_real_distribution<double> x(-1, 5), y(-1, 4), z(0.6, 3);
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 8; ++i) points.push_back({x(engine), y(engine), z(engine)});
  return points;
}

TEST(inside_field_laws, stresses_are_in_equilibrium) {
  const Frame frame = frame_of(1);
  const std::vector<double> t = inside::random_load(frame, 9);
  double worst = 0;
  for (const Derivatives& d : differentiate(frame, t, {2, 0.3}, random_points())) {
    const auto& [x, y, z] = d.along;
    worst = std::max({worst, std::abs(x[0] + y[3] + z[4]), std::abs(x[3] + y[1] + z[5]), std::abs(x[4] + y[5] + z[2])});
  }
  expect_error("divergence of the stress, traction/length", worst, 1.4e-7);
}

TEST(inside_field_laws, displacements_give_the_stresses_by_hooke) {
  const Frame frame = frame_of(1);
  const std::vector<double> t = inside::random_load(frame, 9);
  for (const auto& [nu, bound] : {std::pair{0.0, 2.5e-8}, {0.3, 2.5e-8}, {0.45, 1e-7}}) {
    const Solid solid{2, nu};
    const double lame = 2 * solid.shear * nu / (1 - 2 * nu);
    double worst = 0;
    for (const Derivatives& d : differentiate(frame, t, solid, random_points())) {
      const auto gradient = [&](std::size_t i, std::size_t j) { return d.along[j][6 + i]; };
      const double trace = lame * (gradient(0, 0) + gradient(1, 1) + gradient(2, 2));
      constexpr std::size_t pair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
      for (std::size_t c = 0; c < 6; ++c) {
        const auto [i, j] = pair[c];
        const double s = solid.shear * (gradient(i, j) + gradient(j, i)) + (i == j ? trace : 0);
        worst = std::max(worst, std::abs(s - d.value[c]));
      }
    }
    expect_error("Hooke's law, nu " + std::to_string(nu), worst, bound);
  }
}

TEST(inside_field_laws, moduli_tractions_and_lengths_scale) {
  const Frame frame = frame_of(1), large = frame_of(1e3);
  // The tractions lie on either side of 1.
  std::vector<double> t = inside::random_load(frame, 9), strong = t;
  for (double& v : t) v *= 1e-3;
  for (double& v : strong) v *= 1e3;
  std::vector<std::array<double, 3>> points = random_points(), far = points;
  points.push_back({1.8, 0.9, 1e-3});
  far.push_back(points.back());
  for (auto& p : far)
    for (double& v : p) v *= 1e3;
  const std::vector<Values> one = inside::from_library(frame, t, {2, 0.3}, points, 1e-6);
  const std::vector<Values> other = inside::from_library(large, strong, {2e7, 0.3}, far, 1e-6);
  double stress = 0, motion = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t c = 0; c < 9; ++c) {
      if (c < 6) stress = std::max(stress, std::abs(other[p][c] / 1e3 - one[p][c] * 1e3));
      if (c >= 6) motion = std::max(motion, std::abs(other[p][c] * 10 - one[p][c] * 1e3));
    }
  expect_error("lengths times 1e3, tractions times 1e6: stresses", stress, 1.4e-14);
  expect_error("and shear modulus times 1e7: displacements", motion, 3.3e-16);
}

// Far away the field is that of a point force, until its values or squares of distances leave the numbers' range.
TEST(inside_field_laws, far_away_it_is_that_of_a_point_force) {
  const Frame frame = frame_of(1);
  constexpr double area = 4 * 3, away[] = {0.6, -0.48, 0.64};
  const std::array<double, 3> pull{0.3, -0.2, 1}, force{area * pull[0], area * pull[1], area * pull[2]};
  std::vector<double> t;
  for (std::size_t k = 0; k < frame.x.size(); ++k) t.insert(t.end(), pull.begin(), pull.end());
  const Solid solid{2, 0.3};
  const Values one = inside::point_force(solid, force, away[0], away[1], away[2]);
  double stress = 0, motion = 0;
  for (const double r : {1e8, 1e15, 1e25, 1e80, 1e140}) {
    const Values s = inside::from_library(frame, t, solid, {{r * away[0], r * away[1], r * away[2]}}, accuracy)[0];
    for (std::size_t c = 0; c < 9; ++c) {
      double& worst = c < 6 ? stress : motion;
      worst = std::max(worst, std::abs(s[c] * r * (c < 6 ? r : 1) - one[c]) / area);
    }
  }
  expect_error("stresses 1e8 to 1e140 lengths away, times the distance squared", stress, 1e-7);
  expect_error("displacements there, times the distance", motion, 1e-7);
  for (const double r : {1e160, 1e250, 1e307}) {
    const Values s = inside::from_library(frame, t, solid, {{r, -r, r}}, accuracy)[0];
    for (const double v : s) EXPECT_EQ(v, 0) << r;
  }
}

TEST(inside_field_laws, instruction_sets_agree) {
  const Frame frame = frame_of(1);
  const std::vector<double> t = inside::random_load(frame, 9);
  std::vector<std::array<double, 3>> points = random_points();
  points.push_back({1.7, 0.9, 0});
  const std::vector<Values> best = inside::from_library(frame, t, {2, 0.3}, points, 1e-6);
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
    force_instruction_set(set);
    const std::vector<Values> other = inside::from_library(frame, t, {2, 0.3}, points, 1e-6);
    force_instruction_set(best_instruction_set());
    double worst = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
      for (std::size_t c = 0; c < 9; ++c) worst = std::max(worst, std::abs(other[p][c] - best[p][c]));
    expect_error("stresses of two instruction sets", worst, 1.4e-9);  // rounding at a depth of 1e-8
  }
}

}  // namespace
}  // namespace rollcon
