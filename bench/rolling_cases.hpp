#pragma once
/// Random Hertzian cases of steady rolling, and their forces by frames of the library.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/closed_forms.hpp"

namespace rollcon::bench {

/// Along, across, spin moment.
using Forces = std::array<double, 3>;

/// Input: of rollcon_table_evaluate.
struct RollingCase {
  std::array<double, 9> input;
  double ratio;      ///< of semi-axes
  double magnitude;  ///< s = r / (r + 3), linear theory asking for about r mu Fn
};

namespace rolling_cases {

constexpr double poisson = 0.28, shear = 82000, mu = 0.3, load = 1e5, greatest_ratio = 25;
constexpr closed_forms::Elastic steel{.shear = shear, .poisson = poisson};

/// Creepages whose linear theory asks for 0.1 to 100 mu Fn, evenly in s, in any direction, spin among them. Several
/// cases of one ratio are next to each other.
std::vector<RollingCase> draw(std::size_t count, std::uint32_t seed, double shear_of_two);

/// Of each case, over threads, by frames that the library makes; body 2 rigid, if none.
std::vector<Forces> solve(const std::vector<RollingCase>& drawn, const closed_forms::Elastic& body1,
                          const std::optional<closed_forms::Elastic>& body2, double accuracy, int threads);

/// Likewise of steel on steel by two frames of strips on the known ellipse, `finer` and twice `finer` times as fine as
/// those of the standard table, extrapolated. Their error under full sliding, which has an integral, is taken off times
/// s^3.
std::vector<Forces> solve_on_strips(const std::vector<RollingCase>& drawn, double finer, int threads);

}  // namespace rolling_cases
}  // namespace rollcon::bench
