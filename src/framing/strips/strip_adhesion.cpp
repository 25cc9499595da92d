#include "framing/strips/strip_adhesion.hpp"

#include <cmath>
#include <numbers>

#include "framing/hertz.hpp"

namespace rollcon::strips {
namespace {

/// Friction that holds any node.
constexpr double boundless = 1e9;

struct Paraboloids : PlaneField {
  QuadraticGap gap;
  void at(std::span<const Vec2> point, double* value, Vec2* slope) const override {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const auto [x, y] = point[i];
      value[i] = gap.a * x * x + gap.b * y * y;
      if (slope) slope[i] = {2 * gap.a * x, 2 * gap.b * y};
    }
  }
};

}  // namespace

bool creep_rates(StripContact& contact, const StripScene& scene, const StripSolution& solution, Adhesion& found) {
  std::array<StripParameter, 4> by;
  std::array<StripTotals, 4> rate;
  for (std::size_t k = 0; k < 3; ++k) by[k].motion[k] = 1;
  by[3].slip = scene.slip;
  if (!contact.rates(scene, solution, by, rate)) return false;
  for (std::size_t k = 0; k < 4; ++k) found.force[k] = rate[k].force;
  return true;
}

bool adhere(StripContact& contact, StripScene scene, const StripSolution& solution, Adhesion& found) {
  scene.mu = boundless;
  scene.friction = nullptr;
  scene.force_given = {};
  return creep_rates(contact, scene, solution, found);
}

double adhere_on_ellipse(StripContact& contact, const StripBodies& bodies, double along, double across,
                         StripCounts counts, StripSolution& solution, Adhesion& found) {
  const double modulus = 1 / (std::numbers::pi * bodies.cn);
  Paraboloids paraboloids;
  paraboloids.gap = gap_with_ratio(along / across, modulus);
  const HertzContact unit = hertz_by_load(paraboloids.gap, modulus, 1);
  StripScene scene;
  scene.bodies = bodies;
  scene.gap = &paraboloids;
  scene.value = std::pow(along * across / (unit.larger * unit.smaller), 1.5);
  constexpr double reach = 1.5;
  const Rectangle box{-reach * along, reach * along, -reach * across, reach * across};
  const bool solved = contact.solve(scene, box, counts, solution, false).status == StripStatus::solved &&
                      adhere(contact, scene, solution, found);
  return solved ? 1.5 * scene.value / (std::numbers::pi * along * across) : 0;
}

}  // namespace rollcon::strips
