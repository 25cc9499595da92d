/// A meshed body's compliance with the body's unknowns written out.

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "bodies/meshed_compliance_class.hpp"
#include "support/index.hpp"

namespace rollcon {
// From tractions in the body's axes to local ones at the frame's nodes.
SparseMatrix MeshedCompliance::local_loads() const {
  const SparseMatrix& load = loads_->load;
  const std::vector<std::int64_t> column = columns(*loads_);
  SparseBuilder writer(load.rows);
  for (std::size_t k = 0; k < column.size(); ++k) {
    const LocalAxes local = local_axes(frame_.x[k], frame_.y[k]);
    for (const Vec3& direction : local) {
      for (std::size_t b = 0; column[k] >= 0 && b < 3; ++b) {
        if (direction[b] == 0) continue;
        const std::size_t from = 3 * at(column[k]) + b;
        for (std::int64_t i = load.start[from]; i < load.start[from + 1]; ++i)
          writer.add(load.row[at(i)], direction[b] * load.value[at(i)]);
      }
      writer.end_column();
    }
  }
  return writer.take();
}

SparseMatrix MeshedCompliance::local_displacements(Points points) const {
  SparseBuilder writer(loads_->load.rows);
  for (std::size_t p = 0; p < points.size(); ++p) {
    Interpolation where;
    if (const std::int64_t row = row_of_node(points.x[p], points.y[p]); row >= 0) {
      where.add(row, 1);
    } else {
      where = locate(points.x[p], points.y[p]);
    }
    std::vector<LocalAxes> local;  // at the body's nodes, as in the response
    for (const std::int64_t row : where.row) local.push_back(local_axes(zone_x_[at(row)], zone_y_[at(row)]));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < where.size(); ++a)
        for (std::size_t b = 0; b < 3; ++b)
          if (const std::int64_t u = loads_->unknown[3 * at(where.row[a]) + b]; u >= 0)
            writer.add(u, where.weight[a] * local[a][i][b]);
      writer.end_column();
    }
  }
  return writer.take();
}

void MeshedCompliance::subtract_interpolated(const Others& group, RowMatrix<double>& direct) const {
  require_halfspace_on_zone();
  for (std::size_t b = 0; b < group.point.size(); ++b)
    for (std::int64_t i = 0; i < 3; ++i) {
      double* row = direct.row(3 * static_cast<std::int64_t>(group.point[b]) + i);
      const Interpolation& where = group.where[b];
      for (std::size_t a = 0; a < where.size(); ++a)
        axpy(-where.weight[a], halfspace_on_zone_.row(3 * where.row[a] + i), row, direct.columns());
    }
}

bool MeshedCompliance::everywhere(const double* traction, SurfaceState& state) const {
  SurfaceResponse& body = *body_.response();
  if (!loads_) loads_ = body.loads(on_body_, threads_);
  const double sign = which_ == 0 ? 1 : -1;  // the second body has the opposite tractions
  const std::vector<std::int64_t> column = columns(*loads_);
  std::vector<Vec3> on_body(loads_->column.size(), Vec3{0, 0, 0});
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (column[k] < 0) continue;
    const LocalAxes local = local_axes(frame_.x[k], frame_.y[k]);
    for (std::size_t i = 0; i < 3; ++i)
      on_body[at(column[k])] = on_body[at(column[k])] + sign * traction[3 * k + i] * local[i];
  }
  const SparseMatrix& load = loads_->load;
  std::vector<double> b(at(load.rows), 0.0);
  for (std::size_t k = 0; k < 3 * on_body.size(); ++k)
    for (std::int64_t i = load.start[k]; i < load.start[k + 1]; ++i)
      b[at(load.row[at(i)])] += on_body[k / 3][k % 3] * load.value[at(i)];
  body.solve_everywhere(b, state, threads_);
  if (!state.traction.empty()) add_tractions(on_body, state);
  return true;
}

void MeshedCompliance::add_tractions(const std::vector<Vec3>& on_body, SurfaceState& state) const {
  if (!on_body_.of_faces()) {
    state.layer = on_body_.layer;
    for (const Vec3& t : on_body) state.layer_traction.insert(state.layer_traction.end(), t.begin(), t.end());
    return;
  }
  const SurfaceMesh& surface = body_.mesh().surface;
  std::map<std::int32_t, std::size_t> column_of_node;
  for (std::size_t k = 0; k < on_body.size(); ++k) column_of_node[loads_->column[k]] = k;
  for (const std::int64_t e : on_body_.face)
    for (std::int64_t k = surface.offset[at(e)]; k < surface.offset[at(e) + 1]; ++k) {
      const Vec3& t = on_body[column_of_node.at(surface.connectivity[at(k)])];
      for (std::size_t c = 0; c < 3; ++c) state.traction[3 * at(k) + c] += t[c];
    }
}

bool MeshedCompliance::expand(Points points, ExpandedCompliance& out) const {
  SurfaceResponse& body = *body_.response();
  if (!loads_) loads_ = body.loads(on_body_, threads_);
  ExpandedBody expanded;
  expanded.equations = body.equations(threads_);
  expanded.load = local_loads();
  expanded.displacement = local_displacements(points);
  out.body.push_back(std::move(expanded));

  const std::array<Others, 2> groups = others(points);
  for (const Others& group : groups) {
    if (group.point.empty()) continue;
    const Local local = local_part(&group == &groups[1]);
    if (!local.compliance) continue;
    require_direct(static_cast<std::int64_t>(points.size()), frame_.nodes(), out);
    add_block(*local.compliance, {group.x, group.y}, group.point, out.direct);
    if (local.corrects) subtract_interpolated(group, out.direct);
  }
  return true;
}

}  // namespace rollcon
