#include "bodies/meshed_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "bodies/frame_on_body.hpp"
#include "bodies/halfspace/halfspace.hpp"
#include "bodies/remainder_compliance.hpp"
#include "mesh/shape.hpp"

namespace rollcon {
namespace {

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

class MeshedCompliance final : public Compliance {
 public:
  MeshedCompliance(const Frame& frame, const PairOfBodies& pair, int which, double accuracy,
                   int threads);

  std::int64_t nodes() const override { return frame_.nodes(); }
  bool couples() const override { return true; }
  void block(Points points, const ComplianceBlock& out) const override;
  void apply(Points points, const double* traction, double* displacement) const override;
  bool offset(Points points, double* u) const override;
  std::string description() const override;
  bool resolves_frame() const override;
  void set_threads(int threads) override {
    threads_ = threads;
    for (Compliance* part : {halfspace_.get(), remainder_.get()})
      if (part) part->set_threads(threads);
  }
  std::int64_t kernel_evaluations() const override {
    return (halfspace_ ? halfspace_->kernel_evaluations() : 0) +
           (remainder_ ? remainder_->kernel_evaluations() : 0);
  }
  std::size_t bytes() const override { return response_.bytes() + correction_.bytes(); }

 private:
  /// Zone rows and weights that interpolate to a point of the surface.
  struct Interpolation {
    bool beyond = false;  ///< the point is over no element of the zone
    int count = 0;
    std::int64_t row[max_element_nodes];
    double weight[max_element_nodes];
  };
  Interpolation locate(double x, double y) const;
  /// Row of the frame node that stands exactly here and is a node of the body; -1: none.
  std::int64_t row_of_node(double x, double y) const;
  void collect_response(const SurfaceRows& rows);
  /// The frame's own at its nodes: at a ridge the field knows only one of the faces that meet
  /// there.
  Triad triad(double x, double y) const {
    const auto found = node_at_.find({x, y});
    return found == node_at_.end() ? local_triad(frame_.axes, normals_.at(x, y))
                                   : frame_.triad(at(found->second));
  }

  const Frame& frame_;
  const Body& body_;
  PairOfBodies pair_;
  Pose pose_;
  int which_;
  double accuracy_;
  int threads_;
  NormalField normals_;
  FrameOnBody on_body_;
  std::vector<double> zone_x_, zone_y_;  ///< of the response's rows, in the axes
  std::vector<std::int64_t> row_of_body_node_;
  std::map<std::pair<double, double>, std::int64_t> node_at_;  ///< frame nodes that are used
  RowMatrix<double> response_;  ///< (3 rows) x (3 frame nodes), local components
  std::unique_ptr<SurfaceSearch> zone_;
  std::shared_ptr<const SurfaceRows> rows_;
  // Made when a point between nodes is asked for.
  mutable std::unique_ptr<Compliance> halfspace_, remainder_;
  mutable RowMatrix<double> correction_;  ///< response less the half-space's

  /// How displacements between nodes are made: a local part, and one interpolated on the zone.
  struct Between {
    const Compliance* local;
    const RowMatrix<double>* smooth;
  };
  Between between(bool beyond) const;
  void require_correction() const;
  bool by_shape_functions() const { return body_.options().between_nodes == 1; }
  /// Points that are not nodes of the body: those of the zone, and those beyond it.
  struct Others {
    std::vector<double> x, y;
    std::vector<std::size_t> point;  ///< of those asked for
    std::vector<Interpolation> where;
  };
  std::array<Others, 2> others(Points points) const;
};

MeshedCompliance::MeshedCompliance(const Frame& frame, const PairOfBodies& pair, int which,
                                   double accuracy, int threads)
    : frame_(frame),
      body_(*pair.body[at(which)]),
      pair_(pair),
      pose_(pair.pose[at(which)]),
      which_(which),
      accuracy_(accuracy),
      threads_(threads),
      normals_(frame.axes, pair),
      on_body_(lay_on_body(frame, body_, pose_, which)) {
  SurfaceResponse& body = *body_.response();
  rows_ = on_body_.matches() ? body.faces(on_body_.face, threads)
                             : body.layer(on_body_.layer, on_body_.row, threads);
  const SurfaceRows* rows = rows_.get();
  row_of_body_node_.assign(at(body_.mesh().surface.nodes()), -1);
  for (std::size_t r = 0; r < rows->row.size(); ++r) {
    row_of_body_node_[at(rows->row[r])] = static_cast<std::int64_t>(r);
    const Vec3 d = pose_.place(body_.mesh().surface.node[at(rows->row[r])]) - frame.axes.origin;
    zone_x_.push_back(dot(d, frame.axes.t1));
    zone_y_.push_back(dot(d, frame.axes.t2));
  }
  std::vector<std::int64_t> usable;
  for (const std::int64_t e : contact_elements(body_.mesh())) {
    const auto nodes = body_.mesh().surface.element(e);
    if (std::all_of(nodes.begin(), nodes.end(),
                    [&](std::int32_t k) { return row_of_body_node_[at(k)] >= 0; }))
      usable.push_back(e);
  }
  zone_ = std::make_unique<SurfaceSearch>(body_.mesh().surface, usable);
  for (std::int64_t k = 0; k < frame.nodes(); ++k) {
    if (!frame.used[at(k)]) continue;
    node_at_[{frame.x[at(k)], frame.y[at(k)]}] = k;
    if (on_body_.node[at(k)] < 0) continue;
    const std::size_t row = at(row_of_body_node_[at(on_body_.node[at(k)])]);
    zone_x_[row] = frame.x[at(k)];  // without rounding: they share the node's triad
    zone_y_[row] = frame.y[at(k)];
  }
  collect_response(*rows);
}

bool MeshedCompliance::resolves_frame() const {
  if (!by_shape_functions() || on_body_.matches()) return true;
  std::vector<std::uint8_t> moves(zone_x_.size(), 0);
  for (std::int64_t k = 0; k < frame_.nodes(); ++k) {
    if (!frame_.used[at(k)]) continue;
    const Interpolation where = locate(frame_.x[at(k)], frame_.y[at(k)]);
    for (int a = 0; a < where.count; ++a) moves[at(where.row[a])] = 1;
  }
  return std::count(frame_.used.begin(), frame_.used.end(), 1) <=
         std::count(moves.begin(), moves.end(), 1);
}

// From the body's axes to local components, from the response's columns to the frame's nodes.
void MeshedCompliance::collect_response(const SurfaceRows& rows) {
  const std::int64_t n = frame_.nodes(), zone = static_cast<std::int64_t>(rows.row.size());
  std::vector<std::int64_t> column(at(n), -1);
  if (on_body_.matches()) {
    std::vector<std::int64_t> of_node(row_of_body_node_.size(), -1);
    for (std::size_t k = 0; k < rows.column.size(); ++k)
      of_node[at(rows.column[k])] = static_cast<std::int64_t>(k);
    for (std::int64_t k = 0; k < n; ++k)
      if (on_body_.node[at(k)] >= 0) column[at(k)] = of_node[at(on_body_.node[at(k)])];
  } else {
    for (std::int64_t k = 0; k < n; ++k) column[at(k)] = frame_.used[at(k)] ? k : -1;
  }
  response_.resize(3 * zone, 3 * n);
  std::vector<std::array<Vec3, 3>> load(at(n));  // local directions at the nodes, body axes
  for (std::int64_t k = 0; k < n; ++k) {
    const Triad t = triad(frame_.x[at(k)], frame_.y[at(k)]);
    load[at(k)] = {pose_.turn_back(t.t1), pose_.turn_back(t.t2), pose_.turn_back(t.n)};
  }
  for (std::int64_t z = 0; z < zone; ++z) {
    const Triad t = triad(zone_x_[at(z)], zone_y_[at(z)]);
    const Vec3 local[3] = {pose_.turn_back(t.t1), pose_.turn_back(t.t2), pose_.turn_back(t.n)};
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
        for (std::size_t j = 0; j < 3; ++j)
          out[3 * k + static_cast<std::int64_t>(j)] = dot(row, load[at(k)][j]);
      }
    }
  }
}

// Boundary elements: what a half-space does, and the difference, which is smooth. Under the load of
// a single node finite elements move by what the mesh does not resolve: their difference is not
// smooth. On faces of their own shape functions serve; under a layer the remainder goes to a
// half-space. Beyond the zone, where its rim's displacement would be all, they take the difference.
MeshedCompliance::Between MeshedCompliance::between(bool beyond) const {
  if (by_shape_functions()) return {nullptr, &response_};
  if (body_.kind() != BodyKind::fem || beyond) {
    require_correction();
    return {halfspace_.get(), &correction_};
  }
  if (rows_->seen.rows() > 0 && !remainder_)
    remainder_ = make_remainder_compliance(frame_, pair_, which_, *rows_, accuracy_, threads_);
  return {remainder_.get(), &response_};
}

void MeshedCompliance::require_correction() const {
  if (halfspace_) return;
  auto halfspace = make_halfspace_compliance(
      frame_,
      halfspace_constants(rows_->young > 0 ? rows_->young : body_.young(),
                          rows_->young > 0 ? rows_->poisson : body_.poisson(),
                          which_ == 0 ? 1 : -1),
      accuracy_, threads_);
  const std::int64_t n = frame_.nodes();
  const std::size_t zone = zone_x_.size();
  std::vector<double> buffer[3][3];
  ComplianceBlock part;
  part.stride = static_cast<std::ptrdiff_t>(n);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      buffer[i][j].assign(zone * at(n), 0.0);
      part.a[i][j] = buffer[i][j].data();
    }
  halfspace->block({zone_x_, zone_y_}, part);
  correction_.resize(response_.rows(), response_.columns());
  for (std::size_t z = 0; z < zone; ++z)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<std::int64_t>(3 * z + i);
      for (std::int64_t k = 0; k < n; ++k)
        for (std::int64_t j = 0; j < 3; ++j)
          correction_.row(row)[3 * k + j] =
              response_.row(row)[3 * k + j] - buffer[i][j][z * at(n) + at(k)];
    }
  halfspace_ = std::move(halfspace);
}

std::int64_t MeshedCompliance::row_of_node(double x, double y) const {
  const auto found = node_at_.find({x, y});
  if (found == node_at_.end()) return -1;
  if (rows_->seen.rows() > 0 && !by_shape_functions()) return -1;  // the remainder moves nodes too
  const std::int32_t node = on_body_.node[at(found->second)];
  return node < 0 ? -1 : row_of_body_node_[at(node)];
}

MeshedCompliance::Interpolation MeshedCompliance::locate(double x, double y) const {
  const Vec3 from = pose_.to_body(plane_point(frame_.axes, x, y));
  const Vec3 direction = pose_.turn_back(frame_.axes.n);
  const auto hit = zone_->along(from, direction, (which_ == 0 ? 1.0 : -1.0) * direction);
  const SurfacePoint point = hit ? *hit : zone_->nearest(from);
  const SurfaceMesh& mesh = body_.mesh().surface;
  Shape shape;
  evaluate_shape(mesh.type[at(point.element)], point.xi, point.eta, shape);
  Interpolation where;
  where.beyond = !hit;
  for (const std::int32_t k : mesh.element(point.element)) {
    where.weight[where.count] = shape.value[static_cast<std::size_t>(where.count)];
    where.row[where.count] = row_of_body_node_[at(k)];
    ++where.count;
  }
  return where;
}

std::array<MeshedCompliance::Others, 2> MeshedCompliance::others(Points points) const {
  std::array<Others, 2> result;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (row_of_node(points.x[p], points.y[p]) >= 0) continue;
    const Interpolation where = locate(points.x[p], points.y[p]);
    Others& group = result[where.beyond ? 1 : 0];
    group.x.push_back(points.x[p]);
    group.y.push_back(points.y[p]);
    group.point.push_back(p);
    group.where.push_back(where);
  }
  return result;
}

void MeshedCompliance::block(Points points, const ComplianceBlock& out) const {
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
    std::vector<double> buffer[3][3];
    ComplianceBlock local;
    local.stride = static_cast<std::ptrdiff_t>(n);
    for (std::size_t i = 0; part.local && i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (out.a[i][j]) {
          buffer[i][j].assign(group.point.size() * at(n), 0.0);
          local.a[i][j] = buffer[i][j].data();
        }
    if (part.local) part.local->block({group.x, group.y}, local);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t b = 0; out.a[i][j] && b < group.point.size(); ++b) {
          double* to = destination(i, j, group.point[b]);
          if (part.local) std::copy_n(buffer[i][j].data() + b * at(n), n, to);
          const Interpolation& where = group.where[b];
          for (int a = 0; a < where.count; ++a)
            add(part.smooth->row(3 * where.row[a] + static_cast<std::int64_t>(i)) + j,
                where.weight[a], to);
        }
  }
}

void MeshedCompliance::apply(Points points, const double* traction, double* displacement) const {
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
        for (int a = 0; a < where.count; ++a)
          u += where.weight[a] * smooth[at(3 * where.row[a]) + i];
        displacement[3 * group.point[b] + i] = u;
      }
    }
  }
}

bool MeshedCompliance::offset(Points points, double* u) const {
  const std::span<const double> own = body_.response()->own_displacement();
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

std::string MeshedCompliance::description() const {
  std::string text =
      "body " + std::to_string(which_ + 1) +
      (body_.kind() == BodyKind::fem ? ": finite elements, " : ": boundary elements, ") +
      std::to_string(body_.mesh().surface.nodes()) + " nodes; ";
  if (on_body_.matches())
    return text + "the frame is " + std::to_string(on_body_.face.size()) + " of its faces";
  return text + "the frame is a mesh of its own laid on it";
}

}  // namespace

std::unique_ptr<Compliance> make_meshed_compliance(const Frame& frame, const PairOfBodies& pair,
                                                   int which, double accuracy, int threads) {
  return std::make_unique<MeshedCompliance>(frame, pair, which, accuracy, threads);
}

}  // namespace rollcon
