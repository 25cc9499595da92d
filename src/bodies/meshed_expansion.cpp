/// A meshed body's compliance with the body's unknowns written out.

#include <algorithm>
#include <utility>
#include <vector>

#include "bodies/meshed_compliance_class.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Sums of sparse columns, one after the other.
class ColumnWriter {
 public:
  ColumnWriter(std::int64_t rows, std::int64_t columns)
      : sum_(at(rows), 0.0), touched_(at(rows), 0) {
    result_.rows = rows;
    result_.columns = columns;
    result_.start.reserve(at(columns) + 1);
    result_.start.push_back(0);
  }
  void add(std::int64_t row, double value) {
    if (value == 0) return;
    if (!touched_[at(row)]) {
      touched_[at(row)] = 1;
      row_.push_back(row);
    }
    sum_[at(row)] += value;
  }
  void end_column() {
    std::sort(row_.begin(), row_.end());
    for (const std::int64_t r : row_) {
      result_.row.push_back(r);
      result_.value.push_back(sum_[at(r)]);
      sum_[at(r)] = 0;
      touched_[at(r)] = 0;
    }
    row_.clear();
    result_.start.push_back(static_cast<std::int64_t>(result_.row.size()));
  }
  SparseColumns take() { return std::move(result_); }

 private:
  SparseColumns result_;
  std::vector<double> sum_;
  std::vector<std::uint8_t> touched_;
  std::vector<std::int64_t> row_;  ///< of this column
};

}  // namespace

// From tractions in the body's axes to local ones at the frame's nodes.
SparseColumns MeshedCompliance::local_loads() const {
  const SparseColumns& load = loads_->load;
  const std::vector<std::int64_t> column = columns(*loads_);
  ColumnWriter writer(load.rows, 3 * frame_.nodes());
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

SparseColumns MeshedCompliance::local_displacements(Points points) const {
  ColumnWriter writer(loads_->load.rows, 3 * static_cast<std::int64_t>(points.size()));
  for (std::size_t p = 0; p < points.size(); ++p) {
    Interpolation where;
    if (const std::int64_t row = row_of_node(points.x[p], points.y[p]); row >= 0) {
      where.count = 1;
      where.row[0] = row;
      where.weight[0] = 1;
    } else {
      where = locate(points.x[p], points.y[p]);
    }
    LocalAxes local[max_element_nodes];  // at the body's nodes, as in the response
    for (int a = 0; a < where.count; ++a)
      local[a] = local_axes(zone_x_[at(where.row[a])], zone_y_[at(where.row[a])]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (int a = 0; a < where.count; ++a)
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
      for (int a = 0; a < where.count; ++a)
        axpy(-where.weight[a], halfspace_on_zone_.row(3 * where.row[a] + i), row, direct.columns());
    }
}

bool MeshedCompliance::expand(Points points, ExpandedCompliance& out) const {
  SurfaceResponse& body = *body_.response();
  if (!loads_)
    loads_ = on_body_.matches() ? body.loads_of_faces(on_body_.face, threads_)
                                : body.loads_of_layer(on_body_.layer, on_body_.row, threads_);
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
