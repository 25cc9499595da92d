/// From samples to the coefficients of a table.

#include <algorithm>
#include <array>
#include <cmath>

#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"
#include "tables/creep_table.hpp"
#include "tables/spline_basis.hpp"
#include "tables/table_samples.hpp"

namespace rollcon {

/// Harmonic h of Fx: cos of odd multiples of the direction, sin of even ones; of Fy and Mz the other way round. That is
/// what mirror images across both axes leave.
class TableFit {
 public:
  TableFit(const TableGrid& grid, const std::vector<double>& sample)
      : grid_(grid),
        layout_(grid),
        sample_(sample),
        nodes_s_(grid.magnitudes + 1),
        nodes_a_(grid.angles + 1),
        row_(3 * grid.directions) {}

  CreepTable fit() {
    for (const double v : sample_)
      if (!std::isfinite(v)) fail(Status::err_state, "samples of the table are missing: solve all parts");
    CreepTable table(grid_);
    const std::int64_t per_plane = (grid_.ratios + 3) * (grid_.magnitudes + 3) * (grid_.angles + 3) * row_;
    for (std::size_t p = 0; p < grid_.poisson.size(); ++p) {
      std::vector<double> value = harmonics(static_cast<std::int64_t>(p));
      value = along_angles(value);
      value = along_magnitudes(value);
      value = along_ratios(value, per_plane / (grid_.ratios + 3));
      std::transform(value.begin(), value.end(), table.coefficient_.begin() + static_cast<std::int64_t>(p) * per_plane,
                     [](double v) { return static_cast<float>(v); });
      const std::vector<double> linear = along_ratios(linear_of(static_cast<std::int64_t>(p)), linear_numbers);
      std::copy(linear.begin(), linear.end(),
                table.linear_.begin() + static_cast<std::int64_t>(p * linear_numbers) * (grid_.ratios + 3));
    }
    return table;
  }

 private:
  const double* plane(std::int64_t p, std::int64_t ratio) const {
    return sample_.data() + (p * (grid_.ratios + 1) + ratio) * layout_.plane();
  }

  std::vector<double> linear_of(std::int64_t p) const {
    std::vector<double> v;
    for (std::int64_t i = 0; i <= grid_.ratios; ++i) {
      const double* c = plane(p, i);
      const double spin = c[1] * grid_.spin_scale(log_ratio_of(grid_, i));
      v.insert(v.end(), {std::log(c[0]), std::log(c[1]), c[2] / spin, c[4] / spin, c[3] / c[1]});
    }
    return v;
  }

  /// What splines go through, at one angle and direction: [magnitude][3], s from 0 to 1.
  void remainder(std::int64_t p, std::int64_t ratio, std::int64_t angle, std::int64_t direction,
                 std::vector<double>& q) const {
    const double* c = plane(p, ratio);
    const double theta = angle_of(grid_, angle), psi = angle == 0 ? 0 : direction_of(grid_, direction);
    const double x = std::sin(theta) * std::cos(psi), y = std::sin(theta) * std::sin(psi), z = std::cos(theta);
    const double spin = c[1] * grid_.spin_scale(log_ratio_of(grid_, ratio)),
                 turn = grid_.stretch(log_ratio_of(grid_, ratio));
    const double creepage[3] = {x / (c[0] * turn), y * turn / c[1], z / spin};
    const double linear[3] = {-c[0] * creepage[0], -c[1] * creepage[1] - c[2] * creepage[2],
                              c[3] * creepage[1] - c[4] * creepage[2]};
    const std::int64_t chain = angle == 0 ? 0 : 1 + (angle - 1) * grid_.directions + direction;
    const double* f = c + linear_numbers + chain * layout_.chain;
    q.resize(at(3 * nodes_s_));
    for (std::int64_t i = 1; i <= grid_.magnitudes; ++i) {
      std::array<double, 3> force{};
      if (i < grid_.magnitudes)
        std::copy_n(f + 3 * (i - 1), 3, force.begin());
      else
        sliding_limit(std::exp(log_ratio_of(grid_, ratio)), creepage, force.data());
      const double size = std::hypot(force[0], force[1]), scale = size > 0 ? unbend(size) / size : 1;
      force[0] *= scale;
      force[1] *= scale;
      const double s = magnitude_of(grid_, i);
      for (std::size_t k = 0; k < 3; ++k)
        q[3 * at(i) + k] = (force[k] - half_magnitude * s * (1 - s) * linear[k]) / (s * s);
    }
    // Nothing is known of it at 0, where it counts for nothing.
    for (std::size_t k = 0; k < 3; ++k) q[k] = 3 * q[3 + k] - 3 * q[6 + k] + q[9 + k];
  }

  /// [ratio][magnitude][angle][row]
  std::vector<double> harmonics(std::int64_t p) const {
    const std::int64_t nodes = (grid_.ratios + 1) * nodes_s_ * nodes_a_;
    std::vector<double> value(at(nodes * row_), 0.0), q;
    for (std::int64_t ratio = 0; ratio <= grid_.ratios; ++ratio)
      for (std::int64_t angle = 0; angle <= grid_.angles; ++angle)
        for (std::int64_t k = 0; k < (angle == 0 ? 1 : grid_.directions); ++k) {
          remainder(p, ratio, angle, k, q);
          for (std::int64_t i = 0; i < nodes_s_; ++i)
            add(angle, k, &q[at(3 * i)], &value[at(((ratio * nodes_s_ + i) * nodes_a_ + angle) * row_)]);
        }
    return value;
  }

  void add(std::int64_t angle, std::int64_t direction, const double* f, double* row) const {
    const std::int64_t n = grid_.directions;
    if (angle == 0) {  // pure spin: no direction
      row[n] = f[1];
      row[2 * n] = f[2];
      return;
    }
    const double psi = direction_of(grid_, direction);
    for (std::int64_t h = 0; h < n; ++h) {
      const double part = (h == 0 ? 1.0 : 2.0) / static_cast<double>(n);
      const double c = std::cos(static_cast<double>(h) * psi), s = std::sin(static_cast<double>(h) * psi);
      const bool odd = h % 2 != 0;
      if (angle == grid_.angles && !odd) continue;  // these vanish without spin
      row[h] += part * f[0] * (odd ? c : s);
      row[n + h] += part * f[1] * (odd ? s : c);
      row[2 * n + h] += part * f[2] * (odd ? s : c);
    }
  }

  /// Values [outer][node][inner] to coefficients, each of the inner ones by a fit of its own.
  template <class FitOf>
  static std::vector<double> along(const std::vector<double>& value, std::int64_t outer, std::int64_t nodes,
                                   std::int64_t inner, FitOf fit_of) {
    std::vector<double> result(at(outer * (nodes + 2) * inner)), v(at(nodes)), c(at(nodes + 2));
    for (std::int64_t o = 0; o < outer; ++o)
      for (std::int64_t k = 0; k < inner; ++k) {
        for (std::int64_t i = 0; i < nodes; ++i) v[at(i)] = value[at((o * nodes + i) * inner + k)];
        fit_of(k).apply(v, c);
        for (std::int64_t i = 0; i < nodes + 2; ++i) result[at((o * (nodes + 2) + i) * inner + k)] = c[at(i)];
      }
    return result;
  }

  /// Smooth through pure spin as functions of both translational creepages, and where spin changes its sign.
  std::vector<double> along_angles(const std::vector<double>& value) const {
    using enum SplineEnd;
    const SplineFit even(grid_.angles, flat, flat), even_odd(grid_.angles, flat, straight),
        odd(grid_.angles, straight, flat);
    const auto fit_of = [&](std::int64_t k) -> const SplineFit& {
      const std::int64_t h = k % grid_.directions;
      return h == 1 ? odd : h % 2 != 0 ? even : even_odd;
    };
    return along(value, (grid_.ratios + 1) * nodes_s_, nodes_a_, row_, fit_of);
  }
  std::vector<double> along_magnitudes(const std::vector<double>& value) const {
    const SplineFit fit(grid_.magnitudes, SplineEnd::open, SplineEnd::open);
    return along(value, grid_.ratios + 1, nodes_s_, (nodes_a_ + 2) * row_,
                 [&](std::int64_t) -> const SplineFit& { return fit; });
  }
  std::vector<double> along_ratios(const std::vector<double>& value, std::int64_t inner) const {
    const SplineFit fit(grid_.ratios, SplineEnd::open, SplineEnd::open);
    return along(value, 1, grid_.ratios + 1, inner, [&](std::int64_t) -> const SplineFit& { return fit; });
  }

  const TableGrid& grid_;
  const SampleLayout layout_;
  const std::vector<double>& sample_;
  const std::int64_t nodes_s_, nodes_a_, row_;
};

CreepTable CreepTable::fit(const TableGrid& grid, const std::vector<double>& sample) {
  return TableFit(grid, sample).fit();
}

}  // namespace rollcon
