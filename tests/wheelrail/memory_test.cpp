/// Forces of a wheel are a function of its position: they do not jump, and do not depend on what was solved before.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "wheel_rail_fixture.hpp"

namespace rollcon {
namespace {

class memory : public wheels {
 protected:
  using Totals = std::array<double, 6>;

  /// Holds a path of positions and velocities, by t from 0 to 1.
  struct Path {
    std::array<double, 6> position{}, velocity{}, way{};
  };
  static Path path(std::mt19937& random) {
    const auto draw = [&](double size) { return std::uniform_real_distribution<>(-size, size)(random); };
    return {{0, draw(4), 0, draw(1e-3), draw(4e-3), 0},
            {2000, draw(4), draw(1), draw(2e-3), draw(4e-3), -4.3459 * (1 + draw(2e-3))},
            {0, 0.4, 0, draw(1e-4), draw(1e-3), 0}};
  }
  /// Returns force over mu N, and the moment over that and the radius.
  static Totals solve(WheelRail& w, const Path& p, double t) {
    std::array<double, 6> position = p.position;
    for (std::size_t k = 0; k < 6; ++k) position[k] += t * p.way[k];
    w.set_position(position.data());
    w.set_velocity(p.velocity.data());
    EXPECT_EQ(w.solve(), Status::ok);
    Totals f{};
    w.resultant(false, f.data(), f.data() + 3);
    for (std::size_t k = 0; k < 6; ++k) f[k] /= mu * 10000 * (k < 3 ? 1 : 460);
    return f;
  }
  static double apart(const Totals& a, const Totals& b) {
    double most = 0;
    for (std::size_t k = 0; k < 6; ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
  }
};

// Vertical forces are met to 1e-6. The interval with the largest second difference is halved towards the larger change.
TEST_F(memory, forces_neither_jump_nor_remember) {
  std::mt19937 random(11);
  for (const double accuracy : {0.02, 0.01}) {
    auto cold = make(), warm = make();
    for (WheelRail* w : {cold.get(), warm.get()}) {
      w->set_real("accuracy", accuracy);
      w->prescribe_vertical(2, 10000);
    }
    double jump = 0, remembered = 0;
    for (int line = 0; line < 4; ++line) {
      const Path p = path(random);
      constexpr int steps = 12;
      std::array<Totals, steps + 1> f{};
      int widest = 0;
      double most = 0;
      for (int i = 0; i <= steps; ++i) {
        cold->reset();
        f[static_cast<std::size_t>(i)] = solve(*cold, p, static_cast<double>(i) / steps);
        remembered = std::max(remembered, apart(f[static_cast<std::size_t>(i)], solve(*warm, p, i / double{steps})));
        if (i < 2) continue;
        const auto at = [&](int back) { return f[static_cast<std::size_t>(i - back)]; };
        Totals straight{};
        for (std::size_t k = 0; k < 6; ++k) straight[k] = 2 * at(1)[k] - at(2)[k];
        if (const double off = apart(at(0), straight); off > most) most = off, widest = i - 1;
      }
      double a = static_cast<double>(widest) / steps, b = static_cast<double>(widest + 1) / steps;
      Totals fa = f[static_cast<std::size_t>(widest)], fb = f[static_cast<std::size_t>(widest) + 1];
      for (int halving = 0; halving < 16; ++halving) {
        const double middle = (a + b) / 2;
        cold->reset();
        const Totals fm = solve(*cold, p, middle);
        const bool first = apart(fa, fm) > apart(fm, fb);
        (first ? b : a) = middle;
        (first ? fb : fa) = fm;
      }
      jump = std::max(jump, apart(fa, fb));
    }
    const std::string at = "accuracy " + std::to_string(accuracy).substr(0, 4) + ", over mu N: ";
    expect_error(at + "greatest jump", jump, 1e-5);
    expect_error(at + "warm beside from nothing", remembered, 2e-5);
  }
}

}  // namespace
}  // namespace rollcon
