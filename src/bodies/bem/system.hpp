#pragma once
/// Solves the algebraic system of a boundary-element body, H u = G t (58): it is assembled for its supports, factorised
/// once and condensed to the surface nodes that contact needs (docs/theory.md, section 9).

#include "bodies/bem/boundary_integrals.hpp"
#include "bodies/bem/collocation_blocks.hpp"
#include "bodies/bem/lifted_surface.hpp"
#include "bodies/bem/somigliana.hpp"
#include "bodies/bem/unknowns.hpp"
#include "bodies/model/body_mesh.hpp"
#include "bodies/model/response_cache.hpp"
#include "linalg/factored_matrix.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon::bem {

class System final : public ResponseCache {
 public:
  /// Assembles and factorises, unless option prepare is 0 and the body has no loads of its own: then the first use
  /// does. The mesh (checked, held) and fans must outlive it. saved: takes instead what save() wrote for an equal body.
  /// Throws err_singular, err_memory and err_io.
  System(const BodyMesh& mesh, const TractionNodes& fans, double young, double poisson, const BodyOptions& options,
         int threads, SectionReader* saved);

  OwnLoads solve_loads(const BodyMesh& loaded, int threads) override;
  BodyStatistics statistics() const override;
  Imbalances imbalances() const override;
  std::shared_ptr<const BodyEquations> equations(int threads) override;
  void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) override;
  std::unique_ptr<const BodyFields> fields(SurfaceState&& state, const OwnLoads& own) override;

 private:
  void respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) override;
  void load(const LoadedSurface& surface, SurfaceLoads& loads, int threads) override;
  std::uint64_t numbering() const override;
  std::int64_t factored() const override { return factor_ ? unknowns_.columns : 0; }
  void write_factors(SectionWriter& file) const override;
  void read_factors(SectionReader& file) override;
  void factorize(int threads);
  /// Says whether factors are hierarchical; else they are dense.
  bool hierarchical() const;
  std::size_t factor_bytes() const { return factor_ ? factor_->bytes() : 0; }
  /// These throw err_memory where the dense matrix, or the factors, would not have room. The second notes what these
  /// need.
  void require_matrix() const;
  void require_factor();
  void factorize_dense(int threads);
  /// Returns rows with columns and places, for hierarchical factors.
  std::vector<Pivot> pivots() const;
  void factorize_hierarchically(const CollocationBlocks& blocks);
  /// Throws err_singular where the factors do not move the body rigidly with its supports.
  void check_rigid_motion(const CollocationBlocks& blocks);
  struct PackTarget;
  std::vector<std::int32_t> needed_fans(std::int32_t& columns) const;
  void place(const double* h, const double* g, const std::vector<std::int32_t>& column_of_fan,
             const PackTarget& to) const;
  /// Assembles the matrix: unknowns squared, column-major, not cleared.
  void assemble(int threads, double* matrix);
  /// Returns the right side of given tractions and displacements.
  std::vector<double> own_load(const BodyMesh& loaded, const std::vector<double>& given,
                               const CollocationBlocks& blocks) const;
  OwnLoads solve_own_load(const BodyMesh& loaded, const CollocationBlocks& blocks) const;
  /// Adds the tractions that a solution has, by traction node and component.
  void add_reactions(const double* b, std::vector<double>& traction) const;
  /// Sums tractions on the whole surface, by traction node and component.
  Resultant resultant(std::span<const double> traction) const;
  /// Returns how far loads and reactions are from a balance, relative to a force at `centre` and to its moment about
  /// what is held.
  double imbalance(const Resultant& sum, const Vec3& centre, double force) const;
  /// Finds what the reactions miss of own loads.
  double missed(std::span<const double> load, std::span<const double> traction) const;
  /// Returns Imbalances::bent for displacements that a force causes.
  double bent(const std::vector<double>& displacement, double force) const;
  /// Checks uniform tractions on the surface that b was made for, right sides after elimination; err_mesh where a
  /// pressure gets no answer that can be trusted. (No load may act along the faces.)
  void check_balance(const std::vector<double>& b, const LoadedSurface& loaded);
  std::vector<double> given_tractions(const BodyMesh& loaded) const;
  Resultant support_reaction(const std::vector<double>& traction, const std::vector<double>& given) const;
  LiftedColumns columns_of_faces(std::span<const std::int64_t> face, const SurfaceOutline& outline) const;
  /// Returns right sides for unit tractions: unknowns x (3 columns).
  std::vector<double> right_sides(const LoadedSurface& surface, const SurfaceOutline& outline, int threads);
  /// Solves for right sides b, and keeps some rows.
  void condense(std::vector<double> b, const LoadedSurface& surface, SurfaceRows& rows, int threads);
  void write_loads(const std::vector<double>& b, SurfaceLoads& loads) const;

  const BodyMesh& mesh_;
  const TractionNodes& fans_;
  double shear_ = 1, poisson_ = 0;
  BodyOptions options_;
  LiftedSurface lifted_;
  BoundaryIntegrals integrals_;  ///< integrals over lifted_
  Unknowns unknowns_;
  std::vector<double> fan_size_;  ///< local element size, which scales unknown tractions
  double rigid_error_ = 0;        ///< error of a rigid motion by hierarchical factors
  double reach_ = 0;              ///< half the diagonal of the body's box
  Vec3 held_at_{0, 0, 0};         ///< mean place of the held nodes
  std::unique_ptr<SystemFactor> factor_;
  std::shared_ptr<const BodyEquations> kept_equations_;  ///< equations until they are factorised
  std::shared_ptr<const SomiglianaBody> inside_;         ///< null until fields inside are asked for
  bool own_solved_ = false;
  Imbalances imbalances_;  ///< worst of all frames; mutex_ guards it, and factor_ once constructed
};

}  // namespace rollcon::bem
