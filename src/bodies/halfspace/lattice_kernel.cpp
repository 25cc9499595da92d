#include "bodies/halfspace/lattice_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bodies/halfspace/lattice_far.hpp"

namespace rollcon::halfspace {

extern const LatticeFarFunction lattice_far_baseline, lattice_far_avx2, lattice_far_avx512;

LatticeFarFunction lattice_far(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return lattice_far_avx512;
    case InstructionSet::avx2:
      return lattice_far_avx2;
    case InstructionSet::baseline:
      break;
  }
  return lattice_far_baseline;
}

namespace {

/// Rules are used where the kernel is analytic on an ellipse of this size around the hat ...
constexpr double smallest_ellipse = 5.5;
/// ... which a singularity this many half-widths off along, or beside, the axis leaves free.
constexpr double clear_along = (smallest_ellipse + 1 / smallest_ellipse) / 2;
constexpr double clear_beside = (smallest_ellipse - 1 / smallest_ellipse) / 2;
constexpr double rule_accuracy = 3e-16;

/// The hat's integral of F'' as a sum over nodes and derivatives of F, for half-width 1:
/// coefficient[p][m] of the p-th derivative at x + (m - 1).
struct Stencil {
  double coefficient[2][3];
};

/// With u = x - y the hat's integral of F''(u), by parts.
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

const LineRule& rule(Hat hat, int n) {
  static const auto table = [] {
    std::array<std::vector<LineRule>, 3> t;
    for (std::size_t h = 0; h < 3; ++h)
      for (int m = 1; m <= max_hat_points; ++m) t[h].push_back(hat_rule(static_cast<Hat>(h), m));
    return t;
  }();
  return table[static_cast<std::size_t>(hat)][static_cast<std::size_t>(n) - 1];
}

/// Sum of the semi-axes of the ellipse with foci -1, 1 through the point (along, beside).
double ellipse(double along, double beside) {
  const double sum = (std::hypot(along + 1, beside) + std::hypot(along - 1, beside)) / 2;
  return sum + std::sqrt(std::max(0.0, sum * sum - 1));
}

int points(double size, double share) {
  if (share <= 1) return 1;
  const double n = std::ceil(std::log(share) / (2 * std::log(size)));
  return static_cast<int>(std::clamp(n, 1.0, static_cast<double>(max_hat_points)));
}

}  // namespace

LatticeIntegrals::LatticeIntegrals(const LatticeHat& hat, double shift_x, double shift_y, int terms)
    : hat_(hat), shift_x_(shift_x), shift_y_(shift_y), terms_(terms) {
  const auto scaled = [](Hat part, double h) {
    std::vector<Rule> rules(1);
    for (int n = 1; n <= max_hat_points; ++n) {
      const LineRule& unit = rule(part, n);
      Rule r{unit.x, unit.w};
      for (double& x : r.x) x *= h;
      for (double& w : r.w) w *= h;
      rules.push_back(std::move(r));
    }
    return rules;
  };
  rule_x_ = scaled(hat.x, hat.dx);
  rule_y_ = scaled(hat.y, hat.dy);
  make_near();
}

void LatticeIntegrals::make_near() {
  const double dx = hat_.dx, dy = hat_.dy;
  const double reach_x = std::max(clear_along * dx, dx + clear_beside * dy);
  const double reach_y = std::max(clear_along * dy, dy + clear_beside * dx);
  const auto range = [](double reach, double shift, double h) {
    return Range{static_cast<std::int64_t>(std::ceil((-reach - shift) / h)),
                 static_cast<std::int64_t>(std::floor((reach - shift) / h))};
  };
  near_x_ = range(reach_x, shift_x_, dx);
  near_y_ = range(reach_y, shift_y_, dy);

  // Lengths over the geometric mean of the spacings: F then has the size of powers of r.
  const Extended unit = std::sqrt(static_cast<Extended>(dx) * dy);
  const Extended hx = dx / unit, hy = dy / unit;
  const Stencil in_x = stencil(hat_.x), in_y = stencil(hat_.y);
  const auto columns = static_cast<std::size_t>(near_x_.size()),
             rows = static_cast<std::size_t>(near_y_.size());
  std::vector<Antiderivatives> f((columns + 2) * (rows + 2));
  for (std::size_t j = 0; j < rows + 2; ++j)
    for (std::size_t i = 0; i < columns + 2; ++i) {
      const Extended x = near_x_.first - 1 + static_cast<Extended>(i),
                     y = near_y_.first - 1 + static_cast<Extended>(j);
      f[j * (columns + 2) + i] =
          antiderivatives(x * hx + shift_x_ / unit, y * hy + shift_y_ / unit);
    }
  for (int k = 0; k < integral_count; ++k) {
    const bool shear = k == 1 || k == 2, coupling = k > 2;
    if ((shear && (terms_ & with_shear) == 0) || (coupling && (terms_ & with_coupling) == 0))
      continue;
    near_[k].resize(columns * rows);
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        Extended sum = 0;
        for (int p = 0; p < 2; ++p)
          for (int q = 0; q < 2; ++q)
            for (std::size_t m = 0; m < 3; ++m)
              for (std::size_t n = 0; n < 3; ++n) {
                const double c = in_x.coefficient[p][m] * in_y.coefficient[q][n];
                if (c == 0) continue;
                // A derivative stands for a difference quotient.
                const Extended scale = (p == 0 ? 1 / hx : 1) * (q == 0 ? 1 / hy : 1);
                sum += c * scale * f[(j + n) * (columns + 2) + i + m].value[k][p][q];
              }
        near_[k][j * columns + i] = static_cast<double>(sum * unit);
      }
  }
  largest_ = *std::max_element(near_[0].begin(), near_[0].end());
}

void LatticeIntegrals::far(double y, const double* x, std::int64_t count, std::int64_t at,
                           double* const (&integral)[integral_count]) const {
  constexpr std::int64_t block = 32;  // observers that share a rule
  const LatticeFarFunction run = lattice_far(instruction_set());
  const double beside_y = std::abs(y);
  for (std::int64_t first = 0; first < count; first += block) {
    const std::int64_t size = std::min(block, count - first);
    // The observer nearest to the source decides.
    const double a = x[first], b = x[first + size - 1];
    const double nearest = a > 0 ? a : b < 0 ? -b : 0;
    const double r = std::hypot(nearest, beside_y);
    const double share = hat_.dx * hat_.dy / (r * largest_ * rule_accuracy);
    const double gap_x = std::max(0.0, nearest - hat_.dx),
                 gap_y = std::max(0.0, beside_y - hat_.dy);
    LatticeFar job;
    job.nx = points(ellipse(nearest / hat_.dx, gap_y / hat_.dx), share);
    job.ny = points(ellipse(beside_y / hat_.dy, gap_x / hat_.dy), share);
    const Rule &rx = rule_x_[static_cast<std::size_t>(job.nx)],
               &ry = rule_y_[static_cast<std::size_t>(job.ny)];
    job.px = rx.x.data(), job.wx = rx.w.data();
    job.py = ry.x.data(), job.wy = ry.w.data();
    job.x = x + first;
    job.y = y;
    job.count = size;
    for (int k = 0; k < integral_count; ++k)
      job.integral[k] = integral[k] == nullptr ? nullptr : integral[k] + at + first;
    run(job, terms_);
  }
}

void LatticeIntegrals::row(std::int64_t j, std::int64_t first, std::int64_t count,
                           double* const (&integral)[integral_count]) const {
  std::vector<double> x(static_cast<std::size_t>(count));
  for (std::int64_t m = 0; m < count; ++m)
    x[static_cast<std::size_t>(m)] = shift_x_ + static_cast<double>(first + m) * hat_.dx;
  const double y = shift_y_ + static_cast<double>(j) * hat_.dy;
  if (!near_y_.contains(j)) return far(y, x.data(), count, 0, integral);
  // Left of the closed forms, the closed forms, right of them.
  const std::int64_t from = std::clamp<std::int64_t>(near_x_.first - first, 0, count);
  const std::int64_t to = std::clamp<std::int64_t>(near_x_.last + 1 - first, from, count);
  far(y, x.data(), from, 0, integral);
  far(y, x.data() + to, count - to, to, integral);
  for (int k = 0; k < integral_count; ++k) {
    if (near_[k].empty()) continue;
    const double* value = near_[k].data() + (j - near_y_.first) * near_x_.size() - near_x_.first;
    std::copy(value + first + from, value + first + to, integral[k] + from);
  }
}

}  // namespace rollcon::halfspace
