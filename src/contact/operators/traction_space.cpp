#include "contact/operators/traction_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/coarsen.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

void end_row(SparseRows& rows) {
  rows.start.push_back(static_cast<std::int64_t>(rows.value.size()));
}

// Interpolates by barycentric coordinates in the triangle that the node lies in, or in the nearest one where rounding
// puts a node on an edge outside of all.
void interpolate(const Frame& fine, std::size_t k, const CoarseMesh& mesh, SparseRows& rows) {
  double best = -std::numeric_limits<double>::infinity();
  std::array<double, 3> weight{};
  const std::array<std::int32_t, 3>* in = nullptr;
  for (const auto& corner : mesh.corner) {
    const std::size_t a = at(mesh.node[at(corner[0])]), b = at(mesh.node[at(corner[1])]),
                      c = at(mesh.node[at(corner[2])]);
    const double ux = fine.x[b] - fine.x[a], uy = fine.y[b] - fine.y[a];
    const double vx = fine.x[c] - fine.x[a], vy = fine.y[c] - fine.y[a];
    const double px = fine.x[k] - fine.x[a], py = fine.y[k] - fine.y[a];
    const double area = ux * vy - uy * vx;
    const double wb = (px * vy - py * vx) / area, wc = (ux * py - uy * px) / area;
    const double least = std::min({1 - wb - wc, wb, wc});
    if (least > best) best = least, weight = {1 - wb - wc, wb, wc}, in = &corner;
  }
  constexpr double rounding = 1e-12;
  for (std::size_t i = 0; in && i < 3; ++i) {
    if (std::abs(weight[i]) < rounding) continue;
    rows.column.push_back((*in)[i]);
    rows.value.push_back(weight[i]);
  }
}

// Adds to[i] += sum over fine nodes of from[k] fine(k, i).
void add_columns(const TractionSpace& space, const double* from, double* to) {
  const SparseRows& rows = space.fine;
  for (std::size_t k = 0; k + 1 < rows.start.size(); ++k)
    for (auto j = at(rows.start[k]); j < at(rows.start[k + 1]); ++j) to[rows.column[j]] += rows.value[j] * from[k];
}

class SpaceCompliance final : public Compliance {
 public:
  SpaceCompliance(const Compliance& fine, const TractionSpace& space) : fine_(fine), space_(space) {}

  std::int64_t nodes() const override { return space_.frame.nodes(); }
  bool couples() const override { return fine_.couples(); }

  void block(Points points, const ComplianceBlock& out) const override {
    const std::size_t n = at(fine_.nodes()), m = points.size();
    ComplianceBlock rows;
    rows.stride = fine_.nodes();
    std::vector<double> buffer[3][3];
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        if (!out.a[r][c]) continue;
        buffer[r][c].resize(m * n);
        rows.a[r][c] = buffer[r][c].data();
      }
    fine_.block(points, rows);
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t p = 0; out.a[r][c] && p < m; ++p) {
          double* to = out.a[r][c] + static_cast<std::ptrdiff_t>(p) * out.stride;
          std::fill_n(to, nodes(), 0.0);
          add_columns(space_, buffer[r][c].data() + p * n, to);
        }
  }

  void apply(Points points, const double* traction, double* displacement) const override {
    const std::size_t m = at(nodes());
    std::vector<double> t(3 * at(fine_.nodes())), one(m);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < m; ++i) one[i] = traction[3 * i + c];
      const std::vector<double> all = spread(space_, one);
      for (std::size_t k = 0; k < all.size(); ++k) t[3 * k + c] = all[k];
    }
    fine_.apply(points, t.data(), displacement);
  }

  void set_threads(int) override {}
  std::int64_t kernel_evaluations() const override { return fine_.kernel_evaluations(); }
  std::size_t bytes() const override { return 0; }

 private:
  const Compliance& fine_;
  const TractionSpace& space_;
};

}  // namespace

TractionSpace coarse_space(const Frame& fine) {
  const CoarseMesh coarse = coarsen(fine);
  TractionSpace space;
  space.node = coarse.node;
  SurfaceMesh mesh;
  mesh.offset = {0};
  // Triangles are made in the plane: those of nodes that lie on a line there could stand steeply in space.
  const Axes& axes = fine.axes;
  for (const std::int32_t k : coarse.node)
    mesh.node.push_back(axes.origin + fine.x[at(k)] * axes.t1 + fine.y[at(k)] * axes.t2);
  for (const auto& corner : coarse.corner) {
    mesh.connectivity.insert(mesh.connectivity.end(), corner.begin(), corner.end());
    mesh.type.push_back(ElementType::tri3);
    mesh.tag.push_back(0);
    mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
  }
  space.frame = build_frame(std::move(mesh), fine.axes);
  if (fine.curved())
    for (const std::int32_t k : coarse.node) {
      space.frame.t1.push_back(fine.t1[at(k)]);
      space.frame.t2.push_back(fine.t2[at(k)]);
      space.frame.n.push_back(fine.n[at(k)]);
    }
  space.frame.section = fine.section;
  std::vector<std::int32_t> place(fine.used.size(), -1);
  for (std::size_t i = 0; i < coarse.node.size(); ++i) place[at(coarse.node[i])] = static_cast<std::int32_t>(i);
  space.fine.start = {0};
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] >= 0) {
      space.fine.column.push_back(place[k]);
      space.fine.value.push_back(1);
    } else if (fine.used[k]) {
      interpolate(fine, k, coarse, space.fine);
    }
    end_row(space.fine);
  }
  return space;
}

TractionSpace whole_space(const Frame& fine) {
  TractionSpace space{fine, {}, {}};
  space.fine.start.push_back(0);
  for (std::size_t k = 0; k < fine.x.size(); ++k) {
    space.node.push_back(static_cast<std::int32_t>(k));
    space.fine.column.push_back(static_cast<std::int32_t>(k));
    space.fine.value.push_back(1);
    end_row(space.fine);
  }
  return space;
}

TractionSpace loaded_space(const Frame& fine, const std::vector<double>& normal) {
  TractionSpace space;
  space.frame.axes = fine.axes;
  space.fine.start = {0};
  for (std::size_t k = 0; k < normal.size(); ++k) {
    if (normal[k] < 0) {
      space.fine.column.push_back(static_cast<std::int32_t>(space.node.size()));
      space.fine.value.push_back(1);
      space.node.push_back(static_cast<std::int32_t>(k));
      space.frame.mesh.node.push_back(fine.mesh.node[k]);
      space.frame.x.push_back(fine.x[k]);
      space.frame.y.push_back(fine.y[k]);
    }
    end_row(space.fine);
  }
  space.frame.used.assign(space.node.size(), 1);
  return space;
}

std::unique_ptr<Compliance> compliance_of(const Compliance& fine, const TractionSpace& space) {
  return std::make_unique<SpaceCompliance>(fine, space);
}

void take_normal_rows(const Operators& fine, const TractionSpace& space, DenseOperators& op) {
  const std::int64_t m = space.frame.nodes();
  for (int c = 0; c < 3; ++c) {
    if (!fine.row(2, c, 0)) continue;
    op.block[2][c].resize(m, m);
    for (std::int64_t i = 0; i < m; ++i) {
      double* to = op.block[2][c].row(i);
      std::fill_n(to, m, 0.0);
      add_columns(space, fine.row(2, c, at(space.node[at(i)])), to);
    }
  }
  op.normal = true;
  op.coupling_vanished = fine.coupling_vanished;
}

std::vector<double> gather(const TractionSpace& space, const std::vector<double>& fine) {
  if (fine.empty()) return {};
  std::vector<double> sums(space.node.size(), 0.0);
  add_columns(space, fine.data(), sums.data());
  return sums;
}

std::vector<double> pick(const TractionSpace& space, const std::vector<double>& fine) {
  std::vector<double> values;
  if (fine.empty()) return values;
  for (const std::int32_t k : space.node) values.push_back(fine[at(k)]);
  return values;
}

std::vector<double> spread(const TractionSpace& space, const std::vector<double>& unknowns) {
  const SparseRows& rows = space.fine;
  std::vector<double> fine(rows.start.size() - 1, 0.0);
  for (std::size_t k = 0; k < fine.size(); ++k)
    for (auto j = at(rows.start[k]); j < at(rows.start[k + 1]); ++j)
      fine[k] += rows.value[j] * unknowns[at(rows.column[j])];
  return fine;
}

}  // namespace rollcon
