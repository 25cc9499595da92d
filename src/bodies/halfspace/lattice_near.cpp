#include "bodies/halfspace/lattice_near.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/halfspace/lattice_antiderivatives.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon::halfspace {
namespace {

/// Kinks and observers up to here (in the cell's shorter side) take the closed form.
constexpr double closed_reach = 6;
constexpr double rule_digits = 1e17;

/// Writes the hat's integral of F'' as a sum over nodes and derivatives of F, for half-width 1: coefficient[p][m]
/// belongs to the p-th derivative at x + (m - 1).
struct Stencil {
  double coefficient[2][3];
};

/// Takes the hat's integral of F''(u), u = x - y, by parts.
Stencil stencil(Hat hat) {
  switch (hat) {
    case Hat::before:
      return {{{0, -1, 1}, {0, -1, 0}}};
    case Hat::after:
      return {{{1, -1, 0}, {0, 1, 0}}};
    case Hat::whole:
      break;
  }
  return {{{1, -2, 1}, {0, 0, 0}}};
}

/// Holds for kernel k: H, its second antiderivative in x, and H_x.
struct Inner {
  double value[integral_count][2];
};

/// Computes H as it is, away from u = 0.
Inner whole_inner(double x, double u) {
  const double r = std::hypot(x, u), s = std::asinh(x / std::abs(u)), l = std::log(r), phi = std::atan(x / u);
  return {{{x * s - r, s},
           {x * s - 2 * r, s - x / r},
           {-u * s, -u / r},
           {x * l + x / 2 + u * phi, l + 1.5},
           {x * phi - u * l - u / 2, phi}}};
}

/// Computes H without its singular part at u = 0, away from x = 0.
Inner smooth_inner(double x, double u) {
  const double r = std::hypot(x, u), l = std::log(r), theta = std::atan(u / x);
  const double s = std::copysign(std::log(std::abs(x) + r), x);
  return {{{x * s - r, s},
           {x * s - 2 * r, s - x / r},
           {-u * s, -u / r},
           {x * l + x / 2 - u * theta, l + 1.5},
           {-x * theta - u * l - u / 2, -theta}}};
}

/// Names the functions of u that the singular part of H is a multiple of, by singular_factor().
enum Singular { log_u, u_log_u, abs_u, sign_u, singular_count };
constexpr Singular singular_of[integral_count] = {log_u, log_u, u_log_u, abs_u, sign_u};
Inner singular_factor(double x) {
  const double sign = std::copysign(1.0, x), quarter = std::copysign(std::numbers::pi / 2, x);
  return {{{-std::abs(x), -sign},
           {-std::abs(x), -sign},
           {sign, 0},
           {quarter, 0},
           {std::abs(x) * std::numbers::pi / 2, quarter}}};
}

/// Computes second antiderivatives of log|u|, u log|u|, |u|, sign u, and their slopes.
void singular_antiderivatives(double u, double (&w)[singular_count][2]) {
  const double l = u != 0 ? std::log(std::abs(u)) : 0, sign = std::copysign(1.0, u);
  w[log_u][0] = u * u * (l / 2 - 0.75), w[log_u][1] = u * (l - 1);
  w[u_log_u][0] = u * u * u * (l / 6 - 5.0 / 36), w[u_log_u][1] = u * u * (l / 2 - 0.25);
  w[abs_u][0] = sign * u * u * u / 6, w[abs_u][1] = sign * u * u / 2;
  w[sign_u][0] = sign * u * u / 2, w[sign_u][1] = sign * u;
}

/// Sums over a hat's kinks lose digits with the square of their distance over the spacing.
struct Across {
  Extended value[integral_count][2] = {};
};

/// Integrates across, for all kinks of one line of observers. Lengths are in units of the shorter side, along which the
/// observer lies at y.
class Line {
 public:
  Line(Hat hat, Extended y) : hat_(hat), y_(y), stencil_(stencil(hat)) {
    for (std::size_t n = 0; n < 3; ++n) {
      double w[singular_count][2];
      singular_antiderivatives(static_cast<double>(y + static_cast<Extended>(n) - 1), w);
      for (std::size_t s = 0; s < singular_count; ++s)
        for (std::size_t q = 0; q < 2; ++q) singular_[s] += stencil_.coefficient[q][n] * w[s][q];
    }
  }

  Across at(Extended x) const {
    const auto beside = static_cast<double>(std::abs(x)), along = static_cast<double>(std::abs(y_));
    if (beside <= closed_reach && along <= closed_reach) return closed(x);
    if (along >= clear_along) return by_rule(x, ellipse_size(along, 0), whole_inner);
    Across sum = by_rule(x, ellipse_size(along, beside), smooth_inner);
    const Inner factor = singular_factor(static_cast<double>(x));
    for (std::size_t k = 0; k < integral_count; ++k)
      for (std::size_t p = 0; p < 2; ++p) sum.value[k][p] += factor.value[k][p] * singular_[singular_of[k]];
    return sum;
  }

 private:
  Across closed(Extended x) const {
    Across sum;
    for (std::size_t n = 0; n < 3; ++n) {
      if (stencil_.coefficient[0][n] == 0 && stencil_.coefficient[1][n] == 0) continue;
      const Antiderivatives f = antiderivatives(x, y_ + (static_cast<Extended>(n) - 1));
      for (std::size_t k = 0; k < integral_count; ++k)
        for (std::size_t p = 0; p < 2; ++p)
          for (std::size_t q = 0; q < 2; ++q) sum.value[k][p] += stencil_.coefficient[q][n] * f.value[k][p][q];
    }
    return sum;
  }

  template <class Function>
  Across by_rule(Extended x, double ellipse, const Function& inner) const {
    const LineRule& rule = stored_hat_rule(hat_, hat_points(ellipse, rule_digits));
    Across sum;
    for (std::size_t m = 0; m < rule.x.size(); ++m) {
      const Inner f = inner(static_cast<double>(x), static_cast<double>(y_ - rule.x[m]));
      for (std::size_t k = 0; k < integral_count; ++k)
        for (std::size_t p = 0; p < 2; ++p) sum.value[k][p] += rule.w[m] * f.value[k][p];
    }
    return sum;
  }

  Hat hat_;
  Extended y_;
  Stencil stencil_;
  double singular_[singular_count] = {};
};

/// Computes the integrals for cells longer along x, or square.
void along_the_longer_side(const LatticeHat& hat, double shift_x, double shift_y, OffsetRange x, OffsetRange y,
                           std::vector<double> (&value)[integral_count]) {
  const Extended unit = hat.dy, h = hat.dx / unit;
  const Stencil in_x = stencil(hat.x);
  const auto columns = static_cast<std::size_t>(x.size()), lines = static_cast<std::size_t>(y.size());
  for (auto& v : value) v.assign(columns * lines, 0.0);
  std::vector<Across> kink(columns + 2);
  for (std::size_t j = 0; j < lines; ++j) {
    check_interrupt();
    const Line line(hat.y, static_cast<Extended>(y.first) + static_cast<Extended>(j) + shift_y / unit);
    for (std::size_t i = 0; i < kink.size(); ++i)
      kink[i] = line.at((static_cast<Extended>(x.first) - 1 + static_cast<Extended>(i)) * h + shift_x / unit);
    for (std::size_t k = 0; k < integral_count; ++k)
      for (std::size_t i = 0; i < columns; ++i) {
        Extended sum = 0;
        for (std::size_t m = 0; m < 3; ++m)  // a derivative stands for a difference quotient
          sum +=
              in_x.coefficient[0][m] / h * kink[i + m].value[k][0] + in_x.coefficient[1][m] * kink[i + m].value[k][1];
        value[k][j * columns + i] = static_cast<double>(sum * unit);
      }
  }
}

}  // namespace

double ellipse_size(double along, double beside) {
  const double sum = (std::hypot(along + 1, beside) + std::hypot(along - 1, beside)) / 2;
  return sum + std::sqrt(std::max(0.0, sum * sum - 1));
}

int hat_points(double size, double digits) {
  if (digits <= 1) return 1;
  const double n = std::ceil(std::log(digits) / (2 * std::log(size)));
  return static_cast<int>(to_index(std::clamp(n, 1.0, static_cast<double>(max_hat_points))));
}

const LineRule& stored_hat_rule(Hat hat, int n) {
  static const auto table = [] {
    std::array<std::vector<LineRule>, 3> t;
    for (std::size_t h = 0; h < 3; ++h)
      for (int m = 1; m <= max_hat_points; ++m) t[h].push_back(hat_rule(static_cast<Hat>(h), m));
    return t;
  }();
  return table[static_cast<std::size_t>(hat)][static_cast<std::size_t>(n) - 1];
}

void near_lattice_integrals(const LatticeHat& hat, double shift_x, double shift_y, int terms, OffsetRange x,
                            OffsetRange y, std::vector<double> (&value)[integral_count]) {
  if (hat.dx >= hat.dy) {
    along_the_longer_side(hat, shift_x, shift_y, x, y, value);
  } else {
    std::vector<double> turned[integral_count];
    along_the_longer_side({hat.dy, hat.dx, hat.y, hat.x}, shift_y, shift_x, y, x, turned);
    for (auto& v : value) v.resize(turned[0].size());
    const auto columns = static_cast<std::size_t>(x.size()), lines = static_cast<std::size_t>(y.size());
    for (std::size_t j = 0; j < lines; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t to = j * columns + i, from = i * lines + j;
        value[0][to] = turned[0][from];
        value[1][to] = turned[0][from] - turned[1][from];
        value[2][to] = turned[2][from];
        value[3][to] = turned[4][from];
        value[4][to] = turned[3][from];
      }
  }
  if ((terms & with_shear) == 0) value[1].clear(), value[2].clear();
  if ((terms & with_coupling) == 0) value[3].clear(), value[4].clear();
}

}  // namespace rollcon::halfspace
