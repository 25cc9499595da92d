#include "bodies/section/harmonics.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/quadrature.hpp"
#include "support/index.hpp"

namespace rollcon::section {
namespace {

constexpr std::int64_t each = 40;  ///< harmonics up to which each is computed
constexpr double per_e = 14;       ///< samples for a factor e beyond
constexpr std::size_t points = 6;  ///< samples that an interpolated harmonic takes

}  // namespace

Harmonics::Harmonics(std::int64_t most) : most_(most) {
  for (std::int64_t n = 0; n <= std::min(each, most); ++n) sample_.push_back(static_cast<double>(n));
  for (int k = 1; sample_.back() < static_cast<double>(most); ++k)
    sample_.push_back(static_cast<double>(each) * std::exp(k / per_e));
}

Harmonics::Mix Harmonics::mix(std::int64_t n) const {
  if (n <= each) return {at(n), {n == 0 ? 1.0 : 1.0 / static_cast<double>(n)}};
  const double x = std::log(static_cast<double>(n));
  const auto after = std::upper_bound(sample_.begin(), sample_.end(), static_cast<double>(n));
  const std::size_t place = at(after - sample_.begin());
  Mix mix;
  mix.first = std::min(place - points / 2, sample_.size() - points);
  for (std::size_t i = 0; i < points; ++i) {
    double weight = 1 / static_cast<double>(n);
    const double own = std::log(sample_[mix.first + i]);
    for (std::size_t j = 0; j < points; ++j)
      if (const double other = std::log(sample_[mix.first + j]); j != i) weight *= (x - other) / (own - other);
    mix.weight.push_back(weight);
  }
  return mix;
}

StationWeights station_weights(const Harmonics& harmonics, double half, const std::vector<double>& offset,
                               bool slopes) {
  constexpr double pi = 3.14159265358979323846;
  const LineRule rule = gauss_legendre(20);
  const auto count = static_cast<std::int64_t>(offset.size());
  StationWeights out;
  RowMatrix<double>* kernel[4] = {&out.cosine, &out.sine, &out.cosine_slope, &out.sine_slope};
  const std::size_t kernels = slopes ? 4 : 2;
  for (std::size_t v = 0; v < kernels; ++v)
    kernel[v]->resize(3 * count, static_cast<std::int64_t>(harmonics.samples().size()));
  for (std::int64_t n = 0; n <= harmonics.most(); ++n) {
    const double number = static_cast<double>(n);
    // Parts of the monomials along cos and sin of the stretch.
    std::array<double, 3> part{};
    for (std::size_t g = 0; g < rule.x.size(); ++g) {
      const double x = rule.x[g], w = rule.w[g] * half / (n == 0 ? 2 * pi : pi);
      part[0] += w * std::cos(number * half * x);
      part[1] += w * x * std::sin(number * half * x);
      part[2] += w * x * x * std::cos(number * half * x);
    }
    const Harmonics::Mix mix = harmonics.mix(n);
    for (std::int64_t k = 0; k < count; ++k) {
      const double c = std::cos(number * offset[at(k)]), s = std::sin(number * offset[at(k)]);
      for (std::int64_t m = 0; m < 3; ++m) {
        const double even[4] = {c, s, -number * s, number * c}, odd[4] = {s, -c, number * c, number * s};
        for (std::size_t v = 0; v < kernels; ++v) {
          double* row = kernel[v]->row(m * count + k) + mix.first;
          const double value = part[at(m)] * (m == 1 ? odd : even)[v];
          for (std::size_t i = 0; i < mix.weight.size(); ++i) row[i] += mix.weight[i] * value;
        }
      }
    }
  }
  return out;
}

}  // namespace rollcon::section
