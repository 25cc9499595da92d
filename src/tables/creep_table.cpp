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

// Returns x up to 1 - d, from there a parabola that ends with slope 0 at x = 1 + d.
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

/// Holds the scene in the table's coordinates, and what was found there.
struct CreepTable::Point {
  double by_v[3][3], by_v_ratio[3][3];  ///< forces of linear theory by v, and derivatives by the logarithm of the ratio
  double at_rest, at_rest_ratio;        ///< Fx over mu Fn without creepages, and its derivative
  double scale[3], scale_rate[3];       ///< scales of the creepages, and derivatives of their logarithms
  double side;                          ///< -1: spin is < 0, and the mirror image is looked up
  double v[3];                          ///< the mirror image's creepages times their scales
  double t, r, w;                       ///< t, r: translation and length of v; w: r that counts as magnitude 1/2
  double s, cos_psi, sin_psi;
  double steps[3];  ///< intervals per unit of ratio's logarithm, magnitude, angle
  SplineWeights ratio, magnitude, angle;
  double own[3];  ///< forces and moment of the plane of add_plane
  // Forces and moment: value; derivatives by logarithm of the ratio (creepages held), creepages, w, the planes'
  // coordinate.
  double f[3], by_ratio[3], by_creepage[3][3], by_w[3], by_plane[3];
};

/// Holds what the splines give for forces and moment, and derivatives by logarithm of the ratio, magnitude, angle; by
/// direction over the sine of the angle.
struct CreepTable::Sums {
  double q[3], ratio[3], magnitude[3], angle[3], turned[3];
};

CreepTable::CreepTable(TableGrid grid) : grid_(std::move(grid)) {
  for (const double friction : grid_.pair.friction) log_friction_.push_back(std::log(friction));
  const std::int64_t planes = static_cast<std::int64_t>(grid_.planes().size());
  coefficient_.assign(at(planes * (grid_.ratios + 3) * (grid_.magnitudes + 3) * (grid_.angles + 3) * grid_.row()), 0);
  linear_.assign(at(planes * (grid_.ratios + 3)) * linear_numbers(grid_), 0);
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
    fail(Status::err_argument, "a / b of entry %lld is %.10g; the table has %.10g to %.10g",
         static_cast<long long>(entry), ratio, grid_.least_ratio, grid_.greatest_ratio);
  const auto require_between = [&](const char* name, double value, const std::vector<double>& of, double beyond,
                                   double margin) {
    const double least = of.front() - beyond, most = of.back() + beyond;
    if (!(value >= least - margin && value <= most + margin))
      fail(Status::err_argument, "%s of entry %lld is %.10g; the table has %.10g to %.10g", name,
           static_cast<long long>(entry), value, least, most);
  };
  // The mean of unlike bodies comes from their constants, which callers may know to six digits.
  require_between("poisson", in.poisson, grid_.poisson, grid_.beyond(), grid_.unlike() ? 1e-6 : rounding);
  if (grid_.unlike()) require_between("friction", in.friction, grid_.pair.friction, 0, rounding);
}

namespace {

constexpr double right_angle = 1.5707963267948966;

/// Holds value, and derivatives by the logarithm of the ratio, magnitude and angle, each of all harmonics.
using HarmonicRow = float[6 * most_directions];

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

// Finds what linear theory says; scales are those of like bodies.
void CreepTable::find_linear_theory(std::size_t plane, const TableInput& in, double log_ratio, Point& point) const {
  const std::size_t numbers = linear_numbers(grid_);
  double c[most_linear_numbers] = {0, 0, 0, 0, 0, 1, 1, 0}, d[most_linear_numbers] = {};
  std::fill_n(c, numbers, 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const double* from = &linear_[(plane * at(grid_.ratios + 3) + at(point.ratio.first) + i) * numbers];
    for (std::size_t k = 0; k < numbers; ++k) {
      c[k] += point.ratio.value[i] * from[k];
      d[k] += point.ratio.slope[i] * point.steps[0] * from[k];
    }
  }
  const double c22 = std::exp(c[log_c22_of]), stretch = grid_.stretch(log_ratio), stretched = grid_.stretched;
  const double scale[3] = {std::exp(c[log_c11_of]) * stretch, c22 / stretch,
                           c22 * grid_.spin_scale(log_ratio) * std::sqrt(in.a * in.b)};
  const double scale_rate[3] = {d[log_c11_of] + stretched, d[log_c22_of] - stretched,
                                d[log_c22_of] + (0.5 - stretched) * std::tanh(log_ratio)};
  std::copy_n(scale, 3, point.scale);
  std::copy_n(scale_rate, 3, point.scale_rate);
  point.by_v[0][0] = -c[c11_by_of] / stretch;
  point.by_v[1][1] = -c[c22_by_of] * stretch;
  point.by_v[1][2] = -c[c23_by_spin];
  point.by_v[2][1] = c[c32_by_c22] * stretch;
  point.by_v[2][2] = -c[c33_by_spin];
  point.by_v_ratio[0][0] = (stretched * c[c11_by_of] - d[c11_by_of]) / stretch;
  point.by_v_ratio[1][1] = -(stretched * c[c22_by_of] + d[c22_by_of]) * stretch;
  point.by_v_ratio[1][2] = -d[c23_by_spin];
  point.by_v_ratio[2][1] = (stretched * c[c32_by_c22] + d[c32_by_c22]) * stretch;
  point.by_v_ratio[2][2] = -d[c33_by_spin];
  point.at_rest = c[force_at_rest];
  point.at_rest_ratio = d[force_at_rest];
}

template <bool rates>
void CreepTable::sum_harmonics(std::size_t plane, Point& point, Sums& sums) const {
  const std::int64_t ns = grid_.magnitudes + 3, na = grid_.angles + 3, n = grid_.directions, row = grid_.row();
  HarmonicRow row_sums[4];
  sum_coefficients<rates>(coefficient_.data() + static_cast<std::int64_t>(plane) * (grid_.ratios + 3) * ns * na * row,
                          ns * na * row, na * row, row, point.ratio, point.magnitude, point.angle, row_sums);
  // Harmonics grow like the sine of the angle or faster near pure spin.
  constexpr double least_sine = 1e-3;
  const double sine = point.t / point.r, by_sine = sine > least_sine ? 1 / sine : 0;
  const std::int64_t parities = grid_.parities();
  double cos_h = 1, sin_h = 0;
  for (std::int64_t h = 0; h < n; ++h) {
    for (std::int64_t i = 0; i < 3; ++i)
      for (std::int64_t parity = 0; parity < parities; ++parity) {
        const std::size_t c = at(i), k = at((i * parities + parity) * n + h);
        const bool cosine = is_cosine(i, parity, h);
        const double basis = cosine ? cos_h : sin_h;
        sums.q[c] += row_sums[0][k] * basis;
        if (!rates) continue;
        sums.ratio[c] += row_sums[1][k] * basis * point.steps[0];
        sums.magnitude[c] += row_sums[2][k] * basis * point.steps[1];
        const double by_angle = row_sums[3][k] * point.steps[2];
        sums.angle[c] += by_angle * basis;
        const double over_sine = by_sine > 0 ? row_sums[0][k] * by_sine : h == 1 ? by_angle : 0;
        sums.turned[c] += over_sine * static_cast<double>(h) * (cosine ? -sin_h : cos_h);
      }
    const double next = cos_h * point.cos_psi - sin_h * point.sin_psi;
    sin_h = sin_h * point.cos_psi + cos_h * point.sin_psi;
    cos_h = next;
  }
}

template <bool rates>
void CreepTable::add_plane(std::size_t plane, double share, const TableInput& in, Point& point) const {
  const double log_ratio = std::log(in.a / in.b), low = std::log(grid_.least_ratio);
  point.steps[0] = static_cast<double>(grid_.ratios) / (std::log(grid_.greatest_ratio) - low);
  point.ratio = spline_weights((log_ratio - low) * point.steps[0], grid_.ratios);
  find_linear_theory(plane, in, log_ratio, point);
  point.side = in.spin < 0 ? -1 : 1;
  point.v[0] = point.scale[0] * in.longitudinal;
  point.v[1] = point.side * point.scale[1] * in.lateral;
  point.v[2] = point.side * point.scale[2] * in.spin;
  point.w = half_magnitude * in.friction * in.load / (in.shear * in.a * in.b);
  point.t = std::hypot(point.v[0], point.v[1]);
  point.r = std::hypot(point.t, point.v[2]);
  if (!(point.r > 0)) {
    point.own[0] = point.w > 0 ? point.at_rest : 0;
    point.own[1] = point.own[2] = 0;
    point.f[0] += share * point.own[0];
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
  Sums sums{};
  sum_harmonics<rates>(plane, point, sums);
  // f = (1 - s^2) f0 + 3 s (1 - s) l + s^2 q, with l the forces of linear theory by a unit of creepage.
  const double s = point.s;
  for (std::size_t i = 0; i < 3; ++i) {
    const double* const by_v = point.by_v[i];
    const double l = (by_v[0] * point.v[0] + by_v[1] * point.v[1] + by_v[2] * point.v[2]) / point.r;
    point.own[i] = (i == 0 ? (1 - s * s) * point.at_rest : 0) + half_magnitude * s * (1 - s) * l + s * s * sums.q[i];
    if (i > 0) point.own[i] *= point.side;
    point.f[i] += share * point.own[i];
  }
  if (rates) add_rates(share, sums, point);
}

void CreepTable::add_rates_at_rest(double share, Point& point) const {
  const double unit = share * half_magnitude / point.w;
  point.by_ratio[0] += share * point.at_rest_ratio;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) point.by_creepage[i][k] += unit * point.by_v[i][k] * point.scale[k];
}

void CreepTable::add_rates(double share, const Sums& q, Point& point) const {
  const double s = point.s, total = point.r + point.w, sine = point.t / point.r, cosine = point.v[2] / point.r;
  const double e_r[3] = {point.v[0] / point.r, point.v[1] / point.r, cosine};
  const double e_angle[3] = {cosine * point.cos_psi, cosine * point.sin_psi, -sine};
  const double e_direction[3] = {-point.sin_psi, point.cos_psi, 0};
  const double first = half_magnitude * s * (1 - s), first_s = half_magnitude * (1 - 2 * s);
  for (std::size_t i = 0; i < 3; ++i) {
    const double sign = share * (i == 0 ? 1 : point.side);
    const double *const l_by = point.by_v[i], *const l_ratio = point.by_v_ratio[i];
    const double l = l_by[0] * e_r[0] + l_by[1] * e_r[1] + l_by[2] * e_r[2];
    double by_s = first_s * l + 2 * s * q.q[i] + s * s * q.magnitude[i];
    double along = first * (l_ratio[0] * e_r[0] + l_ratio[1] * e_r[1] + l_ratio[2] * e_r[2]) + s * s * q.ratio[i];
    if (i == 0) by_s -= 2 * s * point.at_rest, along += (1 - s * s) * point.at_rest_ratio;
    for (std::size_t k = 0; k < 3; ++k) {
      const double by_v =
          by_s * point.w / (total * total) * e_r[k] +
          (first * (l_by[k] - l * e_r[k]) + s * s * (q.angle[i] * e_angle[k] + q.turned[i] * e_direction[k])) / point.r;
      along += by_v * point.v[k] * point.scale_rate[k];
      point.by_creepage[i][k] += sign * by_v * (k == 0 ? 1 : point.side) * point.scale[k];
    }
    point.by_ratio[i] += sign * along;
    point.by_w[i] -= sign * by_s * point.r / (total * total);
  }
}

template <bool rates>
CreepTable::Point CreepTable::between_planes(const TableInput& in) const {
  const bool by_friction = grid_.unlike();
  const PlaneWeights planes =
      by_friction ? plane_weights(log_friction_, std::log(in.friction)) : plane_weights(grid_.poisson, in.poisson);
  Point point{};
  for (std::int64_t i = 0; i < planes.count; ++i) {
    const double share = planes.value[i], slope = planes.slope[i];
    const std::size_t plane = at(planes.first + i);
    // A plane without a weight counts in the derivative alone.
    if (share != 0)
      add_plane<rates>(plane, share, in, point);
    else if (rates && slope != 0)
      add_plane<false>(plane, 0, in, point);
    else
      continue;
    for (std::size_t k = 0; k < 3; ++k) point.by_plane[k] += slope * point.own[k];
  }
  return point;
}

void CreepTable::evaluate(const TableInput& in, std::int64_t entry, double* result, double* derivative) const {
  check(in, entry);
  const Point point = derivative ? between_planes<true>(in) : between_planes<false>(in);
  // Forces are bent to the limit of friction.
  const double size = std::hypot(point.f[0], point.f[1]);
  double slope = 1;
  const double scale = size > 0 ? bend(size, &slope) / size : 1;
  const double length = std::sqrt(in.a * in.b), bound = in.friction * in.load;
  const double unit[3] = {bound, bound, bound * length}, f[3] = {scale * point.f[0], scale * point.f[1], point.f[2]};
  for (std::size_t i = 0; i < 3; ++i) result[i] = unit[i] * f[i];
  if (!derivative) return;

  // Rates are by shear, poisson, friction, a, b, load, longitudinal, lateral, spin.
  const double along_friction[2] = {size > 0 ? point.f[0] / size : 0, size > 0 ? point.f[1] / size : 0};
  double rate[table_inputs][3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double by_size = point.by_w[i] * point.w, by_length = point.by_creepage[i][2] * in.spin / 2;
    rate[0][i] = -by_size / in.shear;
    // Planes of unlike bodies lie along the logarithm of friction, and Poisson's ratio is the pair's.
    rate[1][i] = grid_.unlike() ? 0 : point.by_plane[i];
    rate[2][i] = in.friction > 0 ? (by_size + (grid_.unlike() ? point.by_plane[i] : 0)) / in.friction : 0;
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
