#pragma once
/// Columns of nodes on a lattice's rim, whose hats are cut off: one side at a time by FFT along it,
/// corners as they are. Made when the first rim node carries traction.

#include <complex>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "contact/lattice/lattice_entries.hpp"
#include "linalg/fft.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

enum class RimSide { low_x, high_x, low_y, high_y };

struct RimWorkspace {
  AlignedArray<double> line;
  AlignedArray<std::complex<double>> source[3], sum;
  std::size_t bytes() const;
};

/// Convolution with the nodes of one side, its corners excluded. Immutable.
class SideColumns {
 public:
  SideColumns(const Lattice& lattice, HalfspaceConstants c, double delta, RimSide side);
  /// Adds to the wanted images at all nodes, in the frame's numbering.
  void add(const double* const (&lambda)[3], double* const (&image)[3], RimWorkspace& w) const;
  std::size_t bytes() const;

 private:
  using Complex = std::complex<double>;
  /// Node q along the side of the line p nodes away from it.
  std::int32_t node(std::int64_t p, std::int64_t q) const;

  const Lattice& lattice_;
  RimSide side_;
  std::int64_t length_, depth_;  ///< nodes along the side, lines of nodes beside it
  std::int64_t padded_, columns_, stride_;
  RealFft<double> fft_;
  EntryKinds kinds_;
  std::vector<AlignedArray<Complex>> spectrum_;  ///< [p][k], times 1 / padded
};

/// The columns of one corner node.
class CornerColumns {
 public:
  CornerColumns(const Lattice& lattice, HalfspaceConstants c, double delta, bool high_x,
                bool high_y);
  void add(const double* const (&lambda)[3], double* const (&image)[3]) const;
  std::size_t bytes() const;

 private:
  const Lattice& lattice_;
  std::int32_t node_;
  EntryKinds kinds_;
  std::vector<std::vector<double>> value_;  ///< of each kind: [iy][ix]
};

/// The rim's columns, each part made at its first use. May be shared by threads.
class Rim {
 public:
  Rim(const Lattice& lattice, HalfspaceConstants c, double delta);
  /// Adds what the tractions of rim nodes cause.
  void add(const double* const (&lambda)[3], double* const (&image)[3], RimWorkspace& w);
  std::size_t bytes();

 private:
  const Lattice& lattice_;
  HalfspaceConstants c_;
  double delta_;
  std::vector<std::int32_t> nodes_[4];  ///< of each side, corners excluded
  std::int32_t corner_[4];
  std::mutex making_;
  std::unique_ptr<const SideColumns> side_[4];
  std::unique_ptr<const CornerColumns> corner_columns_[4];
};

}  // namespace rollcon
