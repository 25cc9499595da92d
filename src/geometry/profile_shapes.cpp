#include "geometry/profile_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/profile_fit.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using Pieces = std::vector<ProfilePiece>;
using Parameters = std::span<const double>;

ProfilePiece arc(const Vec2& start, double angle, double length, double curvature) {
  ProfilePiece p;
  p.length = length;
  p.start = start;
  p.along = {std::cos(angle), std::sin(angle)};
  p.curvature = curvature;
  return p;
}

ProfilePiece straight(const Vec2& from, const Vec2& to) {
  const Vec2 d = to - from;
  return arc(from, std::atan2(d[1], d[0]), length(d), 0);
}

Vec2 end_of(const ProfilePiece& p) {
  return ProfileCurve({p}).at(0, p.length).x;
}

void require_positive(double value, const char* name) {
  if (!(value > 0)) fail(Status::err_argument, "%s is %g; allowed: > 0", name, value);
}

Pieces line(Parameters p) {
  require_positive(p[0], "half_width, parameter 1 of \"line\",");
  return {straight({-p[0], -p[0] * p[1]}, {p[0], p[0] * p[1]})};
}

Pieces circle(Parameters p) {
  const double radius = p[0], half = p[1];
  if (radius == 0) fail(Status::err_argument, "radius, parameter 1 of \"arc\", is 0; allowed: any other");
  if (!(half > 0 && half <= std::abs(radius)))
    fail(Status::err_argument, "half_width, parameter 2 of \"arc\", is %g; allowed: > 0, at most the radius, %g", half,
         std::abs(radius));
  const double angle = std::asin(half / radius), sagitta = half * std::tan(angle / 2);
  return {arc({-half, -sagitta}, angle, 2 * radius * angle, -1 / radius)};
}

Pieces chain(Parameters p) {
  Pieces all;
  Vec2 start{p[0], p[1]};
  double angle = p[2];
  for (std::size_t i = 3; i < p.size(); i += 2) {
    if (!(p[i] > 0))
      fail(Status::err_argument, "length, parameter %d of \"arcs\" (counting from 1), is %g; allowed: > 0",
           static_cast<int>(i) + 1, p[i]);
    if (std::abs(p[i] * p[i + 1]) > std::numbers::pi)
      fail(Status::err_argument,
           "length and curvature, parameters %d and %d of \"arcs\" (counting from 1), turn by %g; allowed: at most a "
           "half circle each",
           static_cast<int>(i) + 1, static_cast<int>(i) + 2, std::abs(p[i] * p[i + 1]));
    all.push_back(arc(start, angle, p[i], p[i + 1]));
    start = end_of(all.back());
    angle += p[i] * p[i + 1];
  }
  return all;
}

/// Returns an arc of the circle about `centre`, on the side of greater z (side 1) or less (-1), between two values of
/// y.
ProfilePiece arc_between(double from, double to, const Vec2& centre, double radius, double side) {
  const double first = std::asin((from - centre[0]) / radius), last = std::asin((to - centre[0]) / radius);
  const Vec2 start{from, centre[1] + side * radius * std::cos(first)};
  return arc(start, -side * first, radius * (last - first), -side / radius);
}

/// Builds z = relief ln(1 - k (y / half_width)^2), up to where it is 45 degrees steep, and quarter circles beyond.
Pieces roller(Parameters p) {
  const double half = p[0], relief = p[1], k = p[2], edge = p[3];
  require_positive(half, "half_width, parameter 1 of \"roller\",");
  if (!(relief >= 0)) fail(Status::err_argument, "relief, parameter 2 of \"roller\", is %g; allowed: >= 0", relief);
  if (!(k >= 0 && k <= 1)) fail(Status::err_argument, "k, parameter 3 of \"roller\", is %g; allowed: 0 to 1", k);
  if (!(edge >= 0)) fail(Status::err_argument, "edge_radius, parameter 4 of \"roller\", is %g; allowed: >= 0", edge);
  Pieces all{straight({-half, 0}, {half, 0})};
  double angle = 0;
  if (relief * k > 0) {
    const double end = std::min(half, half * half / k / (relief + std::hypot(relief, half / std::sqrt(k))));
    angle = std::atan(2 * relief * k * end / (half * half - k * end * end));
    // With y = half / sqrt(k) tanh(t), z is -2 relief ln cosh(t), which even steps of t resolve everywhere.
    const double reach = std::atanh(std::sqrt(k) * end / half);
    const std::int64_t parts = 16 + to_index(100 * reach);
    std::vector<Vec2> point;
    for (std::int64_t i = 0; i <= parts; ++i) {
      const double t = reach * (2 * static_cast<double>(i) / static_cast<double>(parts) - 1);
      point.push_back({half / std::sqrt(k) * std::tanh(t), -2 * relief * std::log(std::cosh(t))});
    }
    const Vec2 begin{std::cos(angle), std::sin(angle)}, last{begin[0], -begin[1]};
    all = spline_through(point, &begin, &last);
  }
  if (!(edge > 0)) return all;
  const double turn = std::numbers::pi / 2 - angle;
  const Vec2 from = all.front().start, to = end_of(all.back());
  all.insert(all.begin(), arc(from - edge * Vec2{1 - std::sin(angle), std::cos(angle)}, std::numbers::pi / 2,
                              edge * turn, -1 / edge));
  all.push_back(arc(to, -angle, edge * turn, -1 / edge));
  return all;
}

double polynomial(std::span<const double> c, double y) {
  double sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * y + c[i];
  return sum;
}

/// Adds a spline so fine that it is the polynomial within 1e-10 mm, because its arc length has no closed form.
void add_polynomial(Pieces& all, std::span<const double> coefficient, double from, double to, double step) {
  const std::int64_t parts = to_index(std::ceil((to - from) / step));
  std::vector<Vec2> point;
  for (std::int64_t i = 0; i <= parts; ++i) {
    const double y = from + (to - from) * static_cast<double>(i) / static_cast<double>(parts);
    point.push_back({y, polynomial(coefficient, y)});
  }
  const Pieces fit = spline_through(point);
  all.insert(all.end(), fit.begin(), fit.end());
}

/// Moves pieces so that each begins where the one before ends, and one of them stays: published places are rounded.
Pieces joined(Pieces all, std::size_t stays) {
  for (std::size_t i = stays + 1; i < all.size(); ++i) all[i].start = end_of(all[i - 1]);
  for (std::size_t i = stays; i-- > 0;) all[i].start = all[i].start + all[i + 1].start - end_of(all[i]);
  return all;
}

/// Builds the wheel of EN 13715, in mm.
Pieces s1002() {
  constexpr double slope = -0.066666667, rise = 1.364323640;
  constexpr double tread[] = {0,
                              -3.358537058e-2,
                              1.565681624e-3,
                              -2.810427944e-5,
                              5.844240864e-8,
                              -1.562379023e-8,
                              5.309217349e-15,
                              -5.957839843e-12,
                              2.646656573e-13};
  constexpr double root[] = {-4.320221063e3,  -1.038384026e3,  -1.065501873e2,  -6.051367875,
                             -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7};
  constexpr double flank[] = {-93.576667419, -2.747477419};
  Pieces all{
      arc_between(-70, -62.764705882, {-49.5, 9.519259302}, 20.5, 1),
      arc_between(-62.764705882, -49.662510381, {-55, 16}, 12, 1),
      arc_between(-49.662510381, -39.764473993, {-58.558326413, 8.834924130}, 20, 1),
      straight({-39.764473993, polynomial(flank, -39.764473993)}, {-38.426669071, polynomial(flank, -38.426669071)}),
      arc_between(-38.426669071, -35, {-26.210665, 16.446}, 13, -1)};
  add_polynomial(all, root, -35, -26, 0.02);
  add_polynomial(all, tread, -26, 32.15796, 0.05);
  all.push_back(straight({32.15796, rise + slope * 32.15796}, {60, rise + slope * 60}));
  return joined(all, all.size() - 2);
}

/// Builds the rail of EN 13674-1 to the digits of the Manchester benchmark's rail, in mm.
Pieces e60() {
  constexpr Vec2 shoulder{7.7, 80.134785}, corner{23.016218, 14.908963};
  constexpr double middle_end = 10.5, lowest = 35;
  const double middle = std::asin(middle_end / 300), from = std::asin((middle_end - shoulder[0]) / 80);
  const double to = std::atan2(corner[0] - shoulder[0], shoulder[1] - corner[1]);
  const double side = std::atan2(36.0 - corner[0], corner[1] - 14.25977);
  const Vec2 edge{corner[0] + 13 * std::sin(side), corner[1] - 13 * std::cos(side)};
  const double down = (lowest - edge[1]) / std::sin(side);
  const auto turned = [](double angle, const Vec2& centre, double radius) {
    return Vec2{centre[0] + radius * std::sin(angle), centre[1] - radius * std::cos(angle)};
  };
  const Vec2 foot{edge[0] + down * std::cos(side), lowest};
  const auto left = [](const Vec2& x) { return Vec2{-x[0], x[1]}; };
  constexpr std::size_t head = 3;
  return joined({straight(left(foot), left(edge)), arc(left(edge), -side, 13 * (side - to), 1.0 / 13),
                 arc(left(turned(to, shoulder, 80)), -to, 80 * (to - from), 1.0 / 80),
                 arc(left(turned(middle, {0, 300}, 300)), -middle, 600 * middle, 1.0 / 300),
                 arc(turned(from, shoulder, 80), from, 80 * (to - from), 1.0 / 80),
                 arc(turned(to, corner, 13), to, 13 * (side - to), 1.0 / 13), straight(edge, foot)},
                head);
}

Pieces scaled(Pieces all, double unit) {
  require_positive(unit, "unit, parameter 1 of the shape,");
  for (ProfilePiece& p : all) {
    p.length *= unit;
    p.start = unit * p.start;
    p.square = (1 / unit) * p.square;
    p.cube = (1 / (unit * unit)) * p.cube;
    p.curvature /= unit;
  }
  return all;
}

struct Shape {
  const char* name;
  std::size_t parameters;  ///< number of parameters, for chains of arcs that of one arc
  const char* meaning;
  Pieces (*make)(Parameters);
};

constexpr Shape shapes[] = {
    {"line", 2, "half_width, slope", line},
    {"arc", 2, "radius, half_width", circle},
    {"arcs", 5, "y, z, angle, then length and curvature of each arc", chain},
    {"roller", 4, "half_width, relief, k, edge_radius", roller},
    {"s1002", 1, "unit", [](Parameters p) { return scaled(s1002(), p[0]); }},
    {"60e1", 1, "unit", [](Parameters p) { return scaled(e60(), p[0]); }},
};

}  // namespace

ProfileCurve profile_of_shape(const std::string& name, std::span<const double> parameter) {
  const auto* found =
      std::find_if(std::begin(shapes), std::end(shapes), [&](const Shape& s) { return s.name == name; });
  if (found == std::end(shapes)) {
    std::string known;
    for (const Shape& s : shapes) known += (known.empty() ? "" : ", ") + std::string(s.name);
    fail(Status::err_argument, "shape is \"%s\"; allowed: %s", name.c_str(), known.c_str());
  }
  const bool fits = found->make == chain
                        ? parameter.size() >= found->parameters && (parameter.size() - found->parameters) % 2 == 0
                        : parameter.size() == found->parameters;
  if (!fits)
    fail(Status::err_argument, "shape \"%s\" was given %d parameter(s); allowed: %s", found->name,
         static_cast<int>(parameter.size()), found->meaning);
  for (std::size_t i = 0; i < parameter.size(); ++i) {
    constexpr double most = 1e30;
    if (!(std::abs(parameter[i]) <= most))
      fail(Status::err_argument, "parameter %d (counting from 1) of shape \"%s\" is %g; allowed: -%g to %g",
           static_cast<int>(i) + 1, found->name, parameter[i], most, most);
  }
  return ProfileCurve(found->make(parameter));
}

}  // namespace rollcon
