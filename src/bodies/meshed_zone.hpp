#pragma once
/// The faces of a body under a contact frame and around it: which of the body's nodes move a point of the frame, and in
/// which directions tractions and displacements there count.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "bodies/frame_on_body.hpp"
#include "geometry/surface_search.hpp"

namespace rollcon {

/// Rows of a zone, and weights that sum them to the displacement of a point.
struct Interpolation {
  bool beyond = false;  ///< the point is over no element of the zone
  std::vector<std::int64_t> row;
  std::vector<double> weight;

  std::size_t size() const { return row.size(); }
  void add(std::int64_t to, double value) { row.push_back(to), weight.push_back(value); }
};

class MeshedZone {
 public:
  /// The frame must outlive it.
  MeshedZone(const Frame& frame, const PairOfBodies& pair, int which);

  const Frame& frame;
  const PairOfBodies pair;
  const int which;
  const Body& body;
  const FrameOnBody on_body;
  std::vector<double> x, y;  ///< rows of the response, in the axes
  MeshOnFrame under;

  /// Lets a smooth displacement bend between the nodes of linear faces; locate() then adds that.
  void let_bend();
  Interpolation locate(double px, double py) const;
  /// Row of the frame node that stands exactly here and is a node of the body; -1: none.
  std::int64_t row_of_node(double px, double py) const;
  /// Displacement there by the elements' shape functions, as part of u1 - u2 in local components; u: of every node.
  Vec3 interpolate(double px, double py, std::span<const double> u) const;
  /// The outline's column of each node of the frame; -1: none.
  std::vector<std::int64_t> columns(const SurfaceOutline& outline) const;
  /// Directions of the local components there, in the body's axes.
  std::array<Vec3, 3> local_axes(double px, double py) const;
  /// 1, or -1 for the second body of u1 - u2, which has the opposite tractions.
  double sign() const { return which == 0 ? 1 : -1; }

 private:
  SurfacePoint look(const SurfaceSearch& search, double px, double py, bool& beyond) const;
  void bend(double px, double py, Interpolation& where) const;

  /// Second derivatives xx, xy, yy of a field at a row, by the rows around it.
  struct Curvature {
    std::vector<std::int64_t> row;
    std::vector<std::array<double, 3>> weight;
  };
  Pose pose_;
  NormalField normals_;
  std::vector<std::int64_t> row_of_body_node_, elements_;
  std::map<std::pair<double, double>, std::int64_t> node_at_;  ///< frame nodes that are used
  std::unique_ptr<SurfaceSearch> search_;
  std::vector<Curvature> curvature_;  ///< at each row; empty: nothing bends
};

}  // namespace rollcon
