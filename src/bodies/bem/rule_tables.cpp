#include "bodies/bem/rule_tables.hpp"

#include <cstddef>
#include <vector>

#include "mesh/shape.hpp"
#include "quadrature/rule_selection.hpp"
#include "quadrature/rules.hpp"

namespace rollcon::bem {
namespace {

struct Table {
  std::vector<double> data;
  RuleTable view;
};

Table tabulate(ElementType type, const PlaneRule& rule) {
  Table table;
  const auto nodes = static_cast<std::size_t>(node_count(type));
  const std::size_t n = rule.size();
  const std::size_t padded = (n + point_padding - 1) / point_padding * point_padding;
  table.data.assign((3 * nodes + 1) * padded, 0.0);
  double* value = table.data.data();
  double *d_xi = value + nodes * padded, *d_eta = d_xi + nodes * padded;
  double* w = d_eta + nodes * padded;
  for (std::size_t q = 0; q < padded; ++q) {
    const std::size_t k = q < n ? q : n - 1;
    Shape s;
    evaluate_shape(type, rule.xi[k], rule.eta[k], s);
    for (std::size_t i = 0; i < nodes; ++i) {
      value[i * padded + q] = s.value[i];
      d_xi[i * padded + q] = s.d_xi[i];
      d_eta[i * padded + q] = s.d_eta[i];
    }
    w[q] = q < n ? rule.w[k] : 0;
  }
  table.view = {static_cast<int>(n), static_cast<int>(padded), value, d_xi, d_eta, w};
  return table;
}

/// Quadrilaterals: entry (n1 - 1) * most_far_points + n2 - 1. Triangles: entry = degree.
std::vector<Table> tables_of(ElementType type) {
  std::vector<Table> tables;
  if (corner_count(type) == 4) {
    for (int n1 = 1; n1 <= most_far_points; ++n1)
      for (int n2 = 1; n2 <= most_far_points; ++n2)
        tables.push_back(tabulate(type, product_rule(quadrature::line_rule(n1), quadrature::line_rule(n2))));
    return tables;
  }
  for (int degree = 0; degree <= quadrature::most_triangle_degree; ++degree) {
    if (degree < 2) {
      tables.push_back(tabulate(type, {{1.0 / 3}, {1.0 / 3}, {0.5}}));
      continue;
    }
    for (const auto& rule : quadrature::symmetric_triangle_rules())
      if (rule.degree >= degree) {
        tables.push_back(tabulate(type, rule.points));
        break;
      }
  }
  return tables;
}

}  // namespace

const RuleTable& rule_table(ElementType type, int n1, int n2) {
  static const std::vector<Table> tri3 = tables_of(ElementType::tri3), tri6 = tables_of(ElementType::tri6),
                                  quad4 = tables_of(ElementType::quad4), quad8 = tables_of(ElementType::quad8),
                                  quad9 = tables_of(ElementType::quad9);
  const auto square = static_cast<std::size_t>((n1 - 1) * most_far_points + n2 - 1);
  switch (type) {
    case ElementType::tri3:
      return tri3[static_cast<std::size_t>(n1)].view;
    case ElementType::tri6:
      return tri6[static_cast<std::size_t>(n1)].view;
    case ElementType::quad4:
      return quad4[square].view;
    case ElementType::quad8:
      return quad8[square].view;
    default:
      return quad9[square].view;
  }
}

}  // namespace rollcon::bem
