#include "bodies/meshed_compliance.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "bodies/meshed_compliance_class.hpp"
#include "bodies/thinness.hpp"
#include "mesh/shape.hpp"
#include "support/index.hpp"

namespace rollcon {

MeshedCompliance::MeshedCompliance(const Frame& frame, const PairOfBodies& pair, int which, double accuracy,
                                   int threads)
    : frame_(frame),
      body_(*pair.body[at(which)]),
      pair_(pair),
      pose_(pair.pose[at(which)]),
      which_(which),
      accuracy_(accuracy),
      threads_(threads),
      normals_(frame.axes, pair),
      on_body_(lay_on_body(frame, body_, pose_, which)) {
  const std::vector<std::int32_t> rows =
      on_body_.of_faces() ? nodes_around(body_.mesh().surface, on_body_.face) : on_body_.row;
  row_of_body_node_.assign(at(body_.mesh().surface.nodes()), -1);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    row_of_body_node_[at(rows[r])] = static_cast<std::int64_t>(r);
    const Vec3 d = pose_.place(body_.mesh().surface.node[at(rows[r])]) - frame.axes.origin;
    zone_x_.push_back(dot(d, frame.axes.t1));
    zone_y_.push_back(dot(d, frame.axes.t2));
  }
  std::vector<std::int64_t> usable;
  for (const std::int64_t e : contact_elements(body_.mesh())) {
    const auto nodes = body_.mesh().surface.element(e);
    if (std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t k) { return row_of_body_node_[at(k)] >= 0; }))
      usable.push_back(e);
  }
  zone_ = std::make_unique<SurfaceSearch>(body_.mesh().surface, usable);
  under_ = look_under(body_.mesh(), usable);
  if (!on_body_.of_faces() && !body_.traits().smooth_difference && !by_shape_functions()) find_curvatures(usable);
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    if (!frame.used[at(k)]) continue;
    node_at_[{frame.x[at(k)], frame.y[at(k)]}] = k;
    if (on_body_.node[at(k)] < 0) continue;
    const std::size_t row = at(row_of_body_node_[at(on_body_.node[at(k)])]);
    zone_x_[row] = frame.x[at(k)];  // without rounding: they share the node's triad
    zone_y_[row] = frame.y[at(k)];
  }
}

const SurfaceOutline& MeshedCompliance::outline() const {
  if (loads_) return *loads_;
  require_response();
  return *outline_;
}

bool MeshedCompliance::resolves_frame() const {
  if (!by_shape_functions() || on_body_.of_faces()) return true;
  std::vector<std::uint8_t> moves(zone_x_.size(), 0);
  for (std::int64_t k = 0; k < frame_.nodes(); ++k) {
    if (!frame_.used[at(k)]) continue;
    const Interpolation where = locate(frame_.x[at(k)], frame_.y[at(k)]);
    for (std::size_t a = 0; a < where.size(); ++a) moves[at(where.row[a])] = 1;
  }
  return std::count(frame_.used.begin(), frame_.used.end(), 1) <= std::count(moves.begin(), moves.end(), 1);
}

std::vector<std::int64_t> MeshedCompliance::columns(const SurfaceOutline& outline) const {
  std::vector<std::int64_t> column(at(frame_.nodes()), -1);
  if (!on_body_.of_faces()) {
    for (std::size_t k = 0; k < column.size(); ++k)
      if (frame_.used[k]) column[k] = static_cast<std::int64_t>(k);
    return column;
  }
  std::vector<std::int64_t> of_node(row_of_body_node_.size(), -1);
  for (std::size_t k = 0; k < outline.column.size(); ++k) of_node[at(outline.column[k])] = static_cast<std::int64_t>(k);
  for (std::size_t k = 0; k < column.size(); ++k)
    if (on_body_.node[k] >= 0) column[k] = of_node[at(on_body_.node[k])];
  return column;
}

// From the body's axes to local components, from the response's columns to the frame's nodes.
void MeshedCompliance::require_response() const {
  if (outline_) return;
  SurfaceResponse& body = *body_.response();
  const std::shared_ptr<const SurfaceRows> found = body.rows(on_body_, threads_);
  const SurfaceRows& rows = *found;
  const std::int64_t n = frame_.nodes(), zone = static_cast<std::int64_t>(rows.row.size());
  const std::vector<std::int64_t> column = columns(rows);
  response_.resize(3 * zone, 3 * n);
  std::vector<LocalAxes> load(at(n));
  for (std::size_t k = 0; k < at(n); ++k) load[k] = local_axes(frame_.x[k], frame_.y[k]);
  for (std::int64_t z = 0; z < zone; ++z) {
    const LocalAxes local = local_axes(zone_x_[at(z)], zone_y_[at(z)]);
    const double* u[3] = {rows.u.row(3 * z), rows.u.row(3 * z + 1), rows.u.row(3 * z + 2)};
    for (std::size_t i = 0; i < 3; ++i) {
      double* out = response_.row(3 * z + static_cast<std::int64_t>(i));
      for (std::int64_t k = 0; k < n; ++k) {
        Vec3 row{0, 0, 0};  // local component i per unit traction in the body's axes
        if (const std::int64_t c = column[at(k)]; c >= 0)
          for (std::size_t b = 0; b < 3; ++b)
            row[b] = local[i][0] * u[0][3 * c + static_cast<std::int64_t>(b)] +
                     local[i][1] * u[1][3 * c + static_cast<std::int64_t>(b)] +
                     local[i][2] * u[2][3 * c + static_cast<std::int64_t>(b)];
        for (std::size_t j = 0; j < 3; ++j) out[3 * k + static_cast<std::int64_t>(j)] = dot(row, load[at(k)][j]);
      }
    }
  }
  // Of the response itself this is a copy: whether the body keeps it is the body's matter.
  outline_ = std::make_unique<const SurfaceOutline>(rows);
}

void MeshedCompliance::block(Points points, const ComplianceBlock& out) const {
  require_response();
  const std::int64_t n = frame_.nodes();
  const auto destination = [&](std::size_t i, std::size_t j, std::size_t point) {
    return out.a[i][j] + static_cast<std::ptrdiff_t>(point) * out.stride;
  };
  const auto add = [&](const double* from, double weight, double* to) {
    for (std::int64_t k = 0; k < n; ++k) to[k] += weight * from[3 * k];
  };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t p = 0; out.a[i][j] && p < points.size(); ++p) {
        // Half-spaces that do not couple leave blocks alone.
        std::fill_n(destination(i, j, p), n, 0.0);
        if (const std::int64_t row = row_of_node(points.x[p], points.y[p]); row >= 0)
          add(response_.row(3 * row + static_cast<std::int64_t>(i)) + j, 1, destination(i, j, p));
      }
  const std::array<Others, 2> groups = others(points);
  for (const Others& group : groups) {
    if (group.point.empty()) continue;
    const Between part = between(&group == &groups[1]);
    const BlockBuffer local(part.local ? out : ComplianceBlock{}, group.point.size(), n);
    if (part.local) part.local->block({group.x, group.y}, local.block());
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t b = 0; out.a[i][j] && b < group.point.size(); ++b) {
          double* to = destination(i, j, group.point[b]);
          if (part.local) std::copy_n(local.row(i, j, b), n, to);
          const Interpolation& where = group.where[b];
          for (std::size_t a = 0; a < where.size(); ++a)
            add(part.smooth->row(3 * where.row[a] + static_cast<std::int64_t>(i)) + j, where.weight[a], to);
        }
  }
}

void MeshedCompliance::apply(Points points, const double* traction, double* displacement) const {
  require_response();
  for (std::size_t p = 0; p < points.size(); ++p)
    if (const std::int64_t row = row_of_node(points.x[p], points.y[p]); row >= 0)
      multiply(response_.row(3 * row), 3, response_.columns(), traction, 0, displacement + 3 * p);
  const std::array<Others, 2> groups = others(points);
  for (const Others& group : groups) {
    if (group.point.empty()) continue;
    const Between part = between(&group == &groups[1]);
    const RowMatrix<double>& matrix = *part.smooth;
    std::vector<double> smooth(at(matrix.rows())), local(3 * group.point.size(), 0.0);
    multiply(matrix.data(), matrix.rows(), matrix.columns(), traction, 0, smooth.data());
    if (part.local) part.local->apply({group.x, group.y}, traction, local.data());
    for (std::size_t b = 0; b < group.point.size(); ++b) {
      const Interpolation& where = group.where[b];
      for (std::size_t i = 0; i < 3; ++i) {
        double u = local[3 * b + i];
        for (std::size_t a = 0; a < where.size(); ++a) u += where.weight[a] * smooth[at(3 * where.row[a]) + i];
        displacement[3 * group.point[b] + i] = u;
      }
    }
  }
}

bool MeshedCompliance::offset(Points points, double* u) const {
  const std::span<const double> own = body_.response()->own().displacement;
  if (own.empty()) return false;
  const SurfaceMesh& mesh = body_.mesh().surface;
  const double sign = which_ == 0 ? 1 : -1;  // u1 - u2
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec3 from = pose_.to_body(plane_point(frame_.axes, points.x[p], points.y[p]));
    const Vec3 direction = pose_.turn_back(frame_.axes.n);
    const auto hit = body_.search().along(from, direction, sign * direction);
    const SurfacePoint point = hit ? *hit : body_.search().nearest(from);
    Shape shape;
    evaluate_shape(mesh.type[at(point.element)], point.xi, point.eta, shape);
    Vec3 moved{0, 0, 0};
    const auto nodes = mesh.element(point.element);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const double* of_node = own.data() + 3 * at(nodes[a]);
      moved = moved + shape.value[a] * Vec3{of_node[0], of_node[1], of_node[2]};
    }
    moved = sign * pose_.turn(moved);
    const Triad t = triad(points.x[p], points.y[p]);
    u[3 * p] = dot(moved, t.t1);
    u[3 * p + 1] = dot(moved, t.t2);
    u[3 * p + 2] = dot(moved, t.n);
  }
  return true;
}

void MeshedCompliance::find_meshes(std::array<MeshOnFrame, 2>& found) const {
  MeshOnFrame& own = found[at(which_)] = under_;
  own.response = body_.response();
  own.between_nodes = !on_body_.of_faces() && !by_shape_functions();
}

std::string MeshedCompliance::description() const {
  std::string text = "body " + std::to_string(which_ + 1) + ": " + body_.traits().parts + ", " +
                     std::to_string(body_.mesh().surface.nodes()) + " nodes; ";
  if (on_body_.of_faces()) return text + "the frame is " + std::to_string(on_body_.face.size()) + " of its faces";
  return text + "the frame is a mesh of its own laid on it";
}

std::unique_ptr<Compliance> make_meshed_compliance(const Frame& frame, const PairOfBodies& pair, int which,
                                                   double accuracy, int threads) {
  return std::make_unique<MeshedCompliance>(frame, pair, which, accuracy, threads);
}

}  // namespace rollcon
