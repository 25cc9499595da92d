#pragma once
/// Elastic bodies with a mesh: how their surface answers loads, their equations, and their fields inside.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bodies/model/expanded_compliance.hpp"
#include "bodies/model/imbalance.hpp"
#include "bodies/model/surface_state.hpp"
#include "linalg/dense.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// The place where a frame's tractions act: on faces of the body, interpolated by the faces' own shape functions and
/// zero elsewhere; or on a mesh of its own that lies on the body's surface.
struct LoadedSurface {
  std::vector<std::int64_t> face;  ///< elements, ascending; empty: `layer`
  SurfaceMesh layer;               ///< in the body's coordinates
  /// The body's nodes whose displacements are wanted under a layer. Under faces these are their nodes and those of all
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

/// Right sides of the body's equations under unit nodal tractions, and which unknowns the displacements are.
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
  double missed = 0;   ///< boundary elements: the part of these loads that the reactions miss
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

/// The body with its unknowns written out instead of eliminated. Nothing is factorised for loads and equations.
class AsEquations {
 public:
  /// Right sides for tractions on the surface. Shared as long as anyone holds them.
  virtual std::shared_ptr<const SurfaceLoads> loads(const LoadedSurface& surface, int threads) = 0;
  /// The matrix to these right sides, assembled once: shared like them, and kept by the body itself until it is
  /// factorised (unless option keep_factors is 0).
  virtual std::shared_ptr<const BodyEquations> equations(int threads) = 0;
  /// Displacements of every node, and the reactions of supports as tractions of boundary elements, under a right side
  /// of the equations, which is overwritten; own loads and given displacements apart. Factorises at most once.
  virtual void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) = 0;

 protected:
  ~AsEquations() = default;
};

/// A body whose factors and responses go to and from files.
class Saved {
 public:
  /// Unknowns for whose loads nothing needs to be assembled or factorised any more.
  virtual std::int64_t solvable() const = 0;
  /// Writes what is kept, and the displacements under these loads: sections "response", "factors" when there are any,
  /// "kept". What can be found again from the mesh without factorising is left out.
  virtual void save(SectionWriter& file, const OwnLoads& own) const = 0;
  /// Adds what section "kept" has and is not kept yet.
  virtual void add_kept(SectionReader& file) = 0;

 protected:
  ~Saved() = default;
};

/// An elastic body with a mesh as a contact needs it: how the surface that a frame lies on answers tractions and the
/// body's own loads. A body model implements this, and offers the other faces where it has them. Safe for several
/// threads.
class Condensed {
 public:
  virtual ~Condensed() = default;
  /// Kept, up to option cache_bytes: asking again for the same surface costs nothing.
  virtual std::shared_ptr<const SurfaceRows> rows(const LoadedSurface& surface, int threads) = 0;
  /// The loads that the body was prepared with.
  virtual const OwnLoads& own() const = 0;
  /// What the loads of a mesh do that differs from the body's in loads and given displacements alone. Factorises at
  /// most once for all that ask, finite elements with nothing condensed; boundary elements are assembled anew.
  /// err_argument.
  virtual OwnLoads solve_loads(const BodyMesh& loaded, int threads) = 0;
  virtual BodyStatistics statistics() const = 0;
  /// What loads on frames miss: see Imbalances.
  virtual Imbalances imbalances() const { return {}; }

  // Null where the body has no such face.
  virtual AsEquations* as_equations() { return nullptr; }
  virtual Saved* saved() { return nullptr; }
  /// Finite elements.
  virtual const IntegrationPoints* integration_points() const { return nullptr; }
  /// Fields inside under this state and own loads; an empty state is those alone. They must not outlive the body.
  virtual std::unique_ptr<const BodyFields> fields(SurfaceState&& /*state*/, const OwnLoads& /*own*/) {
    return nullptr;
  }
};

}  // namespace rollcon
