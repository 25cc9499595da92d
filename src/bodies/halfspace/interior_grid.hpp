#pragma once
/// Computes stresses and displacements inside a half-space at grids of points below a lattice, slice by slice, by FFT.
///
/// Gauss rules with a node's hat as weight, of as many points as the distance asks for, give the influence of a unit
/// traction at an offset; right below the hat the near field gives it. A slice is the convolution of these influences
/// with the nodes' tractions.

#include <cstdint>
#include <vector>

#include "bodies/halfspace/interior.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Holds points at one depth, on the places of the lattice moved by a part of a cell.
struct InteriorSlice {
  double z = 0;                            ///< depth
  double shift_x = 0, shift_y = 0;         ///< move in cells, [0, 1)
  std::int64_t first_x = 0, first_y = 0;   ///< first place
  std::int64_t nx = 0, ny = 0;             ///< counts of places from the first on
  std::vector<std::int64_t> point, place;  ///< numbers of the caller's points; iy * nx + ix
};

class InteriorGrid {
 public:
  /// Takes what HalfspaceInterior does, with tractions of the frame's nodes. The lattice must outlive it.
  InteriorGrid(const Lattice& lattice, const double* traction, HalfspaceInterior::Material material, double accuracy);

  /// Returns false if some hat under load lacks a cell, or the build has no FFT: nothing can be done here.
  bool usable() const { return usable_; }
  /// Finds the points (x, y, z) that make up slices for which convolutions are faster than points one by one.
  std::vector<InteriorSlice> slices(std::int64_t points, const double* xyz) const;
  /// Fills the slice's points in the caller's arrays, of which either may be null.
  void evaluate(const InteriorSlice& slice, double* stress, double* displacement) const;

 private:
  struct Table;

  std::int64_t extent_x(const InteriorSlice& slice) const { return nx_ + slice.nx - 1; }
  std::int64_t extent_y(const InteriorSlice& slice) const { return ny_ + slice.ny - 1; }
  bool worthwhile(const InteriorSlice& slice) const;
  void influence(const InteriorSlice& slice, Table& table) const;
  void near_influence(const InteriorSlice& slice, Table& table) const;
  bool far_influence(double x, double y, double z, double (&value)[3][9]) const;
  void write(const InteriorSlice& slice, int output, const double* field, double* stress, double* displacement) const;
  void turn(const InteriorSlice& slice, double* stress, double* displacement) const;

  const Lattice& lattice_;
  HalfspaceInterior::Material material_;
  double accuracy_;
  bool usable_ = true;
  std::int64_t first_x_ = 0, first_y_ = 0, nx_ = 0, ny_ = 0;  ///< places under load
  std::vector<double> traction_[3];  ///< tractions there, in the lattice's axes: [iy * nx_ + ix]
  struct HatRule {
    double least_axis2;
    int n;
    std::vector<double> x, y, w, zero;
  };
  std::vector<HatRule> rules_;
};

}  // namespace rollcon
