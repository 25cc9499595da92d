#pragma once
/// Chooses the far field's rules by the distance of a whole pack of points from an element: the error model of
/// rule_selection.hpp has rho >= 1.9 R/a, R the distance and a the half-length, so that one comparison of R with a
/// product of an element's and a pack's factor does.

#include <vector>

#include "quadrature/rule_selection.hpp"

namespace rollcon::bem {

using namespace quadrature;

/// Limits the rules tried: 1 to this many points per direction, or triangle rules of degree 1 to twice that.
inline constexpr int far_levels = 6;

/// Holds points per direction, or the degree on triangles; 0: too near, ask select_rule for every point.
struct FarRule {
  int first = 0, second = 0;
};

/// Returns a power of two near the size of a mesh: coordinates divided by it lose nothing.
double size_near(const SurfaceMesh& mesh);
std::vector<ElementGeometry> geometries(const SurfaceMesh& mesh, double scale);

class FarField {
 public:
  /// Takes the tolerance of T for all packs; U has one for each pack.
  FarField(const std::vector<ElementGeometry>& elements, double tolerance_t);

  /// Holds powers of the pack's tolerance of U.
  struct PackFactors {
    explicit PackFactors(double tolerance_u);
    double power[2 * far_levels + 1];
  };

  /// Returns the rule for a pack whose points are at least at this distance from the element's centre.
  FarRule rule(std::size_t element, double distance, int terms, const PackFactors& pack) const;
  std::size_t bytes() const;

 private:
  struct Level {
    double t = 0;              ///< distance from which the rule is good enough for T
    double u[3] = {0, 0, 0};   ///< such distances for U with tolerance 1: kernel, map, Jacobian
    int exponent[2] = {0, 0};  ///< exponents of kernel and map; the Jacobian has 0
  };
  struct Element {
    double nearest = 0;
    bool triangle = false;
    Level level[2][far_levels];  ///< levels by direction
  };
  static Level level(const ElementGeometry& element, int direction, int exact, double tolerance_t);
  std::vector<Element> elements_;
};

}  // namespace rollcon::bem
