#pragma once
/// Finds fixed points x = g(x) by Anderson's mixing (Walker & Ni 2011), which combines the last few x best.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace rollcon {

class Mixing {
 public:
  void start() { steps_ = 0; }
  /// Makes x the next one; f = g(x) - x; weight: that of each entry in what is to become small.
  void next(std::span<double> x, std::span<const double> f, std::span<const double> weight);

 private:
  static constexpr std::size_t depth = 5;
  std::array<std::vector<double>, depth> change_x_, change_f_;
  std::vector<double> last_x_, last_f_;
  std::size_t steps_ = 0;
};

}  // namespace rollcon
