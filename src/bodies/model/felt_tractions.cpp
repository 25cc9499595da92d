#include "bodies/model/felt_tractions.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/surface_quadrature.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Returns the lower triangle of a coupling of faces with themselves, nodes numbered by place.
SparseMatrix symmetric(const SurfaceCoupling& mass, const std::vector<std::int64_t>& place) {
  SparseMatrix matrix;
  matrix.begin(mass.columns);
  for (std::int64_t i = 0; i < mass.columns; ++i) {
    for (std::int64_t k = mass.start[at(i)]; k < mass.start[at(i) + 1]; ++k)
      if (const std::int64_t j = place[at(mass.row[at(k)])]; j >= i) matrix.push(j, mass.value[at(k)]);
    matrix.end_column();
  }
  return matrix;
}

/// Computes share^2 int d N_i . d N_j over one face, row by row, with derivatives over the face's own size in each
/// direction: by the coordinates of a square or an equilateral triangle of unit sides.
void element_smoothing(const SurfaceMesh& surface, std::int64_t e, double share, double* out) {
  const bool three = corner_count(surface.type[at(e)]) == 3;
  const auto nodes = surface.element(e);
  const std::size_t n = nodes.size();
  std::fill_n(out, n * n, 0.0);
  double du[max_element_nodes], dv[max_element_nodes];
  for (const auto& [weight, shape] : tabulated<5>(surface.type[at(e)])) {
    const double area = length(combine(surface, e, shape, surface.node[at(nodes[0])]).normal);
    for (std::size_t i = 0; i < n; ++i) {
      du[i] = three ? shape.d_xi[i] : 2 * shape.d_xi[i];
      dv[i] = three ? (2 * shape.d_eta[i] - shape.d_xi[i]) / std::sqrt(3.0) : 2 * shape.d_eta[i];
    }
    const double w = weight * area * share * share;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) out[i * n + j] += w * (du[i] * du[j] + dv[i] * dv[j]);
  }
}

void add_smoothing(const SurfaceMesh& surface, std::span<const std::int64_t> face, std::span<const double> share,
                   const std::vector<std::int64_t>& place, SparseMatrix& matrix) {
  double part[max_element_nodes * max_element_nodes];
  for (std::size_t f = 0; f < face.size(); ++f) {
    if (share[f] == 0) continue;
    const auto nodes = surface.element(face[f]);
    element_smoothing(surface, face[f], share[f], part);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t b = 0; b < nodes.size(); ++b) {
        const std::int64_t column = place[at(nodes[a])], row = place[at(nodes[b])];
        if (row < column) continue;
        const auto begin = matrix.row.begin() + matrix.start[at(column)];
        const auto found = std::lower_bound(begin, matrix.row.begin() + matrix.start[at(column) + 1], row);
        matrix.value[at(found - matrix.row.begin())] += part[a * nodes.size() + b];
      }
  }
}

/// Returns the mean square of the spacing of the columns' nodes around each row's: their areas, weighted.
std::vector<double> frame_spacing(const SurfaceCoupling& coupling, std::int64_t nodes) {
  std::vector<double> area;  // areas of the frame's nodes
  for (std::size_t k = 0; k < coupling.row.size(); ++k) {
    if (area.size() <= at(coupling.row[k])) area.resize(at(coupling.row[k]) + 1, 0.0);
    area[at(coupling.row[k])] += coupling.value[k];
  }
  std::vector<double> spacing(at(nodes), 0.0);
  for (std::size_t r = 0; r < coupling.node.size(); ++r) {
    double sum = 0, weight = 0;
    for (std::int64_t k = coupling.start[r]; k < coupling.start[r + 1]; ++k) {
      const double w = std::abs(coupling.value[at(k)]);
      sum += w * std::abs(area[at(coupling.row[at(k)])]);
      weight += w;
    }
    if (weight > 0) spacing[at(coupling.node[r])] = sum / weight;
  }
  return spacing;
}

}  // namespace

RowMatrix<double> columns_of(const SurfaceCoupling& coupling, std::span<const std::int32_t> column) {
  RowMatrix<double> load;
  load.resize(static_cast<std::int64_t>(coupling.node.size()), static_cast<std::int64_t>(column.size()));
  for (std::size_t r = 0; r < coupling.node.size(); ++r)
    for (std::int64_t k = coupling.start[r]; k < coupling.start[r + 1]; ++k) {
      const auto found = std::lower_bound(column.begin(), column.end(), coupling.row[at(k)]);
      load.row(static_cast<std::int64_t>(r))[found - column.begin()] = coupling.value[at(k)];
    }
  return load;
}

std::vector<double> smoothing_shares(const SurfaceMesh& surface, const TractionNodes& fans,
                                     std::span<const std::int64_t> face, const SurfaceCoupling& coupling) {
  const std::vector<double> frame = frame_spacing(coupling, surface.nodes());
  std::vector<double> share;
  for (const std::int64_t e : face) {
    const auto nodes = surface.element(e);
    bool sharp = false;
    double there = 0, known = 0;
    for (const std::int32_t k : nodes) {
      sharp = sharp || fans.start[at(k) + 1] - fans.start[at(k)] > 1;
      there += frame[at(k)];
      known += frame[at(k)] > 0;
    }
    const double per_node = is_quadratic(surface.type[at(e)]) ? 4 : 1;
    const double own = element_area(surface, e) / per_node;
    const double excess = known > 0 ? own - there / known : own;
    share.push_back(sharp || excess <= 0 ? 0 : excess / own / std::sqrt(per_node));
  }
  return share;
}

FeltTractions felt_tractions(const SurfaceMesh& surface, std::span<const std::int64_t> face,
                             std::span<const double> share, const SurfaceCoupling& coupling,
                             std::span<const std::int32_t> column) {
  const SurfaceCoupling mass = couple_faces(surface, face);
  FeltTractions felt;
  felt.node = mass.node;
  const auto n = static_cast<std::int64_t>(mass.node.size());
  const auto columns = static_cast<std::int64_t>(column.size());
  std::vector<std::int64_t> place(at(surface.nodes()), -1);
  for (std::int64_t i = 0; i < n; ++i) place[at(mass.node[at(i)])] = i;
  SparseMatrix matrix = symmetric(mass, place);
  add_smoothing(surface, face, share, place, matrix);
  const auto factor = factor_definite(matrix, {});

  // B, column by column, then solved in place.
  std::vector<std::int64_t> number;
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (number.size() <= at(column[k])) number.resize(at(column[k]) + 1, -1);
    number[at(column[k])] = static_cast<std::int64_t>(k);
  }
  std::vector<double> b(at(n * columns), 0.0);
  for (std::size_t r = 0; r < coupling.node.size(); ++r)
    for (std::int64_t k = coupling.start[r]; k < coupling.start[r + 1]; ++k)
      b[at(number[at(coupling.row[at(k)])] * n + place[at(coupling.node[r])])] = coupling.value[at(k)];
  factor->solve(b.data(), columns);
  felt.traction.resize(n, columns);
  felt.load.resize(n, columns);
  for (std::int64_t i = 0; i < n; ++i) {
    double* traction = felt.traction.row(i);
    double* load = felt.load.row(i);
    for (std::int64_t c = 0; c < columns; ++c) {
      const double* s = b.data() + c * n;
      traction[c] = s[i];
      double sum = 0;
      for (std::int64_t k = mass.start[at(i)]; k < mass.start[at(i) + 1]; ++k)
        sum += mass.value[at(k)] * s[place[at(mass.row[at(k)])]];
      load[c] = sum;
    }
  }
  return felt;
}

}  // namespace rollcon
