/// Stands for what elastic bodies with a mesh share in a build without finite and boundary elements. No call gets here:
/// there is no such body. Rigid bodies with a mesh need none of it.

#include "bodies/displacement_beside.hpp"
#include "bodies/meshed_compliance.hpp"
#include "bodies/model/supports.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

[[noreturn]] void refuse() {
  fail(Status::err_unsupported,
       "this build of rollcon has no elastic bodies with a mesh (components FEM and BEM: "
       "ROLLCON_WITH_FEM and ROLLCON_WITH_BEM are OFF)");
}

}  // namespace

std::unique_ptr<Compliance> make_meshed_compliance(const Frame& /*frame*/, const PairOfBodies& /*pair*/, int /*which*/,
                                                   double /*accuracy*/, int /*threads*/) {
  refuse();
}

Vec3 displacement_beside(const Frame& /*frame*/, const PairOfBodies& /*pair*/, int /*which*/,
                         std::span<const double> /*traction*/, const Vec3& /*x*/) {
  refuse();
}

void require_supports(const BodyMesh& /*mesh*/, const RowMatrix<double>* /*stiffness*/) {
  refuse();
}

void refuse_incompressible_cavities(const BodyMesh& /*mesh*/, double /*poisson*/) {
  refuse();
}

}  // namespace rollcon
