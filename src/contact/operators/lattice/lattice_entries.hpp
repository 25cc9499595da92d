#pragma once
/// Entries of a contact's operators on a lattice: between two nodes they depend on the offset alone.

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/model/translation.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// The entries that differ: what is stored, and where the nine of a pair of nodes come from.
struct EntryKinds {
  struct Kind {
    int r, c;
  };
  struct Use {
    int kind = -1;  ///< none: the entry is zero
    double sign = 1;
  };
  std::vector<Kind> kind;
  Use use[3][3];
};

class LatticeEntries {
 public:
  /// delta: distance to the upstream point of the characteristic scheme; then rows 0 and 1 are its slip (w(x) - w(x +
  /// delta t1)) / delta. Zero: they are the tangential displacements w. x, y: hats of the sources, along the lattice's
  /// axes. Offsets reach across the lattice and this margin.
  LatticeEntries(const Lattice& lattice, const TranslationKernel& kernel, double delta, Hat x = Hat::whole,
                 Hat y = Hat::whole, std::int64_t margin = 0);

  struct Workspace {
    std::vector<double> memory;
  };
  /// entry[r][c][m], m < count, null: not wanted: of a source at the origin on the node
  /// (first + m, j) away, as ComplianceBlock and Operators have them.
  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&entry)[3][3], Workspace& w) const;

  /// False where the entry is zero at every offset.
  bool present(int r, int c) const {
    if (r == c) return true;
    return r == 2 || c == 2 ? couples_ : shears_;
  }
  /// 1 or -1: the entry's sign under j -> -j. 0: not mirrored, the lattice is turned.
  int mirror(int r, int c) const { return cut_y_ || s_ != 0 ? 0 : (r == 1) == (c == 1) ? 1 : -1; }
  EntryKinds kinds() const;

 private:
  bool couples_, shears_;
  double e_, s_;  ///< direction of the lattice's first axis
  double delta_;
  bool cut_y_;
  std::unique_ptr<LatticeRows> here_, ahead_;  ///< ahead: of the characteristic scheme alone
};

}  // namespace rollcon
