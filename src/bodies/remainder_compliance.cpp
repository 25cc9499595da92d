#include "bodies/remainder_compliance.hpp"

#include <utility>
#include <vector>

#include "bodies/halfspace/near_halfspaces.hpp"
#include "linalg/lapack.hpp"
#include "mesh/turned_over.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Faces that bend away from the plane are folded between their corners and midside nodes when they are projected on
/// it: their midside nodes go to the middle of their sides. All nodes lie in the plane.
void straighten_folded(const Axes& axes, SurfaceMesh& faces) {
  for (std::int64_t e = 0; e < faces.elements(); ++e) {
    if (!is_quadratic(faces.type[at(e)])) continue;
    const auto nodes = faces.element(e);
    const std::size_t corners = at(corner_count(faces.type[at(e)]));
    const auto node = [&](std::size_t i) -> Vec3& { return faces.node[at(nodes[i])]; };
    bool folded = false;
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t next = (i + 1) % corners, last = (i + corners - 1) % corners;
      const auto turn = [&](const Vec3& a, const Vec3& b) { return dot(cross(a - node(i), b - node(i)), axes.n); };
      // Tangents of both sides at their corner.
      const Vec3 ahead = 4.0 * node(corners + i) - node(next) - 2.0 * node(i),
                 back = 4.0 * node(corners + last) - node(last) - 2.0 * node(i);
      constexpr double least = 0.1;  // least turn over that of straight sides
      folded = folded || !(turn(ahead, back) / turn(node(next), node(last)) > least);
    }
    for (std::size_t i = 0; folded && i < corners; ++i) node(corners + i) = 0.5 * (node(i) + node((i + 1) % corners));
  }
}

/// Makes a frame of the faces that feel the layer; they look out of body 1.
Frame frame_of_faces(const Frame& frame, const PairOfBodies& pair, int which, const SurfaceOutline& rows) {
  const SurfaceMesh& surface = pair.body[at(which)]->mesh().surface;
  std::vector<std::int32_t> number(at(surface.nodes()), -1);
  SurfaceMesh faces;
  faces.offset.push_back(0);
  for (std::size_t i = 0; i < rows.seen_node.size(); ++i) {
    number[at(rows.seen_node[i])] = static_cast<std::int32_t>(i);
    // Half-spaces see the projection on the axes' plane alone; steep faces are not refused for it.
    const Vec3 d = pair.pose[at(which)].place(surface.node[at(rows.seen_node[i])]) - frame.axes.origin;
    faces.node.push_back(plane_point(frame.axes, dot(d, frame.axes.t1), dot(d, frame.axes.t2)));
  }
  for (const std::int64_t e : rows.seen_face) {
    faces.type.push_back(surface.type[at(e)]);
    faces.tag.push_back(0);
    for (const std::int32_t k : surface.element(e)) faces.connectivity.push_back(number[at(k)]);
    faces.offset.push_back(static_cast<std::int64_t>(faces.connectivity.size()));
  }
  straighten_folded(frame.axes, faces);
  if (which == 1) turn_over(faces);
  return build_frame(std::move(faces), frame.axes);
}

class RemainderCompliance final : public Compliance {
 public:
  RemainderCompliance(const Frame& frame, const PairOfBodies& pair, int which, const SurfaceOutline& rows,
                      double accuracy, int threads)
      : rows_(rows), faces_(frame_of_faces(frame, pair, which, rows)) {
    const HalfspaceConstants constants = halfspace_constants(rows.young, rows.poisson, which == 0 ? 1 : -1);
    on_layer_ = make_halfspace_compliance(frame, constants, accuracy, threads);
    on_faces_ = make_halfspace_compliance(faces_, constants, accuracy, threads);
  }

  std::int64_t nodes() const override { return on_layer_->nodes(); }
  bool couples() const override { return on_layer_->couples(); }
  void block(Points points, const ComplianceBlock& out) const override;
  void apply(Points points, const double* traction, double* displacement) const override;
  bool near_halfspaces(Points points, NearHalfspaces& out) const override;
  void set_threads(int threads) override {
    on_layer_->set_threads(threads);
    on_faces_->set_threads(threads);
  }
  std::int64_t kernel_evaluations() const override {
    return on_layer_->kernel_evaluations() + on_faces_->kernel_evaluations();
  }
  std::size_t bytes() const override { return on_layer_->bytes() + on_faces_->bytes(); }

 private:
  const SurfaceOutline& rows_;
  Frame faces_;
  std::unique_ptr<Compliance> on_layer_, on_faces_;
};

void RemainderCompliance::block(Points points, const ComplianceBlock& out) const {
  on_layer_->block(points, out);
  const std::int64_t n = rows_.seen.rows();
  const BlockBuffer felt(out, points.size(), n);
  on_faces_->block(points, felt.block());
  // out -= felt * seen, row-major: the transposes of column-major matrices.
  const int layer = static_cast<int>(rows_.seen.columns()), count = static_cast<int>(points.size()),
            faces = static_cast<int>(n), stride = static_cast<int>(out.stride);
  const double minus = -1, one = 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (out.a[i][j])
        dgemm_("N", "N", &layer, &count, &faces, &minus, rows_.seen.data(), &layer, felt.row(i, j, 0), &faces, &one,
               out.a[i][j], &stride);
}

bool RemainderCompliance::near_halfspaces(Points points, NearHalfspaces& out) const {
  if (!on_layer_->near_halfspaces(points, out)) return false;
  ExpandedCompliance on_faces;
  add_direct(*on_faces_, points, on_faces);
  for (std::int64_t k = 0; k < on_faces.direct.rows() * on_faces.direct.columns(); ++k) on_faces.direct.data()[k] *= -1;
  out.part.push_back({std::move(on_faces.direct), rows_.seen});
  return true;
}

void RemainderCompliance::apply(Points points, const double* traction, double* displacement) const {
  on_layer_->apply(points, traction, displacement);
  const std::int64_t n = rows_.seen.rows();
  std::vector<double> felt(3 * at(n), 0.0), u(3 * points.size());
  for (std::int64_t i = 0; i < n; ++i) {
    const double* share = rows_.seen.row(i);
    for (std::int64_t k = 0; k < rows_.seen.columns(); ++k)
      for (std::size_t c = 0; c < 3; ++c) felt[3 * at(i) + c] += share[k] * traction[3 * at(k) + c];
  }
  on_faces_->apply(points, felt.data(), u.data());
  for (std::size_t k = 0; k < u.size(); ++k) displacement[k] -= u[k];
}

}  // namespace

std::unique_ptr<Compliance> make_remainder_compliance(const Frame& frame, const PairOfBodies& pair, int which,
                                                      const SurfaceOutline& rows, double accuracy, int threads) {
  return std::make_unique<RemainderCompliance>(frame, pair, which, rows, accuracy, threads);
}

}  // namespace rollcon
