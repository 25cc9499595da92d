#include "bodies/meshed_zone.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/thinness.hpp"
#include "mesh/quadratic_fit.hpp"
#include "mesh/shape.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Returns the angle per time at which a section that creeps turns, as its material passes the frame's origin against
/// the rolling direction; else 0.
double rate_of(const Frame& frame, const PairOfBodies& pair, int which) {
  constexpr double least = 0.9;
  const Body& body = *pair.body[at(which)];
  if (!body.creeps()) return 0;
  const SweptSection& section = body.mesh().section;
  const Pose& pose = pair.pose[at(which)];
  const auto& [e1, along, e2] = section.axes_at_start();
  const Vec3 d = pose.to_body(frame.axes.origin) - section.path().origin;
  const double p = dot(d, e1), q = dot(d, along);
  const Vec3 way = section.axes(section.revolved() ? std::atan2(q, p) : 0).along;
  const double cosine = dot(pose.turn_back(frame.axes.t1), way);
  if (std::abs(cosine) < least)
    fail(Status::err_unsupported,
         "body %d is viscoelastic (rollcon_body_set_viscoelastic) and rolls at %.3g degrees to the way of its section; "
         "allowed: up to %.3g",
         which + 1, std::acos(std::abs(cosine)) * 180 / SweptSection::pi, std::acos(least) * 180 / SweptSection::pi);
  return -pair.speed * cosine / section.way(std::hypot(p, q));
}

/// Returns the frame on the body, with that rate.
FrameOnBody laid_in_rolling(const Frame& frame, const PairOfBodies& pair, int which) {
  FrameOnBody on = lay_on_body(frame, *pair.body[at(which)], pair.pose[at(which)], which);
  on.rate = rate_of(frame, pair, which);
  if (pair.losses) on.slope = on.rate / pair.speed;
  return on;
}

}  // namespace

MeshedZone::MeshedZone(const Frame& on, const PairOfBodies& of, int body_of)
    : frame(on),
      pair(of),
      which(body_of),
      body(*of.body[at(body_of)]),
      on_body(laid_in_rolling(on, of, body_of)),
      pose_(of.pose[at(body_of)]),
      normals_(on.axes, of) {
  const SurfaceMesh& surface = body.mesh().surface;
  const std::vector<std::int32_t> rows = on_body.of_faces() ? nodes_around(surface, on_body.face) : on_body.row;
  row_of_body_node_.assign(at(surface.nodes()), -1);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    row_of_body_node_[at(rows[r])] = static_cast<std::int64_t>(r);
    const Vec3 d = pose_.place(surface.node[at(rows[r])]) - frame.axes.origin;
    x.push_back(dot(d, frame.axes.t1));
    y.push_back(dot(d, frame.axes.t2));
  }
  for (const std::int64_t e : contact_elements(body.mesh())) {
    const auto nodes = surface.element(e);
    if (std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t k) { return row_of_body_node_[at(k)] >= 0; }))
      elements_.push_back(e);
  }
  search_ = std::make_unique<SurfaceSearch>(surface, elements_);
  under = look_under(body.mesh(), elements_);
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    if (!frame.used[at(k)]) continue;
    node_at_[{frame.x[at(k)], frame.y[at(k)]}] = k;
    if (on_body.node[at(k)] < 0) continue;
    const std::size_t row = at(row_of_body_node_[at(on_body.node[at(k)])]);
    x[row] = frame.x[at(k)];  // exact, as both share the node's triad
    y[row] = frame.y[at(k)];
  }
}

std::int64_t MeshedZone::row_of_node(double px, double py) const {
  const auto found = node_at_.find({px, py});
  const std::int32_t node = found == node_at_.end() ? -1 : on_body.node[at(found->second)];
  return node < 0 ? -1 : row_of_body_node_[at(node)];
}

// A frame node has the frame's own axes: at a ridge the field of normals knows only one of the faces that meet there.
std::array<Vec3, 3> MeshedZone::local_axes(double px, double py) const {
  const auto found = node_at_.find({px, py});
  const Triad t = found == node_at_.end() ? local_triad(frame.axes, normals_.at(px, py))
                                          : frame.triad(static_cast<std::size_t>(found->second));
  return {pose_.turn_back(t.t1), pose_.turn_back(t.t2), pose_.turn_back(t.n)};
}

std::vector<std::int64_t> MeshedZone::columns(const SurfaceOutline& outline) const {
  std::vector<std::int64_t> of_node(row_of_body_node_.size(), -1), column(at(frame.nodes()), -1);
  for (std::size_t k = 0; on_body.of_faces() && k < outline.column.size(); ++k)
    of_node[at(outline.column[k])] = static_cast<std::int64_t>(k);
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (!on_body.of_faces())
      column[k] = frame.used[k] ? static_cast<std::int64_t>(k) : -1;
    else if (on_body.node[k] >= 0)
      column[k] = of_node[at(on_body.node[k])];
  }
  return column;
}

SurfacePoint MeshedZone::look(const SurfaceSearch& search, double px, double py, bool& beyond) const {
  const Vec3 from = pose_.to_body(plane_point(frame.axes, px, py));
  const Vec3 direction = pose_.turn_back(frame.axes.n);
  const auto hit = search.along(from, direction, sign() * direction);
  beyond = !hit;
  return hit ? *hit : search.nearest(from);
}

Interpolation MeshedZone::locate(double px, double py) const {
  Interpolation where;
  const SurfacePoint point = look(*search_, px, py, where.beyond);
  const SurfaceMesh& mesh = body.mesh().surface;
  Shape shape;
  evaluate_shape(mesh.type[at(point.element)], point.xi, point.eta, shape);
  const auto nodes = mesh.element(point.element);
  for (std::size_t a = 0; a < nodes.size(); ++a) where.add(row_of_body_node_[at(nodes[a])], shape.value[a]);
  if (!curvature_.empty() && !is_quadratic(mesh.type[at(point.element)])) bend(px, py, where);
  return where;
}

Vec3 MeshedZone::interpolate(double px, double py, std::span<const double> u) const {
  bool beyond = false;
  const SurfacePoint point = look(body.search(), px, py, beyond);
  const SurfaceMesh& mesh = body.mesh().surface;
  Shape shape;
  evaluate_shape(mesh.type[at(point.element)], point.xi, point.eta, shape);
  Vec3 moved{0, 0, 0};
  const auto nodes = mesh.element(point.element);
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double* of_node = u.data() + 3 * at(nodes[a]);
    moved = moved + sign() * shape.value[a] * Vec3{of_node[0], of_node[1], of_node[2]};
  }
  const std::array<Vec3, 3> local = local_axes(px, py);
  return {dot(moved, local[0]), dot(moved, local[1]), dot(moved, local[2])};
}

// A smooth displacement lies off what a linear face makes of its nodal values by half the mean, by the shape functions,
// of its second differences from the point to the nodes. Its curvatures are found at the nodes, so that it has no step
// between faces.
void MeshedZone::bend(double px, double py, Interpolation& where) const {
  const std::size_t own = where.size();
  for (std::size_t a = 0; a < own; ++a) {
    const std::size_t node = at(where.row[a]);
    const double dx = x[node] - px, dy = y[node] - py, half = -0.5 * where.weight[a];
    const Curvature& curvature = curvature_[node];
    for (std::size_t k = 0; k < curvature.row.size(); ++k) {
      const auto [xx, xy, yy] = curvature.weight[k];
      where.add(curvature.row[k], half * (xx * dx * dx + 2 * xy * dx * dy + yy * dy * dy));
    }
  }
}

// Curvatures come from the nodes of the faces around a node; from those around these, too, where it stands at an edge.
// Walls of the body, whose nodes stand below each other, do not count. Where two materials meet displacements have a
// kink.
void MeshedZone::let_bend() {
  constexpr double steepest = 0.1;
  const BodyMesh& given = body.mesh();
  const SurfaceMesh& mesh = given.surface;
  const Vec3 out = sign() * pose_.turn_back(frame.axes.n);
  const auto material = [&](std::int64_t e) {
    return given.origin.empty() ? 0 : given.volume.tag[at(given.origin[at(e)].element)];
  };
  std::vector<std::vector<std::int64_t>> around(x.size());
  std::vector<std::int64_t> first(x.size(), -1);
  std::vector<std::uint8_t> kink(x.size(), 0);
  for (const std::int64_t e : elements_) {
    const auto nodes = mesh.element(e);
    const auto corner = [&](std::size_t i) { return mesh.node[at(nodes[i])]; };
    const std::size_t last = at(corner_count(mesh.type[at(e)])) - 1;
    const Vec3 normal = cross(corner(1) - corner(0), corner(last) - corner(0));
    if (dot(normal, out) < steepest * length(normal)) continue;
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
  std::vector<double> px, py;
  for (std::size_t r = 0; r < around.size(); ++r) {
    if (kink[r]) continue;
    Curvature& found = curvature_[r];
    found.row = around[r];
    for (int rings = 1; rings <= 2; ++rings) {
      px.clear(), py.clear();
      for (const std::int64_t k : found.row) px.push_back(x[at(k)]), py.push_back(y[at(k)]);
      found.weight = curvature_weights(px, py);
      if (!found.weight.empty() || rings == 2) break;
      for (const std::int64_t k : around[r])
        found.row.insert(found.row.end(), around[at(k)].begin(), around[at(k)].end());
      sort(found.row);
    }
    if (found.weight.empty()) found.row.clear();
  }
}

}  // namespace rollcon
