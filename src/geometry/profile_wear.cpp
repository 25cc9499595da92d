#include "geometry/profile_wear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rollcon {

std::vector<double> shares_of_length(std::span<const double> s) {
  if (s.size() == 1) return {1};
  std::vector<double> share(s.size(), 0.0);
  for (std::size_t j = 0; j + 1 < s.size(); ++j) {
    const double half = 0.5 * (s[j + 1] - s[j]);
    share[j] += half;
    share[j + 1] += half;
  }
  return share;
}

std::vector<double> lengths_along(std::span<const Vec2> point) {
  std::vector<double> s(point.size(), 0.0);
  for (std::size_t j = 1; j < point.size(); ++j) s[j] = s[j - 1] + length(point[j] - point[j - 1]);
  return s;
}

void smooth_keeping_volume(std::span<const double> s, double length, std::vector<double>& value) {
  const std::size_t n = s.size();
  if (n < 2 || !(length > 0)) return;
  const double reach = length / (2 * std::numbers::pi);
  const std::vector<double> mass = shares_of_length(s);
  // The matrix is tridiagonal and solved by elimination from the first row on.
  std::vector<double> diagonal = mass, beside(n, 0.0);
  for (std::size_t j = 0; j < n; ++j) value[j] *= mass[j];
  for (std::size_t j = 0; j + 1 < n; ++j) {
    beside[j] = reach * reach / (s[j + 1] - s[j]);
    diagonal[j] += beside[j];
    diagonal[j + 1] += beside[j];
  }
  for (std::size_t j = 0; j + 1 < n; ++j) {
    const double factor = beside[j] / diagonal[j];
    diagonal[j + 1] -= factor * beside[j];
    value[j + 1] += factor * value[j];
  }
  value[n - 1] /= diagonal[n - 1];
  for (std::size_t j = n - 1; j-- > 0;) value[j] = (value[j] + beside[j] * value[j + 1]) / diagonal[j];
}

WornProfile wear_profile(std::span<const Vec2> point, std::vector<double> rate, double side, double distance,
                         double most_depth, double smoothing) {
  smooth_keeping_volume(lengths_along(point), smoothing, rate);
  const double fastest = *std::max_element(rate.begin(), rate.end());
  WornProfile worn;
  worn.taken = fastest * distance > most_depth ? most_depth / fastest : distance;
  for (std::size_t j = 0; j < point.size(); ++j) {
    const Vec2 along = point[std::min(j + 1, point.size() - 1)] - point[j > 0 ? j - 1 : 0];
    // The normal points towards greater z, whichever way the points go.
    const double turn = (along[0] < 0 ? -1 : 1) * side / length(along);
    worn.point.push_back(point[j] + (worn.taken * rate[j] * turn) * Vec2{-along[1], along[0]});
  }
  return worn;
}

}  // namespace rollcon
