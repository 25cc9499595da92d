#pragma once
/// Draws random Hertzian cases of steady rolling, and finds their forces by frames of the library.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/closed_forms.hpp"

namespace rollcon::bench {

/// Holds the forces along and across, and the spin moment.
using Forces = std::array<double, 3>;

/// Holds the input of rollcon_table_evaluate.
struct RollingCase {
  std::array<double, 9> input;
  double ratio;      ///< ratio of semi-axes
  double magnitude;  ///< s = r / (r + 3), where linear theory asks for about r mu Fn
};

namespace rolling_cases {

constexpr double poisson = 0.28, shear = 82000, mu = 0.3, load = 1e5, greatest_ratio = 25;
constexpr closed_forms::Elastic steel{.shear = shear, .poisson = poisson};

/// Draws creepages whose linear theory asks for 0.1 to 100 mu Fn, evenly in s, in any direction, spin among them.
/// Several cases of one ratio are next to each other.
std::vector<RollingCase> draw(std::size_t count, std::uint32_t seed, double shear_of_two);

/// Returns the forces of each case, over threads, by frames that the library makes; body 2 is rigid, if none.
std::vector<Forces> solve(const std::vector<RollingCase>& drawn, const closed_forms::Elastic& body1,
                          const std::optional<closed_forms::Elastic>& body2, double accuracy, int threads);

/// Returns the forces of bodies of steel's shear modulus and each case's Poisson's ratio by two frames of strips on the
/// known ellipse, `finer` and twice `finer` times as fine as those of the standard table, extrapolated. Their error
/// under full sliding, which has an integral, is taken off times s^3.
std::vector<Forces> solve_on_strips(const std::vector<RollingCase>& drawn, double finer, int threads);

}  // namespace rolling_cases
}  // namespace rollcon::bench
