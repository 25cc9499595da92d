#pragma once
/// An elastic body with a mesh: its equations, and how its surface answers loads. Boundary-element and finite-element
/// bodies implement it; everything above sees this face of them.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bodies/model/body_interior.hpp"
#include "bodies/model/expanded_compliance.hpp"
#include "bodies/model/surface_state.hpp"
#include "linalg/dense.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Where a frame's tractions act: on faces of the body, interpolated by the faces' own shape functions and zero
/// elsewhere; or on a mesh of its own that lies on the body's surface.
struct LoadedSurface {
  std::vector<std::int64_t> face;  ///< elements, ascending; empty: `layer`
  SurfaceMesh layer;               ///< in the body's coordinates
  /// Of a layer: the body's nodes whose displacements are wanted. Of faces these are their nodes and those of all
  /// elements that touch them.
  std::vector<std::int32_t> row;
  bool of_faces() const { return !face.empty(); }
  bool operator==(const LoadedSurface& other) const;
};

/// Whose tractions and displacements a frame's are, all in the body's axes.
struct SurfaceOutline {
  std::vector<std::int32_t> column;  ///< node of each traction column: of the body, or of the layer
  std::vector<std::int32_t> row;     ///< node of the body of each displacement row

  /// Finite elements under a layer feel, instead of its tractions, smoother ones on the body's own faces: component by
  /// component, seen.row(i) of the tractions of all columns at
  /// seen_node[i] of the faces seen_face. Empty: felt as they are.
  std::vector<std::int64_t> seen_face;
  std::vector<std::int32_t> seen_node;
  RowMatrix<double> seen;
  double young = 0, poisson = 0;  ///< of most of these faces
};

/// Displacements of some surface nodes under unit nodal tractions.
struct SurfaceRows : SurfaceOutline {
  RowMatrix<double> u;  ///< (3 * row.size()) x (3 * column.size())
};

/// The same before the body's unknowns are eliminated: right sides of its equations, and which unknowns the
/// displacements are.
struct SurfaceLoads : SurfaceOutline {
  SparseMatrix load;                  ///< unknowns x (3 * column.size())
  std::vector<std::int64_t> unknown;  ///< of (row, component): [3 * r + c]; -1: held
};

/// Moment about the origin of the body's axes.
struct Resultant {
  Vec3 force{0, 0, 0}, moment{0, 0, 0};
};

/// What a body's own loads and given displacements do.
struct OwnLoads {
  std::vector<double> displacement;  ///< of every node, u[3 * node + c]; empty: there are none
  /// Boundary elements: tractions that go with it, by traction node of the body (see TractionNodes), t[3 * k + c]: what
  /// was given, and the reactions of the supports. Empty when displacement is.
  std::vector<double> traction;
  Resultant reaction;  ///< what the supports exert on the body
  double missed = 0;   ///< boundary elements: see Imbalances
};

struct BodyStatistics {
  std::int64_t unknowns = 0, assemblies = 0, factorizations = 0, condensations = 0;
  std::int64_t kernel_evaluations = 0;
  std::int64_t condensed = 0;  ///< finite elements: unknowns left after condensation
  std::int64_t nonzeros = 0;   ///< of the factors; dense: unknowns squared
  double condition = 0;        ///< estimate, of the scaled matrix
  double imbalance = 0;        ///< boundary elements: largest, of supports' reactions to loads
  double seconds_assembly = 0, seconds_order = 0, seconds_factor = 0, seconds_condense = 0;
  std::int64_t responses_kept = 0, responses_dropped = 0;  ///< to sets of faces and layers
  std::size_t bytes = 0, peak_bytes = 0;
};

struct BodyMesh;
class SectionReader;
class SectionWriter;

/// Safe for several threads.
class SurfaceResponse {
 public:
  virtual ~SurfaceResponse() = default;
  /// Kept, up to option cache_bytes: asking again for the same surface costs nothing.
  virtual std::shared_ptr<const SurfaceRows> rows(const LoadedSurface& surface, int threads) = 0;
  /// Right sides for the same tractions. The body factorises and condenses nothing for them. Shared as long as anyone
  /// holds them.
  virtual std::shared_ptr<const SurfaceLoads> loads(const LoadedSurface& surface, int threads) = 0;
  /// The matrix to these right sides, assembled once: shared like them, and kept by the body itself until it is
  /// factorised (unless option keep_factors is 0).
  virtual std::shared_ptr<const BodyEquations> equations(int threads) = 0;
  /// Displacements of every node, and the reactions of supports as tractions of boundary elements, under a right side
  /// of the equations, which is overwritten; own loads and given displacements apart. Factorises at most once.
  virtual void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) = 0;
  /// Boundary elements: fields inside under this state and own loads; an empty one is those alone. Null: the body has
  /// elements inside.
  virtual std::unique_ptr<const SurfaceFields> surface_fields(SurfaceState&& /*state*/, const OwnLoads& /*own*/) {
    return nullptr;
  }
  /// Null: the body has no elements inside.
  virtual const BodyInterior* interior() const { return nullptr; }
  /// Those that the body was prepared with.
  virtual const OwnLoads& own() const = 0;
  /// Those of a mesh that differs from the body's in loads and given displacements alone. Factorises at most once for
  /// all that ask, finite elements with nothing condensed; boundary elements are assembled anew. err_argument.
  virtual OwnLoads solve_loads(const BodyMesh& loaded, int threads) = 0;
  virtual BodyStatistics statistics() const = 0;

  /// Unknowns for whose loads nothing needs to be assembled or factorised any more.
  virtual std::int64_t solvable() const = 0;
  /// Writes what is kept: sections "response", "factors" when there are any, "kept". What can be found again from the
  /// mesh without factorising is left out.
  void save(SectionWriter& file) const { save(file, own()); }
  virtual void save(SectionWriter& file, const OwnLoads& own) const = 0;
  /// Adds what section "kept" has and is not kept yet.
  virtual void add_kept(SectionReader& file) = 0;
};

}  // namespace rollcon
