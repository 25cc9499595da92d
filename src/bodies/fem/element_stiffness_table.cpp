#include "bodies/fem/element_stiffness_table.hpp"

#include <limits>

#include "mesh/volume_shape.hpp"

namespace rollcon::fem {
namespace {

/// degree: of the rule. The patch test on curved elements needs the integrals of dN/dx det J, whose degrees are 3
/// (tet10), 4 in the triangle and 5 along zeta (wedge15), 5 (hex20).
/// linear: reference directions in which the dilatation varies.
struct Formulation {
  int degree;
  std::vector<int> linear, bubble;
  double cap;
};

constexpr double uncapped = std::numeric_limits<double>::infinity();

Formulation formulation(VolumeType type, Hex8 hex8) {
  switch (type) {
    case VolumeType::tet4:
      return {1, {}, {}, uncapped};
    case VolumeType::tet10:
      return {3, {0, 1, 2}, {}, 4};
    case VolumeType::wedge6:
      return {2, {2}, {2}, uncapped};
    case VolumeType::wedge15:
      return {4, {0, 1, 2}, {}, 8};
    case VolumeType::hex8:
      if (hex8 == Hex8::b_bar) return {3, {}, {}, uncapped};
      return {3, {0, 1, 2}, {0, 1, 2}, uncapped};
    case VolumeType::hex20:
      return {5, {0, 1, 2}, {}, uncapped};
  }
  return {};
}

Vec3 centre_of(VolumeType type) {
  const int corners = corner_count(type);
  Vec3 centre{};
  for (const Vec3& node : reference_nodes(type).first(static_cast<std::size_t>(corners)))
    centre = centre + (1.0 / corners) * node;
  return centre;
}

void append_derivatives(VolumeType type, const Vec3& at, std::vector<double>& d) {
  VolumeShape shape;
  evaluate_shape(type, at, shape);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t i = 0; i < static_cast<std::size_t>(node_count(type)); ++i) d.push_back(shape.d[i][r]);
}

ElementTable make_table(VolumeType type, Hex8 hex8) {
  const Formulation chosen = formulation(type, hex8);
  const VolumeRule rule = volume_rule(type, chosen.degree);
  const Vec3 centre = centre_of(type);
  ElementTable table;
  table.nodes = node_count(type);
  table.points = static_cast<int>(rule.size());
  table.bubble = chosen.bubble;
  table.modes = 1 + static_cast<int>(chosen.linear.size());
  table.cap = chosen.cap;
  table.w = rule.w;
  append_derivatives(type, centre, table.centre);
  for (const Vec3& point : rule.point) {
    append_derivatives(type, point, table.d);
    table.offset.push_back(point - centre);
    table.mode.push_back(1);
    for (int r : chosen.linear) table.mode.push_back(table.offset.back()[static_cast<std::size_t>(r)]);
  }
  return table;
}

}  // namespace

const ElementTable& element_table(VolumeType type, Hex8 hex8) {
  static const OfEachElement<ElementTable> made(&make_table);
  return made.of(type, hex8);
}

}  // namespace rollcon::fem
