#pragma once
/// Models of elastic bodies with a mesh. Each is a component of the build: where one is left out, fem_absent.cpp,
/// bem_absent.cpp and meshed_absent.cpp stand for it.

#include <map>
#include <memory>

#include "bodies/model/body_mesh.hpp"
#include "bodies/model/surface_response.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon {

class SectionReader;

// saved: what the response wrote to a file (Condensed::save); null: from nothing.

namespace fem {
/// Throws err_unsupported, naming component and option, in a build without finite elements.
void require_support();
/// Largest Poisson's ratio for which the element is accurate; beyond it bodies refuse it.
double largest_poisson(VolumeType type);
/// See fem::System.
std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans,
                                         const std::map<std::int32_t, Elastic>& material, const BodyOptions& options,
                                         int threads, SectionReader* saved);
}  // namespace fem

namespace bem {
/// Throws err_unsupported, naming component and option, in a build without boundary elements.
void require_support();
/// See bem::System.
std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans, double young, double poisson,
                                         const BodyOptions& options, int threads, SectionReader* saved);
}  // namespace bem

}  // namespace rollcon
