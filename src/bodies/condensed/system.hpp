#pragma once
/// Answers for a body whose stiffness or flexibility on its nodes is given (docs/condensed.md).

#include <vector>

#include "bodies/model/body_mesh.hpp"
#include "bodies/model/response_cache.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon::condensed {

class System final : public ResponseCache {
 public:
  /// Checks the mesh's matrix and eliminates what its supports hold. The mesh and its fans (of the smooth surface) must
  /// outlive the system. contact: constants of the half-space between nodes. Throws err_argument naming the entry of a
  /// matrix that is not symmetric, not definite or does not fit, err_singular naming a rigid motion that is free.
  System(const BodyMesh& mesh, const TractionNodes& fans, const Elastic& contact, const BodyOptions& options,
         int threads, SectionReader* saved);

  OwnLoads solve_loads(const BodyMesh& loaded, int threads) override;
  BodyStatistics statistics() const override;
  Imbalances imbalances() const override;
  std::shared_ptr<const BodyEquations> equations(int /*threads*/) override { return nullptr; }
  void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) override;
  std::unique_ptr<const BodyFields> fields(SurfaceState&& state, const OwnLoads& own) override;

 private:
  void respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) override;
  void load(const LoadedSurface& surface, SurfaceLoads& loads, int threads) override;
  /// Returns forces of the columns at nodes of the body, and sets in `outline` what is left to a half-space.
  struct Acting {
    std::vector<std::int32_t> node;
    RowMatrix<double> force;
  };
  Acting act(const LoadedSurface& surface, SurfaceOutline& outline) const;
  std::uint64_t numbering() const override { return 0; }
  std::int64_t factored() const override { return 0; }
  void write_factors(SectionWriter& /*file*/) const override {}
  void read_factors(SectionReader& /*file*/) override {}
  void invert(const RowMatrix<double>& stiffness);
  void take(const RowMatrix<double>& flexibility);
  OwnLoads solve_own_load(const BodyMesh& loaded) const;

  const BodyMesh& mesh_;
  const TractionNodes& fans_;
  Elastic contact_;
  std::vector<std::int64_t> free_, held_;  ///< unknowns, ascending
  /// Displacements by forces, and by unit displacements of the held unknowns; rows and columns of held ones vanish.
  RowMatrix<double> flexibility_, by_held_;
  double local_young_ = 0;
};

}  // namespace rollcon::condensed
