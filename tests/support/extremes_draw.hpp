#pragma once
/// Draws the random scenes.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "rollcon.h"
#include "support/frames.hpp"

namespace rollcon::extremes {

class Draw {
 public:
  explicit Draw(std::uint32_t seed) : random_(seed) {
    for (int i = 0; i < 8; ++i) random_();  // neighbouring seeds begin alike
  }
  double between(double a, double b) { return random_.between(a, b); }
  double log_between(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
  int pick(int n) { return std::min(n - 1, static_cast<int>(between(0, n))); }
  bool chance(double p) { return between(0, 1) < p; }
  double sign() { return chance(0.5) ? 1 : -1; }
  template <class T, std::size_t N>
  T of(const T (&list)[N]) {
    return list[static_cast<std::size_t>(pick(static_cast<int>(N)))];
  }
  /// Draws dense operators for "fft" where the library has none: what is drawn afterwards is the same in all builds.
  template <std::size_t N>
  std::string operators(const char* const (&list)[N]) {
    const std::string drawn = of(list);
    return drawn == "fft" && !rollcon_has_feature("fftw") ? "dense" : drawn;
  }

 private:
  frames::Random random_;
};

}  // namespace rollcon::extremes
