#pragma once
/// Numbers about the last solve, by name.

#include <span>

namespace rollcon {

struct SolverState;

struct Statistic {
  const char* name;
  double (*value)(SolverState&);
  bool of_cases = false;  ///< told of the cases of a list, too
};

std::span<const Statistic> statistics();

}  // namespace rollcon
