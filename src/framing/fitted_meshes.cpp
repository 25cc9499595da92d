#include "framing/fitted_meshes.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {
namespace {

Rectangle around(const Rectangle& a, const Rectangle& b) {
  return {std::min(a.x_least, b.x_least), std::max(a.x_greatest, b.x_greatest), std::min(a.y_least, b.y_least),
          std::max(a.y_greatest, b.y_greatest)};
}

/// Describes what a lattice covers, and the sizes of its cells.
struct Cover {
  Rectangle box{};
  double along = 0, across = 0;

  /// Says whether both are less than two cells apart.
  bool beside(const Cover& other) const {
    const double x = 2 * std::max(along, other.along), y = 2 * std::max(across, other.across);
    return box.x_least - x < other.box.x_greatest && other.box.x_least - x < box.x_greatest &&
           box.y_least - y < other.box.y_greatest && other.box.y_least - y < box.y_greatest;
  }
};

/// Returns one cover for all outlines or, on conformal frames, one for each group of outlines beside each other.
std::vector<Cover> covers_of(const FrameShape& shape, std::int64_t along, std::int64_t across) {
  std::vector<Cover> cover;
  const std::vector<Rectangle> box = shape.boxes();
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Rectangle& b = box[i];
    const double more = shape.outline.empty() ? 1 : shape.outline[i].more_strips();
    Cover now{b, (b.x_greatest - b.x_least) / static_cast<double>(along),
              (b.y_greatest - b.y_least) / (more * static_cast<double>(across))};
    for (auto before = cover.begin(); before != cover.end();) {
      if (shape.conformal && !now.beside(*before)) {
        ++before;
        continue;
      }
      now = {around(now.box, before->box), std::min(now.along, before->along), std::min(now.across, before->across)};
      cover.erase(before);
      before = cover.begin();
    }
    cover.push_back(now);
  }
  return cover;
}

// Counts the intervals of a stretched range with one more on either side. The range stops earlier where a body ends.
std::int64_t intervals(double stretch, double& low, double& high, double size,
                       const std::function<double(double)>& gap) {
  const double more = size + 0.5 * (stretch - 1) * (high - low), middle = 0.5 * (low + high);
  // Ends of tilted bodies are slightly curved.
  const double before = 1e-4 * size;
  const auto first = end_of_body(gap, middle, low - more), last = end_of_body(gap, middle, high + more);
  low = first ? *first + before : low - more;
  high = last ? *last - before : high + more;
  return std::max<std::int64_t>(to_index(std::round((high - low) / size)), 2);
}

RectangleCells cells_over(const FrameShape& shape, const GapBetween& gap, Cover c, std::int64_t along) {
  // Contacts are wider near a sharp end, over a length like their width.
  constexpr double longest = 2;  // cells
  constexpr std::int64_t most = 32;
  Rectangle& b = c.box;
  if (shape.sharp) {
    c.across =
        std::min(c.across, std::max(longest * c.along, (b.y_greatest - b.y_least) / static_cast<double>(most * along)));
    const double wider = 0.15 * (b.x_greatest - b.x_least);
    b.x_least -= wider;
    b.x_greatest += wider;
  }
  const double x = 0.5 * (b.x_least + b.x_greatest), y = 0.5 * (b.y_least + b.y_greatest);
  const auto nx = intervals(shape.stretch, b.x_least, b.x_greatest, c.along, [&](double at) { return gap(at, y); }),
             ny = intervals(shape.stretch, b.y_least, b.y_greatest, c.across, [&](double at) { return gap(x, at); });
  return {b, nx, ny};
}

// Draws back outermost strips that leave the body in their middle or at their ends, and with them all strips between
// them and the middle.
void keep_on_body(std::vector<Strip>& strip, const GapBetween& gap) {
  const std::size_t half = strip.size() / 2;
  for (const bool upper : {false, true}) {
    const Strip last = upper ? strip.back() : strip.front();
    const double inside = strip[half].y;
    const auto widest = [&](double y) {
      return std::max({gap(last.from, y), gap(0.5 * (last.from + last.to), y), gap(last.to, y)});
    };
    const auto end = end_of_body(widest, inside, last.y);
    if (!end) continue;
    constexpr double rounding = 1e-6;
    const double part = (1 - rounding) * (*end - inside) / (last.y - inside);
    for (std::size_t i = upper ? half + 1 : 0; i < (upper ? strip.size() : half); ++i)
      strip[i].y = inside + part * (strip[i].y - inside);
  }
}

// Cuts a strip at the end of a body if the strip would end a little before it or beyond it.
void cut_where_body_ends(Strip& strip, const GapBetween& gap) {
  const double middle = 0.5 * (strip.from + strip.to), before = 0.05 * (strip.to - strip.from);
  const auto along = [&](double x) { return gap(x, strip.y); };
  for (double* const end : {&strip.from, &strip.to})
    *end = end_of_body(along, middle, *end + std::copysign(before, *end - middle)).value_or(*end);
}

}  // namespace

std::optional<double> end_of_body(const std::function<double(double)>& gap, double inside, double outside) {
  constexpr int halvings = 50;
  if (std::isfinite(gap(outside)) || !std::isfinite(gap(inside))) return std::nullopt;
  for (int i = 0; i < halvings; ++i) {
    const double x = 0.5 * (inside + outside);
    (std::isfinite(gap(x)) ? inside : outside) = x;
  }
  return inside;
}

static Rectangle around_ellipse(const FramePlace& place) {
  const double x = std::hypot(place.length, place.shear), y = place.width;
  return {-x, x, -y, y};
}

std::vector<Rectangle> FrameShape::boxes() const {
  if (outline.empty()) return {around_ellipse(place)};
  std::vector<Rectangle> each;
  for (const Outline& of : outline) each.push_back(of.box());
  return each;
}

void FrameShape::find_box() {
  constexpr double wider = 1.15;
  Rectangle all = outline.empty() ? around_ellipse(place) : outline.front().box();
  for (const Outline& of : outline) all = around(all, of.box());
  const double x = 0.5 * (all.x_least + all.x_greatest), y = 0.5 * (all.y_least + all.y_greatest),
               half_x = 0.5 * wider * (all.x_greatest - all.x_least),
               half_y = 0.5 * wider * (all.y_greatest - all.y_least);
  box = {x - half_x, x + half_x, y - half_y, y + half_y};
}

SurfaceMesh strips_over(const FrameShape& shape, const GapBetween& gap, const Axes& axes, std::int64_t along,
                        std::int64_t across) {
  std::vector<std::vector<Strip>> patch;
  for (const Outline& outline : shape.outline) {
    patch.push_back(outline.strips(across, shape.stretch, shape.at_body_ends));
    keep_on_body(patch.back(), gap);
    for (Strip& strip : patch.back()) cut_where_body_ends(strip, gap);
  }
  return strips_mesh(axes, patch, along);
}

SurfaceMesh lattice_over(const FrameShape& shape, const GapBetween& gap, const Axes& axes, std::int64_t along,
                         std::int64_t across) {
  std::vector<RectangleCells> lattice;
  for (const Cover& c : covers_of(shape, along, across)) lattice.push_back(cells_over(shape, gap, c, along));
  return rectangles_mesh(axes, ElementType::quad4, lattice);
}

}  // namespace rollcon
