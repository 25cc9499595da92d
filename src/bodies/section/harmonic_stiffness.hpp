#pragma once
/// Gives the stiffness of a section for displacements that vary as harmonics of the way: u1 = U cos n phi,
/// u2 = Y cos n phi and along it T sin n phi, or with cos and sin exchanged and T negative. It is K0 + n K1 + n^2 K2
/// (docs/sections.md).

#include <array>
#include <cstdint>
#include <vector>

#include "bodies/model/body_mesh.hpp"
#include "linalg/sparse_matrix.hpp"

namespace rollcon::section {

/// Integrals over the way leave a factor 2 pi (n = 0) or pi (all others) to forces.
class HarmonicStiffness {
 public:
  /// Takes elastic constants by element, Young's moduli over a reference. Both must outlive it.
  HarmonicStiffness(const BodyMesh& mesh, std::vector<Elastic> material, double reference);

  /// Returns the lower triangle; n may be any number, as wave numbers are. Scaled by a power of n that keeps its size.
  SparseMatrix matrix(double n) const;
  std::int64_t unknowns() const { return count_; }
  /// Returns the unknown of component c (e1, along, e2) of a node; -1: held.
  std::int64_t unknown(std::int32_t node, std::size_t c) const { return of_[3 * static_cast<std::size_t>(node) + c]; }
  const std::vector<std::int64_t>& numbers() const { return of_; }
  const Elastic& material(std::int64_t element) const { return material_[static_cast<std::size_t>(element)]; }

  /// Returns forces per radian, over the reference, of loads that are the same all along the way, by unknown, and of
  /// displacements that are given: [3 * node + c]. All of a mesh that differs in loads alone.
  std::vector<double> loads(const BodyMesh& loaded) const;
  /// Returns what is given at held components, zero elsewhere: [3 * node + c].
  std::vector<double> given(const BodyMesh& loaded) const;
  /// Returns forces per radian under displacements of n = 0: [3 * node + c].
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

/// Returns the part of a body's axis that each of e1, along, e2 is: its number and sign. err_state: bits other than all
/// three hold or load a section whose axes are not the body's.
std::array<std::pair<std::size_t, double>, 3> body_axes_of(const SweptSection& section);

}  // namespace rollcon::section
