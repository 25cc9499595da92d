#pragma once
/// Solves a body that is given by a section: harmonics of the way, each condensed to the nodes of the section's contact
/// edges, answer tractions on the surface that the section sweeps (docs/theory.md, section 10).

#include <map>
#include <vector>

#include "bodies/model/felt_layer.hpp"
#include "bodies/model/response_cache.hpp"
#include "bodies/section/harmonic_stiffness.hpp"
#include "bodies/section/harmonics.hpp"

namespace rollcon::section {

/// Names what acts: the part of tractions that goes with profile node `node` and the shape function `function` along
/// the way, over the stretch of faces that begins at `station` of the surface.
struct Source {
  std::int64_t station = 0;
  std::int32_t node = 0, function = 0;
  auto operator<=>(const Source&) const = default;
};

class System final : public ResponseCache {
 public:
  /// Factorises the harmonics at once. The mesh (swept) and the fans of its surface must outlive it. saved: takes
  /// instead what save() wrote for an equal body. Throws err_singular, err_memory, err_unsupported and err_io.
  System(const BodyMesh& mesh, const TractionNodes& fans, const std::map<std::int32_t, Elastic>& material,
         const BodyOptions& options, int threads, SectionReader* saved);

  OwnLoads solve_loads(const BodyMesh& loaded, int threads) override;
  BodyStatistics statistics() const override;
  AsEquations* as_equations() override { return nullptr; }
  std::shared_ptr<const BodyEquations> equations(int /*threads*/) override { return nullptr; }
  void solve_everywhere(std::span<double> /*load*/, SurfaceState& /*state*/, int /*threads*/) override {}

 private:
  void respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) override;
  void load(const LoadedSurface& /*surface*/, SurfaceLoads& /*loads*/, int /*threads*/) override {}
  std::uint64_t numbering() const override;
  std::int64_t factored() const override { return response_.rows(); }
  void write_factors(SectionWriter& file) const override;
  void read_factors(SectionReader& file) override;
  std::unique_ptr<SparseFactor> factor_of(double n, std::span<const std::int64_t> condensed) const;
  void solve_harmonics(int threads);
  OwnLoads solve_own_load(const BodyMesh& loaded) const;
  std::vector<std::int64_t> profile_unknowns() const;
  void find_sources(std::span<const std::int64_t> face, std::span<const std::int32_t> node,
                    const RowMatrix<double>& traction, std::vector<Source>& source, RowMatrix<double>& acting) const;
  /// Answers tractions by node of faces: traction(r, c) is that of column c at node[r].
  void answer(std::span<const std::int64_t> face, std::span<const std::int32_t> node, const RowMatrix<double>& traction,
              SurfaceRows& rows) const;

  const BodyMesh& mesh_;
  const SweptSection& section_;
  const TractionNodes& fans_;
  double reference_;
  HarmonicStiffness stiffness_;
  Harmonics harmonics_;
  /// Rows by sample: displacement component a of profile node j under a force b at node i, per radian, times n:
  /// [((3 * j + a) * profile + i) * 3 + b].
  RowMatrix<double> response_;
};

}  // namespace rollcon::section
