#include "wheelrail/patch_past.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "framing/makers.hpp"
#include "geometry/vec2.hpp"
#include "mesh/lattice_values.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Returns where the axes of a past patch have their origin in the plane of others; none where their planes differ.
std::optional<Vec2> origin_in(const Axes& axes, const PatchPast& p) {
  constexpr double least = 0.5;  // cosine of 60 degrees
  if (!(dot(p.axes.n, axes.n) > least)) return std::nullopt;
  const Vec3 off = p.axes.origin - axes.origin;
  Vec2 at{dot(off, axes.t1), dot(off, axes.t2)};
  constexpr double rounding = 1e-9;
  const double cell = (p.cells.box.x_greatest - p.cells.box.x_least) / static_cast<double>(p.cells.along);
  for (double& a : at)
    if (std::abs(a) < rounding * cell) a = 0;
  return at;
}

Rectangle moved(const Rectangle& r, const Vec2& by) {
  return {r.x_least + by[0], r.x_greatest + by[0], r.y_least + by[1], r.y_greatest + by[1]};
}

double common_area(const Rectangle& a, const Rectangle& b) {
  const double x = std::min(a.x_greatest, b.x_greatest) - std::max(a.x_least, b.x_least);
  const double y = std::min(a.y_greatest, b.y_greatest) - std::max(a.y_least, b.y_least);
  return x > 0 && y > 0 ? x * y : 0;
}

/// Returns the patch that counts most in a box; null: none.
const PatchPast* greatest_in(const WheelPast& past, const Axes& axes, const Rectangle& box) {
  const PatchPast* greatest = nullptr;
  double most = 0;
  for (const PatchPast& p : past.patch) {
    const auto at = origin_in(axes, p);
    const double size = at ? p.weight * p.depth * common_area(moved(p.cells.box, *at), box) : 0;
    if (size > most) greatest = &p, most = size;
  }
  return greatest;
}

/// Returns the cells of a patch, widened by whole ones to cover a rectangle.
RectangleCells widened(RectangleCells cells, const Rectangle& to) {
  const auto widen = [](double& low, double& high, std::int64_t& n, double from, double until) {
    const double cell = (high - low) / static_cast<double>(n);
    const auto below = std::max<std::int64_t>(0, to_index(std::ceil((low - from) / cell))),
               above = std::max<std::int64_t>(0, to_index(std::ceil((until - high) / cell)));
    low -= static_cast<double>(below) * cell;
    high += static_cast<double>(above) * cell;
    n += below + above;
  };
  widen(cells.box.x_least, cells.box.x_greatest, cells.along, to.x_least, to.x_greatest);
  widen(cells.box.y_least, cells.box.y_greatest, cells.across, to.y_least, to.y_greatest);
  return cells;
}

Frame frame_of(const RectangleCells& cells) {
  return build_frame(rectangle_mesh({}, ElementType::quad4, cells.along, cells.across, cells.box), {});
}

}  // namespace

Vec3 origin_from(const WheelPast& past, const Axes& axes, const Rectangle& box) {
  const PatchPast* const p = greatest_in(past, axes, box);
  if (!p) return axes.origin;
  const Vec2 at = *origin_in(axes, *p);
  return axes.origin + at[0] * axes.t1 + at[1] * axes.t2;
}

RectangleCells start_from(const WheelPast& past, const Axes& axes, const Rectangle& box, double overlap,
                          PastStep& start, GridFrame& made) {
  start = {};
  start.time = past.time;
  start.steps = past.steps;
  const PatchPast* const greatest = greatest_in(past, axes, box);
  if (!greatest) return {};
  RectangleCells cells{moved(greatest->cells.box, *origin_in(axes, *greatest)), greatest->cells.along,
                       greatest->cells.across};
  std::vector<std::pair<const PatchPast*, Rectangle>> part;
  for (const PatchPast& p : past.patch)
    if (const auto at = origin_in(axes, p))
      if (const Rectangle sides = moved(p.cells.box, *at); common_area(sides, box) > 0) {
        part.emplace_back(&p, sides);
        cells = widened(cells, sides);
      }
  if (!made.frame || !(made.cells == cells)) {
    auto frame = std::make_shared<FrameOfPast>();
    frame->frame = frame_of(cells);
    made = {cells, std::move(frame)};
  }
  start.on = made.frame;
  const std::size_t n = start.on->frame.x.size();
  for (auto& lambda : start.lambda) lambda.assign(n, 0.0);
  const std::optional<Lattice> to = find_lattice(start.on->frame);
  std::vector<double> carried;
  for (const auto& [p, sides] : part) {
    const bool same = part.size() == 1;
    const std::optional<Lattice> from =
        same ? std::nullopt : find_lattice(frame_of({sides, p->cells.along, p->cells.across}));
    for (std::size_t c = 0; c < 3; ++c) {
      if (!same) carry_to_lattice(*from, p->traction[c], *to, carried);
      const std::vector<double>& value = same ? p->traction[c] : carried;
      for (std::size_t k = 0; k < n; ++k) start.lambda[c][k] += p->weight * value[k];
    }
  }
  start.loaded = std::any_of(start.lambda[2].begin(), start.lambda[2].end(), [](double l) { return l < 0; });
  start.motion[approach] = greatest->depth - overlap;
  return cells;
}

}  // namespace rollcon
