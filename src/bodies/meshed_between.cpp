/// A meshed body's displacements between its nodes: what is local, and what is interpolated.

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/meshed_compliance_class.hpp"
#include "bodies/remainder_compliance.hpp"
#include "mesh/quadratic_fit.hpp"
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
  const auto nodes = mesh.element(point.element);
  for (std::size_t a = 0; a < nodes.size(); ++a) where.add(row_of_body_node_[at(nodes[a])], shape.value[a]);
  if (!curvature_.empty() && !is_quadratic(mesh.type[at(point.element)])) bend(x, y, where);
  return where;
}

// A smooth displacement lies off what a linear face makes of its nodal values by half the mean, by the shape functions,
// of its second differences from the point to the nodes. Its curvatures are found at the nodes, so that it has no step
// between faces.
void MeshedCompliance::bend(double x, double y, Interpolation& where) const {
  const std::size_t own = where.size();
  for (std::size_t a = 0; a < own; ++a) {
    const std::size_t node = at(where.row[a]);
    const double dx = zone_x_[node] - x, dy = zone_y_[node] - y, half = -0.5 * where.weight[a];
    const Curvature& curvature = curvature_[node];
    for (std::size_t k = 0; k < curvature.row.size(); ++k) {
      const auto [xx, xy, yy] = curvature.weight[k];
      where.add(curvature.row[k], half * (xx * dx * dx + 2 * xy * dx * dy + yy * dy * dy));
    }
  }
}

// From the nodes of the faces around a node; from those around these, too, where it stands at an edge. Not from walls
// of the body, whose nodes stand below each other, and not where two materials meet, whose displacements have a kink.
void MeshedCompliance::find_curvatures(std::span<const std::int64_t> elements) {
  constexpr double steepest = 0.1;
  const BodyMesh& body = body_.mesh();
  const SurfaceMesh& mesh = body.surface;
  const Vec3 out = (which_ == 0 ? 1.0 : -1.0) * pose_.turn_back(frame_.axes.n);
  const auto material = [&](std::int64_t e) {
    return body.origin.empty() ? 0 : body.volume.tag[at(body.origin[at(e)].element)];
  };
  std::vector<std::vector<std::int64_t>> around(zone_x_.size());
  std::vector<std::int64_t> first(zone_x_.size(), -1);
  std::vector<std::uint8_t> kink(zone_x_.size(), 0);
  for (const std::int64_t e : elements) {
    const auto nodes = mesh.element(e);
    const auto corner = [&](std::size_t i) { return mesh.node[at(nodes[i])]; };
    const std::size_t last = at(corner_count(mesh.type[at(e)])) - 1;
    const Vec3 normal = cross(corner(1) - corner(0), corner(last) - corner(0));
    if (dot(normal, out) < steepest * std::sqrt(dot(normal, normal))) continue;
    for (const std::int32_t a : nodes) {
      const std::size_t row = at(row_of_body_node_[at(a)]);
      if (first[row] < 0) first[row] = e;
      kink[row] = kink[row] || material(e) != material(first[row]);
      for (const std::int32_t b : nodes) around[row].push_back(row_of_body_node_[at(b)]);
    }
  }
  const auto sort = [](std::vector<std::int64_t>& rows) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  };
  for (auto& rows : around) sort(rows);
  curvature_.resize(around.size());
  std::vector<double> x, y;
  for (std::size_t r = 0; r < around.size(); ++r) {
    if (kink[r]) continue;
    Curvature& found = curvature_[r];
    found.row = around[r];
    for (int rings = 1; rings <= 2; ++rings) {
      x.clear(), y.clear();
      for (const std::int64_t k : found.row) x.push_back(zone_x_[at(k)]), y.push_back(zone_y_[at(k)]);
      found.weight = curvature_weights(x, y);
      if (!found.weight.empty() || rings == 2) break;
      for (const std::int64_t k : around[r])
        found.row.insert(found.row.end(), around[at(k)].begin(), around[at(k)].end());
      sort(found.row);
    }
    if (found.weight.empty()) found.row.clear();
  }
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
