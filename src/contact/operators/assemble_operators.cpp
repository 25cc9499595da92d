/// Rows of the discrete operators from the compliance and the convective scheme.

#include <algorithm>
#include <cmath>

#include "contact/operators/dense_operators.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t chunk = 64;  // rows of compliance held at a time

// Transpose of the convective rows: which slip rows use a sample, with what factor.
struct Users {
  std::vector<std::int64_t> start;
  std::vector<std::int32_t> row;
  std::vector<double> value;
};

Users transpose(const SparseRows& d, std::size_t samples) {
  Users t;
  t.start.assign(samples + 1, 0);
  for (const std::int32_t j : d.column) ++t.start[at(j) + 1];
  for (std::size_t j = 0; j < samples; ++j) t.start[j + 1] += t.start[j];
  t.row.resize(d.column.size());
  t.value.resize(d.column.size());
  std::vector<std::int64_t> next(t.start.begin(), t.start.end() - 1);
  for (std::size_t i = 0; i + 1 < d.start.size(); ++i)
    for (auto k = at(d.start[i]); k < at(d.start[i + 1]); ++k) {
      const std::size_t s = at(next[at(d.column[k])]++);
      t.row[s] = static_cast<std::int32_t>(i);
      t.value[s] = d.value[k];
    }
  return t;
}

// Adds the displacements of a sample to the slip rows that use it.
void scatter(const Users& users, std::size_t sample, const double* displacement, std::span<const std::uint8_t> wanted,
             RowMatrix<double>& out) {
  for (auto k = at(users.start[sample]); k < at(users.start[sample + 1]); ++k)
    if (wanted[at(users.row[k])]) axpy(users.value[k], displacement, out.row(users.row[k]), out.columns());
}

double largest(const DenseOperators& op, const RowMatrix<double>& block) {
  double value = 0;
  for (std::int64_t i = 0; i < block.rows(); ++i)
    for (std::int64_t k = 0; op.has_row(static_cast<std::size_t>(i)) && k < block.columns(); ++k)
      value = std::max(value, std::abs(block.row(i)[k]));
  return value;
}

void drop_vanished_coupling(DenseOperators& op) {
  constexpr double rounding = 1e-12;
  const auto vanishes = [&](double coupling, double direct) { return coupling <= rounding * direct; };
  const double along = std::max(largest(op, op.block[0][0]), largest(op, op.block[0][1]));
  const double across = std::max(largest(op, op.block[1][0]), largest(op, op.block[1][1]));
  if (!vanishes(std::max(largest(op, op.block[2][0]), largest(op, op.block[2][1])), largest(op, op.block[2][2])) ||
      !vanishes(std::max(largest(op, op.block[0][2]), largest(op, op.block[1][2])), std::max(along, across)))
    return;
  for (int c = 0; c < 2; ++c) {
    op.block[2][c].release();
    op.block[c][2].release();
  }
  op.coupled = false;
  op.coupling_vanished = true;
}

// Which blocks to assemble.
struct Wanted {
  bool block[3][3] = {};
  bool any() const {
    for (const auto& row : block)
      for (const bool b : row)
        if (b) return true;
    return false;
  }
  bool slip() const { return block[0][0]; }
};

/// Rows of the nodes in `rows`, of the blocks wanted, as sums over samples.
class Assembly {
 public:
  Assembly(const Frame& frame, const Compliance& compliance, const Convection& convection, const Wanted& wanted,
           std::span<const std::uint8_t> rows, DenseOperators& op)
      : frame_(frame),
        compliance_(compliance),
        convection_(convection),
        wanted_(wanted),
        rows_(rows),
        op_(op),
        n_(frame.nodes()) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        if (!wanted.block[r][c]) continue;
        if (op.block[r][c].empty()) op.block[r][c].resize_untouched(n_, n_);
        buffer_[r][c].resize(chunk, n_);
        for (std::int64_t i = 0; r < 2 && i < n_; ++i)
          if (rows[at(i)]) std::fill_n(op.block[r][c].row(i), n_, 0.0);
      }
    if (wanted.slip()) users_ = transpose(convection.rows, samples());
  }

  void run() {
    const std::size_t nodes = at(n_);
    std::vector<std::int32_t> needed;
    for (std::size_t k = 0; k < nodes; ++k)
      if (rows_[k] || used(k)) needed.push_back(static_cast<std::int32_t>(k));
    in_chunks(needed, [&](std::span<const std::int32_t> sample) { take_nodes(sample); });
    if (!wanted_.slip()) return;
    needed.clear();
    for (std::size_t k = nodes; k < samples(); ++k)
      if (used(k)) needed.push_back(static_cast<std::int32_t>(k));
    in_chunks(needed, [&](std::span<const std::int32_t> sample) { take_ahead(sample); });
    scale();
  }

 private:
  std::size_t samples() const { return at(n_) + convection_.ahead.size(); }
  /// By a slip row that is to be assembled.
  bool used(std::size_t sample) const {
    if (!wanted_.slip()) return false;
    for (auto k = at(users_.start[sample]); k < at(users_.start[sample + 1]); ++k)
      if (rows_[at(users_.row[k])]) return true;
    return false;
  }

  template <class Take>
  static void in_chunks(const std::vector<std::int32_t>& sample, Take take) {
    for (std::size_t first = 0; first < sample.size(); first += chunk)
      take(std::span(sample).subspan(first, std::min(at(chunk), sample.size() - first)));
  }

  void take_nodes(std::span<const std::int32_t> node) {
    place(node, [&](std::size_t k) { return frame_.x[k]; });
    // Rows that need nothing more go where they belong at once.
    const bool in_place = node.back() - node.front() + 1 == static_cast<std::int32_t>(node.size()) &&
                          std::all_of(node.begin(), node.end(), [&](std::int32_t k) { return rows_[at(k)] != 0; });
    ComplianceBlock out = blocks(3);
    for (int c = 0; c < 3; ++c)
      if (wanted_.block[2][c] && in_place) out.a[2][c] = op_.block[2][c].row(node[0]);
    compliance_.block({x_, y_}, out);
    for (int c = 0; c < 3; ++c)
      for (std::size_t p = 0; wanted_.block[2][c] && !in_place && p < node.size(); ++p)
        if (rows_[at(node[p])])
          std::copy_n(buffer_[2][c].row(static_cast<std::int64_t>(p)), n_, op_.block[2][c].row(node[p]));
    add_to_slip(node);
  }

  void take_ahead(std::span<const std::int32_t> sample) {
    place(sample, [&](std::size_t k) {
      const std::size_t node = k - at(n_);
      return frame_.x[node] + convection_.ahead[node];
    });
    compliance_.block({x_, y_}, blocks(2));
    add_to_slip(sample);
  }

  template <class Along>
  void place(std::span<const std::int32_t> sample, Along along) {
    x_.clear();
    y_.clear();
    for (const std::int32_t k : sample) {
      x_.push_back(along(at(k)));
      y_.push_back(frame_.y[at(k) % at(n_)]);
    }
  }

  ComplianceBlock blocks(int rows) {
    ComplianceBlock out;
    out.stride = n_;
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < 3; ++c)
        if (wanted_.block[r][c]) out.a[r][c] = buffer_[r][c].data();
    return out;
  }

  void add_to_slip(std::span<const std::int32_t> sample) {
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c)
        for (std::size_t p = 0; wanted_.block[r][c] && p < sample.size(); ++p)
          scatter(users_, at(sample[p]), buffer_[r][c].row(static_cast<std::int64_t>(p)), rows_, op_.block[r][c]);
  }

  void scale() {
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c)
        for (std::int64_t i = 0; wanted_.block[r][c] && i < n_; ++i) {
          const double factor = convection_.factor[at(i)];
          if (!rows_[at(i)] || factor == 1) continue;
          double* row = op_.block[r][c].row(i);
          for (std::int64_t k = 0; k < n_; ++k) row[k] *= factor;
        }
  }

  const Frame& frame_;
  const Compliance& compliance_;
  const Convection& convection_;
  const Wanted& wanted_;
  std::span<const std::uint8_t> rows_;
  DenseOperators& op_;
  std::int64_t n_;
  RowMatrix<double> buffer_[3][3];
  Users users_;
  std::vector<double> x_, y_;
};

}  // namespace

void assemble_operators(const Frame& frame, const Compliance& compliance, const Convection& convection,
                        bool want_tangential, DenseOperators& op, std::span<const std::uint8_t> wanted) {
  const std::int64_t n = frame.nodes();
  op.nodes = n;
  op.coupled = compliance.couples() && !op.coupling_vanished;
  if (!op.normal) op.rows = 0;
  if (!op.normal || op.there.empty()) op.there.assign(static_cast<std::size_t>(n), op.normal ? 1 : 0);
  // Of nodes that have rows: blocks that were not needed before. With coupling, a frictionless scene still needs no
  // tangential column.
  const bool slip = want_tangential || op.tangential;
  Wanted of_old, of_new;
  of_old.block[2][0] = of_old.block[2][1] = op.normal && op.coupled && want_tangential && op.block[2][0].empty();
  of_new.block[2][2] = true;
  of_new.block[2][0] = of_new.block[2][1] = op.coupled && (slip || !op.block[2][0].empty());
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 3; ++c) {
      of_new.block[r][c] = slip && (c < 2 || op.coupled);
      of_old.block[r][c] = of_new.block[r][c] && op.normal && !op.tangential;
    }
  std::vector<std::uint8_t> missing(static_cast<std::size_t>(n), 0);
  std::int64_t count = 0;
  for (std::size_t k = 0; k < missing.size(); ++k)
    if (!op.has_row(k) && (wanted.empty() || wanted[k])) missing[k] = 1, ++count;
  if (count == 0 && !of_old.any()) return;

  bool need[3][3];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) need[r][c] = of_old.block[r][c] || of_new.block[r][c];
  op.require_memory_for(need, op.rows + count);
  const bool first = !op.tangential && slip;
  if (of_old.any()) Assembly(frame, compliance, convection, of_old, op.there, op).run();
  if (count > 0) Assembly(frame, compliance, convection, of_new, missing, op).run();
  for (std::size_t k = 0; k < missing.size(); ++k)
    if (missing[k]) op.there[k] = 1;
  op.rows += count;
  op.normal = true;
  if (slip) op.tangential = true;
  // A kernel knows whether it couples; under little friction the smallest coupling counts.
  if (first && op.coupled && !compliance.translation()) drop_vanished_coupling(op);
}

}  // namespace rollcon
