// Makes scenes whose tangential loads are given, several at a time, from none to a tenth more than friction carries.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "support/extremes_base.hpp"
#include "support/extremes_draw.hpp"
#include "support/frames.hpp"

namespace rollcon::extremes {
namespace {

using laws::Scheme;

constexpr std::array<std::int32_t, 3> tangential{ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_SPIN};

SurfaceMesh draw_frame(Draw& d, std::uint32_t seed, bool& regular) {
  constexpr double half = 1.3;
  const int n = 6 + d.pick(9);
  const auto lines = frames::uniform_lines(-half, half, n);
  regular = false;
  switch (d.pick(6)) {
    case 0:
      return frames::perturb(frames::rectangle(ElementType::quad4, lines, lines), d.between(0.05, 0.2), seed);
    case 1:
      return frames::perturb(frames::rectangle(ElementType::tri3, lines, lines), d.between(0.05, 0.2), seed);
    case 2: {
      constexpr ElementType quadratic[] = {ElementType::quad8, ElementType::quad9, ElementType::tri6};
      const auto few = frames::uniform_lines(-half, half, std::max(4, n / 2));
      return frames::rectangle(d.of(quadratic), few, few);
    }
    default:
      regular = true;
      return frames::rectangle(ElementType::quad4, lines, lines);
  }
}

double size_of(const Scene& scene) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& x : scene.given.frame.node) low = std::min(low, x[0]), high = std::max(high, x[0]);
  return 0.5 * (high - low);
}

}  // namespace

Scene forces_scene(std::uint32_t seed) {
  Draw d(seed + 0x51ed27U);
  Scene scene;
  scene.name = std::to_string(seed);
  const scenes::Elastic first = elastic(d.log_between(1e3, 1e6), d.between(0.1, 0.49));
  scene.body1 = scenes::HalfspaceBody{first};
  const int pairing = d.pick(4);  // half of them equal
  double e_star = closed_forms::effective_modulus(first);
  if (pairing == 0) {
    scene.body2 = scenes::RigidBody{};
  } else if (pairing == 1) {
    const scenes::Elastic second = elastic(first.young() * d.log_between(0.1, 10), d.between(0.1, 0.49));
    scene.body2 = scenes::HalfspaceBody{second};
    e_star = closed_forms::effective_modulus(first, second);
  } else {
    scene.body2 = scene.body1;
    e_star = closed_forms::effective_modulus(first, first);
  }
  laws::Given& g = scene.given;
  g.frame = draw_frame(d, seed, g.regular);
  const double aspect = d.log_between(0.5, 2), press = d.between(0.3, 1);
  const double a = std::sqrt(aspect) * std::sqrt(press), b = press / a;
  const auto hertz = closed_forms::hertz_from_axes(a, b, 0.01 * e_star, e_star);
  g.quadratic = {hertz.A, hertz.B, d.chance(0.3) ? 0.1 * hertz.A : 0.0};
  const double mu = d.log_between(0.02, 0.6);
  scene.friction(mu).creep(0, 0, 0);
  if (d.chance(0.5))
    scene.load(hertz.load);
  else
    scene.approach(hertz.approach);
  // Two or all three of the loads are given, their fractions anywhere on a sphere.
  std::array<double, 3> part{d.between(-1, 1), d.between(-1, 1), d.between(-1, 1)};
  const int combination = d.pick(4);  // number of the load that is not given; 3: all are
  for (std::size_t i = 0; i < 3; ++i) {
    if (combination == static_cast<int>(i)) part[i] = 0;
    if (combination != static_cast<int>(i) && d.chance(0.15)) part[i] = 0;
  }
  constexpr double shares[] = {0, 0.5, 0.8, 0.9, 0.95, 0.99, 1, 1.05, 1.1};
  const double share = d.chance(0.25) ? d.of(shares) : d.between(0, 1.1);
  const double length = std::hypot(part[0], part[1], part[2]);
  // Friction that turns about the middle carries 3 pi / 16 mu Fn times the radius.
  const double most = mu * hertz.load, unit[] = {most, most, 0.589 * most * std::sqrt(a * b)};
  for (std::size_t i = 0; i < 3; ++i)
    if (combination != static_cast<int>(i))
      scene.force(tangential[i], length > 0 ? share * part[i] / length * unit[i] : 0.0);
  constexpr Scheme schemes[] = {Scheme::characteristic, Scheme::characteristic, Scheme::least_squares, Scheme::godunov};
  scene.scheme(d.of(schemes));
  if (g.regular) {
    constexpr const char* operators[] = {"auto", "dense", "fft"};
    scene.set("operators", d.operators(operators));
    scene.set("accuracy", 1e-10);  // the accuracy of the tables
  }
  scene.group = std::string("random: several loads, ") + (pairing < 2 ? "unlike bodies" : "like bodies");
  scene.right = {ROLLCON_OK, ROLLCON_COARSE, ROLLCON_RIM_CONTACT, ROLLCON_ERR_LOAD};
  return scene;
}

double loads_over_friction(const Scene& scene) {
  constexpr double fast = 1e6;  // fast enough that every node slides that way
  const laws::Given& g = scene.given;
  const double size = size_of(scene);
  std::array<double, 3> wanted{}, unit{1, 1, 1 / size};
  std::array<bool, 3> given{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(tangential[i]) - 1;
    given[i] = g.by_force[k];
    wanted[i] = given[i] ? g.value[k] * unit[i] : 0;
  }
  Scene sliding = scene;
  for (std::size_t i = 0; i < 3; ++i)
    if (given[i]) sliding.motion(tangential[i], 0);
  const auto pair = make_pair(sliding);
  give_scene(*pair, sliding);
  // The function returns the loads wanted over those of sliding in a direction, both in that direction.
  const auto over = [&](const std::array<double, 3>& to) {
    const double asked = to[0] * wanted[0] + to[1] * wanted[1] + to[2] * wanted[2];
    if (!(asked > 0)) return 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      if (given[i]) sliding.motion(tangential[i], -fast * to[i] * unit[i]);
    pair->creep(sliding.given.value[0], sliding.given.value[1], sliding.given.value[3]);
    const std::int32_t status = rollcon_contact_solve(pair->handle());
    if (status < 0 || status == ROLLCON_NOT_CONVERGED) return double(NAN);
    const scenes::Solution s = pair->solution();
    const double carried = to[0] * s.force[0] + to[1] * s.force[1] + to[2] * s.moment[2] * unit[2];
    return carried > 0 ? asked / carried : double(INFINITY);
  };
  // The greatest ratio over all directions is found by steps that shrink, from the loads' own direction.
  const auto towards = [&](std::array<double, 3> v) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!given[i]) v[i] = 0;
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double& c : v) c /= length;
    return v;
  };
  const double length = std::hypot(wanted[0], wanted[1], wanted[2]);
  if (!(length > 0)) return 0;
  std::array<double, 3> best = towards(wanted);
  double most = over(best);
  for (double step = 0.5; step > 2e-3;) {
    bool better = false;
    for (std::size_t i = 0; i < 3; ++i)
      for (const double sign : {-1.0, 1.0}) {
        if (!given[i]) continue;
        std::array<double, 3> next = best;
        next[i] += sign * step;
        next = towards(next);
        const double there = over(next);
        if (there > most) best = next, most = there, better = true;
      }
    if (!better) step /= 2;
  }
  return most;
}

}  // namespace rollcon::extremes
