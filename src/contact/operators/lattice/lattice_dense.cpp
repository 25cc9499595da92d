#include "contact/operators/lattice/lattice_dense.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/operators/lattice/hat_pieces.hpp"
#include "contact/operators/lattice/lattice_entries.hpp"

namespace rollcon {
namespace {

/// Holds entries of the sources with one shape of hat for all offsets that occur.
class Part {
 public:
  Part(const Lattice& lattice, const TranslationKernel& kernel, double delta, const HatPiece& sources) {
    std::int64_t low_x = lattice.nx, high_x = 0;
    for (const std::int32_t place : sources.places) {
      low_x = std::min(low_x, place % lattice.nx);
      high_x = std::max(high_x, place % lattice.nx);
    }
    const std::int64_t low_y = sources.places.front() / lattice.nx, high_y = sources.places.back() / lattice.nx;
    const std::int64_t first_i = -high_x, first_j = -high_y;
    const std::int64_t height = lattice.ny - low_y + high_y;
    width_ = lattice.nx - low_x + high_x;
    middle_ = -first_j * width_ - first_i;
    for (const std::int32_t place : sources.places)
      source_.push_back(
          {lattice.node[static_cast<std::size_t>(place)], place / lattice.nx * width_ + place % lattice.nx});
    const LatticeEntries entries(lattice, kernel, delta, sources.x, sources.y);
    kinds_ = entries.kinds();
    value_.assign(kinds_.kind.size(), std::vector<double>(static_cast<std::size_t>(width_ * height)));
    LatticeEntries::Workspace w;
    for (std::int64_t line = 0; line < height; ++line) {
      double* entry[3][3] = {};
      for (std::size_t k = 0; k < value_.size(); ++k)
        entry[kinds_.kind[k].r][kinds_.kind[k].c] = value_[k].data() + line * width_;
      entries.row(first_j + line, first_i, width_, entry, w);
    }
  }

  /// Adds the entries (r, c) of these sources to the row of node (tx, ty); row in the frame's numbering.
  void add(std::int64_t tx, std::int64_t ty, int r, int c, double* row) const {
    const EntryKinds::Use& use = kinds_.use[r][c];
    if (use.kind < 0) return;
    const double* value = value_[static_cast<std::size_t>(use.kind)].data() + middle_ + ty * width_ + tx;
    for (const Source& s : source_) row[s.node] += use.sign * value[-s.offset];
  }

 private:
  struct Source {
    std::int32_t node;
    std::int64_t offset;
  };
  std::vector<Source> source_;
  std::int64_t width_ = 0, middle_ = 0;  ///< width of a line of entries, and the place of offset 0
  EntryKinds kinds_;
  std::vector<std::vector<double>> value_;  ///< entries of each kind: [j][i]
};

}  // namespace

void fill_lattice_operators(const Lattice& lattice, const TranslationKernel& kernel, const Convection& convection,
                            bool want_tangential, DenseOperators& op) {
  const std::int64_t n = lattice.frame_nodes();
  op.nodes = n;
  op.coupled = kernel.couples();
  bool wanted[3][3];
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k)
      wanted[r][k] = r == 2 ? k == 2 || (want_tangential && op.coupled) : want_tangential && (k < 2 || op.coupled);
  op.require_memory_for(wanted);
  const double delta = convection.ahead.empty() ? 0 : convection.ahead[0];
  std::vector<Part> parts;
  for (const HatPiece& piece : hat_pieces(lattice)) parts.emplace_back(lattice, kernel, delta, piece);
  std::vector<std::int64_t> place(static_cast<std::size_t>(n), -1);
  for (std::size_t at = 0; at < lattice.node.size(); ++at)
    if (lattice.node[at] >= 0) place[static_cast<std::size_t>(lattice.node[at])] = static_cast<std::int64_t>(at);
  const auto write = [&](std::int64_t node, int r, int k, double* row) {
    std::fill_n(row, n, 0.0);
    const std::int64_t at = place[static_cast<std::size_t>(node)];
    if (at < 0) return;
    for (const Part& part : parts) part.add(at % lattice.nx, at / lattice.nx, r, k, row);
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
        for (auto m = static_cast<std::size_t>(convection.rows.start[node]);
             m < static_cast<std::size_t>(convection.rows.start[node + 1]); ++m) {
          write(convection.rows.column[m], r, k, displacement.data());
          axpy(convection.rows.value[m], displacement.data(), row, n);
        }
      }
    }
  op.normal = true;
  if (want_tangential) op.tangential = true;
}

}  // namespace rollcon
