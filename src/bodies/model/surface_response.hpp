#pragma once
/// Declares how the surface of an elastic body with a mesh answers loads, its equations, and its fields inside.

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

/// Names the place where a frame's tractions act: on faces of the body, interpolated by the faces' own shape functions
/// and zero elsewhere; or on a mesh of its own that lies on the body's surface.
struct LoadedSurface {
  std::vector<std::int64_t> face;  ///< elements, ascending; empty: tractions act on `layer`
  SurfaceMesh layer;               ///< mesh in the body's coordinates
  /// Nodes of the body whose displacements are wanted under a layer. Under faces they are the nodes of these and of all
  /// elements that touch them.
  std::vector<std::int32_t> row;
  double rate = 0;  ///< angle per time at which a section that creeps passes by; else 0
  /// Asks for so many times the derivative by the angle of displacements that lag; 0: for displacements.
  double slope = 0;
  bool of_faces() const { return !face.empty(); }
  bool operator==(const LoadedSurface& other) const;
};

/// Tells which nodes a frame's tractions and displacements belong to, all in the body's axes.
struct SurfaceOutline {
  std::vector<std::int32_t> column;  ///< node of the body, or of the layer, of each traction column
  std::vector<std::int32_t> row;     ///< node of the body of each displacement row

  // Finite elements under a layer feel, instead of its tractions, smoother ones on the body's own faces: component by
  // component, seen.row(i) times the tractions of all columns at node seen_node[i] of the faces seen_face. Empty: they
  // feel the tractions as they are.
  std::vector<std::int64_t> seen_face;
  std::vector<std::int32_t> seen_node;
  RowMatrix<double> seen;
  double young = 0, poisson = 0;  ///< constants of most of these faces
};

/// Holds displacements of some surface nodes under unit nodal tractions.
struct SurfaceRows : SurfaceOutline {
  RowMatrix<double> u;  ///< (3 * row.size()) x (3 * column.size())
};

/// Holds right sides of the body's equations under unit nodal tractions, and which unknowns the displacements are.
struct SurfaceLoads : SurfaceOutline {
  SparseMatrix load;                  ///< unknowns x (3 * column.size())
  std::vector<std::int64_t> unknown;  ///< unknown of (row, component): [3 * r + c]; -1: held
};

/// Holds a force and its moment about the origin of the body's axes.
struct Resultant {
  Vec3 force{0, 0, 0}, moment{0, 0, 0};
};

/// Holds what a body's own loads and given displacements do.
struct OwnLoads {
  std::vector<double> displacement;  ///< u[3 * node + c] of every node; empty: there are no loads
  /// Tractions of boundary elements that go with the displacement, by traction node of the body (see TractionNodes),
  /// t[3 * k + c]: what was given, and the reactions of the supports. Empty when displacement is. Sections have the
  /// displacements of their plane nodes here, along e1, the way and e2.
  std::vector<double> traction;
  Resultant reaction;  ///< force and moment that the supports exert on the body
  double missed = 0;   ///< part of these loads that reactions of boundary elements miss
};

struct BodyStatistics {
  std::int64_t unknowns = 0, assemblies = 0, factorizations = 0, condensations = 0;
  std::int64_t kernel_evaluations = 0;
  std::int64_t condensed = 0;  ///< unknowns of finite elements left after condensation
  std::int64_t nonzeros = 0;   ///< nonzeros of the factors; dense: unknowns squared
  double condition = 0;        ///< estimate for the scaled matrix
  double imbalance = 0;        ///< largest part of loads that reactions of boundary elements miss
  double seconds_assembly = 0, seconds_order = 0, seconds_factor = 0, seconds_condense = 0;
  std::int64_t responses_kept = 0, responses_dropped = 0;  ///< counts over sets of faces and layers
  std::size_t bytes = 0, peak_bytes = 0;
  double needed_bytes = 0;  ///< bytes foreseen for the factors, known before they are made; 0: nothing is foreseen
};

struct BodyMesh;
class SectionReader;
class SectionWriter;

/// Gives the body with its unknowns written out instead of eliminated. Loads and equations factorise nothing.
class AsEquations {
 public:
  /// Returns right sides for tractions on the surface, shared as long as anyone holds them.
  virtual std::shared_ptr<const SurfaceLoads> loads(const LoadedSurface& surface, int threads) = 0;
  /// Returns the matrix to these right sides, assembled once: it is shared as they are, and kept by the body itself
  /// until it is factorised (unless option keep_factors is 0). Null: the body has no such matrix.
  virtual std::shared_ptr<const BodyEquations> equations(int threads) = 0;
  /// Returns displacements of every node, and the reactions of supports as tractions of boundary elements, under a
  /// right side of the equations, which is overwritten; own loads and given displacements apart. Factorises at most
  /// once.
  virtual void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) = 0;

 protected:
  ~AsEquations() = default;
};

/// Brings the factors and responses of a body to and from files.
class Saved {
 public:
  /// Returns how many unknowns can be loaded without assembling or factorising anything more.
  virtual std::int64_t solvable() const = 0;
  /// Writes what is kept, and the displacements under these loads, to sections "response", "factors" when there are
  /// any, and "kept". What can be found again from the mesh without factorising is left out.
  virtual void save(SectionWriter& file, const OwnLoads& own) const = 0;
  /// Adds what section "kept" has and is not kept yet.
  virtual void add_kept(SectionReader& file) = 0;

 protected:
  ~Saved() = default;
};

/// Tells a contact how the surface of an elastic body with a mesh answers tractions on a frame and the body's own
/// loads. A body model implements this, and offers the other interfaces where it has them. Safe for several threads.
class Condensed {
 public:
  virtual ~Condensed() = default;
  /// Returns the rows of a surface, kept up to option cache_bytes: asking for them again costs nothing.
  virtual std::shared_ptr<const SurfaceRows> rows(const LoadedSurface& surface, int threads) = 0;
  /// Returns what the loads do that the body was prepared with.
  virtual const OwnLoads& own() const = 0;
  /// Returns what the loads of a mesh do that differs from the body's in loads and given displacements alone.
  /// Factorises at most once for all callers, finite elements with nothing condensed; boundary elements are assembled
  /// anew. err_argument: displacements are not finite.
  virtual OwnLoads solve_loads(const BodyMesh& loaded, int threads) = 0;
  virtual BodyStatistics statistics() const = 0;
  /// Returns what loads on frames miss: see Imbalances.
  virtual Imbalances imbalances() const { return {}; }

  // These functions return null where the body has no such interface.
  virtual AsEquations* as_equations() { return nullptr; }
  virtual Saved* saved() { return nullptr; }
  /// Only finite elements have integration points.
  virtual const IntegrationPoints* integration_points() const { return nullptr; }
  /// Returns fields inside under this state and own loads; an empty state means own loads alone. The body must outlive
  /// them.
  virtual std::unique_ptr<const BodyFields> fields(SurfaceState&& /*state*/, const OwnLoads& /*own*/) {
    return nullptr;
  }
};

}  // namespace rollcon
