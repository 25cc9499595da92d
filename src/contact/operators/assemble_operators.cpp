/// Rows of the discrete operators from the compliance and the convective scheme.

#include <algorithm>
#include <cmath>

#include "bodies/halfspace/halfspace.hpp"
#include "contact/operators/operators.hpp"
#include "support/memory_limit.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t chunk = 64;  // rows of compliance held at a time

// Transpose of the sparse convective rows: which slip rows use node J, with what factor.
struct Users {
  std::vector<std::int64_t> start;
  std::vector<std::int32_t> row;
  std::vector<double> value;
};

Users transpose(const SparseRows& d, std::int64_t n) {
  Users t;
  t.start.assign(static_cast<std::size_t>(n) + 1, 0);
  for (const std::int32_t j : d.column) ++t.start[static_cast<std::size_t>(j) + 1];
  for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j) t.start[j + 1] += t.start[j];
  t.row.resize(d.column.size());
  t.value.resize(d.column.size());
  std::vector<std::int64_t> next(t.start.begin(), t.start.end() - 1);
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t k = d.start[static_cast<std::size_t>(i)];
         k < d.start[static_cast<std::size_t>(i) + 1]; ++k) {
      const auto s = static_cast<std::size_t>(
          next[static_cast<std::size_t>(d.column[static_cast<std::size_t>(k)])]++);
      t.row[s] = static_cast<std::int32_t>(i);
      t.value[s] = d.value[static_cast<std::size_t>(k)];
    }
  return t;
}

// Adds the rows of displacements of node j to the slip rows that use them.
void scatter(const Users& users, std::int32_t node, const double* displacement,
             std::span<const std::uint8_t> wanted, RowMatrix<double>& out) {
  const auto j = static_cast<std::size_t>(node);
  for (auto k = static_cast<std::size_t>(users.start[j]);
       k < static_cast<std::size_t>(users.start[j + 1]); ++k)
    if (wanted[static_cast<std::size_t>(users.row[k])])
      axpy(users.value[k], displacement, out.row(users.row[k]), out.columns());
}

double largest(const ContactOperators& op, const RowMatrix<double>& block) {
  double value = 0;
  for (std::int64_t i = 0; i < block.rows(); ++i)
    for (std::int64_t k = 0; op.has_row(static_cast<std::size_t>(i)) && k < block.columns(); ++k)
      value = std::max(value, std::abs(block.row(i)[k]));
  return value;
}

void drop_vanished_coupling(ContactOperators& op) {
  constexpr double rounding = 1e-12;
  const auto vanishes = [&](double coupling, double direct) {
    return coupling <= rounding * direct;
  };
  const double along = std::max(largest(op, op.block[0][0]), largest(op, op.block[0][1]));
  const double across = std::max(largest(op, op.block[1][0]), largest(op, op.block[1][1]));
  if (!vanishes(std::max(largest(op, op.block[2][0]), largest(op, op.block[2][1])),
                largest(op, op.block[2][2])) ||
      !vanishes(std::max(largest(op, op.block[0][2]), largest(op, op.block[1][2])),
                std::max(along, across)))
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

// Rows of the nodes in `rows`, of the blocks wanted.
void assemble_rows(const Frame& frame, const Compliance& compliance, const Wanted& wanted,
                   std::span<const std::uint8_t> rows, ContactOperators& op) {
  const std::int64_t n = frame.nodes();
  const bool stencils = wanted.slip() && op.upstream.empty();
  RowMatrix<double> buffer[3][3];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      if (!wanted.block[r][c]) continue;
      if (op.block[r][c].empty()) op.block[r][c].resize_untouched(n, n);
      buffer[r][c].resize(chunk, n);
      for (std::int64_t i = 0; stencils && r < 2 && i < n; ++i)
        if (rows[static_cast<std::size_t>(i)]) std::fill_n(op.block[r][c].row(i), n, 0.0);
    }
  // Upwind schemes also need displacements of the neighbours.
  std::vector<std::uint8_t> needed(rows.begin(), rows.end());
  Users users;
  if (stencils) {
    users = transpose(op.convection, n);
    for (std::size_t j = 0; j < needed.size(); ++j)
      for (auto k = static_cast<std::size_t>(users.start[j]);
           k < static_cast<std::size_t>(users.start[j + 1]); ++k)
        needed[j] = needed[j] || rows[static_cast<std::size_t>(users.row[k])];
  }
  std::vector<std::int32_t> node;
  for (std::size_t k = 0; k < needed.size(); ++k)
    if (needed[k]) node.push_back(static_cast<std::int32_t>(k));

  std::vector<double> px, py;
  for (std::size_t first = 0; first < node.size(); first += chunk) {
    const std::size_t size = std::min(static_cast<std::size_t>(chunk), node.size() - first);
    const std::span<const std::int32_t> at(node.data() + first, size);
    px.resize(size);
    py.resize(size);
    for (std::size_t p = 0; p < size; ++p) {
      px[p] = frame.x[static_cast<std::size_t>(at[p])];
      py[p] = frame.y[static_cast<std::size_t>(at[p])];
    }
    // Rows that need nothing more go where they belong at once.
    const bool in_place = at.back() - at.front() + 1 == static_cast<std::int32_t>(size) &&
                          std::all_of(at.begin(), at.end(), [&](std::int32_t k) {
                            return rows[static_cast<std::size_t>(k)] != 0;
                          });
    ComplianceBlock out;
    out.stride = n;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        if (wanted.block[r][c])
          out.a[r][c] = r == 2 && in_place ? op.block[2][c].row(at[0]) : buffer[r][c].data();
    compliance.block({px, py}, out);
    for (int c = 0; c < 3; ++c)
      for (std::size_t p = 0; wanted.block[2][c] && !in_place && p < size; ++p)
        if (rows[static_cast<std::size_t>(at[p])])
          std::copy_n(buffer[2][c].row(static_cast<std::int64_t>(p)), n, op.block[2][c].row(at[p]));
    if (!wanted.slip()) continue;
    if (stencils) {
      for (int r = 0; r < 2; ++r)
        for (int c = 0; c < 3; ++c)
          for (std::size_t p = 0; wanted.block[r][c] && p < size; ++p)
            scatter(users, at[p], buffer[r][c].row(static_cast<std::int64_t>(p)), rows,
                    op.block[r][c]);
      continue;
    }
    // Characteristic scheme: (w(x_I) - w(x_I + delta e)) / delta, both displacements exact.
    for (std::size_t p = 0; p < size; ++p) px[p] += op.upstream[static_cast<std::size_t>(at[p])];
    ComplianceBlock ahead;
    ahead.stride = n;
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c)
        if (wanted.block[r][c]) {
          for (std::size_t p = 0; p < size; ++p)
            std::copy_n(buffer[r][c].row(static_cast<std::int64_t>(p)), n,
                        op.block[r][c].row(at[p]));
          ahead.a[r][c] = buffer[r][c].data();
        }
    compliance.block({px, py}, ahead);
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c) {
        if (!wanted.block[r][c]) continue;
        for (std::size_t p = 0; p < size; ++p) {
          const double delta = op.path(static_cast<std::size_t>(at[p]));
          const double factor = delta > 0 ? 1 / delta : 0;
          double* s = op.block[r][c].row(at[p]);
          const double* w = buffer[r][c].row(static_cast<std::int64_t>(p));
          for (std::int64_t k = 0; k < n; ++k) s[k] = factor * (s[k] - w[k]);
        }
      }
  }
}

}  // namespace

void assemble_operators(const Frame& frame, const Compliance& compliance, bool want_tangential,
                        ContactOperators& op, std::span<const std::uint8_t> wanted) {
  const std::int64_t n = frame.nodes();
  op.nodes = n;
  op.coupled = compliance.couples() && !op.coupling_vanished;
  if (!op.normal) op.rows = 0;
  if (!op.normal || op.there.empty())
    op.there.assign(static_cast<std::size_t>(n), op.normal ? 1 : 0);
  // Of nodes that have rows: blocks that were not needed before. With coupling, a frictionless
  // scene still needs no tangential column.
  const bool slip = want_tangential || op.tangential;
  Wanted of_old, of_new;
  of_old.block[2][0] = of_old.block[2][1] =
      op.normal && op.coupled && want_tangential && op.block[2][0].empty();
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
  require_operator_memory(op, need, op.rows + count);
  const bool first = !op.tangential && slip;
  if (of_old.any()) assemble_rows(frame, compliance, of_old, op.there, op);
  if (count > 0) assemble_rows(frame, compliance, of_new, missing, op);
  for (std::size_t k = 0; k < missing.size(); ++k)
    if (missing[k]) op.there[k] = 1;
  op.rows += count;
  op.normal = true;
  if (slip) op.tangential = true;
  // The coupling of half-spaces is known by its constant; under little friction the smallest
  // counts.
  HalfspaceConstants constants;
  if (first && op.coupled && !compliance.halfspace(constants)) drop_vanished_coupling(op);
}

}  // namespace rollcon
