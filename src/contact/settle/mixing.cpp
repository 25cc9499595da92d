#include "contact/settle/mixing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollcon {
namespace {

constexpr std::size_t most = 5;
using Matrix = std::array<std::array<double, most>, most>;

// Solves a system that is symmetric and positive but for rounding: directions that say nothing new are left out.
void solve(Matrix& a, std::array<double, most>& b, std::size_t n) {
  constexpr double new_enough = 1e-12;
  std::array<double, most> diagonal{};
  for (std::size_t i = 0; i < n; ++i) diagonal[i] = a[i][i];
  std::array<bool, most> left_out{};
  for (std::size_t i = 0; i < n; ++i) {
    left_out[i] = !(a[i][i] > new_enough * diagonal[i]);
    if (left_out[i]) continue;
    for (std::size_t r = i + 1; r < n; ++r) {
      const double part = a[r][i] / a[i][i];
      for (std::size_t c = i; c < n; ++c) a[r][c] -= part * a[i][c];
      b[r] -= part * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    double sum = b[i];
    for (std::size_t c = i + 1; c < n; ++c) sum -= a[i][c] * b[c];
    b[i] = left_out[i] ? 0 : sum / a[i][i];
  }
}

}  // namespace

void Mixing::next(std::span<double> x, std::span<const double> f, std::span<const double> weight) {
  const std::size_t n = x.size();
  if (steps_ > 0) {
    auto& dx = change_x_[(steps_ - 1) % depth];
    auto& df = change_f_[(steps_ - 1) % depth];
    dx.resize(n), df.resize(n);
    for (std::size_t k = 0; k < n; ++k) dx[k] = x[k] - last_x_[k], df[k] = f[k] - last_f_[k];
  }
  last_x_.assign(x.begin(), x.end());
  last_f_.assign(f.begin(), f.end());
  const std::size_t used = std::min(steps_, depth);
  ++steps_;
  Matrix a{};
  std::array<double, most> b{};
  const auto product = [&](std::span<const double> u, std::span<const double> v) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += weight[k] * weight[k] * u[k] * v[k];
    return sum;
  };
  for (std::size_t i = 0; i < used; ++i) {
    for (std::size_t j = 0; j < used; ++j) a[i][j] = product(change_f_[i], change_f_[j]);
    b[i] = product(change_f_[i], f);
  }
  solve(a, b, used);
  for (std::size_t k = 0; k < n; ++k) {
    double step = f[k];
    for (std::size_t i = 0; i < used; ++i) step -= b[i] * (change_x_[i][k] + change_f_[i][k]);
    x[k] += step;
  }
}

}  // namespace rollcon
