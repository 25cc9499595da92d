#pragma once
/// Holds what the choice of a rule needs to know of an element, in space or in a plane, or of a part of one.

#include "mesh/surface_mesh.hpp"
#include "quadrature/cell.hpp"

namespace rollcon::quadrature {

/// Classifies the smoothness of an element's map, which decides the polynomial degrees of the integrands.
enum class MapKind : std::uint8_t { affine, straight, curved };

/// Holds positions on a cell: corners, edge midpoints (numbered by the edge's first corner), centre.
struct CellShape {
  int corners = 4;
  Vec3 corner[4], middle[4], centre;
  double area = 0;
  double half_length = 0;  ///< half length of the longest side
  int depth = 0;           ///< how often the element was cut
};

struct ElementGeometry {
  ElementType type = ElementType::tri3;
  MapKind map = MapKind::affine;
  int nodes = 3, corners = 3;
  double node[3][max_element_nodes];  ///< node[component][k]
  CellShape shape;                    ///< shape of the whole element
  double half[2] = {0, 0};            ///< largest half-length along xi and along eta
  double radius = 0;                  ///< radius of the ball about the centre with all points of shape
  /// Degree in one direction of N times the Jacobian of an affine element, and what the map adds.
  int degree = 1, extra = 0;
  double log_departure = 0;  ///< log of the relative change of the normal vector, negative
  double bend = 0;           ///< largest squared change of the unit normal
  /// Logarithms, along xi and eta, of the ellipse's parameter up to which |normal vector| is analytic.
  double jacobian_log_rho[2] = {1, 1};
  /// Logarithm of the ratio in which terms fall after those of `degree`, where shape functions are series
  /// (plane_part.hpp); 0: polynomials.
  double series_log = 0;

  Vec3 position(Vec2 reference) const;
  /// Computes position and tangents.
  void tangents(Vec2 reference, Vec3& x, Vec3& d_xi, Vec3& d_eta) const;
};

ElementGeometry element_geometry(ElementType type, std::span<const Vec3> node);
/// Returns the element with all coordinates multiplied by `scale`.
ElementGeometry element_geometry(const SurfaceMesh& mesh, std::int64_t element, double scale);

/// Returns the shape of a part of the element.
CellShape measure(const ElementGeometry& element, const Cell& cell);

/// Returns the degree of shape function times Jacobian: in each reference direction of a quadrilateral, in all of a
/// triangle.
int direction_degree(ElementType type, MapKind map);
/// Returns the total degree along a ray from any point.
int ray_degree(ElementType type, MapKind map);

}  // namespace rollcon::quadrature
