#pragma once
/// Declares the models of elastic bodies with a mesh. Each is a component of the build: where one is left out,
/// fem_absent.cpp, bem_absent.cpp and meshed_absent.cpp stand for it.

#include <map>
#include <memory>

#include "bodies/model/body_mesh.hpp"
#include "bodies/model/relaxation.hpp"
#include "bodies/model/surface_response.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon {

class SectionReader;

// Models take `saved`, what the response wrote to a file (Saved::save); null: they start from nothing.

namespace fem {
/// Throws err_unsupported, naming component and option, in a build without finite elements.
void require_support();
/// Returns the largest Poisson's ratio for which the element is accurate; beyond it bodies refuse it.
double largest_poisson(VolumeType type);
/// Makes the response of a finite-element body, see fem::System.
std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans,
                                         const std::map<std::int32_t, Elastic>& material, const BodyOptions& options,
                                         int threads, SectionReader* saved);
}  // namespace fem

namespace bem {
/// Throws err_unsupported, naming component and option, in a build without boundary elements.
void require_support();
/// Makes the response of a boundary-element body, see bem::System.
std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans, double young, double poisson,
                                         const BodyOptions& options, int threads, SectionReader* saved);
}  // namespace bem

namespace section {
/// Throws err_unsupported, naming component and option, in a build without them.
void require_support();
/// Refers to materials by tag, and to how those relax that do.
struct Materials {
  const std::map<std::int32_t, Elastic>& elastic;
  const std::map<std::int32_t, Relaxation>& relaxation;
};
/// Makes the response of a body that a section gives, see section::System.
std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans, const Materials& material,
                                         const BodyOptions& options, int threads, SectionReader* saved);
}  // namespace section

namespace condensed {
/// Throws err_unsupported, naming component and option, in a build without them.
void require_support();
/// Makes the response of a body whose matrix is given, see condensed::System.
std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans, const Elastic& contact,
                                         const BodyOptions& options, int threads, SectionReader* saved);
/// Returns the matrix of a body on the nodes of these faces, ascending, rows 3 * node + component.
RowMatrix<double> matrix_on_faces(MatrixForm form, const SurfaceMesh& surface, const std::vector<std::int64_t>& faces,
                                  Condensed& response, int threads);
}  // namespace condensed

}  // namespace rollcon
