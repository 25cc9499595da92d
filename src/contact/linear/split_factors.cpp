#include "contact/linear/split_factors.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {
namespace {

using Rows = FreeSystem::Rows;

// Returns the scale of residuals, as single precision has a narrow range. 0: nothing to solve.
double largest_of(const double* x, std::int64_t n) {
  double largest = 0;
  for (std::int64_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(x[i]));
  return std::isfinite(largest) ? largest : 0;
}

}  // namespace

bool SplitFactors::Block::factor(FreeSystem& system, Rows rows, std::int64_t node_count) {
  // The tangential part grows as nodes stick, to twice its nodes at most.
  const std::int64_t n = system.size(rows), full = system.system().size();
  const std::int64_t room = rows == Rows::normal || n >= 1000 ? std::max(n / 5, with_room(n) - n) : with_room(full) - n;
  system.dense(rows, lu.prepare(n, room));
  valid = lu.factor();
  nodes = system.active();
  borders = system.borders(rows);
  const auto active = system.system().nodes();
  if (node.capacity() < active.size()) node.reserve(with_room(active.size()));
  node.assign(active.begin(), active.end());
  place.assign(at(node_count), -1);
  for (std::size_t a = 0; a < active.size(); ++a) place[at(active[a])] = static_cast<std::int32_t>(a);
  if (work.size() < at(n)) work.resize(at(n + room));
  return valid;
}

bool SplitFactors::Block::usable(const FreeSystem& system, Rows rows) const {
  return valid && borders == system.borders(rows);
}

bool SplitFactors::Block::same_nodes(const FreeSystem& system) const {
  const auto active = system.system().nodes();
  return active.size() == node.size() && std::equal(active.begin(), active.end(), node.begin());
}

bool SplitFactors::factor(FreeSystem& system, std::int64_t node_count) {
  bool good = true;
  if (system.tangential()) {
    good = tangential_.factor(system, Rows::tangential, node_count);
    const std::size_t na = at(system.active());
    for (int c = 0; c < 2; ++c) across_[c].resize(na);
    second_.assign(na, -1);
    for (std::size_t a = 0; a < na; ++a)
      for (int c = 0; c < 2; ++c) across_[c][a] = system.across(c, a);
    auto row = static_cast<std::int32_t>(na);
    for (const std::int32_t a : system.whole()) second_[at(a)] = row++;
  }
  if (good && system.normal() && !(normal_.usable(system, Rows::normal) && normal_.same_nodes(system)))
    good = normal_.factor(system, Rows::normal, node_count);
  return good;
}

bool SplitFactors::usable(const FreeSystem& system) const {
  return (!system.tangential() || tangential_.usable(system, Rows::tangential)) &&
         (!system.normal() || normal_.usable(system, Rows::normal));
}

void SplitFactors::match(FreeSystem& system) {
  system_ = &system;
  changed_ = 0;
  const auto active = system.system().nodes();
  const std::size_t na = active.size();
  if (to_normal_.size() < na) {
    const std::size_t room = with_room(na);
    to_tangential_.resize(room), to_normal_.resize(room), own_second_.resize(room);
    rest_.resize(room + 1), right_.resize(2 * room + 3), found_.resize(2 * room + 3);
  }
  if (system.normal())
    for (std::size_t a = 0; a < na; ++a) {
      to_normal_[a] = normal_.place[at(active[a])];
      changed_ += to_normal_[a] < 0;
    }
  if (!system.tangential()) return;
  std::fill(own_second_.begin(), own_second_.begin() + static_cast<std::ptrdiff_t>(na), -1);
  auto row = static_cast<std::int32_t>(na);
  for (const std::int32_t a : system.whole()) own_second_[at(a)] = row++;
  for (std::size_t a = 0; a < na; ++a) {
    const std::int32_t p = to_tangential_[a] = tangential_.place[at(active[a])];
    changed_ += p < 0 || (second_[at(p)] < 0) != (own_second_[a] < 0);
  }
}

// Solves between the bases of both systems: components that only one of them has are left alone.
void SplitFactors::solve_tangential(const double* x, double* y) {
  const std::size_t na = at(system_->active());
  const std::int64_t present = system_->size(Rows::tangential), n = tangential_.lu.size();
  const std::int64_t borders = tangential_.borders;
  const double scale = largest_of(x, present);
  std::copy(x, x + present, y);
  if (!(scale > 0)) return;
  float* work = tangential_.work.data();
  std::fill(work, work + n, 0.0f);
  for (std::size_t a = 0; a < na; ++a) {
    const std::int32_t p = to_tangential_[a];
    if (p < 0) continue;
    const std::int32_t own = own_second_[a];
    double r1 = system_->across(0, a) * x[a], r2 = system_->across(1, a) * x[a];
    if (own >= 0) r2 += x[own];
    const std::int32_t second = second_[at(p)];
    if (second >= 0) {
      work[p] = static_cast<float>(r1 / scale);
      work[second] = static_cast<float>(r2 / scale);
    } else {
      work[p] = static_cast<float>((across_[0][at(p)] * r1 + across_[1][at(p)] * r2) / scale);
    }
  }
  for (std::int64_t k = 1; k <= borders; ++k) work[n - k] = static_cast<float>(x[present - k] / scale);
  tangential_.lu.solve(work);
  for (std::size_t a = 0; a < na; ++a) {
    const std::int32_t p = to_tangential_[a];
    if (p < 0) continue;
    const std::int32_t own = own_second_[a], second = second_[at(p)];
    double z1 = scale * static_cast<double>(work[p]), z2 = 0;
    if (second >= 0) {
      z2 = scale * static_cast<double>(work[second]);
    } else {
      const double e1 = across_[1][at(p)], e2 = -across_[0][at(p)];
      double left = 0;  // the residual along the slip at the time of the factors
      if (own >= 0) left = e1 * x[a] + e2 * x[own];
      z2 = across_[1][at(p)] * z1 + e2 * left;
      z1 = across_[0][at(p)] * z1 + e1 * left;
    }
    if (own >= 0) {
      y[a] = z1;
      y[own] = z2;
    } else {
      y[a] = system_->across(0, a) * z1 + system_->across(1, a) * z2;
    }
  }
  for (std::int64_t k = 1; k <= borders; ++k) y[present - k] = scale * static_cast<double>(work[n - k]);
}

void SplitFactors::solve_normal(const double* x, double* y) {
  const std::int64_t na = system_->active(), nodes = normal_.nodes, borders = normal_.borders;
  const double scale = largest_of(x, na + borders);
  std::copy(x, x + na + borders, y);
  if (!(scale > 0)) return;
  float* work = normal_.work.data();
  std::fill(work, work + nodes, 0.0f);
  for (std::int64_t a = 0; a < na; ++a)
    if (const std::int32_t p = to_normal_[at(a)]; p >= 0) work[p] = static_cast<float>(x[a] / scale);
  for (std::int64_t k = 0; k < borders; ++k) work[nodes + k] = static_cast<float>(x[na + k] / scale);
  normal_.lu.solve(work);
  for (std::int64_t a = 0; a < na; ++a)
    if (const std::int32_t p = to_normal_[at(a)]; p >= 0) y[a] = scale * static_cast<double>(work[p]);
  for (std::int64_t k = 0; k < borders; ++k) y[na + k] = scale * static_cast<double>(work[nodes + k]);
}

void SplitFactors::apply(const double* x, double* y) {
  if (!system_->normal()) return solve_tangential(x, y);
  if (!system_->tangential()) return solve_normal(x, y);
  // Motions stand behind the normal tractions.
  const std::int64_t borders = tangential_.borders, na = system_->active();
  const std::int64_t tractions = system_->size(Rows::tangential) - borders;
  const std::int64_t normal = na + normal_.borders;
  double *right = right_.data(), *found = found_.data(), *rest = rest_.data();
  std::copy(x, x + tractions, right);
  std::copy(x + tractions + na, x + tractions + na + borders, right + tractions);
  solve_tangential(right, found);
  std::copy(x + tractions, x + tractions + na, rest);
  const double* last = x + tractions + na + borders;
  std::copy(last, last + normal_.borders, rest + na);
  system_->subtract_from_normal(found, rest);
  std::copy(found, found + tractions, y);
  std::copy(found + tractions, found + tractions + borders, y + tractions + na);
  solve_normal(rest, found);
  std::copy(found, found + na, y + tractions);
  std::copy(found + na, found + normal, y + tractions + na + borders);
}

std::size_t SplitFactors::bytes() const {
  return tangential_.lu.bytes() + normal_.lu.bytes();
}

}  // namespace rollcon
