#pragma once
/// Solves contacts of half-spaces or blocks whose results are asked for derivatives.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon::sensitivity_test {

using scenes::Elastic;
using scenes::RollingPair;

inline constexpr std::int32_t parameters[] = {ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_NORMAL, ROLLCON_SPIN,
                                              ROLLCON_FRICTION};
/// Holds force, moment, approach, creepages and spin.
using Values = std::array<double, 10>;
inline void must(std::int32_t status) {
  ASSERT_EQ(status, ROLLCON_OK) << rollcon_status_string(status);
}

inline Values observe(const RollingPair& pair) {
  Values v{};
  must(rollcon_contact_get_resultant(pair.handle(), ROLLCON_LOCAL, &v[0], &v[3]));
  must(rollcon_contact_get_motion(pair.handle(), &v[6], &v[7]));
  return v;
}

inline Values derivatives(const RollingPair& pair, std::int32_t parameter) {
  Values v{};
  must(rollcon_contact_get_sensitivity(pair.handle(), parameter, &v[0], &v[3], &v[6], &v[7]));
  return v;
}

inline std::vector<std::int32_t> states(const RollingPair& pair) {
  return pair.solution().state;
}

/// Says what is prescribed: motions first; those of `by_force` then by the loads that they cause.
struct Drive {
  double approach, along, across, spin, mu;
  std::array<bool, 4> by_force{};  ///< longitudinal, lateral, normal, spin
  /// Sets a law other than Coulomb's, given by a function of mu.
  std::function<void(RollingPair&, double)> law{};
};

struct Setting {
  std::unique_ptr<RollingPair> pair;
  Drive drive;
  std::array<double, 4> value{};

  /// Solves; a few nodes touch blocks, but rates of the discrete problem are exact all the same.
  void solve() {
    const std::int32_t status = pair->solve();
    EXPECT_TRUE(status == ROLLCON_OK || status == ROLLCON_COARSE) << status;
  }

  void friction(double mu) {
    if (drive.law)
      drive.law(*pair, mu);
    else
      pair->friction(mu);
  }

  void prescribe(std::size_t direction, double v) {
    const std::int32_t how = drive.by_force[direction] ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION;
    must(rollcon_contact_prescribe(pair->handle(), static_cast<std::int32_t>(direction) + 1, how, v));
  }

  /// Solves, and prescribes the loads found where wanted.
  Setting(std::unique_ptr<RollingPair> made, const Drive& wanted) : pair(std::move(made)), drive(wanted) {
    pair->option("tolerance", 1e-13);
    friction(drive.mu);
    pair->approach(drive.approach).creep(drive.along, drive.across, drive.spin);
    solve();
    const Values v = observe(*pair);
    value = {drive.along, drive.across, drive.approach, drive.spin};
    const std::array<double, 4> load = {v[0], v[1], -v[2], v[5]};
    for (std::size_t d = 0; d < 4; ++d) {
      if (drive.by_force[d]) value[d] = load[d];
      prescribe(d, value[d]);
    }
    solve();
  }

  double scale(std::int32_t parameter) const {
    if (parameter == ROLLCON_FRICTION) return 1;
    const auto d = static_cast<std::size_t>(parameter) - 1;
    if (value[d] != 0) return std::abs(value[d]);
    return 1e-3;  // step for a creepage or spin that is zero
  }

  /// Solves with the parameter moved; the states of the nodes are those of the last solve.
  Values moved(std::int32_t parameter, double by) {
    const std::vector<std::int32_t> before = states(*pair);
    const auto d = static_cast<std::size_t>(parameter) - 1;
    if (parameter == ROLLCON_FRICTION)
      friction(drive.mu * (1 + by));
    else
      prescribe(d, value[d] + by);
    solve();
    EXPECT_EQ(states(*pair), before) << "choose a state away from changes of stick and slip";
    const Values v = observe(*pair);
    if (parameter == ROLLCON_FRICTION)
      friction(drive.mu);
    else
      prescribe(d, value[d]);
    return v;
  }

  /// Returns the fourth-order central difference.
  Values difference(std::int32_t parameter) {
    const double h = 1e-4 * scale(parameter);
    const Values a = moved(parameter, -2 * h), b = moved(parameter, -h), c = moved(parameter, h),
                 e = moved(parameter, 2 * h);
    Values slope{};
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = (8 * (c[i] - b[i]) - (e[i] - a[i])) / (12 * h);
    return slope;
  }
};

// The scene is a sphere of radius 50 on a half-space or a rigid plane, with a contact radius of about 1.
inline const Elastic steel{.shear = 1e4 / 2.6, .poisson = 0.3};
inline const Elastic soft{.shear = 1e4 / 2.2, .poisson = 0.1};

inline std::unique_ptr<RollingPair> half_spaces(const std::optional<Elastic>& other, int n = 14) {
  auto pair = std::make_unique<RollingPair>(steel, other);
  pair->rectangle(ElementType::quad4, n, n, 1.3, 1.3).gap_quadratic(0.011, 0.009);
  return pair;
}

inline const Drive rolling{0.02, -9e-4, 5e-4, 6e-4, 0.3};

inline Drive with(std::array<bool, 4> by_force, Drive drive = rolling) {
  drive.by_force = by_force;
  return drive;
}

inline constexpr std::array<bool, 4> ways[] = {{false, false, false, false}, {false, false, true, false},
                                               {true, false, false, false},  {false, true, true, false},
                                               {false, false, false, true},  {true, true, true, true}};

}  // namespace rollcon::sensitivity_test
