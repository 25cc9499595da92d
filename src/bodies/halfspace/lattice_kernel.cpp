#include "bodies/halfspace/lattice_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/halfspace/lattice_far.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon::halfspace {

extern const LatticeFarFunction lattice_far_baseline, lattice_far_avx2, lattice_far_avx512;

LatticeFarFunction lattice_far(InstructionSet set) {
  return chosen(set, lattice_far_baseline, lattice_far_avx2, lattice_far_avx512);
}

LatticeIntegrals::LatticeIntegrals(const LatticeHat& hat, double shift_x, double shift_y, int terms, OffsetReach reach,
                                   double accuracy)
    : hat_(hat), shift_x_(shift_x), shift_y_(shift_y), terms_(terms), reach_(reach), accuracy_(accuracy) {
  const auto scaled = [](Hat part, double h) {
    std::vector<Rule> rules(1);
    for (int n = 1; n <= max_hat_points; ++n) {
      const LineRule& unit = stored_hat_rule(part, n);
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
  const double near_x = std::max(clear_along * dx, dx + clear_beside * dy);
  const double near_y = std::max(clear_along * dy, dy + clear_beside * dx);
  // What nobody asks for is left out: slender cells have as many near offsets as the sides' ratio.
  const auto range = [](double near, double shift, double h, std::int64_t reach) {
    const double source = std::round(-shift / h), most = static_cast<double>(reach);
    const double first = std::max(std::ceil((-near - shift) / h), std::min(-most, source));
    const double last = std::min(std::floor((near - shift) / h), std::max(most, source));
    return OffsetRange{to_index(first), to_index(last)};
  };
  near_x_ = range(near_x, shift_x_, dx, reach_.x);
  near_y_ = range(near_y, shift_y_, dy, reach_.y);
  near_lattice_integrals(hat_, shift_x_, shift_y_, terms_, near_x_, near_y_, near_);
  largest_ = *std::max_element(near_[0].begin(), near_[0].end());
}

void LatticeIntegrals::far(double y, const double* x, std::int64_t count, std::int64_t at,
                           double* const (&integral)[integral_count], int terms) const {
  constexpr std::int64_t block = 32;  // observers that share a rule
  const LatticeFarFunction run = lattice_far(instruction_set());
  const double beside_y = std::abs(y);
  for (std::int64_t first = 0; first < count; first += block) {
    const std::int64_t size = std::min(block, count - first);
    // The observer nearest to the source decides.
    const double a = x[first], b = x[first + size - 1];
    const double nearest = a > 0 ? a : b < 0 ? -b : 0;
    const double r = std::hypot(nearest, beside_y);
    const double share = hat_.dx * hat_.dy / (r * largest_ * accuracy_);
    const double gap_x = std::max(0.0, nearest - hat_.dx), gap_y = std::max(0.0, beside_y - hat_.dy);
    LatticeFar job;
    job.nx = hat_points(ellipse_size(nearest / hat_.dx, gap_y / hat_.dx), share);
    job.ny = hat_points(ellipse_size(beside_y / hat_.dy, gap_x / hat_.dy), share);
    const Rule &rx = rule_x_[static_cast<std::size_t>(job.nx)], &ry = rule_y_[static_cast<std::size_t>(job.ny)];
    job.px = rx.x.data(), job.wx = rx.w.data();
    job.py = ry.x.data(), job.wy = ry.w.data();
    job.x = x + first;
    job.y = y;
    job.count = size;
    for (int k = 0; k < integral_count; ++k)
      job.integral[k] = integral[k] == nullptr ? nullptr : integral[k] + at + first;
    run(job, terms_ & terms);
  }
}

void LatticeIntegrals::row(std::int64_t j, std::int64_t first, std::int64_t count,
                           double* const (&integral)[integral_count], int terms) const {
  if (std::max(std::abs(first), std::abs(first + count - 1)) > reach_.x || std::abs(j) > reach_.y)
    fail(Status::err_internal, "offsets %lld to %lld, %lld lie beyond those of the lattice",
         static_cast<long long>(first), static_cast<long long>(first + count - 1), static_cast<long long>(j));
  std::vector<double> x(static_cast<std::size_t>(count));
  for (std::int64_t m = 0; m < count; ++m)
    x[static_cast<std::size_t>(m)] = shift_x_ + static_cast<double>(first + m) * hat_.dx;
  const double y = shift_y_ + static_cast<double>(j) * hat_.dy;
  if (!near_y_.contains(j)) return far(y, x.data(), count, 0, integral, terms);
  // Left of the closed forms, the closed forms, right of them.
  const std::int64_t from = std::clamp<std::int64_t>(near_x_.first - first, 0, count);
  const std::int64_t to = std::clamp<std::int64_t>(near_x_.last + 1 - first, from, count);
  far(y, x.data(), from, 0, integral, terms);
  far(y, x.data() + to, count - to, to, integral, terms);
  for (int k = 0; k < integral_count; ++k) {
    if (near_[k].empty() || (integral_terms(k) & terms) != integral_terms(k)) continue;
    const double* value = near_[k].data() + (j - near_y_.first) * near_x_.size() - near_x_.first;
    std::copy(value + first + from, value + first + to, integral[k] + from);
  }
}

void LatticeIntegrals::at_place(double x, std::int64_t j, double* const (&integral)[integral_count], int terms) const {
  const double near = std::max(clear_along * hat_.dx, hat_.dx + clear_beside * hat_.dy);
  if (std::abs(x) > near || !near_y_.contains(j))
    return far(shift_y_ + static_cast<double>(j) * hat_.dy, &x, 1, 0, integral, terms);
  std::vector<double> value[integral_count];
  near_lattice_integrals(hat_, x, shift_y_, terms_ & terms, {0, 0}, {j, j}, value);
  for (int k = 0; k < integral_count; ++k)
    if (!value[k].empty()) *integral[k] = value[k].front();
}

}  // namespace rollcon::halfspace
