#pragma once
/// Assembles the sparse stiffness matrix of a finite-element body and its loads, on the free displacement components.
/// Everything is over one reference modulus, so that entries are lengths.

#include <cstdint>
#include <map>
#include <vector>

#include "bodies/fem/element_stiffness.hpp"
#include "bodies/model/body_mesh.hpp"
#include "linalg/sparse_factor.hpp"

namespace rollcon::fem {

struct Unknowns {
  std::vector<std::int64_t> of;  ///< unknown of displacement component c of node k: [3 * k + c]; -1: held
  std::int64_t count = 0;
};
Unknowns number_unknowns(const BodyMesh& mesh);

struct Material {
  double young = 0, poisson = 0;  ///< young is over the reference
};

class Assembly {
 public:
  /// Takes the mesh, which must outlive it, materials by element, and the reference that their moduli are over.
  Assembly(const BodyMesh& mesh, std::vector<Material> material, Hex8 hex8, double reference);

  const Material& material(std::int64_t element) const { return material_[static_cast<std::size_t>(element)]; }
  /// Assembles the matrix, with sums in an order that does not depend on the number of threads.
  SparseMatrix stiffness(const Unknowns& unknowns, int threads) const;
  /// Returns nodal forces f[3 * k + c] of the elements that touch a held component, under displacements u.
  std::vector<double> forces_at_supports(const std::vector<double>& u) const;
  /// Returns consistent nodal loads of the tractions, pressures and body forces given, over the reference modulus.
  std::vector<double> loads(double reference) const;

 private:
  void add_body_force(const BodyForce& load, double reference, std::vector<double>& force) const;
  std::vector<std::vector<std::int64_t>> colours() const;
  void element_matrix(std::int64_t e, std::vector<double>& k) const;
  void add_springs(std::int64_t e, std::vector<double>& k) const;

  const BodyMesh& mesh_;
  std::vector<Material> material_;
  Hex8 hex8_;
  double reference_;
  std::map<std::int64_t, std::vector<std::pair<std::int64_t, Vec3>>> spring_;  ///< faces on springs, by element
};

}  // namespace rollcon::fem
