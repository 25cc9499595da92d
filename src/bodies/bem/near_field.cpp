#include "bodies/bem/near_field.hpp"

namespace rollcon::bem {

void near_integrals(const ElementGeometry& element, const Vec3& point, const OnElement& on, Tolerance tolerance,
                    int terms, const KelvinConstants& constants, const Kernels& kernels, NearWorkspace& workspace,
                    NearIntegrals& integrals) {
  integrals = {};
  NearElement relative;
  relative.type = element.type;
  for (std::size_t j = 0; j < 3; ++j)
    for (int k = 0; k < element.nodes; ++k) relative.node[j][k] = element.node[j][k] - point[j];
  near_field(element, point, on, tolerance, (terms & double_layer) != 0, workspace,
             [&] { kernels.near(relative, workspace.points, constants, terms, integrals); });
}

}  // namespace rollcon::bem
