#include "bodies/meshed_compliance.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "bodies/meshed_compliance_class.hpp"
#include "support/index.hpp"

namespace rollcon {

const SurfaceOutline& ByShapeFunctions::outline() const {
  if (loads_) return *loads_;
  require_response();
  return *outline_;
}

bool ByShapeFunctions::resolves_frame() const {
  const Frame& frame = zone_.frame;
  if (zone_.on_body.of_faces()) return true;
  std::vector<std::uint8_t> moves(zone_.x.size(), 0);
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    if (!frame.used[at(k)]) continue;
    for (const std::int64_t row : zone_.locate(frame.x[at(k)], frame.y[at(k)]).row) moves[at(row)] = 1;
  }
  return std::count(frame.used.begin(), frame.used.end(), 1) <= std::count(moves.begin(), moves.end(), 1);
}

// Turns the body's axes to local components, from the response's columns to the frame's nodes.
void ByShapeFunctions::require_response() const {
  if (outline_) return;
  const std::shared_ptr<const SurfaceRows> found = zone_.body.response()->rows(zone_.on_body, threads_);
  const SurfaceRows& rows = *found;
  const std::int64_t n = nodes(), zone = static_cast<std::int64_t>(rows.row.size());
  const std::vector<std::int64_t> column = zone_.columns(rows);
  response_.resize(3 * zone, 3 * n);
  std::vector<std::array<Vec3, 3>> load(at(n));
  for (std::size_t k = 0; k < at(n); ++k) load[k] = zone_.local_axes(zone_.frame.x[k], zone_.frame.y[k]);
  for (std::int64_t z = 0; z < zone; ++z) {
    const std::array<Vec3, 3> local = zone_.local_axes(zone_.x[at(z)], zone_.y[at(z)]);
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
  // The outline is copied: whether the body keeps the response is the body's matter.
  outline_ = std::make_unique<const SurfaceOutline>(rows);
}

std::vector<ByShapeFunctions::Group> ByShapeFunctions::groups(Points points) const {
  std::vector<Group> all(3);
  const bool alone = nodes_move_alone();
  for (std::size_t p = 0; p < points.size(); ++p) {
    Interpolation where;
    const std::int64_t row = alone ? zone_.row_of_node(points.x[p], points.y[p]) : -1;
    if (row >= 0)
      where.add(row, 1);
    else
      where = zone_.locate(points.x[p], points.y[p]);
    const Place place = row >= 0 ? at_nodes : where.beyond ? beyond : inside;
    Group& group = all[place];
    group.place = place;
    group.x.push_back(points.x[p]);
    group.y.push_back(points.y[p]);
    group.point.push_back(p);
    group.where.push_back(std::move(where));
  }
  std::erase_if(all, [](const Group& group) { return group.point.empty(); });
  return all;
}

void ByShapeFunctions::block(Points points, const ComplianceBlock& out) const {
  require_response();
  const std::int64_t n = nodes();
  for (const Group& group : groups(points)) {
    const Compliance* local = this->local(group.place);
    const RowMatrix<double>& smooth = this->smooth(group.place);
    const BlockBuffer buffer(local ? out : ComplianceBlock{}, group.point.size(), n);
    if (local) local->block({group.x, group.y}, buffer.block());
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t b = 0; out.a[i][j] && b < group.point.size(); ++b) {
          double* to = out.a[i][j] + static_cast<std::ptrdiff_t>(group.point[b]) * out.stride;
          // Half-spaces that do not couple leave blocks alone.
          std::fill_n(to, n, 0.0);
          if (local) std::copy_n(buffer.row(i, j, b), n, to);
          const Interpolation& where = group.where[b];
          for (std::size_t a = 0; a < where.size(); ++a) {
            const double* from = smooth.row(3 * where.row[a] + static_cast<std::int64_t>(i)) + j;
            for (std::int64_t k = 0; k < n; ++k) to[k] += where.weight[a] * from[3 * k];
          }
        }
  }
}

void ByShapeFunctions::apply(Points points, const double* traction, double* displacement) const {
  require_response();
  for (const Group& group : groups(points)) {
    const RowMatrix<double>& matrix = smooth(group.place);
    std::vector<double> moved(at(matrix.rows())), u(3 * group.point.size(), 0.0);
    multiply(matrix.data(), matrix.rows(), matrix.columns(), traction, 0, moved.data());
    if (const Compliance* more = local(group.place)) more->apply({group.x, group.y}, traction, u.data());
    for (std::size_t b = 0; b < group.point.size(); ++b) {
      const Interpolation& where = group.where[b];
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t a = 0; a < where.size(); ++a)
          u[3 * b + i] += where.weight[a] * moved[at(3 * where.row[a]) + i];
        displacement[3 * group.point[b] + i] = u[3 * b + i];
      }
    }
  }
}

bool ByShapeFunctions::offset(Points points, double* u) const {
  const std::span<const double> own = zone_.body.own().displacement;
  for (std::size_t p = 0; p < points.size() && !own.empty(); ++p) {
    const Vec3 moved = zone_.interpolate(points.x[p], points.y[p], own);
    std::copy(moved.begin(), moved.end(), u + 3 * p);
  }
  return !own.empty();
}

void ByShapeFunctions::find_meshes(std::array<MeshOnFrame, 2>& found) const {
  found[at(zone_.which)] = zone_.under;
  found[at(zone_.which)].response = zone_.body.response();
}

std::string ByShapeFunctions::description() const {
  std::string text = "body " + std::to_string(zone_.which + 1) + ": " + zone_.body.traits().parts + ", " +
                     std::to_string(zone_.body.mesh().surface.nodes()) + " nodes; ";
  if (zone_.on_body.of_faces())
    return text + "the frame is " + std::to_string(zone_.on_body.face.size()) + " of its faces";
  return text + "the frame is a mesh of its own laid on it";
}

// Option between_nodes asks for shape functions; a boundary-element body that is thin under its own faces needs them,
// since a half-space between their nodes would be far softer than the body.
std::unique_ptr<Compliance> make_meshed_compliance(const Frame& frame, const PairOfBodies& pair, int which,
                                                   double accuracy, int threads) {
  constexpr double least_depth = 2.6;  // no ratio of usual meshes: rounding decides there
  MeshedZone zone(frame, pair, which);
  const bool shape_functions =
      pair.losses || zone.body.options().between_nodes == 1 ||
      (zone.body.traits().smooth_difference && zone.on_body.of_faces() && zone.under.under_faces < least_depth);
  if (shape_functions) return std::make_unique<ByShapeFunctions>(std::move(zone), threads);
  return std::make_unique<BetweenNodes>(std::move(zone), accuracy, threads);
}

}  // namespace rollcon
