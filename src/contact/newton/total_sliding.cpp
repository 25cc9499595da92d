#include "contact/newton/total_sliding.hpp"

#include <algorithm>
#include <cmath>

#include "contact/operators/dense_operators.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Greatest elastic slip over the rigid one. The directions then change by at most half as much from one step to the
// next.
constexpr double greatest_turn = 1.0 / 3;
constexpr std::int64_t most_steps = 60;

double rigid_speed(const Problem& p, std::int64_t i, const Iterate& it) {
  return std::hypot(p.rigid_slip1(i, it.motion), p.rigid_slip2(i, it.motion));
}

// Largest slip that node i can get from unit tractions of node j.
double influence(const DenseOperators& op, std::int64_t i, std::int64_t j) {
  double sum = 0;
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c) {
      const double v = op.block[r][c].row(i)[j];
      sum += v * v;
    }
  return std::sqrt(sum);
}

}  // namespace

bool TotalSliding::applies(const Problem& p, const Prescribed& given, const Iterate& it) {
  if (given.by_force[xi1] || given.by_force[xi2] || given.by_force[spin]) return false;
  const DenseOperators* rows = p.op->dense();
  if (!rows || !rows->tangential || rows->coupled) return false;
  loaded_.clear();
  loaded_.reserve(at(p.nodes));
  row_sum_.reserve(at(p.nodes));
  for (auto& v : next_) v.reserve(at(p.nodes));
  for (std::int64_t i = 0; i < p.nodes; ++i) {
    const double bound = -given.friction * p.mu[at(i)] * it.lambda[2][at(i)];
    if (!(bound > 0)) continue;
    // Its own traction alone: nearly all scenes that do not slide altogether end here.
    if (influence(*rows, i, i) * bound > greatest_turn * rigid_speed(p, i, it)) return false;
    loaded_.push_back(static_cast<std::int32_t>(i));
  }
  if (loaded_.empty()) return false;
  if (row_sum_.size() != at(p.nodes)) row_sum_.assign(at(p.nodes), -1.0);
  double largest = 0;
  for (const std::int32_t i : loaded_) largest = std::max(largest, -given.friction * p.mu[at(i)] * it.lambda[2][at(i)]);
  return std::all_of(loaded_.begin(), loaded_.end(),
                     [&](std::int32_t i) { return bound_holds(p, given, it, i, largest); });
}

// largest: greatest mu p.
bool TotalSliding::bound_holds(const Problem& p, const Prescribed& given, const Iterate& it, std::int64_t i,
                               double largest) {
  const DenseOperators& op = *p.op->dense();
  const double most = greatest_turn * rigid_speed(p, i, it);
  double& sum = row_sum_[at(i)];
  if (sum < 0) {
    sum = 0;
    for (std::int64_t j = 0; j < p.nodes; ++j) sum += influence(op, i, j);
  }
  if (sum * largest <= most) return true;
  double elastic = 0;
  for (const std::int32_t j : loaded_)
    elastic -= influence(op, i, j) * given.friction * p.mu[at(j)] * it.lambda[2][at(j)];
  return elastic <= most;
}

std::int64_t TotalSliding::solve(const Problem& p, const Prescribed& given, Iterate& it, double tolerance) {
  for (auto& v : next_) v.resize(loaded_.size());
  // Tractions of an earlier solution tell elastic slip nearly; nodes that carry none now lose them.
  double largest = 0;
  for (std::size_t k = 0, a = 0; k < at(p.nodes); ++k) {
    if (a < loaded_.size() && at(loaded_[a]) == k) {
      largest = std::max(largest, -given.friction * p.mu[k] * it.lambda[2][k]);
      ++a;
    } else {
      it.lambda[0][k] = it.lambda[1][k] = 0;
    }
  }
  for (std::int64_t step = 1; step <= most_steps; ++step) {
    std::fill(it.slip_valid.begin(), it.slip_valid.end(), std::uint8_t{0});
    double change = 0;
    for (std::size_t a = 0; a < loaded_.size(); ++a) {
      const std::int64_t i = loaded_[a];
      const std::size_t k = at(i);
      it.update_slip(p, i);
      const double s1 = p.rigid_slip1(i, it.motion) + it.image[0][k];
      const double s2 = p.rigid_slip2(i, it.motion) + it.image[1][k];
      const double factor = given.friction * p.mu[k] * it.lambda[2][k] / std::hypot(s1, s2);
      next_[0][a] = factor * s1;
      next_[1][a] = factor * s2;
      for (int c = 0; c < 2; ++c) change = std::max(change, std::abs(next_[c][a] - it.lambda[c][k]));
    }
    if (!(change > tolerance * largest)) return step;
    for (std::size_t a = 0; a < loaded_.size(); ++a)
      for (int c = 0; c < 2; ++c) it.lambda[c][at(loaded_[a])] = next_[c][a];
  }
  it.invalidate();
  return 0;
}

}  // namespace rollcon
