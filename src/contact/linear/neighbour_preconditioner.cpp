/// Inverts Newton's systems approximately on irregular frames of half-spaces.
///
/// Normal displacements are inverted row by row: each row of the inverse is that of the matrix of the node's nearest
/// neighbours, as the inverse's entries fall like 1/r^3. Convection of sticking nodes is undone first, by a sweep of
/// upwind differences from upstream to downstream, which leaves displacements; tangential displacements are taken for
/// normal ones, stiffer by the mean ratio under waves.

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/linear/node_preconditioner.hpp"
#include "contact/operators/hierarchical/hierarchical_operator.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Inverts normal displacements of some nodes.
class NearInverse {
 public:
  /// Makes rows for nodes, if they are others than before.
  void make(const HierarchicalOperator& on, const std::vector<std::int32_t>& node);
  /// Computes tractions from displacements of the nodes.
  void apply(const double* displacement, double* traction) const {
    for (std::size_t i = 0; i + 1 < start_.size(); ++i) {
      double sum = 0;
      for (std::size_t m = start_[i]; m < start_[i + 1]; ++m) sum += value_[m] * displacement[column_[m]];
      traction[i] = sum;
    }
  }
  const std::vector<std::int32_t>& nodes() const { return node_; }
  std::size_t bytes() const {
    return value_.capacity() * sizeof(double) + (node_.capacity() + column_.capacity()) * sizeof(std::int32_t) +
           start_.capacity() * sizeof(std::size_t);
  }

 private:
  std::vector<std::int32_t> node_, column_;
  std::vector<std::size_t> start_;
  std::vector<double> value_;
  Lu<double> lu_;
};

void NearInverse::make(const HierarchicalOperator& on, const std::vector<std::int32_t>& node) {
  constexpr std::size_t most = 24;  // neighbours, the node itself among them
  if (node == node_ && !start_.empty()) return;
  node_ = node;
  std::vector<std::int32_t> number(at(on.nodes), -1);
  for (std::size_t i = 0; i < node.size(); ++i) number[at(node[i])] = static_cast<std::int32_t>(i);
  start_.assign(1, 0);
  column_.clear();
  value_.clear();
  std::vector<std::pair<double, std::int32_t>> close;
  std::vector<double> row;
  for (const std::int32_t k : node) {
    const Vec2 here = on.place(at(k));
    close.clear();
    for (const std::int32_t l : on.near_nodes(at(k)))
      if (number[at(l)] >= 0) {
        const Vec2 d = on.place(at(l)) - here;
        close.emplace_back(dot(d, d), l);
      }
    const std::size_t n = std::min(most, close.size());
    std::partial_sort(close.begin(), close.begin() + static_cast<std::ptrdiff_t>(n), close.end());
    double* matrix = lu_.prepare(static_cast<std::int64_t>(n));
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; q < n; ++q) matrix[q * n + p] = on.near(2, 2, at(close[p].second), at(close[q].second));
    row.assign(n, 0.0);
    row[0] = 1;
    if (lu_.factor()) {
      lu_.solve(row.data());
    } else {
      row.assign(n, 0.0);
      row[0] = 1 / on.near(2, 2, at(k), at(k));
    }
    for (std::size_t p = 0; p < n; ++p) {
      column_.push_back(number[at(close[p].second)]);
      value_.push_back(row[p]);
    }
    start_.push_back(column_.size());
  }
}

class NeighbourPreconditioner final : public NodePreconditioner {
 public:
  explicit NeighbourPreconditioner(const HierarchicalOperator& on) : on_(on), field_(at(on.nodes), 0.0) {
    const TranslationKernel::Softness soft = on.kernel().softness(1);
    stiffer_ = soft.normal / std::sqrt(soft.along * soft.across);
  }
  std::size_t bytes() const override {
    return NodePreconditioner::bytes() + normal_.bytes() + stick_.bytes() +
           (field_.capacity() + part_.capacity() + found_.capacity()) * sizeof(double);
  }

 private:
  void take_rows() override;
  void normal_rows(const double* x, double* y) override;
  void sticking_rows(const double* x, double* y) override;

  const HierarchicalOperator& on_;
  double stiffer_;  ///< ratio of tangential to normal stiffness
  NearInverse normal_, stick_;
  std::vector<std::int32_t> sticking_;  ///< active nodes that stick
  std::vector<std::uint8_t> active_;    ///< flags by node of the frame
  std::vector<double> field_, part_, found_;
};

void NeighbourPreconditioner::take_rows() {
  const auto nodes = system().nodes();
  if (system().part() != Part::tangential) normal_.make(on_, {nodes.begin(), nodes.end()});
  if (system().part() == Part::normal) return;
  std::vector<std::int32_t> stuck;
  sticking_.clear();
  active_.assign(field_.size(), 0);
  for (std::int64_t a = 0; a < system().active(); ++a) {
    active_[at(nodes[at(a)])] = 1;
    if (!sticks(a)) continue;
    sticking_.push_back(static_cast<std::int32_t>(a));
    stuck.push_back(nodes[at(a)]);
  }
  stick_.make(on_, stuck);
}

void NeighbourPreconditioner::normal_rows(const double* x, double* y) {
  part_.resize(at(system().active()));
  for (std::size_t a = 0; a < part_.size(); ++a) part_[a] = x[a] / system().normal_scale(static_cast<std::int64_t>(a));
  normal_.apply(part_.data(), y);
}

void NeighbourPreconditioner::sticking_rows(const double* x, double* y) {
  const auto& [rows, order] = on_.flow();
  const std::vector<std::int32_t>& stuck = stick_.nodes();
  part_.resize(stuck.size());
  found_.resize(stuck.size());
  for (int c = 0; c < 2; ++c) {
    const std::int64_t first = c * system().active();
    std::fill(field_.begin(), field_.end(), 0.0);
    for (std::size_t i = 0; i < stuck.size(); ++i)
      field_[at(stuck[i])] = x[first + sticking_[i]] / system().slip_scale(sticking_[i]);
    for (const std::int32_t k : order) {
      if (!active_[at(k)]) continue;
      double own = 0, sum = field_[at(k)];
      for (auto m = at(rows.start[at(k)]); m < at(rows.start[at(k) + 1]); ++m)
        if (rows.column[m] == k)
          own += rows.value[m];
        else
          sum -= rows.value[m] * field_[at(rows.column[m])];
      field_[at(k)] = own > 0 ? sum / own : 0;
    }
    for (std::size_t i = 0; i < stuck.size(); ++i) part_[i] = stiffer_ * field_[at(stuck[i])];
    stick_.apply(part_.data(), found_.data());
    for (std::size_t i = 0; i < stuck.size(); ++i) y[first + sticking_[i]] = found_[i];
  }
}

}  // namespace

std::unique_ptr<FieldPreconditioner> HierarchicalOperator::make_preconditioner() const {
  return std::make_unique<NeighbourPreconditioner>(*this);
}

}  // namespace rollcon
