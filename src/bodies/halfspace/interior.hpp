#pragma once
/// Computes stresses and displacements inside an elastic half-space z >= 0 from tractions on its surface that a frame's
/// shape functions interpolate (docs/theory.md, inside of half-spaces).
///
/// Elements near a point are integrated by the rules of near_field.hpp, those farther off by one Gauss rule that is
/// enough for their distance, and boxes of them, farther still, by forces on a grid (source_tree.hpp). On the surface
/// the integrals are limits: there they are taken at a depth of 1e-8 of the smallest element, which changes stresses by
/// about 1e-7 of the largest traction, but grows like a logarithm with it where tractions jump.

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/halfspace/source_tree.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

class HalfspaceInterior {
 public:
  struct Material {
    double shear, poisson;
  };

  /// Copies what it needs. traction[3 * node + j]: on the half-space, along x, y, z (z into the body). accuracy: error
  /// of every stress relative to the largest component of the tractions.
  HalfspaceInterior(const Frame& frame, const double* traction, Material material, double accuracy);

  /// Returns stresses xx, yy, zz, xy, xz, yz and three displacements at each point (x, y, z), z >= 0; either may be
  /// null. Throws Cancelled.
  void evaluate(std::int64_t points, const double* xyz, double* stress, double* displacement, int threads) const;

 private:
  struct Rule {
    double least_distance2;  ///< squared distance over that of half an element's longest side
    halfspace::NearPoints points;
  };
  struct Workspace;

  const std::vector<Rule>& rules(const halfspace::LoadedElement& e) const;
  void near(const halfspace::LoadedElement& e, const halfspace::InteriorPoint& at, Workspace& w) const;
  void add_element(const halfspace::LoadedElement& e, const halfspace::InteriorPoint& at, Workspace& w) const;
  void add_all(const halfspace::SourceTree* tree, const halfspace::InteriorPoint& at, Workspace& w) const;

  Material material_;
  double largest_ = 0, least_depth_ = 0, accuracy_;
  std::vector<halfspace::LoadedElement> elements_;
  /// Rules by the element's number of nodes and its kind of map; empty: there are no such elements.
  std::vector<Rule> rules_[max_element_nodes + 1][3];
};

}  // namespace rollcon
