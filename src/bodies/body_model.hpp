#pragma once
/// Holds what a body is made of and what preparing it made of that. Bodies of equal content share one model.

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "bodies/body_kind.hpp"
#include "bodies/model/body_mesh.hpp"
#include "bodies/model/body_profile.hpp"
#include "bodies/model/relaxation.hpp"
#include "bodies/model/surface_response.hpp"
#include "bodies/thinness.hpp"
#include "geometry/mesh_surface.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon {

class SectionReader;
class SectionWriter;

struct BodyModel {
  BodyKind kind = BodyKind::rigid;
  const BodyTraits& traits() const { return traits_of(kind); }
  std::map<std::int32_t, Elastic> material;       ///< materials by tag; one for the whole body has tag 0
  std::map<std::int32_t, Relaxation> relaxation;  ///< how these relax; one that is not here does not
  BodyMesh mesh;
  BodyProfile profile;
  BodyOptions options;  ///< options that it was prepared with

  // Preparing the body makes what follows, frozen from then on.
  Elastic contact_material;  ///< material of most contact faces; until prepared: the one given last
  std::int32_t contact_tag = 0;
  TractionNodes traction_nodes, smooth_fans;
  std::unique_ptr<SurfaceSearch> search;
  std::unique_ptr<Surface> surface;
  Thinness thin;
  /// Response that bodies which differ in their loads alone share; safe for several threads.
  std::shared_ptr<Condensed> response;
  OwnLoads own;  ///< effect of the body's own loads
};

/// Checks that every model takes this Young's modulus and Poisson's ratio; err_argument, err_nonfinite.
void require_elastic_constants(double young, double poisson);

/// Checks form, size, symmetry and that all is finite; err_argument, err_nonfinite.
void require_matrix(const CondensedMatrix& matrix, std::int64_t nodes, std::int32_t index_base);

/// Names the source of a model's equations: they are assembled and factorised as far as known to be needed, unless a
/// file has them, or a prepared body that differs in its loads alone.
struct EquationSource {
  SectionReader* saved = nullptr;
  std::shared_ptr<BodyModel> unlike_loads;
};

/// Checks the mesh and makes the equations. Throws what Body::prepare does.
void prepare_model(BodyModel& model, int threads, const EquationSource& from);

using ContentDigest = std::pair<std::uint64_t, std::uint64_t>;

/// Digests all that was given: kind, materials, mesh, supports, loads, contact faces, options.
ContentDigest digest_of(const BodyModel& model);
/// Digests all but loads and given displacements.
ContentDigest digest_without_loads(const BodyModel& model);

/// Write all that was given to section "body" of a file, and read it. Reading throws err_io for what cannot be, and
/// then uses nothing of it. (Shapes of elements are checked by preparing, as always.)
void write_content(const BodyModel& model, SectionWriter& file);
void read_content(SectionReader& file, BodyModel& model);

}  // namespace rollcon
