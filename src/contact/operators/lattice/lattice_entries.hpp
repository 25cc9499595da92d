#pragma once
/// Provides entries of a contact's operators on a lattice: between two nodes they depend on the offset alone.

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/model/translation.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Tells which entries differ and are stored, and where the nine of a pair of nodes come from.
struct EntryKinds {
  struct Kind {
    int r, c;
  };
  struct Use {
    int kind = -1;  ///< -1: the entry is zero
    double sign = 1;
  };
  std::vector<Kind> kind;
  Use use[3][3];
};

class LatticeEntries {
 public:
  /// Makes entries of sources with hats x, y along the lattice's axes. delta: distance to the upstream point of the
  /// characteristic scheme, where rows 0 and 1 are its slip (w(x) - w(x + delta t1)) / delta; zero: they are the
  /// tangential displacements w. Offsets reach across the lattice and this margin.
  LatticeEntries(const Lattice& lattice, const TranslationKernel& kernel, double delta, Hat x = Hat::whole,
                 Hat y = Hat::whole, std::int64_t margin = 0);

  struct Workspace {
    std::vector<double> memory;
  };
  /// Fills entry[r][c][m], m < count (null: not wanted), for a source at the origin on the node (first + m, j) away, as
  /// ComplianceBlock and Operators have them.
  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&entry)[3][3], Workspace& w) const;

  /// Returns false where the entry is zero at every offset.
  bool present(int r, int c) const {
    if (r == c) return true;
    return r == 2 || c == 2 ? couples_ : shears_;
  }
  /// Returns the entry's sign under j -> -j, 1 or -1. 0: not mirrored, the lattice is turned.
  int mirror(int r, int c) const { return cut_y_ || s_ != 0 ? 0 : (r == 1) == (c == 1) ? 1 : -1; }
  EntryKinds kinds() const;

 private:
  bool couples_, shears_;
  double e_, s_;  ///< direction of the lattice's first axis
  double delta_;
  bool cut_y_;
  std::unique_ptr<LatticeRows> here_, ahead_;  ///< ahead: in the characteristic scheme alone
};

}  // namespace rollcon
