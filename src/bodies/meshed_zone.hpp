#pragma once
/// Describes the faces of a body under a contact frame and around it: which of the body's nodes move a point of the
/// frame, and in which directions tractions and displacements there count.

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

/// Holds rows of a zone, and weights that sum them to the displacement of a point.
struct Interpolation {
  bool beyond = false;  ///< true: the point is over no element of the zone
  std::vector<std::int64_t> row;
  std::vector<double> weight;

  std::size_t size() const { return row.size(); }
  void add(std::int64_t to, double value) { row.push_back(to), weight.push_back(value); }
};

class MeshedZone {
 public:
  /// Finds the zone under a frame, which must outlive it.
  MeshedZone(const Frame& frame, const PairOfBodies& pair, int which);

  const Frame& frame;
  const PairOfBodies pair;
  const int which;
  const Body& body;
  const FrameOnBody on_body;
  std::vector<double> x, y;  ///< places of the response's rows, in the axes
  MeshOnFrame under;

  /// Lets a smooth displacement bend between the nodes of linear faces; locate() then adds that.
  void let_bend();
  Interpolation locate(double px, double py) const;
  /// Returns the row of the frame node that stands exactly here and is a node of the body; -1: none.
  std::int64_t row_of_node(double px, double py) const;
  /// Interpolates displacements u of all nodes by the elements' shape functions, as part of u1 - u2, in local
  /// components.
  Vec3 interpolate(double px, double py, std::span<const double> u) const;
  /// Returns the outline's column of each node of the frame; -1: none.
  std::vector<std::int64_t> columns(const SurfaceOutline& outline) const;
  /// Returns the directions of the local components at a point, in the body's axes.
  std::array<Vec3, 3> local_axes(double px, double py) const;
  /// Returns 1, or -1 for the second body of u1 - u2, which has the opposite tractions.
  double sign() const { return which == 0 ? 1 : -1; }

 private:
  SurfacePoint look(const SurfaceSearch& search, double px, double py, bool& beyond) const;
  void bend(double px, double py, Interpolation& where) const;

  /// Gives second derivatives xx, xy, yy of a field at a row, by the rows around it.
  struct Curvature {
    std::vector<std::int64_t> row;
    std::vector<std::array<double, 3>> weight;
  };
  Pose pose_;
  NormalField normals_;
  std::vector<std::int64_t> row_of_body_node_, elements_;
  std::map<std::pair<double, double>, std::int64_t> node_at_;  ///< rows of the frame nodes that are used, by place
  std::unique_ptr<SurfaceSearch> search_;
  std::vector<Curvature> curvature_;  ///< curvature at each row; empty: nothing bends
};

}  // namespace rollcon
