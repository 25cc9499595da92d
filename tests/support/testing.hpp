#pragma once
/// Provides what nearly every test includes, and prints one line with what was measured, the error and its bound.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rollcon {

inline double relative(double value, double reference) {
  return std::abs(value - reference) / std::abs(reference);
}

/// Expects |error| <= bound; a NaN fails.
inline void expect_error(const std::string& what, double error, double bound) {
  std::printf("%-66s error %9.2e  bound %8.1e%s\n", what.c_str(), error, bound,
              std::abs(error) <= bound ? "" : "  FAILS");
  EXPECT_LE(std::abs(error), bound) << what;
}

/// Prints a number that the method's theory does not bound.
inline void report(const std::string& what, double value) {
  std::printf("%-66s value %9.2e\n", what.c_str(), value);
}

/// Returns the observed order of convergence from errors at two mesh sizes.
inline double observed_order(double error_coarse, double error_fine, double h_coarse, double h_fine) {
  return std::log(std::abs(error_coarse / error_fine)) / std::log(h_coarse / h_fine);
}

inline void expect_order(const std::string& what, double order, double least) {
  std::printf("%-66s order %9.2f  least %8.1f%s\n", what.c_str(), order, least, order >= least ? "" : "  FAILS");
  EXPECT_GE(order, least) << what;
}

}  // namespace rollcon
