/// Gives a meshed body's compliance with the body's unknowns written out.

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "bodies/meshed_compliance_class.hpp"
#include "support/index.hpp"

namespace rollcon {

const SurfaceLoads* ByShapeFunctions::require_loads() const {
  AsEquations* body = zone_.body.response()->as_equations();
  if (body && !loads_) loads_ = body->loads(zone_.on_body, threads_);
  return loads_.get();
}

// Turns tractions in the body's axes to local ones at the frame's nodes.
SparseMatrix ByShapeFunctions::local_loads() const {
  const SparseMatrix& load = loads_->load;
  const std::vector<std::int64_t> column = zone_.columns(*loads_);
  SparseBuilder writer(load.rows);
  for (std::size_t k = 0; k < column.size(); ++k) {
    const std::array<Vec3, 3> local = zone_.local_axes(zone_.frame.x[k], zone_.frame.y[k]);
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

SparseMatrix ByShapeFunctions::local_displacements(const std::vector<Group>& groups, std::size_t points) const {
  std::vector<const Interpolation*> of_point(points);
  for (const Group& group : groups)
    for (std::size_t b = 0; b < group.point.size(); ++b) of_point[group.point[b]] = &group.where[b];
  SparseBuilder writer(loads_->load.rows);
  for (const Interpolation* where : of_point) {
    std::vector<std::array<Vec3, 3>> local;  // axes at the body's nodes, as the response has them
    for (const std::int64_t row : where->row) local.push_back(zone_.local_axes(zone_.x[at(row)], zone_.y[at(row)]));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < where->size(); ++a)
        for (std::size_t b = 0; b < 3; ++b)
          if (const std::int64_t u = loads_->unknown[3 * at(where->row[a]) + b]; u >= 0)
            writer.add(u, where->weight[a] * local[a][i][b]);
      writer.end_column();
    }
  }
  return writer.take();
}

bool ByShapeFunctions::everywhere(const double* traction, SurfaceState& state) const {
  if (!require_loads()) return false;
  const std::vector<std::int64_t> column = zone_.columns(*loads_);
  std::vector<Vec3> on_body(loads_->column.size(), Vec3{0, 0, 0});
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (column[k] < 0) continue;
    const std::array<Vec3, 3> local = zone_.local_axes(zone_.frame.x[k], zone_.frame.y[k]);
    for (std::size_t i = 0; i < 3; ++i)
      on_body[at(column[k])] = on_body[at(column[k])] + zone_.sign() * traction[3 * k + i] * local[i];
  }
  const SparseMatrix& load = loads_->load;
  std::vector<double> b(at(load.rows), 0.0);
  for (std::size_t k = 0; k < 3 * on_body.size(); ++k)
    for (std::int64_t i = load.start[k]; i < load.start[k + 1]; ++i)
      b[at(load.row[at(i)])] += on_body[k / 3][k % 3] * load.value[at(i)];
  state.rate = zone_.on_body.rate;
  zone_.body.response()->as_equations()->solve_everywhere(b, state, threads_);
  if (!state.traction.empty()) add_tractions(on_body, state);
  return true;
}

void ByShapeFunctions::add_tractions(const std::vector<Vec3>& on_body, SurfaceState& state) const {
  if (!zone_.on_body.of_faces()) {
    state.layer = zone_.on_body.layer;
    for (const Vec3& t : on_body) state.layer_traction.insert(state.layer_traction.end(), t.begin(), t.end());
    return;
  }
  const SurfaceMesh& surface = zone_.body.mesh().surface;
  std::map<std::int32_t, std::size_t> column_of_node;
  for (std::size_t k = 0; k < on_body.size(); ++k) column_of_node[loads_->column[k]] = k;
  for (const std::int64_t e : zone_.on_body.face)
    for (std::int64_t k = surface.offset[at(e)]; k < surface.offset[at(e) + 1]; ++k) {
      const Vec3& t = on_body[column_of_node.at(surface.connectivity[at(k)])];
      for (std::size_t c = 0; c < 3; ++c) state.traction[3 * at(k) + c] += t[c];
    }
}

bool ByShapeFunctions::expand(Points points, ExpandedCompliance& out) const {
  if (!require_loads()) return false;
  ExpandedBody expanded;
  expanded.equations = zone_.body.response()->as_equations()->equations(threads_);
  if (!expanded.equations) return false;
  const std::vector<Group> all = groups(points);
  expanded.load = local_loads();
  expanded.displacement = local_displacements(all, points.size());
  out.body.push_back(std::move(expanded));
  for (const Group& group : all) add_local(group, points.size(), out);
  return true;
}

}  // namespace rollcon
