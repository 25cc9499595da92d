#pragma once
/// Computes stresses and interpolated fields of a finite-element body.

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "bodies/fem/assembly.hpp"
#include "bodies/model/surface_state.hpp"
#include "mesh/volume_search.hpp"

namespace rollcon::fem {

class Interior final : public IntegrationPoints {
 public:
  /// Takes mesh and assembly, which must outlive it, and the reference modulus that the materials' moduli are over.
  Interior(const BodyMesh& mesh, const Assembly& assembly, Hex8 hex8, double reference);

  std::int64_t points() const override { return first_.back(); }
  void at_points(const double* u, double* stress, double* xyz, int threads) const override;
  /// Returns nodal stresses under displacements u of all nodes, see BodyFields.
  void at_nodes(const double* u, double* stress, int threads) const;
  /// Interpolates u and smoothed stresses at nodes by the elements' shape functions. Arrays may be null. False: the
  /// point is outside, and nothing is written.
  bool interpolate(const Vec3& x, const double* u, const double* node_stress, double* displacement,
                   double* stress) const;
  std::int64_t nodes() const { return mesh_.surface.nodes(); }

 private:
  /// Returns what element_stress() does, but stresses in the caller's unit.
  double element(std::int64_t e, const double* u, double* stress, double* xyz) const;
  const VolumeSearch& search() const;

  const BodyMesh& mesh_;
  const Assembly& assembly_;
  Hex8 hex8_;
  double reference_;
  std::vector<std::int64_t> first_;  ///< first integration point of each element, and the number of all
  mutable std::once_flag searched_;
  mutable std::unique_ptr<const VolumeSearch> search_;
};

/// Gives fields under displacements of all nodes. The interior must outlive them.
class InteriorFields final : public BodyFields {
 public:
  InteriorFields(const Interior& interior, std::vector<double> u) : interior_(interior), u_(std::move(u)) {}
  void at_points(std::int64_t n, const double* xyz, double* displacement, double* stress, int threads) const override;
  void at_nodes(double* stress, int threads) const override { interior_.at_nodes(u_.data(), stress, threads); }

 private:
  const Interior& interior_;
  std::vector<double> u_;
};

}  // namespace rollcon::fem
