#pragma once
/// Solves a body by a section. Harmonics of the way, each condensed to the nodes of the section's contact edges, give
/// the response to tractions on the surface that the section sweeps (docs/sections.md).

#include <complex>
#include <list>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "bodies/model/felt_layer.hpp"
#include "bodies/model/mesh_models.hpp"
#include "bodies/model/response_cache.hpp"
#include "bodies/section/harmonic_stiffness.hpp"
#include "bodies/section/harmonics.hpp"
#include "linalg/complex_condensation.hpp"

namespace rollcon::section {

/// Names one part of the tractions: that with the shape function of profile node `node` across the way and the shape
/// function `function` along it, over the stretch of faces that begins at `station` of the surface.
struct Source {
  std::int64_t station = 0;
  std::int32_t node = 0, function = 0;
  bool operator==(const Source&) const = default;
  bool operator<(const Source& other) const {
    return std::tie(station, node, function) < std::tie(other.station, other.node, other.function);
  }
};

/// Returns the coefficients of 1, x, x^2 of a shape function along the way. Functions 0, 1, 2 are those of the first,
/// the last and the middle station.
std::array<double, 3> along_the_way(bool quadratic, std::size_t function);

/// Holds samples of n times the response. Rows are by sample and hold, at [((3 * j + a) * profile + i) * 3 + b],
/// component a of the displacement of profile node j under component b of a force at node i, per radian.
struct Response {
  double rate = 0;               ///< angle per time at which the body passes by; 0: it stands, or is elastic
  RowMatrix<double> part, lags;  ///< real and imaginary parts; elastic bodies have none that lags
};

/// Holds displacements [column][3 * plane node + c]: real parts and, for bodies that creep, imaginary ones.
struct Displaced {
  std::vector<double> part, lags;
};

class System final : public ResponseCache {
 public:
  /// Factorises the harmonics, or reads them from `saved`, which save() wrote for an equal body; those of bodies that
  /// creep wait for a rate. The swept mesh and the fans of its surface must outlive the system. Throws err_singular,
  /// err_memory, err_unsupported and err_io.
  System(const BodyMesh& mesh, const TractionNodes& fans, const Materials& material, const BodyOptions& options,
         int threads, SectionReader* saved);

  OwnLoads solve_loads(const BodyMesh& loaded, int threads) override;
  BodyStatistics statistics() const override;
  std::shared_ptr<const BodyEquations> equations(int /*threads*/) override { return nullptr; }
  void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) override;
  std::unique_ptr<const BodyFields> fields(SurfaceState&& state, const OwnLoads& own) override;

  // SectionFields takes these.
  const SweptSection& section() const { return section_; }
  Elastic material(std::int64_t element) const {
    const Elastic& m = stiffness_.material(element);
    return {m.young * reference_, m.poisson};
  }
  std::size_t samples() const { return harmonics_.samples().size(); }
  /// Returns the amount of each sample and column (profile node, component) in forces, numbered as load() does, seen
  /// from an angle: [(sample * columns + column) * 4 + kernel]. Kernels are cosine, sine and, if slopes are asked for,
  /// the derivatives of both by the angle. known: weights of at_stations(), if the angle is that of `station`.
  std::vector<double> sampled(std::span<const double> force, double angle, bool slopes,
                              const StationWeights* known = nullptr, std::int64_t station = 0) const;
  StationWeights at_stations(bool slopes) const;
  /// Returns displacements of all plane nodes, times n of the sample, under a unit force of each column, while the body
  /// passes by at a rate.
  Displaced sample_everywhere(std::size_t sample, double rate) const;
  /// Returns one more than the number of ways in which materials relax at a rate: one for those that do not relax.
  std::size_t relaxations(double rate) const { return rate == 0 ? 1 : 1 + creeping_.size(); }
  /// Returns the number of the way in which an element relaxes. unit: the elasticity that its moduli are multiples of.
  std::size_t relaxation_of(std::int64_t element, double rate, Elastic& unit) const;
  /// Returns the modulus of a way in a sample, as a multiple of that elasticity.
  std::complex<double> modulus(std::size_t way, std::size_t sample, double rate) const;

 private:
  void respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) override;
  void load(const LoadedSurface& surface, SurfaceLoads& loads, int threads) override;
  /// Holds a frame's tractions on the surface: traction(r, c) is that of column c at node[r] of these faces.
  struct Acted {
    std::vector<std::int64_t> face;
    std::vector<std::int32_t> node;
    RowMatrix<double> traction;
  };
  /// Finds these tractions, and sets in `outline` what is left to a half-space.
  Acted act(const LoadedSurface& surface, SurfaceOutline& outline) const;
  std::uint64_t numbering() const override;
  std::int64_t factored() const override { return creeping_.empty() ? response_.front().part.rows() : 0; }
  void write_factors(SectionWriter& file) const override;
  void read_factors(SectionReader& file) override;
  std::unique_ptr<SparseFactor> factor_of(double n, std::span<const std::int64_t> condensed,
                                          std::span<const std::int64_t> order) const;
  [[noreturn]] void refuse_singular(double n, std::int64_t unknown) const;
  /// Returns the response at a rate, made if it is none of the few latest.
  const Response& response(double rate, int threads);
  /// Holds the order of elimination of sections that creep, and 3 * profile node + c of each condensed unknown.
  struct Condensation {
    ComplexCondensation of;
    std::vector<std::int64_t> row;
  };
  const Condensation& condensation() const;
  /// Returns the stiffness of harmonic n with the moduli at the frequency n times the rate.
  std::vector<std::complex<double>> creeping_stiffness(double n, double rate) const;
  void solve_harmonics(Response& response, int threads);
  void solve_creeping(Response& response, int threads);
  void find_power(SurfaceState& state, const Response& response) const;
  OwnLoads solve_own_load(const BodyMesh& loaded) const;
  /// Returns forces, numbered as load() does, of one shape function on a stretch along e1, the way and e2 of each
  /// profile node.
  std::vector<double> local_forces(std::span<const double> force, std::int64_t stretch, std::size_t function) const;
  std::vector<std::int64_t> profile_unknowns() const;
  void find_sources(std::span<const std::int64_t> face, std::span<const std::int32_t> node,
                    const RowMatrix<double>& traction, std::vector<Source>& source, RowMatrix<double>& acting) const;
  /// Computes the response to tractions on faces: traction(r, c) is that of column c at node[r].
  void answer(const Response& response, std::span<const std::int64_t> face, std::span<const std::int32_t> node,
              const RowMatrix<double>& traction, SurfaceRows& rows) const;

  const BodyMesh& mesh_;
  const SweptSection& section_;
  const TractionNodes& fans_;
  double reference_;
  HarmonicStiffness stiffness_;  ///< with all materials relaxed
  Harmonics harmonics_;
  /// Holds the elements that relax alike, with their moduli at once and nothing else.
  struct Creeping {
    Relaxation relaxation;
    HarmonicStiffness stiffness;
  };
  std::list<Creeping> creeping_;
  std::list<Response> response_;  ///< the latest used first
  /// Order of the unknowns with none condensed, which all harmonics share; found once for all threads.
  mutable std::once_flag order_found_;
  mutable std::vector<std::int64_t> order_;
  mutable std::once_flag condensed_once_;
  mutable std::optional<Condensation> condensation_;
};

}  // namespace rollcon::section
