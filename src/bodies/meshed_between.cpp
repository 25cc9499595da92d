/// A meshed body's displacements between its nodes: what is local, and what is interpolated.

#include <utility>

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/meshed_compliance_class.hpp"
#include "bodies/remainder_compliance.hpp"
#include "support/index.hpp"

namespace rollcon {

// Boundary elements: what a half-space does, and the difference, which is smooth. Under the load of a single node
// finite elements move by what the mesh does not resolve: their difference is not smooth. On faces of their own shape
// functions serve; under a layer the remainder goes to a half-space. Beyond the zone, where its rim's displacement
// would be all, they take the difference.
MeshedCompliance::Local MeshedCompliance::local_part(bool beyond) const {
  if (by_shape_functions()) return {};
  if (body_.traits().smooth_difference || beyond) {
    if (!halfspace_) {
      const bool seen = outline().young > 0;
      halfspace_ = make_halfspace_compliance(
          frame_,
          halfspace_constants(seen ? outline().young : body_.young(), seen ? outline().poisson : body_.poisson(),
                              which_ == 0 ? 1 : -1),
          accuracy_, threads_);
    }
    return {halfspace_.get(), true};
  }
  if (outline().seen.rows() > 0 && !remainder_)
    remainder_ = make_remainder_compliance(frame_, pair_, which_, outline(), accuracy_, threads_);
  return {remainder_.get(), false};
}

MeshedCompliance::Between MeshedCompliance::between(bool beyond) const {
  const Local local = local_part(beyond);
  if (!local.corrects) return {local.compliance, &response_};
  if (correction_.empty()) {
    require_halfspace_on_zone();
    correction_.resize(response_.rows(), response_.columns());
    for (std::int64_t r = 0; r < response_.rows(); ++r)
      for (std::int64_t k = 0; k < response_.columns(); ++k)
        correction_.row(r)[k] = response_.row(r)[k] - halfspace_on_zone_.row(r)[k];
    halfspace_on_zone_.release();
  }
  return {local.compliance, &correction_};
}

void MeshedCompliance::require_halfspace_on_zone() const {
  if (!halfspace_on_zone_.empty()) return;
  ExpandedCompliance zone;
  add_direct(*halfspace_, {zone_x_, zone_y_}, zone);
  halfspace_on_zone_ = std::move(zone.direct);
}

std::int64_t MeshedCompliance::row_of_node(double x, double y) const {
  const auto found = node_at_.find({x, y});
  if (found == node_at_.end()) return -1;
  if (!by_shape_functions() && outline().seen.rows() > 0) return -1;  // the remainder moves nodes
  const std::int32_t node = on_body_.node[at(found->second)];
  return node < 0 ? -1 : row_of_body_node_[at(node)];
}

MeshedCompliance::Interpolation MeshedCompliance::locate(double x, double y) const {
  const Vec3 from = pose_.to_body(plane_point(frame_.axes, x, y));
  const Vec3 direction = pose_.turn_back(frame_.axes.n);
  const auto hit = zone_->along(from, direction, (which_ == 0 ? 1.0 : -1.0) * direction);
  const SurfacePoint point = hit ? *hit : zone_->nearest(from);
  const SurfaceMesh& mesh = body_.mesh().surface;
  Shape shape;
  evaluate_shape(mesh.type[at(point.element)], point.xi, point.eta, shape);
  Interpolation where;
  where.beyond = !hit;
  for (const std::int32_t k : mesh.element(point.element)) {
    where.weight[where.count] = shape.value[static_cast<std::size_t>(where.count)];
    where.row[where.count] = row_of_body_node_[at(k)];
    ++where.count;
  }
  return where;
}

std::array<MeshedCompliance::Others, 2> MeshedCompliance::others(Points points) const {
  std::array<Others, 2> result;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (row_of_node(points.x[p], points.y[p]) >= 0) continue;
    const Interpolation where = locate(points.x[p], points.y[p]);
    Others& group = result[where.beyond ? 1 : 0];
    group.x.push_back(points.x[p]);
    group.y.push_back(points.y[p]);
    group.point.push_back(p);
    group.where.push_back(where);
  }
  return result;
}

}  // namespace rollcon
