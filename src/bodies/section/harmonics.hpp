#pragma once
/// Sums harmonics: says which are computed, how others follow from them, and how much of each a load between two
/// stations has.

#include <array>
#include <cstdint>
#include <vector>

#include "linalg/dense.hpp"

namespace rollcon::section {

/// Represents harmonics 0 ... most by samples: all n up to 40, and beyond them 14 for each factor e. Others are
/// interpolated, because n times a response is smooth in log n.
class Harmonics {
 public:
  explicit Harmonics(std::int64_t most);

  const std::vector<double>& samples() const { return sample_; }
  std::int64_t most() const { return most_; }
  /// Holds weights of consecutive samples. The weighted sum of n times the response (for n = 0 of the response itself)
  /// is the response of a harmonic; weights include 1 / n.
  struct Mix {
    std::size_t first = 0;
    std::vector<double> weight;
  };
  Mix mix(std::int64_t n) const;

 private:
  std::int64_t most_;
  std::vector<double> sample_;
};

/// Holds weights that turn samples into responses at stations: a row times the samples of n times the response is the
/// displacement there under a load 1, x or x^2 on the stretch x = -1 ... 1 between two stations. A stretch is 2 * half
/// radians long, and offsets are in radians from its middle.
struct StationWeights {
  /// Rows are by monomial, then by offset; the slopes are derivatives by the offset.
  RowMatrix<double> cosine, sine, cosine_slope, sine_slope;
};
StationWeights station_weights(const Harmonics& harmonics, double half, const std::vector<double>& offset, bool slopes);

}  // namespace rollcon::section
