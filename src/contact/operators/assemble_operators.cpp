/// Assembles rows of the discrete operators from the compliance and the convective scheme.

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/operators/dense_operators.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t chunk = 64;  // rows of compliance held at a time

// Holds the transpose of the convective rows: which slip rows use a sample, with what factor.
struct Users {
  std::vector<std::int64_t> start;
  std::vector<std::int32_t> row;
  std::vector<double> value;
  std::vector<std::int64_t> next;  ///< workspace of transpose()
};

void transpose(const SparseRows& d, std::size_t samples, Users& t) {
  t.start.assign(samples + 1, 0);
  for (const std::int32_t j : d.column) ++t.start[at(j) + 1];
  for (std::size_t j = 0; j < samples; ++j) t.start[j + 1] += t.start[j];
  t.row.resize(d.column.size());
  t.value.resize(d.column.size());
  std::vector<std::int64_t>& next = t.next;
  next.assign(t.start.begin(), t.start.end() - 1);
  for (std::size_t i = 0; i + 1 < d.start.size(); ++i)
    for (auto k = at(d.start[i]); k < at(d.start[i + 1]); ++k) {
      const std::size_t s = at(next[at(d.column[k])]++);
      t.row[s] = static_cast<std::int32_t>(i);
      t.value[s] = d.value[k];
    }
}

// Adds the displacements of a sample to the slip rows that use it.
void scatter(const Users& users, std::size_t sample, const double* displacement, RowMatrix<double>& out) {
  for (auto k = at(users.start[sample]); k < at(users.start[sample + 1]); ++k)
    axpy(users.value[k], displacement, out.row(users.row[k]), out.columns());
}

double largest(const RowMatrix<double>& block) {
  double value = 0;
  for (std::int64_t i = 0; i < block.rows() * block.columns(); ++i) value = std::max(value, std::abs(block.data()[i]));
  return value;
}

void drop_vanished_coupling(DenseOperators& op) {
  constexpr double rounding = 1e-12;
  const auto vanishes = [&](double coupling, double direct) { return coupling <= rounding * direct; };
  const double along = std::max(largest(op.block[0][0]), largest(op.block[0][1]));
  const double across = std::max(largest(op.block[1][0]), largest(op.block[1][1]));
  if (!vanishes(std::max(largest(op.block[2][0]), largest(op.block[2][1])), largest(op.block[2][2])) ||
      !vanishes(std::max(largest(op.block[0][2]), largest(op.block[1][2])), std::max(along, across)))
    return;
  for (int c = 0; c < 2; ++c) {
    op.block[2][c].release();
    op.block[c][2].release();
  }
  op.coupled = false;
  op.coupling_vanished = true;
}

}  // namespace

/// Holds room for one assembly after the other.
struct AssemblySpace {
  RowMatrix<double> buffer[3][3];
  Users users;
  std::vector<double> x, y;
  std::vector<std::int32_t> needed;
};

namespace {

// Tells which blocks to assemble.
struct Wanted {
  bool block[3][3] = {};
  bool slip() const { return block[0][0]; }
};

/// Assembles the blocks wanted, as sums over samples.
class Assembly {
 public:
  Assembly(const Frame& frame, const Compliance& compliance, const Convection& convection, const Wanted& wanted,
           std::span<const std::int32_t> mirror, DenseOperators& op, AssemblySpace& space)
      : frame_(frame),
        compliance_(compliance),
        convection_(convection),
        wanted_(wanted),
        mirror_(mirror),
        op_(op),
        n_(frame.nodes()),
        space_(space) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        if (!wanted.block[r][c]) continue;
        if (op.block[r][c].empty()) op.block[r][c].resize_untouched(n_, n_);
        if (space.buffer[r][c].columns() != n_) space.buffer[r][c].resize_untouched(chunk, n_);
        if (r < 2) clear(op.block[r][c]);
      }
    if (wanted.slip()) transpose(convection.rows, samples(), users_);
  }

  void run() {
    const std::size_t nodes = at(n_);
    std::vector<std::int32_t>& needed = space_.needed;
    needed.clear();
    for (std::size_t k = 0; k < nodes; ++k)
      if (!mirrored(k)) needed.push_back(static_cast<std::int32_t>(k));
    in_chunks(needed, [&](std::span<const std::int32_t> sample) { take_nodes(sample); });
    if (wanted_.slip()) {
      needed.clear();
      for (std::size_t k = nodes; k < samples(); ++k)
        if (used(k) && !mirrored(k - nodes)) needed.push_back(static_cast<std::int32_t>(k));
      in_chunks(needed, [&](std::span<const std::int32_t> sample) { take_ahead(sample); });
      scale();
    }
    if (!mirror_.empty()) fill_mirrored();
  }

 private:
  /// Clears some rows at a time: the system takes seconds to give gigabytes.
  static void clear(RowMatrix<double>& block) {
    for (std::int64_t first = 0; first < block.rows(); first += chunk) {
      check_interrupt();
      std::fill_n(block.row(first), std::min(chunk, block.rows() - first) * block.columns(), 0.0);
    }
  }
  /// Says whether the rows of this node are those of its mirror image.
  bool mirrored(std::size_t k) const { return !mirror_.empty() && at(mirror_[k]) < k; }
  /// Fills rows of mirror images, where components along t2 change their sign.
  void fill_mirrored() {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        if (!wanted_.block[r][c]) continue;
        const double sign = (r == 1) == (c == 1) ? 1 : -1;
        for (std::int64_t k = 0; k < n_; ++k) {
          if (!mirrored(at(k))) continue;
          const double* from = op_.block[r][c].row(mirror_[at(k)]);
          double* to = op_.block[r][c].row(k);
          for (std::int64_t j = 0; j < n_; ++j) to[j] = sign * from[mirror_[at(j)]];
        }
      }
  }
  std::size_t samples() const { return at(n_) + convection_.ahead.size(); }
  /// Says whether a slip row uses the sample.
  bool used(std::size_t sample) const { return users_.start[sample] < users_.start[sample + 1]; }

  template <class Take>
  static void in_chunks(const std::vector<std::int32_t>& sample, Take take) {
    for (std::size_t first = 0; first < sample.size(); first += chunk)
      take(std::span(sample).subspan(first, std::min(at(chunk), sample.size() - first)));
  }

  void take_nodes(std::span<const std::int32_t> node) {
    place(node, [&](std::size_t k) { return frame_.x[k]; });
    // Normal rows need nothing more and go where they belong at once.
    ComplianceBlock out = blocks(3);
    for (int c = 0; c < 3; ++c)
      if (wanted_.block[2][c]) out.a[2][c] = op_.block[2][c].row(node[0]);
    compliance_.block({x_, y_}, out);
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
        if (wanted_.block[r][c]) out.a[r][c] = space_.buffer[r][c].data();
    return out;
  }

  void add_to_slip(std::span<const std::int32_t> sample) {
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c)
        for (std::size_t p = 0; wanted_.block[r][c] && p < sample.size(); ++p)
          scatter(users_, at(sample[p]), space_.buffer[r][c].row(static_cast<std::int64_t>(p)), op_.block[r][c]);
  }

  void scale() {
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c)
        for (std::int64_t i = 0; wanted_.block[r][c] && i < n_; ++i) {
          const double factor = convection_.factor[at(i)];
          if (factor == 1) continue;
          double* row = op_.block[r][c].row(i);
          for (std::int64_t k = 0; k < n_; ++k) row[k] *= factor;
        }
  }

  const Frame& frame_;
  const Compliance& compliance_;
  const Convection& convection_;
  const Wanted& wanted_;
  std::span<const std::int32_t> mirror_;
  DenseOperators& op_;
  std::int64_t n_;
  AssemblySpace& space_;
  Users& users_ = space_.users;
  std::vector<double>&x_ = space_.x, &y_ = space_.y;
};

}  // namespace

void assemble_operators(const Frame& frame, const Compliance& compliance, const Convection& convection,
                        bool want_tangential, DenseOperators& op, std::span<const std::int32_t> mirror) {
  op.nodes = frame.nodes();
  op.coupled = compliance.couples() && !op.coupling_vanished;
  const bool slip = want_tangential || op.tangential, first = slip && !op.tangential;
  if (op.normal && !first) return;
  Wanted wanted;
  wanted.block[2][2] = !op.normal;
  // A frictionless scene needs no tangential column even with coupling.
  for (int c = 0; c < 2; ++c) wanted.block[2][c] = op.coupled && slip && (!op.normal || op.block[2][c].empty());
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 3; ++c) wanted.block[r][c] = first && (c < 2 || op.coupled);
  op.require_memory_for(wanted.block);
  // Frames that move are assembled again and again; those of many nodes take long anyway.
  constexpr std::int64_t few = 1000;
  if (!op.space) op.space = std::make_shared<AssemblySpace>();
  Assembly(frame, compliance, convection, wanted, mirror, op, *op.space).run();
  if (frame.nodes() > few) op.space.reset();
  op.normal = true;
  op.tangential = slip;
  // A kernel knows whether it couples; under little friction the smallest coupling counts.
  if (first && op.coupled && !compliance.translation()) drop_vanished_coupling(op);
}

}  // namespace rollcon
