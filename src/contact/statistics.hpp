#pragma once
/// Provides numbers about the last solve, by name.

#include <span>

#include "support/statistic_info.hpp"

namespace rollcon {

class Solver;

struct Statistic {
  StatisticInfo info;
  double (*value)(Solver&);
  bool of_cases = false;  ///< known for the cases of a list, too
};

std::span<const Statistic> statistics();  ///< all statistics of a solve
/// Returns the value of one statistic. err_option: unknown name; err_state: there is no solution.
double find_statistic(Solver& solver, const char* name);

}  // namespace rollcon
