#include "bodies/displacement_beside.hpp"

#include <algorithm>

#include "bodies/meshed_zone.hpp"
#include "bodies/model/surface_response.hpp"
#include "mesh/shape.hpp"
#include "support/index.hpp"

namespace rollcon {

Vec3 displacement_beside(const Frame& frame, const PairOfBodies& pair, int which, std::span<const double> traction,
                         const Vec3& x) {
  const MeshedZone zone(frame, pair, which);
  const Pose& pose = pair.pose[at(which)];
  const SurfacePoint near = zone.body.search().nearest(pose.to_body(x));
  const SurfaceMesh& surface = zone.body.mesh().surface;
  const auto nodes = surface.element(near.element);
  LoadedSurface loaded = zone.on_body;
  loaded.row.insert(loaded.row.end(), nodes.begin(), nodes.end());
  std::sort(loaded.row.begin(), loaded.row.end());
  loaded.row.erase(std::unique(loaded.row.begin(), loaded.row.end()), loaded.row.end());
  const auto rows = zone.body.response()->rows(loaded, 1);
  const std::vector<std::int64_t> column = zone.columns(*rows);
  std::vector<double> force(3 * rows->column.size(), 0.0);
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (column[k] < 0) continue;
    const std::array<Vec3, 3> axis = zone.local_axes(frame.x[k], frame.y[k]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        force[3 * at(column[k]) + c] += zone.sign() * traction[3 * k + i] * axis[i][c];
  }
  Shape shape;
  evaluate_shape(surface.type[at(near.element)], near.xi, near.eta, shape);
  Vec3 moved{0, 0, 0};
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto row = std::find(rows->row.begin(), rows->row.end(), nodes[a]) - rows->row.begin();
    for (std::size_t c = 0; c < 3; ++c)
      moved[c] +=
          shape.value[a] * dot(rows->u.row(3 * row + static_cast<std::int64_t>(c)), force.data(), std::ssize(force));
  }
  return pose.turn(moved);
}

}  // namespace rollcon
