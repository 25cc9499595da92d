/// Stands for boundary-element bodies in a build without them.

#include "bodies/model/mesh_models.hpp"
#include "support/error.hpp"

namespace rollcon::bem {

void require_support() {
  fail(Status::err_unsupported,
       "kind is 2 (BEM), but this build of rollcon has no boundary-element bodies (component BEM: "
       "ROLLCON_WITH_BEM is OFF)");
}

// No call gets here: there is no body that could ask.
std::unique_ptr<Condensed> make_response(const BodyMesh& /*mesh*/, const TractionNodes& /*fans*/, double /*young*/,
                                         double /*poisson*/, const BodyOptions& /*options*/, int /*threads*/,
                                         SectionReader* /*saved*/) {
  require_support();
  return nullptr;
}

}  // namespace rollcon::bem
