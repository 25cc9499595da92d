#include "bodies/bem/integrals/assembled_rows.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon::assembled_rows {
namespace {

void unpack(const std::vector<double>& packed, std::size_t first, std::size_t count, Rows& rows) {
  const auto columns = static_cast<std::size_t>(rows.columns);
  for (std::size_t p = 0; p < count; ++p)
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < 3; ++i)
          rows.value[(3 * (first + p) + i) * 3 * columns + 3 * j + c] = packed[((3 * j + c) * 3 + i) * bem::lanes + p];
}

}  // namespace

double Rows::largest() const {
  double worst = 0;
  for (const double v : value) worst = std::max(worst, std::abs(v));
  return worst;
}

std::vector<bem::CollocationPoint> all_nodes(const SurfaceMesh& mesh) {
  std::vector<bem::CollocationPoint> points;
  for (std::size_t i = 0; i < mesh.node.size(); ++i)
    points.push_back({mesh.node[i], static_cast<std::int32_t>(i), -1, 0, 0});
  return points;
}

System assemble(const bem::BoundaryIntegrals& integrals, const SurfaceMesh& mesh,
                std::span<const bem::CollocationPoint> points, bool double_layer, bool single_layer) {
  const auto columns = mesh.node.size(), size = 9 * columns * points.size();
  System system;
  system.h.columns = system.g.columns = mesh.nodes();
  if (double_layer) system.h.value.resize(size);
  if (single_layer) system.g.value.resize(size);
  std::vector<double> h(9 * bem::lanes * columns), g(h.size());
  for (std::size_t first = 0; first < points.size(); first += bem::lanes) {
    const std::size_t count = std::min<std::size_t>(bem::lanes, points.size() - first);
    integrals.rows(points.subspan(first, count), double_layer ? h.data() : nullptr, mesh.connectivity.data(),
                   mesh.nodes(), single_layer ? g.data() : nullptr);
    if (double_layer) unpack(h, first, count, system.h);
    if (single_layer) unpack(g, first, count, system.g);
  }
  return system;
}

double difference(const Rows& a, const Rows& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    const double d = std::abs(a.value[i] - b.value[i]);
    worst = d <= worst ? worst : d;  // a NaN stays
  }
  return worst;
}

}  // namespace rollcon::assembled_rows
