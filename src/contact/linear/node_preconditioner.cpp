#include "contact/linear/node_preconditioner.hpp"

#include <algorithm>

#include "support/index.hpp"

namespace rollcon {

void NodePreconditioner::take(const ReducedSystem& system) {
  system_ = &system;
  const std::int64_t na = system.active();
  stick_.assign(at(na), 0);
  inverse_.assign(at(4 * na), 0.0);
  if (system.part() != Part::normal)
    for (std::int64_t a = 0; a < na; ++a) {
      const TangentialLaw& law = system.law(a);
      stick_[at(a)] = !law.sliding;
      if (!law.sliding) continue;
      double block[3][3];
      system.pair_block(a, block);
      const double det = block[0][0] * block[1][1] - block[0][1] * block[1][0];
      double* inverse = inverse_.data() + 4 * a;
      inverse[0] = block[1][1] / det, inverse[1] = -block[0][1] / det;
      inverse[2] = -block[1][0] / det, inverse[3] = block[0][0] / det;
    }
  take_rows();
  // The Schur complement of [A b; c 0] solves for the borders.
  borders_ = system.borders();
  const std::int64_t rows = system.components() * na;
  work_.resize(at(rows));
  columns_.resize(at(borders_ * rows));
  for (int k = 0; k < borders_; ++k) {
    system.border_column(k, work_.data());
    apply_rows(work_.data(), columns_.data() + k * rows);
  }
  if (borders_ == 0) return;
  double* s = schur_.prepare(borders_);
  for (int i = 0; i < borders_; ++i)
    for (int j = 0; j < borders_; ++j) s[i * borders_ + j] = system.border_product(i, columns_.data() + j * rows);
  if (!schur_.factor()) borders_ = 0;
}

void NodePreconditioner::apply(const double* x, double* y) {
  const std::int64_t rows = system_->components() * system_->active();
  apply_rows(x, y);
  const int all = system_->borders();
  if (borders_ == 0) {
    std::copy(x + rows, x + rows + all, y + rows);
    return;
  }
  double motion[motion_count];
  for (int k = 0; k < borders_; ++k) motion[k] = system_->border_product(k, y) - x[rows + k];
  schur_.solve(motion);
  for (int k = 0; k < borders_; ++k) {
    y[rows + k] = motion[k];
    const double* column = columns_.data() + k * rows;
    for (std::int64_t i = 0; i < rows; ++i) y[i] -= motion[k] * column[i];
  }
}

void NodePreconditioner::apply_rows(const double* x, double* y) {
  // Normal tractions come first: sliding nodes follow them.
  const std::int64_t first = (system_->components() - 1) * system_->active();
  if (system_->part() != Part::tangential) normal_rows(x + first, y + first);
  if (system_->part() == Part::normal) return;
  sticking_rows(x, y);
  sliding_rows(x, y);
}

void NodePreconditioner::sliding_rows(const double* x, double* y) const {
  const std::int64_t na = system_->active();
  const bool full = system_->part() == Part::full;
  for (std::int64_t a = 0; a < na; ++a) {
    if (sticks(a)) continue;
    const TangentialLaw& law = system_->law(a);
    const double ln = full ? y[2 * na + a] : 0;
    const double r1 = x[a] - law.own[0][2] * ln, r2 = x[na + a] - law.own[1][2] * ln;
    const double* inverse = inverse_.data() + 4 * a;
    y[a] = inverse[0] * r1 + inverse[1] * r2;
    y[na + a] = inverse[2] * r1 + inverse[3] * r2;
  }
}

}  // namespace rollcon
