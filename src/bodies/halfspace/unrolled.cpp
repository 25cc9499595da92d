#include "bodies/halfspace/unrolled.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesh/section_line.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Lays nodes at their arc length, however their line bends.
Frame unrolled(const Frame& frame) {
  SurfaceMesh mesh = frame.mesh;
  for (std::size_t k = 0; k < mesh.node.size(); ++k) mesh.node[k] = {frame.x[k], frame.section->at(frame.y[k]).arc, 0};
  Frame flat = build_frame(std::move(mesh), {});
  flat.used = frame.used;
  return flat;
}

/// Turns the entries a of the plane's block at one point and one node. angle: the tangent's at the point less its angle
/// at the node.
class Turned {
 public:
  explicit Turned(double angle) : c_(std::cos(0.5 * angle)), s_(std::sin(0.5 * angle)) {}

  /// Gives the displacement along t1 per traction along t2 and n.
  std::pair<double, double> along_by_others(double by_t2, double by_n) const {
    return {c_ * by_t2 - s_ * by_n, s_ * by_t2 + c_ * by_n};
  }
  /// Gives displacements along t2 and n per traction along t1.
  std::pair<double, double> others_by_along(double of_t2, double of_n) const {
    return {c_ * of_t2 + s_ * of_n, c_ * of_n - s_ * of_t2};
  }
  /// Turns by the whole angle what turns with both axes; the rest stays.
  void across(double (&a)[2][2]) const {
    const double whole_c = c_ * c_ - s_ * s_, whole_s = 2 * c_ * s_;
    const double mean = 0.5 * (a[0][0] + a[1][1]), skew = 0.5 * (a[1][0] - a[0][1]);
    const double rest = 0.5 * (a[0][0] - a[1][1]), mixed = 0.5 * (a[0][1] + a[1][0]);
    const double p = whole_c * mean + whole_s * skew, q = whole_c * skew - whole_s * mean;
    a[0][0] = p + rest;
    a[1][1] = p - rest;
    a[1][0] = mixed + q;
    a[0][1] = mixed - q;
  }

 private:
  double c_, s_;
};

class UnrolledHalfspace final : public Compliance {
 public:
  UnrolledHalfspace(const Frame& frame, HalfspaceConstants c, double tolerance, int threads)
      : section_(frame.section), flat_(unrolled(frame)) {
    plane_ = make_halfspace_compliance(flat_, c, tolerance, threads);
    for (const double y : frame.y) angle_.push_back(section_->at(y).angle);
    const auto [least, greatest] = std::minmax_element(angle_.begin(), angle_.end());
    turns_ = *least < *greatest;
  }

  std::int64_t nodes() const override { return plane_->nodes(); }
  bool couples() const override { return turns_ || plane_->couples(); }
  void set_threads(int threads) override { plane_->set_threads(threads); }
  std::int64_t kernel_evaluations() const override { return plane_->kernel_evaluations(); }
  std::size_t bytes() const override { return plane_->bytes() + angle_.size() * sizeof(double) * 8; }
  std::string description() const override {
    return "half-spaces under a conformal contact: the frame unrolled into a plane, tractions and displacements turned "
           "with it";
  }

  void block(Points points, const ComplianceBlock& out) const override {
    ComplianceBlock wanted;
    double something = 0;  // BlockBuffer asks whether there is a destination
    const auto want = [&](std::size_t i, std::size_t j) { wanted.a[i][j] = &something; };
    if (out.a[0][0]) want(0, 0);
    if (out.a[0][1] || out.a[0][2]) want(0, 1), want(0, 2);
    if (out.a[1][0] || out.a[2][0]) want(1, 0), want(2, 0);
    if (out.a[1][1] || out.a[1][2] || out.a[2][1] || out.a[2][2]) want(1, 1), want(1, 2), want(2, 1), want(2, 2);
    const BlockBuffer plane(wanted, points.size(), nodes());
    std::vector<double> arc(points.size()), angle(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
      const SectionLine::Point at = section_->at(points.y[p]);
      arc[p] = at.arc;
      angle[p] = at.angle;
    }
    plane_->block({points.x, arc}, plane.block());
    for (std::size_t p = 0; p < points.size(); ++p) turn(plane, p, angle[p], out);
  }

  void apply(Points points, const double* traction, double* displacement) const override {
    constexpr std::size_t chunk = 64;
    const std::size_t n = angle_.size();
    std::vector<double> row[3][3];
    ComplianceBlock out;
    out.stride = static_cast<std::ptrdiff_t>(n);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        row[i][j].resize(std::min(chunk, points.size()) * n);
        out.a[i][j] = row[i][j].data();
      }
    for (std::size_t first = 0; first < points.size(); first += chunk) {
      const std::size_t count = std::min(chunk, points.size() - first);
      block({points.x.subspan(first, count), points.y.subspan(first, count)}, out);
      for (std::size_t p = 0; p < count; ++p)
        for (std::size_t i = 0; i < 3; ++i) {
          double sum = 0;
          for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < n; ++k) sum += row[i][j][p * n + k] * traction[3 * k + j];
          displacement[3 * (first + p) + i] = sum;
        }
    }
  }

 private:
  void turn(const BlockBuffer& plane, std::size_t p, double angle, const ComplianceBlock& out) const {
    const auto to = [&](std::size_t i, std::size_t j) {
      return out.a[i][j] ? out.a[i][j] + static_cast<std::ptrdiff_t>(p) * out.stride : nullptr;
    };
    double* destination[3][3];
    const double* source[3][3];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        destination[i][j] = to(i, j);
        source[i][j] = plane.block().a[i][j] ? plane.row(i, j, p) : nullptr;
      }
    const auto put = [&](std::size_t i, std::size_t j, std::size_t k, double value) {
      if (destination[i][j]) destination[i][j][k] = value;
    };
    for (std::size_t k = 0; k < angle_.size(); ++k) {
      const Turned turned(angle - angle_[k]);
      if (source[0][0]) put(0, 0, k, source[0][0][k]);
      if (source[0][1]) {
        const auto [by_t2, by_n] = turned.along_by_others(source[0][1][k], source[0][2][k]);
        put(0, 1, k, by_t2);
        put(0, 2, k, by_n);
      }
      if (source[1][0]) {
        const auto [of_t2, of_n] = turned.others_by_along(source[1][0][k], source[2][0][k]);
        put(1, 0, k, of_t2);
        put(2, 0, k, of_n);
      }
      if (!source[1][1]) continue;
      double a[2][2];
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) a[i][j] = source[i + 1][j + 1][k];
      turned.across(a);
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) put(i + 1, j + 1, k, a[i][j]);
    }
  }

  std::shared_ptr<const SectionLine> section_;
  Frame flat_;
  std::unique_ptr<Compliance> plane_;
  std::vector<double> angle_;  ///< tangents' angles at the nodes
  bool turns_ = false;
};

}  // namespace

std::unique_ptr<Compliance> make_unrolled_compliance(const Frame& frame, HalfspaceConstants c, double tolerance,
                                                     int threads) {
  return std::make_unique<UnrolledHalfspace>(frame, c, tolerance, threads);
}

}  // namespace rollcon
