#pragma once
/// Solves the algebraic system of a finite-element body, K u = M t (61): it is assembled on the free displacements,
/// factorised once and condensed to the surface nodes that contact needs (docs/theory.md, section 10).

#include <map>
#include <string>

#include "bodies/fem/assembly.hpp"
#include "bodies/fem/interior.hpp"
#include "bodies/model/body_mesh.hpp"
#include "bodies/model/felt_layer.hpp"
#include "bodies/model/response_cache.hpp"
#include "geometry/surface_coupling.hpp"
#include "linalg/sparse_factor.hpp"
#include "mesh/traction_nodes.hpp"
#include "support/ranks.hpp"

namespace rollcon::fem {

class System final : public ResponseCache {
 public:
  /// Assembles and factorises at once when the contact faces are few (and option prepare is 1), the body has loads of
  /// its own or ranks share the work: else the first frame says what to condense to. The mesh (checked, held) and its
  /// fans (of the smooth surface) must outlive it. saved: takes instead what save() wrote for an equal body. Throws
  /// err_singular, err_memory, err_unsupported and err_io.
  System(const BodyMesh& mesh, const TractionNodes& fans, const std::map<std::int32_t, Elastic>& material,
         const BodyOptions& options, int threads, SectionReader* saved);

  OwnLoads solve_loads(const BodyMesh& loaded, int threads) override;
  BodyStatistics statistics() const override;
  std::shared_ptr<const BodyEquations> equations(int threads) override;
  void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) override;
  const IntegrationPoints* integration_points() const override { return &interior_; }
  std::unique_ptr<const BodyFields> fields(SurfaceState&& state, const OwnLoads& own) override;

 private:
  void respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) override;
  void load(const LoadedSurface& surface, SurfaceLoads& loads, int threads) override;
  /// Brings entries by place in `loaded` and by column to the unknowns, component by component.
  void write_loads(const std::vector<std::int32_t>& loaded, const SparseMatrix& entries, SurfaceLoads& loads) const;
  FeltTractions feel(const SurfaceMesh& layer, SurfaceOutline& outline) const;
  void require_matrix(int threads);
  void factorize(std::vector<std::int64_t> condensed, int threads);
  std::unique_ptr<SparseFactor> factor_of(std::span<const std::int64_t> condensed, int threads, const Ranks& ranks);
  std::string bending_hint() const;
  void place_condensed(std::vector<std::int64_t> condensed);
  std::uint64_t numbering() const override;
  std::int64_t factored() const override { return factor_ ? static_cast<std::int64_t>(condensed_.size()) : 0; }
  void write_factors(SectionWriter& file) const override;
  void read_factors(SectionReader& file) override;
  std::size_t factor_bytes() const { return factor_ ? factor_->statistics().bytes : 0; }
  void require_condensed(const std::vector<std::int32_t>& node, int threads);
  std::vector<std::int64_t> unknowns_at(const std::vector<std::int32_t>& node) const;
  OwnLoads solve_own_load(const BodyMesh& loaded, const Assembly& assembly, SparseFactor& factor) const;
  void require_whole(int threads);
  /// Condenses loads that each column of rows has at nodes `loaded`.
  void condense(const std::vector<std::int32_t>& loaded, const RowMatrix<double>& load, SurfaceRows& rows, int threads);

  const BodyMesh& mesh_;
  const TractionNodes& fans_;
  double reference_ = 1;  ///< reference modulus
  BodyOptions options_;
  Assembly assembly_;
  Interior interior_;
  Unknowns unknowns_;

  /// Stiffness matrix; empty until needed, once freed, and once all that contact may need is condensed.
  SparseMatrix matrix_;
  std::unique_ptr<SparseFactor> factor_;
  std::unique_ptr<SparseFactor> whole_;     ///< all unknowns; null until displacements inside are asked for
  std::vector<std::int64_t> condensed_;     ///< unknowns condensed to, ascending
  std::vector<std::int64_t> condensed_at_;  ///< place of each unknown in condensed_, -1: none
  std::vector<std::int64_t> contact_;       ///< unknowns that contact may need
};

}  // namespace rollcon::fem
