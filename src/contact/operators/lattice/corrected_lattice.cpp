#include "contact/operators/lattice/corrected_lattice.hpp"

#include "linalg/row_basis.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Returns the transpose of the operators' rows, over their own entries: component r of node i in column r * nodes + i.
RowMatrix<double> rows_over_own(const NearHalfspaces& near, const Convection& convection, const Operators& own) {
  const std::int64_t n = own.nodes;
  std::int64_t unknowns = 0;
  for (const auto& part : near.part) unknowns += part.left.columns();
  RowMatrix<double> rows;
  rows.resize(unknowns, 3 * n);
  std::int64_t first = 0;
  for (const auto& part : near.part) {
    for (std::int64_t i = 0; i < n; ++i) {
      const auto add = [&](std::int64_t r, std::int64_t sample, double factor) {
        const double* from = part.left.row(3 * sample + r);
        for (std::int64_t k = 0; k < part.left.columns(); ++k) rows.row(first + k)[r * n + i] += factor * from[k];
      };
      add(2, i, 1 / own.own(2, 2, at(i)));
      const SparseRows& d = convection.rows;
      for (std::int64_t r = 0; r < 2; ++r)
        for (auto m = d.start[at(i)]; m < d.start[at(i + 1)]; ++m)
          add(r, d.column[at(m)],
              convection.factor[at(i)] * d.value[at(m)] / own.own(static_cast<int>(r), static_cast<int>(r), at(i)));
    }
    first += part.left.columns();
  }
  return rows;
}

}  // namespace

CorrectedLattice::CorrectedLattice(std::shared_ptr<const LatticeOperator> half_spaces, const NearHalfspaces& near,
                                   const Convection& convection, double rest)
    : half_spaces_(std::move(half_spaces)) {
  nodes = half_spaces_->nodes;
  coupled = normal = true;
  tangential = half_spaces_->tangential;
  const RowBasis basis = row_basis(rows_over_own(near, convection, *half_spaces_), rest);
  const std::int64_t rank = basis.row.rows();
  for (int c = 0; c < 3; ++c) {
    left_[c].resize(nodes, rank), right_[c].resize(nodes, rank);
    for (std::int64_t i = 0; i < nodes; ++i)
      for (std::int64_t k = 0; k < rank; ++k)
        left_[c].row(i)[k] = basis.row.row(k)[c * nodes + i] * half_spaces_->own(c, c, at(i));
    std::int64_t first = 0;
    for (const auto& part : near.part) {
      for (std::int64_t s = 0; s < part.right.rows(); ++s)
        for (std::int64_t i = 0; i < nodes; ++i)
          axpy(part.right.row(s)[i], basis.weight.row(first + 3 * s + c), right_[c].row(i), rank);
      first += part.left.columns();
    }
  }
}

void CorrectedLattice::images(Components wanted, Components columns, std::span<const std::int32_t> at,
                              const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const {
  half_spaces_->images(wanted, columns, at, lambda, image);
  std::vector<double> amount(static_cast<std::size_t>(rank()), 0.0);
  for (int c = columns.first; c <= columns.last; ++c)
    for (std::int64_t k = 0; k < nodes; ++k)
      if (const double own = lambda[c][static_cast<std::size_t>(k)]; own != 0)
        axpy(own, right_[c].row(k), amount.data(), rank());
  const auto add = [&](std::int64_t k) {
    for (int r = wanted.first; r <= wanted.last; ++r)
      image[r][static_cast<std::size_t>(k)] += dot(left_[r].row(k), amount.data(), rank());
  };
  for (const std::int32_t k : at) add(k);
  for (std::int64_t k = 0; at.empty() && k < nodes; ++k) add(k);
}

double CorrectedLattice::own(int r, int c, std::size_t k) const {
  const auto i = static_cast<std::int64_t>(k);
  return half_spaces_->own(r, c, k) + dot(left_[r].row(i), right_[c].row(i), rank());
}

std::size_t CorrectedLattice::bytes() const {
  return half_spaces_->bytes() + 6 * static_cast<std::size_t>(nodes * rank()) * sizeof(double);
}

}  // namespace rollcon
