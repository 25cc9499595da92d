#include "framing/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double pi = std::numbers::pi;

// Fits y = c0 + c1 x + c2 x^2 by least squares, x from their mean; returns false where the points do not tell.
bool fit_parabola(std::span<const EdgePoint> point, double& origin, std::array<double, 3>& c) {
  origin = 0;
  for (const EdgePoint& p : point) origin += p.x / static_cast<double>(point.size());
  double scale = 0;
  for (const EdgePoint& p : point) scale = std::max(scale, std::abs(p.x - origin));
  if (point.size() < 5 || !(scale > 0)) return false;
  // Normal equations of three unknowns are solved by elimination.
  std::array<std::array<double, 4>, 3> a{};
  for (const EdgePoint& p : point) {
    const double x = (p.x - origin) / scale;
    const std::array v{1.0, x, x * x};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) a[i][j] += v[i] * v[j];
      a[i][3] += v[i] * p.y;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(a[i][i] > 1e-9 * static_cast<double>(point.size()))) return false;
    for (std::size_t r = 0; r < 3; ++r) {
      if (r == i) continue;
      const double factor = a[r][i] / a[i][i];
      for (std::size_t j = i; j < 4; ++j) a[r][j] -= factor * a[i][j];
    }
  }
  c = {a[0][3] / a[0][0], a[1][3] / a[1][1] / scale, a[2][3] / a[2][2] / (scale * scale)};
  return true;
}

}  // namespace

Outline::Outline(double x, double y, double radius) : x_middle_(x), y_middle_(y), half_height_(radius) {
  for (Side& side : side_) side = {{0.5 * pi}, {radius}, {1}};
  end_[0].y = y - radius, end_[1].y = y + radius;
}

void Outline::find_end(std::span<const EdgePoint> point, int which) {
  // Fraction of the height: so far a parabola is near an ellipse, and the points are seen along its normal.
  constexpr double near = 0.08, flat = 0.01;
  // Fraction of the length, of which an ellipse has 0.2 within `flat`.
  constexpr double wide = 0.4;
  const double sign = which == 0 ? -1 : 1;
  double extreme = -INFINITY, opposite = INFINITY, first = INFINITY, last = -INFINITY;
  for (const EdgePoint& p : point) {
    extreme = std::max(extreme, sign * p.y);
    opposite = std::min(opposite, sign * p.y);
    first = std::min(first, p.x);
    last = std::max(last, p.x);
  }
  const double height = extreme - opposite;
  std::vector<EdgePoint> close;
  End& end = end_[at(which)];
  std::size_t outermost = 0, of_body = 0;
  double least = INFINITY, greatest = -INFINITY;
  for (const EdgePoint& p : point) {
    if (sign * p.y > extreme - near * height) close.push_back(p);
    if (sign * p.y <= extreme - flat * height) continue;
    ++outermost;
    of_body += p.ends_body;
    least = std::min(least, p.x);
    greatest = std::max(greatest, p.x);
    if (sign * p.y == extreme) end.x = p.x;
  }
  end.y = sign * extreme;
  end.ends_body = of_body >= 3 && 2 * of_body > outermost;
  end.line = end.ends_body || greatest - least > wide * (last - first);
  if (end.line) {
    end.x = 0.5 * (least + greatest);
    return;
  }
  double origin = 0;
  std::array<double, 3> c{};
  if (!fit_parabola(close, origin, c) || !(sign * c[2] < 0)) return;
  const double top = -0.5 * c[1] / c[2];
  const auto [left, right] =
      std::minmax_element(close.begin(), close.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  if (origin + top < left->x || origin + top > right->x) return;
  end.x = origin + top;
  end.y = c[0] + 0.5 * c[1] * top;
}

// Returns the length of strips of an ellipse over its semi-axis.
static double shape(double height, bool line_below, bool line_above) {
  return std::sqrt((line_below ? 1 : std::max(0.0, 1 + height)) * (line_above ? 1 : std::max(0.0, 1 - height)));
}

Outline::Outline(std::span<const EdgePoint> point, std::span<const LoadAt> load, const EdgePoint& cell) {
  // Points nearer to the ends say little about the length of strips.
  constexpr double least_shape = 0.2;
  find_end(point, 0);
  find_end(point, 1);
  y_middle_ = 0.5 * (end_[0].y + end_[1].y);
  half_height_ = 0.5 * (end_[1].y - end_[0].y);
  x_middle_ = 0.5 * (end_[0].x + end_[1].x);
  slant_ = half_height_ > 0 ? 0.5 * (end_[1].x - end_[0].x) / half_height_ : 0;
  for (const double least : {least_shape, 0.0}) {
    for (const EdgePoint& p : point) {
      const double height = std::clamp((p.y - y_middle_) / half_height_, -1.0, 1.0);
      const double factor = shape(height, end_[0].line, end_[1].line), off = p.x - middle(p.y);
      if (!(factor > least)) continue;
      Side& side = side_[off > 0 ? 1 : 0];
      side.angle.push_back(std::acos(height));
      side.reach.push_back(std::abs(off) / factor);
      side.weight.push_back(factor * factor);
    }
    if (!side_[0].angle.empty() && !side_[1].angle.empty()) break;
  }
  // Edges of what is open inside are left out.
  for (Side& side : side_) {
    Side outer;
    for (std::size_t i = 0; i < side.angle.size(); ++i) {
      const double factor = std::sqrt(side.weight[i]), beside = 1.5 * cell.y / (half_height_ * std::max(factor, 0.3));
      bool inside = false;
      for (std::size_t j = 0; j < side.angle.size() && !inside; ++j)
        inside =
            std::abs(side.angle[j] - side.angle[i]) <= beside && (side.reach[j] - side.reach[i]) * factor > 2 * cell.x;
      if (inside) continue;
      outer.angle.push_back(side.angle[i]);
      outer.reach.push_back(side.reach[i]);
      outer.weight.push_back(side.weight[i]);
    }
    side = std::move(outer);
  }
  find_density(load, cell.y);
}

// Finds the strips' density. Between strips tractions are linear: what that misses grows with the second derivative of
// the load over y. Steps that go with its third root, here over that of an ellipse, miss least.
void Outline::find_density(std::span<const LoadAt> load, double cell) {
  constexpr int steps = 64;
  constexpr double most = 6, slack = 1.3;                  // factor that lattices leave of ellipses
  const double width = std::max(cell, half_height_ / 24);  // width of what is taken together
  const auto near = [&](double y) {
    double sum = 0;
    for (const LoadAt& l : load) sum += l.load * std::max(0.0, 1 - std::abs(l.y - y) / width);
    return sum;
  };
  double greatest = 0;
  for (int i = 1; i < steps; ++i) greatest = std::max(greatest, near(y_middle_ + half_height_ * (2.0 * i / steps - 1)));
  if (!(greatest > 0) || half_height_ < 4 * width) return;
  std::vector<double> density(steps + 1);
  for (int i = 0; i <= steps; ++i) {
    // The load ends with a slope: beside the ends it is taken as a little inside.
    const double inside = half_height_ - 2 * width;
    const double y = y_middle_ + std::clamp(half_height_ * std::cos(pi * i / steps), -inside, inside);
    const double turn = (near(y + width) - 2 * near(y) + near(y - width)) / (width * width);
    density[at(i)] =
        std::clamp(std::cbrt(0.5 * std::abs(turn) * half_height_ * half_height_ / greatest) / slack, 1.0, most);
  }
  passed_.assign(1, 0);
  for (int i = 0; i < steps; ++i) {
    const auto beside = [&](int k) { return density[at(std::clamp(k, 0, steps))]; };
    passed_.push_back(passed_.back() + (beside(i - 1) + beside(i) + beside(i + 1) + beside(i + 2)) / (4 * steps));
  }
}

Rectangle Outline::box() const {
  constexpr int steps = 64;
  Rectangle box{INFINITY, -INFINITY, end_[0].y, end_[1].y};
  for (const Strip& s : strips(steps, 1, AtBodyEnds::even)) {
    box.x_least = std::min(box.x_least, s.from);
    box.x_greatest = std::max(box.x_greatest, s.to);
  }
  return box;
}

double Outline::hollow() const {
  constexpr int steps = 32;
  const std::vector<Strip> all = strips(steps, 1, AtBodyEnds::even);
  const auto reach = [&](std::size_t i) { return all[i].to - all[i].from; };
  double longest = 0, deepest = 0;
  for (std::size_t j = 0; j < all.size(); ++j) {
    longest = std::max(longest, reach(j));
    for (std::size_t i = 0; i < j; ++i)
      for (std::size_t k = j + 1; k < all.size(); ++k) {
        const double part = (all[j].y - all[i].y) / (all[k].y - all[i].y);
        deepest = std::max(deepest, (1 - part) * reach(i) + part * reach(k) - reach(j));
      }
  }
  return longest > 0 ? deepest / longest : 0;
}

double Outline::angle_of(double part) const {
  if (passed_.empty()) return pi * part;
  const double wanted = part * passed_.back();
  const auto above = std::upper_bound(passed_.begin() + 1, passed_.end() - 1, wanted);
  const double before = *(above - 1), step = *above - before;
  return pi * (static_cast<double>(above - passed_.begin()) - 1 + (wanted - before) / step) /
         static_cast<double>(passed_.size() - 1);
}

// Takes a straight line by least squares through the points nearest to the angle, and goes little beyond their last.
double Outline::reach(const Side& side, double angle) const {
  constexpr std::size_t nearest = 9;
  const std::size_t n = side.angle.size();
  if (n == 0) return 0;
  std::vector<double> distance(n);
  for (std::size_t i = 0; i < n; ++i) distance[i] = std::abs(side.angle[i] - angle);
  std::vector<double> sorted = distance;
  const std::size_t k = std::min(nearest, n - 1);
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(k), sorted.end());
  const double width = std::max(1.001 * sorted[k], 1e-12);
  double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (distance[i] >= width) continue;
    const double part = distance[i] / width, tricube = 1 - part * part * part;
    const double weight = side.weight[i] * tricube * tricube * tricube, x = side.angle[i] - angle;
    w += weight;
    wx += weight * x;
    wy += weight * side.reach[i];
    wxx += weight * x * x;
    wxy += weight * x * side.reach[i];
  }
  const double determinant = w * wxx - wx * wx;
  const bool line = determinant > 1e-6 * w * w * width * width;
  constexpr double least = 0.05, most = 1.25;
  const double longest = *std::max_element(side.reach.begin(), side.reach.end());
  return std::max(least * longest, std::min(most * longest, line ? (wxx * wy - wx * wxy) / determinant : wy / w));
}

double Outline::height_of(double angle, AtBodyEnds at_ends) const {
  // Mirrored angles have the same cosine to the last digit.
  const auto cosine = [](double a) { return a > 0.5 * pi ? -std::cos(pi - a) : std::cos(a); };
  const bool even = at_ends == AtBodyEnds::even, lower = even && end_[0].ends_body, upper = even && end_[1].ends_body;
  if (lower && upper) return 1 - 2 * angle / pi;
  if (upper) return 1 - 2 * std::sin(0.5 * angle);
  if (lower) return 2 * std::cos(0.5 * angle) - 1;
  return cosine(angle);
}

std::vector<Strip> Outline::strips(std::int64_t across, double stretch, AtBodyEnds at_ends) const {
  std::vector<Strip> strip;
  const double more = passed_.empty() ? 1 : passed_.back();
  const auto last = 2 * to_index(std::round(0.5 * more * static_cast<double>(across)));
  // Fraction of the height. Beyond it lattices, whose hats are cut in half at the end, show too short a contact; strips
  // that are too long there cost little.
  constexpr double near_end = 0.8;
  for (std::int64_t j = last; j >= 0; --j) {
    const double height = height_of(angle_of(static_cast<double>(j) / static_cast<double>(last)), at_ends);
    const double angle = std::acos(std::clamp(height, -1.0, 1.0));
    const End& end = end_[height < 0 ? 0 : 1];
    const double y = y_middle_ + half_height_ * height * (end.ends_body ? 1 : stretch);
    const double factor = end.line || (j > 0 && j < last) ? shape(height, end_[0].line, end_[1].line) : 0;
    const double x = middle(y);
    const auto long_enough = [&](const Side& side) {
      const double there = reach(side, angle), beyond = std::abs(height) - near_end;
      if (!end.ends_body || beyond < 0) return there;
      // The contact is widest where a sharp end is pressed in.
      const double longer = at_ends == AtBodyEnds::closer ? 1 + 0.25 * beyond / (1 - near_end) : 1;
      return longer * std::max(there, reach(side, std::acos(std::copysign(near_end, height))));
    };
    strip.push_back({y, x - stretch * factor * long_enough(side_[0]), x + stretch * factor * long_enough(side_[1])});
  }
  return strip;
}

}  // namespace rollcon
