#include "rolling_cases.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <thread>

#include "support/frames.hpp"
#include "support/scene.hpp"

namespace rollcon::bench::rolling_cases {
namespace {

using closed_forms::Elastic;
constexpr std::size_t most_of_a_ratio = 25;

RollingCase draw_one(frames::Random& random, double ratio, double shear_of_two) {
  const double size = 5;
  const double a = size * std::sqrt(ratio), b = size / std::sqrt(ratio);
  const double s = random.between(0.03, 0.97), r = 3 * s / (1 - s);
  const double cosine = random.between(-1, 1), sine = std::sqrt(1 - cosine * cosine);
  const double angle = random.between(0, 2 * std::numbers::pi);
  const double unit = r * mu * load / (shear_of_two * a * b), wide = std::sqrt(std::cosh(std::log(ratio)));
  const double stiff = 4 * std::max(1.0, 0.3 * ratio);
  const double longitudinal = unit * sine * std::cos(angle) / stiff, lateral = unit * sine * std::sin(angle) / stiff;
  const double spin = unit * cosine / (stiff * wide * size);
  return {{shear_of_two, poisson, mu, a, b, load, longitudinal, lateral, spin}, ratio, s};
}

using Cases = std::span<const RollingCase>;

/// Calls `one` with all cases of a ratio and where their forces go, over threads.
std::vector<Forces> by_ratio(const std::vector<RollingCase>& drawn, int threads,
                             const std::function<void(Cases, Forces*)>& one) {
  std::vector<std::size_t> begin{0};
  for (std::size_t i = 1; i < drawn.size(); ++i)
    if (drawn[i].ratio != drawn[i - 1].ratio) begin.push_back(i);
  if (!drawn.empty()) begin.push_back(drawn.size());
  std::vector<Forces> force(drawn.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k; (k = next++) + 1 < begin.size();)
      one(std::span(drawn).subspan(begin[k], begin[k + 1] - begin[k]), &force[begin[k]]);
  };
  std::vector<std::thread> thread;
  for (int i = 1; i < threads; ++i) thread.emplace_back(work);
  work();
  for (std::thread& t : thread) t.join();
  return force;
}

void set_hertz(scenes::RollingPair& pair, const RollingCase& first, double modulus) {
  const double a = first.input[3], b = first.input[4], p0 = 3 * load / (2 * std::numbers::pi * a * b);
  const auto hertz = closed_forms::hertz_from_axes(a, b, p0, modulus);
  pair.gap_quadratic(hertz.A, hertz.B).load(load).friction(mu);
}

Forces solve_one(scenes::RollingPair& pair, double longitudinal, double lateral, double spin) {
  pair.creep(longitudinal, lateral, spin);
  pair.reset();
  pair.solve();
  double moment[3], f[3];
  rollcon_contact_get_resultant(pair.handle(), ROLLCON_LOCAL, f, moment);
  return {f[0], f[1], moment[2]};
}

/// Returns the forces of bodies that slide on each other like rigid ones: Coulomb's law under the pressure of Hertz.
Forces sliding(const RollingCase& c) {
  constexpr int radii = 160, around = 240;
  const auto& in = c.input;
  Forces f{};
  for (int i = 0; i < radii; ++i) {
    // The midpoints are in sqrt(1 - r^2), in which the pressure is smooth.
    const double z = (i + 0.5) / radii, r = std::sqrt(1 - z * z), part = 3 * mu * load * z * z / (radii * around);
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * std::numbers::pi * (j + 0.5) / around;
      const double x = in[3] * r * std::cos(angle), y = in[4] * r * std::sin(angle);
      const double along = in[6] - in[8] * y, across = in[7] + in[8] * x, speed = std::hypot(along, across);
      if (speed == 0) continue;
      f[0] -= part * along / speed;
      f[1] -= part * across / speed;
      f[2] -= part * (x * across - y * along) / speed;
    }
  }
  return f;
}

/// Holds two frames on one ellipse.
class Strips {
 public:
  Strips(const RollingCase& first, double finer) : Strips(first, finer, {.shear = shear, .poisson = first.input[1]}) {}
  Strips(const RollingCase& first, double finer, const Elastic& body) : coarse_(body, body), fine_(body, body) {
    // Long ellipses need many cells along their length.
    const double along = 12 * finer * std::clamp(std::pow(first.ratio, 0.2), 0.5, 1.35);
    const double across = 10 * finer * std::clamp(std::pow(first.ratio, -0.35), 0.8, 2.2);
    const auto nx = static_cast<std::int32_t>(std::lround(along)), ny = static_cast<std::int32_t>(std::lround(across));
    for (auto* pair : {&coarse_, &fine_}) {
      set_hertz(*pair, first, closed_forms::effective_modulus(body, body));
      const std::int32_t times = pair == &fine_ ? 2 : 1;
      rollcon_contact_frame_ellipse(pair->handle(), times * nx, times * ny, first.input[3], first.input[4], 0);
    }
  }
  Forces solve(const RollingCase& c) {
    constexpr double vast = 1e4;  // creepages that make all nodes slide
    const Forces found = extrapolated(c, 1), slid = extrapolated(c, vast), exact = sliding(c);
    Forces f{};
    for (std::size_t k = 0; k < 3; ++k) f[k] = found[k] + std::pow(c.magnitude, 3) * (exact[k] - slid[k]);
    return f;
  }

 private:
  Forces extrapolated(const RollingCase& c, double times) {
    const double x = times * c.input[6], y = times * c.input[7], spin = times * c.input[8];
    const Forces coarse = solve_one(coarse_, x, y, spin), fine = solve_one(fine_, x, y, spin);
    Forces f{};
    for (std::size_t k = 0; k < 3; ++k) f[k] = (4 * fine[k] - coarse[k]) / 3;
    return f;
  }
  scenes::RollingPair coarse_, fine_;
};

}  // namespace

std::vector<RollingCase> draw(std::size_t count, std::uint32_t seed, double shear_of_two) {
  frames::Random random(seed);
  std::vector<RollingCase> drawn;
  double ratio = 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % most_of_a_ratio == 0) ratio = std::exp(random.between(-std::log(greatest_ratio), std::log(greatest_ratio)));
    drawn.push_back(draw_one(random, ratio, shear_of_two));
  }
  return drawn;
}

std::vector<Forces> solve(const std::vector<RollingCase>& drawn, const Elastic& body1,
                          const std::optional<Elastic>& body2, double accuracy, int threads) {
  const double modulus =
      1 / ((1 - body1.poisson) / (2 * body1.shear) + (body2 ? (1 - body2->poisson) / (2 * body2->shear) : 0));
  return by_ratio(drawn, threads, [&](Cases cases, Forces* force) {
    scenes::RollingPair pair(body1, body2);
    set_hertz(pair, cases[0], modulus);
    pair.option("frame_accuracy", accuracy);
    for (const RollingCase& c : cases) *force++ = solve_one(pair, c.input[6], c.input[7], c.input[8]);
  });
}

std::vector<Forces> solve_on_strips(const std::vector<RollingCase>& drawn, double finer, int threads) {
  return by_ratio(drawn, threads, [&](Cases cases, Forces* force) {
    Strips strips(cases[0], finer);
    for (const RollingCase& c : cases) *force++ = strips.solve(c);
  });
}

}  // namespace rollcon::bench::rolling_cases
