/// Fits the coefficients of a table to samples.

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

class TableFit {
 public:
  TableFit(const TableGrid& grid, const std::vector<double>& sample)
      : grid_(grid),
        layout_(grid),
        sample_(sample),
        nodes_s_(grid.magnitudes + 1),
        nodes_a_(grid.angles + 1),
        row_(grid.row()) {}

  CreepTable fit() {
    for (const double v : sample_)
      if (!std::isfinite(v)) fail(Status::err_state, "samples of the table are missing: solve all parts");
    CreepTable table(grid_);
    const std::int64_t per_plane = (grid_.ratios + 3) * (grid_.magnitudes + 3) * (grid_.angles + 3) * row_;
    for (std::size_t p = 0; p < grid_.planes().size(); ++p) {
      std::vector<double> value = harmonics(static_cast<std::int64_t>(p));
      value = along_angles(value);
      value = along_magnitudes(value);
      value = along_ratios(value, per_plane / (grid_.ratios + 3));
      std::transform(value.begin(), value.end(), table.coefficient_.begin() + static_cast<std::int64_t>(p) * per_plane,
                     [](double v) { return static_cast<float>(v); });
      const std::vector<double> linear = along_ratios(linear_of(static_cast<std::int64_t>(p)), layout_.numbers);
      std::copy(linear.begin(), linear.end(),
                table.linear_.begin() + static_cast<std::int64_t>(p) * layout_.numbers * (grid_.ratios + 3));
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
      const double spin = c[sampled_c22] * grid_.spin_scale(log_ratio_of(grid_, i));
      v.insert(v.end(), {std::log(c[sampled_c11]), std::log(c[sampled_c22]), c[sampled_c23] / spin,
                         c[sampled_c33] / spin, c[sampled_c32] / c[sampled_c22]});
      if (grid_.unlike())
        v.insert(v.end(),
                 {c[sampled_own_c11] / c[sampled_c11], c[sampled_own_c22] / c[sampled_c22], c[sampled_at_rest]});
    }
    return v;
  }

  /// Finds what splines go through, at one angle and direction: [magnitude][3], s from 0 to 1.
  void remainder(std::int64_t p, std::int64_t ratio, std::int64_t angle, std::int64_t direction,
                 std::vector<double>& q) const {
    const double* c = plane(p, ratio);
    const auto creepage = unit_creepages(grid_, log_ratio_of(grid_, ratio), angle_of(grid_, angle),
                                         angle == 0 ? 0 : direction_of(grid_, direction), c);
    const bool unlike = grid_.unlike();
    const double linear[3] = {-c[unlike ? sampled_own_c11 : sampled_c11] * creepage[0],
                              -c[unlike ? sampled_own_c22 : sampled_c22] * creepage[1] - c[sampled_c23] * creepage[2],
                              c[sampled_c32] * creepage[1] - c[sampled_c33] * creepage[2]};
    const double at_rest[3] = {unlike ? c[sampled_at_rest] : 0, 0, 0};
    const std::int64_t chain = angle == 0 ? 0 : 1 + (angle - 1) * grid_.samples_around() + direction;
    const double* f = c + layout_.numbers + chain * layout_.chain;
    q.resize(at(3 * nodes_s_));
    for (std::int64_t i = 1; i <= grid_.magnitudes; ++i) {
      std::array<double, 3> force{};
      if (i <= grid_.samples_along())
        std::copy_n(f + 3 * (i - 1), 3, force.begin());
      else
        sliding_limit(std::exp(log_ratio_of(grid_, ratio)), creepage, force.data());
      const double size = std::hypot(force[0], force[1]), scale = size > 0 ? unbend(size) / size : 1;
      force[0] *= scale;
      force[1] *= scale;
      const double s = magnitude_of(grid_, i);
      for (std::size_t k = 0; k < 3; ++k)
        q[3 * at(i) + k] = (force[k] - (1 - s * s) * at_rest[k] - half_magnitude * s * (1 - s) * linear[k]) / (s * s);
    }
    // The value at 0 is not known and counts for nothing.
    for (std::size_t k = 0; k < 3; ++k) q[k] = 3 * q[3 + k] - 3 * q[6 + k] + q[9 + k];
  }

  /// Returns [ratio][magnitude][angle][row].
  std::vector<double> harmonics(std::int64_t p) const {
    const std::int64_t nodes = (grid_.ratios + 1) * nodes_s_ * nodes_a_;
    std::vector<double> value(at(nodes * row_), 0.0), q;
    for (std::int64_t ratio = 0; ratio <= grid_.ratios; ++ratio)
      for (std::int64_t angle = 0; angle <= grid_.angles; ++angle)
        for (std::int64_t k = 0; k < (angle == 0 ? 1 : grid_.samples_around()); ++k) {
          remainder(p, ratio, angle, k, q);
          for (std::int64_t i = 0; i < nodes_s_; ++i)
            add(angle, k, &q[at(3 * i)], &value[at(((ratio * nodes_s_ + i) * nodes_a_ + angle) * row_)]);
        }
    return value;
  }

  /// Names the component, parity and harmonic of a place in a row.
  struct Place {
    std::int64_t i, parity, h;
  };
  Place place(std::int64_t k) const {
    const std::int64_t n = grid_.directions, parities = grid_.parities();
    return {k / (n * parities), k / n % parities, k % n};
  }
  /// Says whether the number at a place stays when the spin is turned round, as without spin.
  static bool even_in_spin(const Place& at) { return (at.h % 2 != 0) == (at.parity == 0); }

  void add(std::int64_t angle, std::int64_t direction, const double* f, double* row) const {
    const double psi = angle == 0 ? 0 : direction_of(grid_, direction);
    for (std::int64_t k = 0; k < row_; ++k) {
      const Place p = place(k);
      const bool cosine = is_cosine(p.i, p.parity, p.h);
      if (angle == 0) {  // pure spin: no direction
        if (p.h == 0 && cosine) row[k] = f[p.i];
        continue;
      }
      if (angle == grid_.angles && !even_in_spin(p)) continue;
      const double part = (p.h == 0 ? 1.0 : 2.0) / static_cast<double>(grid_.samples_around());
      const double turned = static_cast<double>(p.h) * psi;
      row[k] += part * f[p.i] * (cosine ? std::cos(turned) : std::sin(turned));
    }
  }

  /// Turns values [outer][node][inner] into coefficients, each of the inner ones by a fit of its own.
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

  /// Fits splines smooth through pure spin, by both translational creepages, and where spin changes its sign.
  std::vector<double> along_angles(const std::vector<double>& value) const {
    using enum SplineEnd;
    const SplineFit fit[2][2] = {{{grid_.angles, flat, straight}, {grid_.angles, flat, flat}},
                                 {{grid_.angles, straight, straight}, {grid_.angles, straight, flat}}};
    const auto fit_of = [&](std::int64_t k) -> const SplineFit& {
      const Place p = place(k);
      return fit[p.h == 1 ? 1 : 0][even_in_spin(p) ? 1 : 0];
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
