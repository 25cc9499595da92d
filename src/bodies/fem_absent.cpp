/// Stands for finite-element bodies, and those given by sections, in a build without them.

#include "bodies/model/mesh_models.hpp"
#include "bodies/nodal_loads.hpp"
#include "support/error.hpp"

namespace rollcon::fem {

void require_support() {
  fail(Status::err_unsupported,
       "kind is 1 (FEM), but this build of rollcon has no finite-element bodies (component FEM: "
       "ROLLCON_WITH_FEM is OFF, or neither CHOLMOD nor MUMPS is built in)");
}

// No call gets here: there is no body that could ask.
double largest_poisson(VolumeType /*type*/) {
  require_support();
  return 0;
}

std::unique_ptr<Condensed> make_response(const BodyMesh& /*mesh*/, const TractionNodes& /*fans*/,
                                         const std::map<std::int32_t, Elastic>& /*material*/,
                                         const BodyOptions& /*options*/, int /*threads*/, SectionReader* /*saved*/) {
  require_support();
  return nullptr;
}

}  // namespace rollcon::fem

namespace rollcon::section {

void require_support() {
  fail(Status::err_unsupported,
       "kind is 5 (SECTION), but this build of rollcon has no bodies given by sections (component FEM: "
       "ROLLCON_WITH_FEM is OFF, or neither CHOLMOD nor MUMPS is built in)");
}

std::unique_ptr<Condensed> make_response(const BodyMesh& /*mesh*/, const TractionNodes& /*fans*/,
                                         const Materials& /*material*/, const BodyOptions& /*options*/, int /*threads*/,
                                         SectionReader* /*saved*/) {
  require_support();
  return nullptr;
}

}  // namespace rollcon::section

namespace rollcon::condensed {

void require_support() {
  fail(Status::err_unsupported,
       "kind is 6 (CONDENSED), but this build of rollcon has no bodies given by a matrix (component FEM: "
       "ROLLCON_WITH_FEM is OFF, or CHOLMOD is not built in)");
}

std::unique_ptr<Condensed> make_response(const BodyMesh& /*mesh*/, const TractionNodes& /*fans*/,
                                         const Elastic& /*contact*/, const BodyOptions& /*options*/, int /*threads*/,
                                         SectionReader* /*saved*/) {
  require_support();
  return nullptr;
}

RowMatrix<double> matrix_on_faces(MatrixForm /*form*/, const SurfaceMesh& /*surface*/,
                                  const std::vector<std::int64_t>& /*faces*/, Condensed& /*response*/,
                                  int /*threads*/) {
  require_support();
  return {};
}

}  // namespace rollcon::condensed

namespace rollcon {

NodalLoads nodal_loads(const Frame& /*frame*/, const PairOfBodies& /*pair*/, int /*which*/,
                       std::span<const double> /*traction*/, const Resultant& /*contact*/) {
  fail(
      Status::err_unsupported,
      "this build of rollcon puts no contact on nodes (component FEM: ROLLCON_WITH_FEM is OFF, or CHOLMOD is not built "
      "in)");
}

}  // namespace rollcon
