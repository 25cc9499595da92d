#pragma once
/// Derivatives of the results of a solve, from Newton's system linearised at the solution with the
/// state of every node held (docs/theory.md, section 6). Each is computed when first asked for and
/// kept until the next solve.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/scene/enumerators.hpp"
#include "mesh/vec3.hpp"

namespace rollcon {

/// Per unit of a parameter, in the axes.
struct Rates {
  Vec3 force{}, moment{};          ///< on body 1, about the origin
  std::array<double, 4> motion{};  ///< by Motion
};

struct Sensitivities {
  static constexpr std::size_t parameters = 5;
  std::array<bool, parameters> known{};  ///< by Parameter, minus one
  std::array<Rates, parameters> rates{};

  // Work done since the last solve.
  std::int64_t right_sides = 0, factorizations = 0, linear_iterations = 0;
  double seconds = 0;

  // Storage kept for the next.
  std::vector<double> lambda[3];  ///< rates of the tractions
  std::vector<double> gap, slip[2], bound[2], b, x;

  void forget();
  void reserve(std::size_t nodes);
};

struct SolverState;

/// Of a solution that converged or has no contact. err_state: a tangential load is prescribed where
/// there is no friction. err_singular: the linearised system has no solution.
const Rates& find_rates(SolverState& state, Parameter parameter);

}  // namespace rollcon
