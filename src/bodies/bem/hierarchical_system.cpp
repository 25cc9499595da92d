/// Chooses how the equations of a boundary-element body are factorised, and makes hierarchical factors.

#include <algorithm>
#include <cmath>

#include "bodies/bem/system.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/hierarchical_factor.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/memory_limit.hpp"

namespace rollcon::bem {
namespace {

/// Holds the number of unknowns from which hierarchical factors are made faster than dense ones.
constexpr std::int64_t crossing = 12'000;
/// Holds the largest accepted error of a rigid motion, relative to the motion.
constexpr double most_rigid_error = 0.01;

}  // namespace

bool System::hierarchical() const {
  return options_.factor == 2 || (options_.factor == 0 && unknowns_.columns >= crossing && has_hierarchical_factor());
}

void System::require_matrix() const {
  const double bytes = 8.0 * static_cast<double>(unknowns_.columns) * static_cast<double>(unknowns_.columns);
  require_memory({bytes, bytes}, "take a coarser mesh, or a body of finite elements",
                 "the matrix of a boundary-element body with %lld unknowns needs",
                 static_cast<long long>(unknowns_.columns));
}

void System::require_factor() {
  const double n = static_cast<double>(unknowns_.columns);
  const double bytes = hierarchical() ? hierarchical_bytes(unknowns_.columns, options_.factor_accuracy) : 8 * n * n;
  statistics_.needed_bytes = bytes;
  if (!hierarchical()) return require_matrix();
  require_memory({bytes, bytes}, "take a coarser mesh or a larger factor_accuracy, or a body of finite elements",
                 "the hierarchical factors of a boundary-element body with %lld unknowns need about",
                 static_cast<long long>(unknowns_.columns));
}

std::vector<Pivot> System::pivots() const {
  const std::vector<std::int32_t> column = unknowns_.column_of_rows(fans_);
  std::vector<Pivot> pivots(column.size());
  for (std::size_t k = 0; k < unknowns_.row.size(); ++k)
    if (const std::int32_t r = unknowns_.row[k]; r >= 0) pivots[at(r)] = {r, column[at(r)], unknowns_.point[k / 3].x};
  return pivots;
}

void System::factorize_hierarchically(const CollocationBlocks& blocks) {
  const Stopwatch watch(statistics_.seconds_factor);
  ++statistics_.assemblies;
  ++statistics_.factorizations;
  factor_ = factor_hierarchically(blocks, pivots(), options_.factor_accuracy);
  count_peak(factor_bytes());
}

// Prescribes a rigid motion of all that is held. Its solution is known, and shows the errors of blocks and factors
// where they are amplified most.
void System::check_rigid_motion(const CollocationBlocks& blocks) {
  BodyMesh moved;
  const auto motion = [&](const Vec3& x) {
    const Vec3 r = (1 / reach_) * (x - held_at_);
    return Vec3{1, -1, 1} + cross(Vec3{1, 1, -1}, r);
  };
  for (const Vec3& x : surface_.node) moved.held_value.push_back(motion(x));
  std::vector<double> u = own_load(moved, {}, blocks);
  factor_->solve(u.data(), 1);
  double error = 0, largest = 0;
  for (std::size_t k = 0; k < unknowns_.displacement.size(); ++k) {
    const double there = moved.held_value[k / 3][k % 3];
    largest = std::max(largest, std::abs(there));
    if (const std::int32_t column = unknowns_.displacement[k]; column >= 0)
      error = std::max(error, std::abs(u[at(column)] - there));
  }
  rigid_error_ = error / largest;
  if (rigid_error_ <= most_rigid_error) return;
  factor_.reset();
  fail(Status::err_singular,
       "the hierarchical factors of the boundary-element body have an error of %.2g under a rigid motion of its "
       "supports; allowed: at most %g; take a smaller factor_accuracy, or factor = 1",
       rigid_error_, most_rigid_error);
}

}  // namespace rollcon::bem
