#include "tables/creep_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/error.hpp"
#include "support/index.hpp"
#include "tables/spline_basis.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t most_directions = 32;
constexpr double bent = 0.002;

}  // namespace

double TableGrid::stretch(double log_ratio) const {
  return std::exp(stretched * log_ratio);
}

double TableGrid::spin_scale(double log_ratio) const {
  return std::pow(std::cosh(log_ratio), 0.5 - stretched);
}

// x up to 1 - d, from there a parabola that ends with slope 0 at x = 1 + d.
double bend(double force, double* slope) {
  if (force <= 1 - bent) return *slope = 1, force;
  if (force >= 1 + bent) return *slope = 0, 1;
  const double over = force - 1 + bent;
  *slope = 1 - over / (2 * bent);
  return force - over * over / (4 * bent);
}

double unbend(double force) {
  if (force <= 1 - bent) return force;
  return 1 + bent - 2 * std::sqrt(bent * std::max(0.0, 1 - force));
}

/// The scene in the table's coordinates, and what was found there.
struct CreepTable::Point {
  // Of linear theory: C23 over the scale of spin, C33 likewise, C32 / C22, and derivatives by the logarithm of the
  // ratio; scales of the creepages and derivatives of their logarithms.
  double c23, c33, c32, c23_rate, c33_rate, c32_rate;
  double stretch, scale[3], scale_rate[3];
  double side;     ///< -1: of spin < 0, whose mirror image is looked up
  double v[3];     ///< the mirror image's creepages times their scales
  double t, r, w;  ///< of v: translation, length; r that counts as magnitude 1/2
  double s, cos_psi, sin_psi;
  double steps[3];  ///< intervals per unit of ratio's logarithm, magnitude, angle
  SplineWeights ratio, magnitude, angle;
  // Of forces and moment: value; derivatives by logarithm of the ratio (creepages held), creepages, w, Poisson's ratio.
  double f[3], by_ratio[3], by_creepage[3][3], by_w[3], by_poisson[3];
};

/// Of forces and moment: what the splines give, and derivatives by logarithm of the ratio, magnitude, angle; by
/// direction over the sine of the angle.
struct CreepTable::Sums {
  double q[3], ratio[3], magnitude[3], angle[3], turned[3];
};

CreepTable::CreepTable(TableGrid grid) : grid_(std::move(grid)) {
  const std::int64_t planes = static_cast<std::int64_t>(grid_.poisson.size());
  coefficient_.assign(at(planes * (grid_.ratios + 3) * (grid_.magnitudes + 3) * (grid_.angles + 3) * row()), 0);
  linear_.assign(at(planes * (grid_.ratios + 3)) * linear_numbers, 0);
}

void CreepTable::check(const TableInput& in, std::int64_t entry) const {
  struct Range {
    const char* name;
    double value;
    bool allowed;
    const char* text;
  };
  const double rounding = 1e-9;
  const double ratio = in.a / in.b;
  const Range ranges[] = {
      {"shear", in.shear, in.shear > 0, "> 0"},
      {"friction", in.friction, in.friction >= 0 && in.friction <= 10, "0 to 10"},
      {"a", in.a, in.a > 0, "> 0"},
      {"b", in.b, in.b > 0, "> 0"},
      {"load", in.load, in.load >= 0, ">= 0"},
      {"longitudinal", in.longitudinal, true, ""},
      {"lateral", in.lateral, true, ""},
      {"spin", in.spin, true, ""},
  };
  for (const Range& r : ranges) {
    if (!std::isfinite(r.value))
      fail(Status::err_nonfinite, "%s of entry %lld is %g", r.name, static_cast<long long>(entry), r.value);
    if (!r.allowed)
      fail(Status::err_argument, "%s of entry %lld is %g; allowed: %s", r.name, static_cast<long long>(entry), r.value,
           r.text);
  }
  if (!(ratio >= grid_.least_ratio * (1 - rounding) && ratio <= grid_.greatest_ratio * (1 + rounding)))
    fail(Status::err_argument, "a / b of entry %lld is %g; the table has %g to %g", static_cast<long long>(entry),
         ratio, grid_.least_ratio, grid_.greatest_ratio);
  if (!(in.poisson >= grid_.poisson.front() - rounding && in.poisson <= grid_.poisson.back() + rounding))
    fail(Status::err_argument, "poisson of entry %lld is %g; the table has %g to %g", static_cast<long long>(entry),
         in.poisson, grid_.poisson.front(), grid_.poisson.back());
}

namespace {

constexpr double right_angle = 1.5707963267948966;

/// Value, and derivatives by the logarithm of the ratio, magnitude and angle, each of all harmonics.
using HarmonicRow = float[3 * most_directions];

/// Asks for memory that is read soon; where the compiler has no such call, nothing is lost but time.
void prefetch([[maybe_unused]] const float* begin, [[maybe_unused]] std::int64_t count) {
#if defined(__GNUC__)
  constexpr std::int64_t line = 64 / sizeof(float);
  for (std::int64_t i = 0; i < count + line - 1; i += line) __builtin_prefetch(begin + std::min(i, count - 1));
#endif
}

template <bool rates>
void sum_along_angle(const float* c, std::int64_t row, const SplineWeights& angle, HarmonicRow (&by_angle)[2]) {
  float v[4], d[4];
  for (int i = 0; i < 4; ++i) v[i] = static_cast<float>(angle.value[i]), d[i] = static_cast<float>(angle.slope[i]);
  // Opposite coefficients cancel exactly at the ends.
  for (std::int64_t k = 0; k < row; ++k) {
    by_angle[0][k] = (v[0] * c[k] + v[2] * c[2 * row + k]) + (v[1] * c[row + k] + v[3] * c[3 * row + k]);
    if (rates) by_angle[1][k] = (d[0] * c[k] + d[2] * c[2 * row + k]) + (d[1] * c[row + k] + d[3] * c[3 * row + k]);
  }
}

template <bool rates>
void sum_coefficients(const float* plane, std::int64_t stride_ratio, std::int64_t stride_magnitude, std::int64_t row,
                      const SplineWeights& ratio, const SplineWeights& magnitude, const SplineWeights& angle,
                      HarmonicRow (&sums)[4]) {
  HarmonicRow by_angle[2], part[3];
  // A vehicle code's own data fills the caches between two calls: all rows are asked for before the first is needed.
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      prefetch(plane + (ratio.first + i) * stride_ratio + (magnitude.first + j) * stride_magnitude + angle.first * row,
               4 * row);
  for (std::int64_t m = 0; m < (rates ? 4 : 1); ++m) std::fill_n(sums[m], row, 0.0f);
  for (int i = 0; i < 4; ++i) {
    for (std::int64_t m = 0; m < (rates ? 3 : 1); ++m) std::fill_n(part[m], row, 0.0f);
    for (int j = 0; j < 4; ++j) {
      sum_along_angle<rates>(
          plane + (ratio.first + i) * stride_ratio + (magnitude.first + j) * stride_magnitude + angle.first * row, row,
          angle, by_angle);
      const float v = static_cast<float>(magnitude.value[j]), d = static_cast<float>(magnitude.slope[j]);
      for (std::int64_t k = 0; k < row; ++k) {
        part[0][k] += v * by_angle[0][k];
        if (rates) part[1][k] += d * by_angle[0][k], part[2][k] += v * by_angle[1][k];
      }
    }
    const float v = static_cast<float>(ratio.value[i]), d = static_cast<float>(ratio.slope[i]);
    for (std::int64_t k = 0; k < row; ++k) {
      sums[0][k] += v * part[0][k];
      if (rates) sums[1][k] += d * part[0][k], sums[2][k] += v * part[1][k], sums[3][k] += v * part[2][k];
    }
  }
}

}  // namespace

template <bool rates>
void CreepTable::add_plane(std::size_t plane, double share, const TableInput& in, Point& point) const {
  const std::int64_t nl = grid_.ratios + 3, ns = grid_.magnitudes + 3, na = grid_.angles + 3, n = grid_.directions;
  const double log_ratio = std::log(in.a / in.b), low = std::log(grid_.least_ratio);
  point.steps[0] = static_cast<double>(grid_.ratios) / (std::log(grid_.greatest_ratio) - low);
  point.ratio = spline_weights((log_ratio - low) * point.steps[0], grid_.ratios);
  double c[linear_numbers] = {}, d[linear_numbers] = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const double* from = &linear_[(plane * at(nl) + at(point.ratio.first) + i) * linear_numbers];
    for (std::size_t k = 0; k < linear_numbers; ++k) {
      c[k] += point.ratio.value[i] * from[k];
      d[k] += point.ratio.slope[i] * point.steps[0] * from[k];
    }
  }
  point.c23 = c[2], point.c33 = c[3], point.c32 = c[4];
  point.c23_rate = d[2], point.c33_rate = d[3], point.c32_rate = d[4];
  const double c22 = std::exp(c[1]);
  point.stretch = grid_.stretch(log_ratio);
  const double stretched = grid_.stretched;
  const double scale[3] = {std::exp(c[0]) * point.stretch, c22 / point.stretch,
                           c22 * grid_.spin_scale(log_ratio) * std::sqrt(in.a * in.b)};
  const double scale_rate[3] = {d[0] + stretched, d[1] - stretched, d[1] + (0.5 - stretched) * std::tanh(log_ratio)};
  std::copy_n(scale, 3, point.scale);
  std::copy_n(scale_rate, 3, point.scale_rate);
  point.side = in.spin < 0 ? -1 : 1;
  point.v[0] = scale[0] * in.longitudinal;
  point.v[1] = point.side * scale[1] * in.lateral;
  point.v[2] = point.side * scale[2] * in.spin;
  point.w = half_magnitude * in.friction * in.load / (in.shear * in.a * in.b);
  point.t = std::hypot(point.v[0], point.v[1]);
  point.r = std::hypot(point.t, point.v[2]);
  if (!(point.r > 0)) {
    if (rates && point.w > 0) add_rates_at_rest(share, point);
    return;
  }
  point.s = point.r / (point.r + point.w);
  point.cos_psi = point.t > 0 ? point.v[0] / point.t : 1;
  point.sin_psi = point.t > 0 ? point.v[1] / point.t : 0;
  point.steps[1] = static_cast<double>(grid_.magnitudes);
  point.steps[2] = static_cast<double>(grid_.angles) / right_angle;
  point.magnitude = spline_weights(point.s * point.steps[1], grid_.magnitudes);
  point.angle = spline_weights(std::atan2(point.t, point.v[2]) * point.steps[2], grid_.angles);
  HarmonicRow row_sums[4];
  sum_coefficients<rates>(coefficient_.data() + static_cast<std::int64_t>(plane) * nl * ns * na * row(),
                          ns * na * row(), na * row(), row(), point.ratio, point.magnitude, point.angle, row_sums);
  Sums sums{};
  // Near pure spin, harmonics grow like the sine of the angle or faster.
  constexpr double least_sine = 1e-3;
  const double sine = point.t / point.r, by_sine = sine > least_sine ? 1 / sine : 0;
  double cos_h = 1, sin_h = 0;
  for (std::int64_t h = 0; h < n; ++h) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = i * at(n) + at(h);
      const bool cosine = (i == 0) == (h % 2 != 0);
      const double basis = cosine ? cos_h : sin_h;
      sums.q[i] += row_sums[0][k] * basis;
      if (!rates) continue;
      sums.ratio[i] += row_sums[1][k] * basis * point.steps[0];
      sums.magnitude[i] += row_sums[2][k] * basis * point.steps[1];
      const double by_angle = row_sums[3][k] * point.steps[2];
      sums.angle[i] += by_angle * basis;
      const double over_sine = by_sine > 0 ? row_sums[0][k] * by_sine : h == 1 ? by_angle : 0;
      sums.turned[i] += over_sine * static_cast<double>(h) * (cosine ? -sin_h : cos_h);
    }
    const double next = cos_h * point.cos_psi - sin_h * point.sin_psi;
    sin_h = sin_h * point.cos_psi + cos_h * point.sin_psi;
    cos_h = next;
  }
  // f = 3 s (1 - s) l + s^2 q, l the forces of linear theory by a unit of creepage.
  const double x = point.v[0] / point.r, y = point.v[1] / point.r, z = point.v[2] / point.r, s = point.s;
  const double along = x / point.stretch, across = y * point.stretch;
  const double l[3] = {-along, -across - point.c23 * z, point.c32 * across - point.c33 * z};
  for (std::size_t i = 0; i < 3; ++i)
    point.f[i] += share * (i == 0 ? 1 : point.side) * (half_magnitude * s * (1 - s) * l[i] + s * s * sums.q[i]);
  if (rates) add_rates(share, sums, point);
}

void CreepTable::add_rates_at_rest(double share, Point& point) const {
  const double unit = share * half_magnitude / point.w;
  point.by_creepage[0][0] -= unit * point.scale[0] / point.stretch;
  point.by_creepage[1][1] -= unit * point.stretch * point.scale[1];
  point.by_creepage[1][2] -= unit * point.c23 * point.scale[2];
  point.by_creepage[2][1] += unit * point.c32 * point.stretch * point.scale[1];
  point.by_creepage[2][2] -= unit * point.c33 * point.scale[2];
}

void CreepTable::add_rates(double share, const Sums& q, Point& point) const {
  const double s = point.s, total = point.r + point.w, sine = point.t / point.r, cosine = point.v[2] / point.r;
  const double e_r[3] = {point.v[0] / point.r, point.v[1] / point.r, cosine};
  const double e_angle[3] = {cosine * point.cos_psi, cosine * point.sin_psi, -sine};
  const double e_direction[3] = {-point.sin_psi, point.cos_psi, 0};
  const double along_unit = 1 / point.stretch, across_unit = point.stretch, stretched = grid_.stretched;
  const double l_by[3][3] = {
      {-along_unit, 0, 0}, {0, -across_unit, -point.c23}, {0, point.c32 * across_unit, -point.c33}};
  const double l_ratio[3] = {stretched * along_unit * e_r[0],
                             -stretched * across_unit * e_r[1] - point.c23_rate * e_r[2],
                             (point.c32_rate + stretched * point.c32) * across_unit * e_r[1] - point.c33_rate * e_r[2]};
  const double first = half_magnitude * s * (1 - s), first_s = half_magnitude * (1 - 2 * s);
  for (std::size_t i = 0; i < 3; ++i) {
    const double sign = share * (i == 0 ? 1 : point.side);
    const double l = l_by[i][0] * e_r[0] + l_by[i][1] * e_r[1] + l_by[i][2] * e_r[2];
    const double by_s = first_s * l + 2 * s * q.q[i] + s * s * q.magnitude[i];
    double along = first * l_ratio[i] + s * s * q.ratio[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const double by_v =
          by_s * point.w / (total * total) * e_r[k] +
          (first * (l_by[i][k] - l * e_r[k]) + s * s * (q.angle[i] * e_angle[k] + q.turned[i] * e_direction[k])) /
              point.r;
      along += by_v * point.v[k] * point.scale_rate[k];
      point.by_creepage[i][k] += sign * by_v * (k == 0 ? 1 : point.side) * point.scale[k];
    }
    point.by_ratio[i] += sign * along;
    point.by_w[i] -= sign * by_s * point.r / (total * total);
  }
}

// Linear between two planes.
template <bool rates>
CreepTable::Point CreepTable::at_poisson(const TableInput& in) const {
  const std::vector<double>& nu = grid_.poisson;
  std::size_t upper = 0;
  while (upper + 1 < nu.size() && nu[upper] < in.poisson) ++upper;
  const double share =
      upper > 0 ? std::clamp((in.poisson - nu[upper - 1]) / (nu[upper] - nu[upper - 1]), 0.0, 1.0) : 1.0;
  Point point{};
  add_plane<rates>(upper, share, in, point);
  const bool between = share < 1;
  if (!between && !(rates && nu.size() > 1)) return point;
  // Of a plane itself, the other one counts in the derivative alone.
  const std::size_t other = upper > 0 ? upper - 1 : 1;
  double of_upper[3], of_other[3];
  std::copy_n(point.f, 3, of_upper);
  if (between) {
    std::fill_n(point.f, 3, 0.0);
    add_plane<rates>(other, 1 - share, in, point);
    std::copy_n(point.f, 3, of_other);
    for (std::size_t i = 0; i < 3; ++i) point.f[i] += of_upper[i];
  } else {
    Point there{};
    add_plane<false>(other, 1, in, there);
    std::copy_n(there.f, 3, of_other);
  }
  const double other_share = between ? 1 - share : 1;
  for (std::size_t i = 0; i < 3; ++i)
    point.by_poisson[i] = (of_upper[i] / share - of_other[i] / other_share) / (nu[upper] - nu[other]);
  return point;
}

void CreepTable::evaluate(const TableInput& in, std::int64_t entry, double* result, double* derivative) const {
  check(in, entry);
  const Point point = derivative ? at_poisson<true>(in) : at_poisson<false>(in);
  // Bent to the limit of friction.
  const double size = std::hypot(point.f[0], point.f[1]);
  double slope = 1;
  const double scale = size > 0 ? bend(size, &slope) / size : 1;
  const double length = std::sqrt(in.a * in.b), bound = in.friction * in.load;
  const double unit[3] = {bound, bound, bound * length}, f[3] = {scale * point.f[0], scale * point.f[1], point.f[2]};
  for (std::size_t i = 0; i < 3; ++i) result[i] = unit[i] * f[i];
  if (!derivative) return;

  // By shear, poisson, friction, a, b, load, longitudinal, lateral, spin.
  const double along_friction[2] = {size > 0 ? point.f[0] / size : 0, size > 0 ? point.f[1] / size : 0};
  double rate[table_inputs][3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double by_size = point.by_w[i] * point.w, by_length = point.by_creepage[i][2] * in.spin / 2;
    rate[0][i] = -by_size / in.shear;
    rate[1][i] = point.by_poisson[i];
    rate[2][i] = in.friction > 0 ? by_size / in.friction : 0;
    rate[3][i] = (point.by_ratio[i] - by_size + by_length) / in.a;
    rate[4][i] = (-point.by_ratio[i] - by_size + by_length) / in.b;
    rate[5][i] = in.load > 0 ? by_size / in.load : 0;
    for (std::size_t k = 0; k < 3; ++k) rate[6 + k][i] = point.by_creepage[i][k];
  }
  for (std::size_t j = 0; j < table_inputs; ++j) {
    const double along = rate[j][0] * along_friction[0] + rate[j][1] * along_friction[1];
    for (std::size_t i = 0; i < 3; ++i) {
      const double bent_rate = i < 2 ? scale * rate[j][i] + (slope - scale) * along * along_friction[i] : rate[j][i];
      derivative[i * table_inputs + j] = unit[i] * bent_rate;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    derivative[i * table_inputs + 2] += in.load * (i == 2 ? length : 1) * f[i];
    derivative[i * table_inputs + 5] += in.friction * (i == 2 ? length : 1) * f[i];
  }
  derivative[2 * table_inputs + 3] += bound * length * f[2] / (2 * in.a);
  derivative[2 * table_inputs + 4] += bound * length * f[2] / (2 * in.b);
}

}  // namespace rollcon
