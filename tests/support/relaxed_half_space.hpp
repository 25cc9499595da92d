#pragma once
/// Solves the rolling of a rigid body without friction on a half-space of one relaxation time, independently of the
/// library: Panek and Kalker's integral equation with pressures that are constant on rectangles, collocation in their
/// middles, Love's closed form filtered by quadrature, and an active set solved by elimination.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/quadrature.hpp"

namespace rollcon {

class RelaxedHalfSpace {
 public:
  /// Describes the body's gap cx x^2 + cy y^2 - approach, and the half-space: glassy E*, creep ratio, and the creep
  /// time times the speed towards +x.
  struct Scene {
    double cx, cy, approach, modulus, ratio, length;
  };
  /// Divides |x| < half_x, |y| < half_y into nx by 2 ny rectangles.
  RelaxedHalfSpace(const Scene& scene, double half_x, double half_y, int nx, int ny)
      : s_(scene), nx_(nx), ny_(ny), hx_(2 * half_x / nx), hy_(half_y / ny), low_(-half_x) {
    fill_table();
    solve();
  }
  double force() const {
    return sum([](double) { return 1.0; });
  }
  /// Returns the moment of the pressures about y.
  double moment() const {
    return sum([](double x) { return x; });
  }
  double largest_pressure() const { return *std::max_element(pressure_.begin(), pressure_.end()); }

 private:
  double x(int i) const { return low_ + (i + 0.5) * hx_; }
  double y(int j) const { return (j + 0.5) * hy_; }
  template <class F>
  double sum(const F& f) const {
    double all = 0;
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i) all += 2 * hx_ * hy_ * f(x(i)) * pressure_[index(i, j)];
    return all;
  }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * nx_ + i); }

  /// Integrates 1/r over a rectangle around the origin.
  double love(double dx, double dy) const {
    const auto corner = [](double a, double b) {
      return (a != 0 ? a * std::asinh(b / std::abs(a)) : 0) + (b != 0 ? b * std::asinh(a / std::abs(b)) : 0);
    };
    const double a = hx_ / 2, b = hy_ / 2;
    return corner(dx + a, dy + b) - corner(dx - a, dy + b) - corner(dx + a, dy - b) + corner(dx - a, dy - b);
  }
  /// Adds what the material remembers: the mean of Love's function upstream, by Gauss's rule on half cells and, further
  /// away, on panels that grow.
  double displaced(double dx, double dy) const {
    static const LineRule rule = gauss_legendre(8);
    double memory = 0;
    for (double from = 0, length = hx_ / 2; from < 45 * s_.length; from += length) {
      length = std::max(hx_ / 2, std::min(0.3 * (dx + from), s_.length));
      for (std::size_t q = 0; q < rule.x.size(); ++q) {
        const double at = from + length * (1 + rule.x[q]) / 2;
        memory += length / 2 * rule.w[q] * std::exp(-at / s_.length) / s_.length * love(dx + at, dy);
      }
    }
    return (love(dx, dy) + s_.ratio * memory) / (std::numbers::pi * s_.modulus);
  }
  void fill_table() {
    table_.resize(static_cast<std::size_t>((2 * nx_ - 1) * 2 * ny_));
    for (int j = 0; j < 2 * ny_; ++j)
      for (int i = 1 - nx_; i < nx_; ++i) table_[entry(i, j)] = displaced(i * hx_, j * hy_);
  }
  std::size_t entry(int i, int j) const { return static_cast<std::size_t>(j * (2 * nx_ - 1) + i + nx_ - 1); }
  /// Returns the displacement of rectangle (i, j) under unit pressures on (k, m) and its mirror image.
  double influence(int i, int j, int k, int m) const {
    return table_[entry(i - k, std::abs(j - m))] + table_[entry(i - k, j + m + 1)];
  }
  double overlap(int i, int j) const { return s_.approach - s_.cx * x(i) * x(i) - s_.cy * y(j) * y(j); }

  void solve() {
    std::vector<std::pair<int, int>> active;
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i)
        if (overlap(i, j) > 0) active.emplace_back(i, j);
    for (int round = 0; round < 30; ++round) {
      std::vector<double> matrix, p;
      for (const auto& [i, j] : active) {
        for (const auto& [k, m] : active) matrix.push_back(influence(i, j, k, m));
        p.push_back(overlap(i, j));
      }
      eliminate(matrix, p);
      pressure_.assign(index(0, ny_), 0.0);
      for (std::size_t a = 0; a < active.size(); ++a) pressure_[index(active[a].first, active[a].second)] = p[a];
      std::vector<std::pair<int, int>> next;
      for (int j = 0; j < ny_; ++j)
        for (int i = 0; i < nx_; ++i)
          if (pressure_[index(i, j)] > 0 || (pressure_[index(i, j)] == 0 && penetrates(i, j, active)))
            next.emplace_back(i, j);
      if (next == active) return;
      active = std::move(next);
    }
    pressure_.assign(index(0, ny_), std::nan(""));  // the active set did not settle
  }
  bool penetrates(int i, int j, const std::vector<std::pair<int, int>>& active) const {
    double left = overlap(i, j);
    for (const auto& [k, m] : active) left -= influence(i, j, k, m) * pressure_[index(k, m)];
    return left > 1e-12 * s_.approach;
  }
  /// Eliminates by Gauss with pivots on the diagonal, which is by far the largest entry.
  static void eliminate(std::vector<double>& a, std::vector<double>& b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) {
        const double factor = a[i * n + k] / a[k * n + k];
        for (std::size_t j = k + 1; j < n; ++j) a[i * n + j] -= factor * a[k * n + j];
        b[i] -= factor * b[k];
      }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k * n + j] * b[j];
      b[k] /= a[k * n + k];
    }
  }

  Scene s_;
  int nx_, ny_;
  double hx_, hy_, low_;
  std::vector<double> table_, pressure_;
};

}  // namespace rollcon
