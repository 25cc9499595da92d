#include "contact/prepare/carried_rows.hpp"

#include <algorithm>

#include "bodies/model/translation.hpp"
#include "contact/operators/lattice/lattice_dense.hpp"
#include "contact/operators/lattice/lattice_operator.hpp"
#include "contact/solution.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {

double upstream(const Prepared& on, std::size_t k) {
  return on.frame.curved() ? on.distance * dot(on.frame.t1[k], on.frame.axes.t1) : on.distance;
}

void CarriedRows::make_dense(const Prepared& on) {
  constexpr std::size_t chunk = 64;
  const std::size_t n = on.frame.x.size();
  dense_ = std::make_shared<DenseOperators>();
  DenseOperators& op = *dense_;
  op.nodes = on.frame.nodes();
  const int columns = on.problem.op->coupled ? 3 : 2;
  bool wanted[3][3] = {};
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < columns; ++c) wanted[r][c] = true;
  op.require_memory_for(wanted);
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < columns; ++c) op.block[r][c].resize(op.nodes, op.nodes);
  std::vector<double> x, y;
  for (std::size_t first = 0; first < n; first += chunk) {
    check_interrupt();
    x.clear(), y.clear();
    for (std::size_t k = first; k < std::min(n, first + chunk); ++k) {
      x.push_back(on.frame.x[k] + upstream(on, k));
      y.push_back(on.frame.y[k]);
    }
    ComplianceBlock out;
    out.stride = static_cast<std::ptrdiff_t>(n);
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < columns; ++c) out.a[r][c] = op.block[r][c].row(static_cast<std::int64_t>(first));
    on.compliance->block({x, y}, out);
  }
  op.coupled = columns == 3;
  op.tangential = true;
  rows_ = dense_;
}

// Makes the rows by what the operators are made of, so that errors of integrals are equal in both and cancel.
void CarriedRows::make(const Prepared& on) {
  ++made_;
  rows_.reset();
  dense_.reset();
  differences_ = false;
  if (on.distance == 0) {
    rows_ = on.problem.op;
  } else if (on.problem.op->on_lattice()) {
    differences_ = true;
    rows_ = std::make_shared<LatticeOperator>(*on.lattice, on.compliance->translation(), on.distance,
                                              on.problem.convection.rows);
  } else if (on.table) {
    dense_ = std::make_shared<DenseOperators>();
    Convection ahead = on.problem.convection;
    ahead.ahead.assign(on.frame.x.size(), on.distance);
    fill_lattice_operators(*on.lattice, *on.compliance->translation(), ahead, true, *dense_);
    for (auto& block : dense_->block[2]) block.release();
    // Blocks turn from what displacements lose upstream, over the distance, into those upstream.
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c) {
        auto& block = dense_->block[r][c];
        if (block.empty()) continue;
        const double* here = on.problem.op->row(r, c, 0);
        for (std::int64_t i = 0; i < block.rows() * block.columns(); ++i)
          block.data()[i] = here[i] - on.distance * block.data()[i];
      }
    rows_ = dense_;
  } else {
    make_dense(on);
  }
  node_.clear();
  for (std::size_t k = 0; k < on.problem.used.size(); ++k)
    if (on.problem.used[k]) node_.push_back(static_cast<std::int32_t>(k));
  for (auto& v : lost_) v.resize(on.frame.x.size());
}

void CarriedRows::apply(const Prepared& on, std::int64_t version, const std::vector<double> (&lambda)[3],
                        std::vector<double> (&carried)[3]) {
  if (!rows_ || version != version_ || distance_ != on.distance) {
    rows_.reset();
    make(on);
    version_ = version;
    distance_ = on.distance;
  }
  rows_->images(slip_components, {}, node_, lambda, carried);
  if (!differences_) return;
  for (std::size_t c = 0; c < 2; ++c) lost_[c].swap(carried[c]);
  on.problem.op->images(slip_components, {}, node_, lambda, carried);
  for (std::size_t c = 0; c < 2; ++c)
    for (const std::int32_t k : node_) carried[c][at(k)] -= distance_ * lost_[c][at(k)];
}

std::size_t CarriedRows::bytes() const {
  return rows_ && distance_ != 0 ? rows_->bytes() : 0;
}

}  // namespace rollcon
