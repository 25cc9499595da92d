#pragma once
/// Sums harmonics: which of them are computed, how the others follow, and what a load between two stations has of each.

#include <array>
#include <cstdint>
#include <vector>

#include "linalg/dense.hpp"

namespace rollcon::section {

/// Names harmonics 0 ... most by samples: all up to 40, then 14 for each factor e. Others are interpolated: n times a
/// response is smooth in log n.
class Harmonics {
 public:
  explicit Harmonics(std::int64_t most);

  const std::vector<double>& samples() const { return sample_; }
  std::int64_t most() const { return most_; }
  /// Holds samples and weights whose sum, of n times the response (the response itself for n = 0), is that of a
  /// harmonic; weights include 1 / n.
  struct Mix {
    std::size_t first = 0;
    std::vector<double> weight;
  };
  Mix mix(std::int64_t n) const;

 private:
  std::int64_t most_;
  std::vector<double> sample_;
};

/// Weighs samples to responses at stations: a row of the product with samples of n times the response is
/// the displacement there, under loads 1, x or x^2 over the stretch x in -1 ... 1 between two stations. Stretches are
/// 2 half radians long and offsets count in radians from their middle.
struct StationWeights {
  /// Rows by monomial, then by offset, of both kernels and of their derivatives by the offset.
  RowMatrix<double> cosine, sine, cosine_slope, sine_slope;
};
StationWeights station_weights(const Harmonics& harmonics, double half, const std::vector<double>& offset, bool slopes);

}  // namespace rollcon::section
