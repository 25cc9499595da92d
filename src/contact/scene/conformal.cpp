#include "contact/scene/conformal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "geometry/surface.hpp"
#include "mesh/section_line.hpp"

namespace rollcon {
namespace {

double compliance_of(const Body& body) {
  return body.rigid() ? 0 : halfspace_constants(body.young(), body.poisson(), 1).cn;
}

struct Slope {
  double height = 0, tangent = 0;
};

/// Cuts both bodies across the rolling direction, in the plane through the axes' origin.
class Section {
 public:
  Section(const Axes& axes, const PairOfBodies& pair) : axes_(axes), pair_(pair) {
    const std::array<double, 2> c{compliance_of(*pair.body[0]), compliance_of(*pair.body[1])};
    share_ = {c[1] / (c[0] + c[1]), c[0] / (c[0] + c[1])};
  }

  /// Returns nothing where neither body is there.
  std::optional<SectionLine::Place> at(double y) const {
    std::array<std::optional<Slope>, 2> of{of_body(0, y), of_body(1, y)};
    if (!of[0] && !of[1]) return std::nullopt;
    for (std::size_t b = 0; b < 2; ++b)
      if (!of[b]) of[b] = of[1 - b];
    const double tangent = share_[0] * of[0]->tangent + share_[1] * of[1]->tangent;
    return SectionLine::Place{y, share_[0] * of[0]->height + share_[1] * of[1]->height, std::atan(tangent)};
  }

 private:
  std::optional<Slope> of_body(std::size_t b, double y) const {
    const Surface* const surface = pair_.body[b]->surface();
    if (!surface) return Slope{};
    const Pose& pose = pair_.pose[b];
    const Vec3 from = pose.to_body(plane_point(axes_, 0, y)), direction = pose.turn_back(axes_.n),
               facing = (b == 0 ? 1.0 : -1.0) * direction;
    const auto met = surface->distance(from, direction, facing);
    const auto normal = surface->normal(from, direction, facing);
    if (!met || !normal) return std::nullopt;
    const Vec3 n = pose.turn(*normal);
    return Slope{*met, -dot(n, axes_.t2) / dot(n, axes_.n)};
  }

  const Axes& axes_;
  const PairOfBodies& pair_;
  std::array<double, 2> share_{};  ///< weights of the bodies in the surface between them
};

std::vector<double> distinct(std::vector<double> y) {
  constexpr double rounding = 1e-12;
  std::sort(y.begin(), y.end());
  const double same = rounding * (y.back() - y.front());
  std::vector<double> out;
  for (const double v : y)
    if (out.empty() || v - out.back() > same) out.push_back(v);
  return out;
}

}  // namespace

bool is_conformal(const Scene& scene, const PairOfBodies& pair) {
  return scene.options.conformal > 0 && !pair.meshed() && (pair.body[0]->surface() || pair.body[1]->surface());
}

void follow_section(Frame& frame, const PairOfBodies& pair) {
  const Section section(frame.axes, pair);
  std::vector<SectionLine::Place> place;
  for (const double y : distinct(frame.y))
    if (const auto at = section.at(y)) place.push_back(*at);
  if (place.empty()) return;  // the gap tells of bodies that are not there
  // Beyond the bodies the line goes on straight.
  const auto on_line = [&](double y) {
    const auto after =
        std::lower_bound(place.begin(), place.end(), y, [](const SectionLine::Place& p, double v) { return p.y < v; });
    const auto before = after == place.begin() ? after : after - 1;
    const SectionLine::Place& nearest =
        after == place.end() || std::abs(before->y - y) < std::abs(after->y - y) ? *before : *after;
    return SectionLine::Place{y, nearest.height + (y - nearest.y) * std::tan(nearest.angle), nearest.angle};
  };
  const Axes& axes = frame.axes;
  std::vector<Vec3> normal(frame.y.size());
  for (std::size_t k = 0; k < frame.y.size(); ++k) {
    const SectionLine::Place at = on_line(frame.y[k]);
    frame.z[k] = at.height;
    frame.mesh.node[k] = plane_point(axes, frame.x[k], frame.y[k]) + at.height * axes.n;
    normal[k] = std::cos(at.angle) * axes.n - std::sin(at.angle) * axes.t2;
  }
  frame.section = std::make_shared<const SectionLine>(std::move(place));
  curve_frame(frame, normal);
  if (!frame.curved()) frame.section.reset();
}

}  // namespace rollcon
