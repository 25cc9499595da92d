#pragma once
/// Couples one element of a layer with the faces of a body under it; surface_coupling.hpp says how.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane_chart.hpp"
#include "geometry/surface_search.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Holds the integrals of N_i N_j for one node i of the body and all nodes j of the layer's element.
struct CoupledNode {
  std::int32_t node;
  std::array<double, max_element_nodes> value;
};

/// Couples the elements of a layer, one after the other, in one workspace.
class ElementCoupling {
 public:
  ElementCoupling(const SurfaceMesh& body, const SurfaceSearch& faces, const SurfaceMesh& layer)
      : body_(body), faces_(faces), layer_(layer), place_(static_cast<std::size_t>(body.nodes()), -1) {}

  /// Returns the faces near the element.
  std::span<const std::int64_t> candidates(std::int64_t element);
  /// Returns the integrals with the candidates found last.
  std::span<const CoupledNode> integrate(std::int64_t element);

 private:
  struct Side;  ///< one of the two elements that share a piece
  struct Under {
    std::int64_t face;
    double height;  ///< height of the face's middle above or below the element's
    std::vector<Polygon> part;
  };

  void project(const PlaneChart& chart, std::int64_t element);
  void pair(const Polygon& piece, Side& upper, Side& lower);
  void bare(const Polygon& piece, Side& upper);
  void slivers(const PlaneChart& chart, Side& upper);
  void at_point(const Vec2& y, double area, Side& upper);
  void add(const Shape& upper, std::int64_t face, const Shape& lower, double area);
  void to_nearest(std::int64_t element);
  void settle(std::int64_t element);
  CoupledNode& row(std::int32_t node);

  const SurfaceMesh& body_;
  const SurfaceSearch& faces_;
  const SurfaceMesh& layer_;
  std::vector<std::int64_t> candidate_;
  std::vector<Under> under_;
  std::vector<CoupledNode> row_;
  std::vector<std::int32_t> place_;  ///< index in row_ of each node of the body, -1: none
  std::size_t columns_ = 0;
};

}  // namespace rollcon
