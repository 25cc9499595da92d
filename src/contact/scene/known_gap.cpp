#include "contact/scene/known_gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "geometry/surface.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

class GapOnGrid final : public KnownGap {
 public:
  explicit GapOnGrid(std::shared_ptr<const HeightGrid> grid) : owned_(std::move(grid)), grid_(*owned_) {}

  double operator()(double x, double y) const override { return grid_(x, y); }
  bool heights(double x, double y, Heights& found) const override {
    found = {};
    found.height[1] = grid_(x, y, &found.slope[1]);
    return std::isfinite(found.height[1]);
  }
  bool ends_at(double x, double y, double) const override { return grid_.ends_at(x, y); }
  Rectangle bounds() const override {
    const GridPlace& on = grid_.place();
    return {on.x_least, on.x_greatest, on.y_least, on.y_greatest};
  }
  const char* beyond_bounds() const override {
    return "the contact reaches the end of the grid of the gap: give a larger one, or +infinity where a body ends "
           "(rollcon_contact_set_gap_grid)";
  }

 private:
  std::shared_ptr<const HeightGrid> owned_;
  const HeightGrid& grid_;
};

/// Holds a strip low <= along . (x, y) <= high.
struct Between {
  std::array<double, 2> along{};
  double low = 0, high = 0;

  double at(const std::array<double, 2>& p) const { return along[0] * p[0] + along[1] * p[1]; }
};

/// Keeps where surfaces were met, by y, as hints for points nearby.
class PlacesMet {
 public:
  PlacesMet() = default;
  PlacesMet(double low, double high) : low_(low), per_length_(count / (high - low)) {}
  /// Returns the hints of both bodies at y. A place where nothing was met yet takes those of the nearest place.
  std::array<SurfaceHint, 2>& at(double y) {
    const double place = (y - low_) * per_length_;
    const int i = !(place > 0) ? 0 : place < count - 1 ? static_cast<int>(place) : count - 1;
    if (!known_[i]) {
      int from = last_;
      for (int k = 1; k < std::abs(from - i); ++k)
        for (const int beside : {i - k, i + k})
          if (beside >= 0 && beside < count && known_[beside]) from = beside;
      hint_[i] = hint_[from];
      known_[i] = true;
    }
    last_ = i;
    return hint_[i];
  }

 private:
  static constexpr int count = 32;
  double low_ = 0, per_length_ = 0;
  int last_ = 0;
  std::array<bool, count> known_{};
  std::array<std::array<SurfaceHint, 2>, count> hint_;
};

/// Finds the gap of two bodies, one of which has a surface at least: measured, or where both are there the given one.
class GapOfSurfaces final : public KnownGap {
 public:
  GapOfSurfaces(const Axes& axes, const PairOfBodies& pair, const std::optional<std::array<double, 3>>& given)
      : axes_(axes), pair_(pair), given_(given) {
    constexpr double rounding = 1e-14;
    for (std::size_t b = 0; b < 2; ++b) {
      const Surface* const surface = pair.body[b]->surface();
      const auto endless = surface ? surface->endless() : std::nullopt;
      straight_[b] = endless && std::abs(dot(pair.pose[b].turn(*endless), axes.t1)) > 1 - rounding;
    }
  }

  double operator()(double x, double y) const override {
    const double gap = along(plane_point(axes_, x, y), axes_.n, y);
    return given_ && std::isfinite(gap) ? (*given_)[0] * x * x + (*given_)[1] * y * y + (*given_)[2] * x * y : gap;
  }

  bool heights(double x, double y, Heights& found) const override {
    const Vec3 point = plane_point(axes_, x, y);
    std::array<SurfaceHint, 2>& hint = met_.at(y);
    for (std::size_t b = 0; b < 2; ++b) {
      found.height[b] = 0;
      found.slope[b] = {};
      const Surface* const surface = pair_.body[b]->surface();
      if (!surface) continue;
      if (straight_[b] && y == last_y_) {
        found.height[b] = last_.height[b];
        found.slope[b] = last_.slope[b];
        continue;
      }
      const Pose& pose = pair_.pose[b];
      const Vec3 direction = pose.turn_back(axes_.n), from = pose.to_body(point);
      const auto met = surface->distance_near(from, direction, (b == 0 ? 1.0 : -1.0) * direction, hint[b]);
      if (!met) {
        last_y_ = NAN;
        return false;
      }
      const Vec3 n = pose.turn(surface->normal_met(from + *met * direction, direction, hint[b]));
      const double steep = dot(n, axes_.n);
      found.height[b] = *met;
      found.slope[b] = {-dot(n, axes_.t1) / steep, -dot(n, axes_.t2) / steep};
    }
    last_y_ = y;
    last_ = found;
    return true;
  }

  /// Returns the way from body 1 to body 2 along a line through a point; y: its place in look_over's region.
  double along(const Vec3& point, const Vec3& n, double y) const {
    std::array<SurfaceHint, 2>& hint = met_.at(y);
    double gap = 0;
    for (std::size_t b = 0; b < 2; ++b) {
      const Surface* const surface = pair_.body[b]->surface();
      if (!surface) {  // the axes' plane
        const double met = dot(axes_.origin - point, axes_.n) / dot(n, axes_.n);
        gap += b == 0 ? -met : met;
        continue;
      }
      const Pose& pose = pair_.pose[b];
      const Vec3 direction = pose.turn_back(n);
      const auto met =
          surface->distance_near(pose.to_body(point), direction, (b == 0 ? 1.0 : -1.0) * direction, hint[b]);
      if (!met) return INFINITY;
      gap += b == 0 ? -*met : *met;
    }
    return gap;
  }
  bool measured() const { return !given_; }

  void look_over(const Rectangle& box) override { met_ = PlacesMet(box.y_least, box.y_greatest); }

  // Looks along both diagonals, of which one passes any edge; edges of tilted bodies are slightly curved.
  bool ends_at(double x, double y, double size) const override {
    const double beside = 2e-2 * size;
    for (const double sx : {-beside, beside})
      for (const double sy : {-beside, beside})
        if (!std::isfinite((*this)(x + sx, y + sy))) return true;
    return false;
  }

  // Returns the box about the corners of what lies between all pairs of parallel lines that bound a body.
  Rectangle bounds() const override {
    std::array<Between, 8> place;
    const std::span<const Between> all = lines(place);
    constexpr double rounding = 1e-9, parallel = 1e-9;
    double size = 0;
    for (const Between& l : all) size = std::max({size, std::abs(l.low), std::abs(l.high)});
    Rectangle box{INFINITY, -INFINITY, INFINITY, -INFINITY};
    bool crossing = false;
    for (const Between& l : all)
      for (const Between& m : all) {
        const double sine = l.along[0] * m.along[1] - l.along[1] * m.along[0];
        if (!(sine > parallel)) continue;
        crossing = true;
        for (const double a : {l.low, l.high})
          for (const double b : {m.low, m.high}) {
            const std::array p{(a * m.along[1] - b * l.along[1]) / sine, (b * l.along[0] - a * m.along[0]) / sine};
            if (!std::all_of(all.begin(), all.end(), [&](const Between& k) {
                  return k.at(p) >= k.low - rounding * size && k.at(p) <= k.high + rounding * size;
                }))
              continue;
            box = {std::min(box.x_least, p[0]), std::max(box.x_greatest, p[0]), std::min(box.y_least, p[1]),
                   std::max(box.y_greatest, p[1])};
          }
      }
    if (!crossing)
      fail(Status::err_state,
           "no frame was given, and the bodies go on without end along one direction: the library makes frames where a "
           "profile is revolved, or where two extruded ones cross; else call a maker of frames");
    if (!(box.x_least < box.x_greatest && box.y_least < box.y_greatest))
      fail(Status::err_state,
           "no frame was given, and seen along the normal of the axes no part of one body lies over the other: check "
           "profiles, poses (rollcon_contact_set_pose) and axes (rollcon_contact_set_axes)");
    return box;
  }

  const char* beyond_bounds() const override { return nullptr; }

 private:
  /// Returns the strip that each body covers in each of its directions, once by either normal.
  std::span<const Between> lines(std::array<Between, 8>& all) const {
    std::size_t n = 0;
    const auto add = [&](const Surface& surface, const Pose& pose, const std::array<double, 2>& a) {
      const Vec3 direction = a[0] * axes_.t1 + a[1] * axes_.t2;
      const auto [low, high] = surface.extent(pose.turn_back(direction));
      const double shift = dot(pose.translation - axes_.origin, direction);
      all[n++] = {a, low + shift, high + shift};
      all[n++] = {{-a[0], -a[1]}, -high - shift, -low - shift};
    };
    for (std::size_t b = 0; b < 2; ++b) {
      const Surface* const surface = pair_.body[b]->surface();
      if (!surface) continue;
      const Pose& pose = pair_.pose[b];
      if (const auto endless = surface->endless()) {
        const Vec3 e = pose.turn(*endless);
        const std::array across{-dot(e, axes_.t2), dot(e, axes_.t1)};
        const double length = std::hypot(across[0], across[1]);
        if (length > 0) add(*surface, pose, {across[0] / length, across[1] / length});
      } else {
        add(*surface, pose, {1, 0});
        add(*surface, pose, {0, 1});
      }
    }
    return std::span(all).first(n);
  }

  Axes axes_;
  PairOfBodies pair_;
  std::optional<std::array<double, 3>> given_;  ///< coefficients of x^2, y^2, xy
  mutable PlacesMet met_;
  std::array<bool, 2> straight_{};  ///< bodies that go on without end along t1
  mutable double last_y_ = NAN;     ///< y of the heights found last
  mutable Heights last_;
};

// Fills in the gap, at(k) at node k. Frames made by the library cover holes of a body, where nothing touches.
template <class At>
void fill(const KnownGap& known, const Frame& frame, At at, std::vector<double>& gap) {
  gap.resize(frame.x.size());
  double greatest = 0;
  bool holes = false;
  for (std::size_t k = 0; k < gap.size(); ++k) {
    gap[k] = at(k);
    if (std::isfinite(gap[k]))
      greatest = std::max(greatest, gap[k]);
    else
      holes = true;
  }
  if (!holes) return;
  const Rectangle all = known.bounds();
  const double far = greatest + 100 * (all.x_greatest - all.x_least + all.y_greatest - all.y_least);
  for (double& g : gap)
    if (!std::isfinite(g)) g = far;
}

}  // namespace

bool is_gap_known(const Scene& scene, const PairOfBodies& pair) {
  if (scene.gap_grid()) return true;
  if (scene.has_gap()) return scene.quadratic_gap() && pair.meshed();
  return pair.body[0]->has_surface() || pair.body[1]->has_surface();
}

std::unique_ptr<KnownGap> known_gap(const Scene& scene, const PairOfBodies& pair) {
  if (!is_gap_known(scene, pair)) return nullptr;
  if (scene.gap_grid()) return std::make_unique<GapOnGrid>(scene.gap_grid());
  return std::make_unique<GapOfSurfaces>(scene.axes(), pair, scene.quadratic_gap());
}

void update_known_gap(const Scene& scene, const PairOfBodies& pair, std::unique_ptr<KnownGap>& gap) {
  auto* const surfaces = dynamic_cast<GapOfSurfaces*>(gap.get());
  if (surfaces && is_gap_known(scene, pair) && !scene.gap_grid())
    *surfaces = GapOfSurfaces(scene.axes(), pair, scene.quadratic_gap());
  else
    gap = known_gap(scene, pair);
}

bool fill_known_gap(const Scene& scene, const PairOfBodies& pair, const Frame& frame, std::vector<double>& gap) {
  if (!is_gap_known(scene, pair)) return false;
  const auto above = [&](const KnownGap& known) {
    fill(
        known, frame, [&](std::size_t k) { return known(frame.x[k], frame.y[k]); }, gap);
  };
  if (scene.gap_grid()) {
    above(GapOnGrid(scene.gap_grid()));
    return true;
  }
  const GapOfSurfaces surfaces(scene.axes(), pair, scene.quadratic_gap());
  if (frame.section && surfaces.measured())
    fill(
        surfaces, frame, [&](std::size_t k) { return surfaces.along(frame.mesh.node[k], frame.n[k], 0); }, gap);
  else
    above(surfaces);
  return true;
}

}  // namespace rollcon
