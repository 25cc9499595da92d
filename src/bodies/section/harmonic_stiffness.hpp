#pragma once
/// Gives the stiffness K0 + n K1 + n^2 K2 of a section for displacements that vary as harmonics along the way: u1 = U
/// cos n phi, u2 = Y cos n phi and, along the way, T sin n phi; or with cos and sin exchanged and T negative
/// (docs/sections.md).

#include <array>
#include <cstdint>
#include <vector>

#include "bodies/model/body_mesh.hpp"
#include "linalg/sparse_matrix.hpp"

namespace rollcon::section {

/// Assembles the stiffness. The integral over the way has a factor 2 pi (n = 0) or pi (all other n), which is left to
/// the forces.
class HarmonicStiffness {
 public:
  /// Takes elastic constants by element, with Young's moduli divided by a reference. The mesh must outlive it.
  HarmonicStiffness(const BodyMesh& mesh, std::vector<Elastic> material, double reference);

  /// Returns the lower triangle, scaled by a power of n so that its size does not change with n. n may be fractional.
  SparseMatrix matrix(double n) const;
  std::int64_t unknowns() const { return count_; }
  /// Returns the unknown of component c (e1, along, e2) of a node; -1: held.
  std::int64_t unknown(std::int32_t node, std::size_t c) const { return of_[3 * static_cast<std::size_t>(node) + c]; }
  const std::vector<std::int64_t>& numbers() const { return of_; }
  const Elastic& material(std::int64_t element) const { return material_[static_cast<std::size_t>(element)]; }

  /// Returns forces per radian, divided by the reference, of loads that are the same all along the way, at
  /// [3 * node + c]. The loaded mesh differs from that of the stiffness in loads alone.
  std::vector<double> loads(const BodyMesh& loaded) const;
  /// Returns the given displacements of held components, and zero elsewhere, at [3 * node + c].
  std::vector<double> given(const BodyMesh& loaded) const;
  /// Returns forces per radian under displacements of n = 0, at [3 * node + c].
  std::vector<double> forces(const std::vector<double>& u) const;

 private:
  struct Element {
    std::vector<double> k[3];  ///< K0, K1, K2 of an element, row by row
  };
  Element element(std::int64_t e) const;
  void add_springs(std::int64_t e, std::vector<double>& k) const;
  void number();
  void require_held() const;

  const BodyMesh& mesh_;
  std::vector<Elastic> material_;
  std::array<std::pair<std::size_t, double>, 3> axis_{};  ///< see body_axes_of
  double reference_;
  std::vector<std::int64_t> of_;
  std::int64_t count_ = 0;
  SparseMatrix pattern_;  ///< with the values of K0
  std::vector<double> first_, second_;
};

/// Returns the number and the sign of the body's axis that each of e1, along, e2 lies on. Throws err_state if a section
/// whose axes are not those of the body has supports or loads with bits other than all three.
std::array<std::pair<std::size_t, double>, 3> body_axes_of(const SweptSection& section);

}  // namespace rollcon::section
