#include "mesh/frame_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/element_sides.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/overlap.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// cos 60 degrees: the frame's slope against the tangent plane.
constexpr double smallest_cosine = 0.5;

struct Sign {
  bool positive = false, negative = false, vanishing = false, steep = false;
};

/// Returns the signs of the Jacobian over the check points, with coordinates divided by the element's size.
Sign jacobian_signs(std::span<const Vec3> point, double size, const std::vector<CheckPoint>& looked_at,
                    double tolerance) {
  Sign sign;
  for (const CheckPoint& p : looked_at) {
    const Shape& s = p.shape;
    double u[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    for (std::size_t i = 0; i < point.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double c = (point[i][k] - point[0][k]) / size;
        u[k] += s.d_xi[i] * c;
        v[k] += s.d_eta[i] * c;
      }
    const double n = u[0] * v[1] - u[1] * v[0];
    const double whole = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], n);
    if (whole <= tolerance)
      sign.vanishing = true;
    else if (std::abs(n) < smallest_cosine * whole)
      sign.steep = true;
    else
      (n > 0 ? sign.positive : sign.negative) = true;
  }
  return sign;
}

}  // namespace

void check_connectivity(const SurfaceMesh& mesh) {
  if (mesh.elements() == 0) fail(Status::err_mesh, "the contact frame has no elements");
  check_connectivity(Names<SurfaceMesh>{mesh, mesh.index_base, "frame"}, mesh.nodes());
}

void check_elements(const SurfaceMesh& mesh, std::span<const double> x, std::span<const double> y,
                    std::span<const double> z) {
  const Names<SurfaceMesh> names{mesh, mesh.index_base, "frame"};
  Tally degenerate, flipped, folded, steep;
  const auto look = [&](const ShapeToCheck& shape) {
    const double tolerance = std::max(smallest_ratio, shape.noise);
    const Sign sign = jacobian_signs(shape.node, shape.size, shape.points, tolerance);
    Tally* found = sign.vanishing                   ? &degenerate
                   : sign.positive && sign.negative ? &folded
                   : sign.steep                     ? &steep
                   : sign.negative                  ? &flipped
                                                    : nullptr;
    if (found) found->add("element %lld (%s)", names.element(shape.element), names.type(shape.element));
  };
  look_at_shapes(
      names,
      [&](std::size_t k) {
        return Vec3{x[k], y[k], z[k]};
      },
      look);
  names.refuse(degenerate, "degenerate element: its Jacobian vanishes");
  names.refuse(folded, "degenerate element: its Jacobian changes sign");
  if (flipped.count == mesh.elements())
    names.refuse(flipped,
                 "all elements look away from the normal n (flipped: clockwise seen from its tip): turn n "
                 "(rollcon_contact_set_axes), or reverse the order of their nodes");
  if (steep.count > 0)
    names.refuse(flipped,
                 "the frame bends away from the normal n, as one closed about an axis does; a contact has one tangent "
                 "plane (rollcon_contact_set_axes) and takes faces within 60 degrees of it: give it those of a part of "
                 "the circumference. Element that looks away from n");
  names.refuse(flipped,
               "element that looks away from the normal n (flipped: clockwise seen from its tip): reverse the order of "
               "its nodes, or leave the faces of a far side out");
  names.refuse(steep,
               "element steeper than 60 degrees against the tangent plane of the axes "
               "(rollcon_contact_set_axes sets it)");
}

namespace {

/// Checks that edges between corners carry one midside node (or none) in both of their elements.
void check_midsides(const Names<SurfaceMesh>& names) {
  if (std::none_of(names.mesh.type.begin(), names.mesh.type.end(), [](ElementType t) { return is_quadratic(t); }))
    return;
  Tally differ;
  for_each_edge(sorted_sides(corner_cells(names.mesh)), [&](const Side& s, std::size_t count) {
    const Side* all = &s;
    for (std::size_t i = 1; i < count; ++i)
      if (midside_node(names.mesh, all[i - 1]) != midside_node(names.mesh, all[i]))
        differ.add("edge %lld-%lld of elements %lld and %lld", names.node(s.low()), names.node(s.high()),
                   names.element(all[i - 1].cell), names.element(all[i].cell));
  });
  names.refuse(differ, "two elements share an edge but not its midside node");
}

}  // namespace

void check_cells(const SurfaceMesh& mesh, const LinearCells& cells, std::span<const Side> side,
                 std::span<const double> x, std::span<const double> y) {
  const Names<SurfaceMesh> names{mesh, mesh.index_base, "frame"};
  auto element_id = [&](std::int64_t cell) { return names.element(cells.element[at(cell)]); };
  Tally crowded, same_side, concave;
  for_each_edge(side, [&](const Side& s, std::size_t count) {
    const Side* all = &s;
    if (count > 2)
      crowded.add("edge %lld-%lld with %lld elements (%lld, %lld, %lld, ...)", names.node(s.low()),
                  names.node(s.high()), static_cast<long long>(count), element_id(all[0].cell), element_id(all[1].cell),
                  element_id(all[2].cell));
    else if (count == 2 && all[0].from == all[1].from)
      same_side.add("elements %lld and %lld on edge %lld-%lld", element_id(all[0].cell), element_id(all[1].cell),
                    names.node(s.low()), names.node(s.high()));
  });
  names.refuse(crowded, "more than two elements share an edge");
  names.refuse(same_side, "two elements lie on the same side of their common edge");
  check_midsides(names);

  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    for (std::size_t i = 0; i < n.size(); ++i) {
      const std::size_t a = at(n[(i + n.size() - 1) % n.size()]), b = at(n[i]), d = at(n[(i + 1) % n.size()]);
      const double px = x[b] - x[a], py = y[b] - y[a], qx = x[d] - x[b], qy = y[d] - y[b];
      if (px * qy - py * qx <= 0) {
        concave.add("element %lld at node %lld", element_id(c), names.node(n[i]));
        break;
      }
    }
  }
  names.refuse(concave, "element too curved: its parts between neighbouring nodes fold");
  const ElementOverlap overlap = find_overlap(cells, x, y, 1e-9);
  if (overlap.count > 0)
    fail(Status::err_mesh,
         "the frame folds over itself when projected on the tangent plane of "
         "the axes "
         "(rollcon_contact_set_axes sets it): elements %lld and %lld (counting "
         "from %d) overlap; "
         "%lld parts of elements concerned",
         element_id(overlap.first), element_id(overlap.second), mesh.index_base, static_cast<long long>(overlap.count));
}

}  // namespace rollcon
