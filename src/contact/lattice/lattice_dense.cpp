#include "contact/lattice/lattice_dense.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/lattice/lattice_entries.hpp"

namespace rollcon {
namespace {

/// Sources [first, last] along one axis whose hats are alike.
struct Sources {
  Hat hat;
  std::int64_t first, last;
};

/// Entries of the sources of one kind for all offsets that occur.
class Part {
 public:
  Part(const Lattice& lattice, HalfspaceConstants c, double delta, Sources x, Sources y)
      : lattice_(lattice),
        x_(x),
        y_(y),
        first_i_(-x.last),
        first_j_(-y.last),
        width_(lattice.nx - x.first + x.last) {
    const LatticeEntries entries(lattice, c, delta, x.hat, y.hat);
    kinds_ = entries.kinds();
    const std::int64_t height = lattice.ny - y.first + y.last;
    value_.assign(kinds_.kind.size(),
                  std::vector<double>(static_cast<std::size_t>(width_ * height)));
    LatticeEntries::Workspace w;
    for (std::int64_t line = 0; line < height; ++line) {
      double* entry[3][3] = {};
      for (std::size_t k = 0; k < value_.size(); ++k)
        entry[kinds_.kind[k].r][kinds_.kind[k].c] = value_[k].data() + line * width_;
      entries.row(first_j_ + line, first_i_, width_, entry, w);
    }
  }

  /// Entries (r, c) of these sources in the row of node (tx, ty); row in the frame's numbering.
  void write(std::int64_t tx, std::int64_t ty, int r, int c, double* row) const {
    const EntryKinds::Use& use = kinds_.use[r][c];
    for (std::int64_t sy = y_.first; sy <= y_.last; ++sy) {
      const std::int32_t* node = lattice_.node.data() + sy * lattice_.nx;
      if (use.kind < 0) {
        for (std::int64_t sx = x_.first; sx <= x_.last; ++sx) row[node[sx]] = 0;
        continue;
      }
      const double* value = value_[static_cast<std::size_t>(use.kind)].data() +
                            (ty - sy - first_j_) * width_ + tx - first_i_;
      for (std::int64_t sx = x_.first; sx <= x_.last; ++sx) row[node[sx]] = use.sign * value[-sx];
    }
  }

 private:
  const Lattice& lattice_;
  Sources x_, y_;
  std::int64_t first_i_, first_j_, width_;
  EntryKinds kinds_;
  std::vector<std::vector<double>> value_;  ///< of each kind: [j][i]
};

std::vector<Sources> along(std::int64_t n) {
  std::vector<Sources> parts{{Hat::after, 0, 0}, {Hat::before, n - 1, n - 1}};
  if (n > 2) parts.push_back({Hat::whole, 1, n - 2});
  return parts;
}

}  // namespace

void fill_lattice_operators(const Lattice& lattice, HalfspaceConstants c, bool want_tangential,
                            ContactOperators& op) {
  const std::int64_t n = lattice.nodes();
  op.nodes = n;
  op.coupled = c.ck != 0;
  bool wanted[3][3];
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k)
      wanted[r][k] = r == 2 ? k == 2 || (want_tangential && op.coupled)
                            : want_tangential && (k < 2 || op.coupled);
  require_operator_memory(op, wanted, n);
  const double delta = op.upstream.empty() ? 0 : op.upstream[0];
  std::vector<Part> parts;
  for (const Sources& x : along(lattice.nx))
    for (const Sources& y : along(lattice.ny)) parts.emplace_back(lattice, c, delta, x, y);
  std::vector<std::int64_t> place(static_cast<std::size_t>(n));
  for (std::size_t at = 0; at < place.size(); ++at)
    place[static_cast<std::size_t>(lattice.node[at])] = static_cast<std::int64_t>(at);
  const auto write = [&](std::int64_t node, int r, int k, double* row) {
    const std::int64_t at = place[static_cast<std::size_t>(node)];
    for (const Part& part : parts) part.write(at % lattice.nx, at / lattice.nx, r, k, row);
  };

  std::vector<double> displacement(static_cast<std::size_t>(n));
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k) {
      if (!wanted[r][k]) continue;
      op.block[r][k].resize(n, n);
      for (std::int64_t i = 0; i < n; ++i) {
        double* row = op.block[r][k].row(i);
        if (r == 2 || delta != 0) {
          write(i, r, k, row);
          continue;
        }
        std::fill_n(row, n, 0.0);
        const auto node = static_cast<std::size_t>(i);
        for (auto m = static_cast<std::size_t>(op.convection.start[node]);
             m < static_cast<std::size_t>(op.convection.start[node + 1]); ++m) {
          write(op.convection.column[m], r, k, displacement.data());
          axpy(op.convection.value[m], displacement.data(), row, n);
        }
      }
    }
  op.there.assign(static_cast<std::size_t>(n), 1);
  op.rows = n;
  op.normal = true;
  if (want_tangential) op.tangential = true;
}

}  // namespace rollcon
