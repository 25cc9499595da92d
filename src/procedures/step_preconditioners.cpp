#include "procedures/step_preconditioners.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {

void OwnEntries::take(const ContactEquations& equations, const std::vector<std::int64_t>& own_rows, bool divide) {
  const std::int64_t first = equations.inner();
  factor_.clear();
  row_ = own_rows;
  for (std::int64_t i = first; i < equations.size(); ++i) row_.push_back(i);
  const auto add = [&](double entry) {
    factor_.push_back(entry == 0 ? 1.0 : divide ? 1 / entry : std::copysign(1.0, entry));
  };
  for (const BodiesEquations::Body& body : equations.bodies().bodies())
    for (std::int64_t j = 0; j < body.equations->unknowns; ++j) {
      double own = 0;
      body.scaled(j, [&](std::int64_t i, double v) {
        if (body.first + i == row_[at(body.first + j)]) own = v;
      });
      add(own);
    }
  for (std::int64_t a = 0; a < equations.contact_size(); ++a) add(equations.contact().row(a)[a]);
}

void OwnEntries::apply(const double* x, double* y) {
  for (std::size_t i = 0; i < factor_.size(); ++i) y[i] = factor_[i] * x[row_[i]];
}

void KeptDirections::keep(const ContactEquations& equations) {
  direction_.clear();
  for (const auto& unknown : equations.unknowns())
    direction_.push_back({3 * at(unknown.node), unknown.direction, unknown.traction});
  motions_ = equations.motions();
}

int KeptDirections::changed(const ContactEquations& equations) const {
  int count = 0;
  std::size_t i = 0;
  for (const auto& unknown : equations.unknowns()) {  // both ascend
    const std::size_t node = 3 * at(unknown.node);
    while (i < direction_.size() && direction_[i].node < node) ++i, ++count;
    if (i < direction_.size() && direction_[i].node == node)
      ++i;
    else
      ++count;
  }
  return count + static_cast<int>(direction_.size() - i);
}

void KeptDirections::to_kept(const ContactEquations& equations, const double* x, std::vector<double>& kept) {
  nodal_.clear();
  for (const auto& unknown : equations.unknowns()) {
    const std::size_t node = 3 * at(unknown.node);
    if (nodal_.size() < node + 3) nodal_.resize(node + 3, 0.0);
    for (std::size_t c = 0; c < 3; ++c) nodal_[node + c] += unknown.direction[c] * *x;
    ++x;
  }
  kept.clear();
  for (const Direction& d : direction_) {
    double sum = 0;
    for (std::size_t c = 0; c < 3 && d.node < nodal_.size(); ++c) sum += d.vector[c] * nodal_[d.node + c];
    for (std::size_t c = 0; c < 3 && d.node < nodal_.size(); ++c) nodal_[d.node + c] -= d.vector[c] * sum;
    kept.push_back(sum);
  }
  kept.insert(kept.end(), x, x + motions_);
}

void KeptDirections::from_kept(const ContactEquations& equations, const std::vector<double>& kept, double* y) {
  for (std::size_t i = 0; i < direction_.size(); ++i)
    for (std::size_t c = 0; c < 3 && direction_[i].node < nodal_.size(); ++c)
      nodal_[direction_[i].node + c] += direction_[i].traction[c] * kept[i];
  for (const auto& unknown : equations.unknowns()) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += unknown.direction[c] * nodal_[3 * at(unknown.node) + c];
    *y++ = sum;
  }
  std::copy(kept.end() - motions_, kept.end(), y);
}

int KeptFactors::price(const ContactEquations& equations) const {
  const std::int64_t n = equations.contact_size();
  return static_cast<int>(images_ ? 10 + n / 400 : 2 + n / 70);
}

bool KeptFactors::factor(const ContactEquations& equations) {
  if (images_) equations.contact_matrix(images_->rough(frame_), matrix_);
  const RowMatrix<double>& from = images_ ? matrix_ : equations.contact();
  const std::int64_t n = equations.contact_size();
  float* to = lu_.prepare(n);
  for (std::int64_t i = 0; i < n * n; ++i) to[i] = static_cast<float>(from.data()[i]);
  directions_.keep(equations);
  return valid_ = lu_.factor();
}

void KeptFactors::apply(const double* x, double* y) {
  const std::int64_t first = equations_->inner();
  directions_.to_kept(*equations_, x + first, kept_);
  // Single precision has a narrow range, so the residual is scaled to order one.
  double most = 0;
  for (const double v : kept_) most = std::max(most, std::abs(v));
  if (most > 0 && std::isfinite(most)) {
    single_.resize(kept_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i) single_[i] = static_cast<float>(kept_[i] / most);
    lu_.solve(single_.data());
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] = most * static_cast<double>(single_[i]);
  }
  directions_.from_kept(*equations_, kept_, y + first);
  if (first == 0) return;
  equations_->tractions(y + first, t_);
  std::copy_n(x, first, y);
  bodies_.add_loads(t_.data(), y);
  bodies_.solve(y);
}

}  // namespace rollcon
