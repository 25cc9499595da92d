#include "geometry/profile_surface.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/profile_crossings.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

/// Measures the distance of a point of the profile's plane from a straight line there, times the direction's length.
struct StraightLine {
  Vec2 from, direction;

  double inside(const Vec2&) const { return 1; }
  double value(const Vec2& x) const { return cross(direction, x - from); }
  double slope(const Vec2&, const Vec2& d) const { return cross(direction, d); }
  std::array<double, 2> range(const ProfileBox& box) const {
    const double a = direction[0] * (box.low[1] - from[1]), b = direction[0] * (box.high[1] - from[1]);
    const double c = -direction[1] * (box.low[0] - from[0]), d = -direction[1] * (box.high[0] - from[0]);
    return {std::min(a, b) + std::min(c, d), std::max(a, b) + std::max(c, d)};
  }
};

/// Describes a line in space by y = y0 + t y1 along an axis and its squared distance from it, square + slant (t -
/// t_least)^2. In the plane of y and radius it is a hyperbola.
struct LineAboutAxis {
  double y0, y1, slant, t_least, square;
  double radius;  ///< radius at z = 0
  bool one_half;  ///< true if only points on this side of the axis count

  double y(double t) const { return y0 + t * y1; }
  bool steep() const { return slant >= y1 * y1; }
  bool counts(double sign) const { return !one_half || (sign < 0) == (t_least > 0); }
};

/// Takes r from a point of the axis to one of the line. Normals of a contact look along `facing`: beyond the axis they
/// would meet the far side of a body, however near to its end.
LineAboutAxis about_axis(const Vec3& r, const Vec3& direction, const Vec3& facing, const Vec3& axis, double radius) {
  constexpr double parallel = 1 - 1e-9;
  LineAboutAxis line{};
  line.y0 = dot(r, axis);
  line.y1 = dot(direction, axis);
  line.radius = radius;
  const Vec3 off = r - line.y0 * axis, across = direction - line.y1 * axis;
  line.slant = dot(across, across);
  line.t_least = line.slant > 0 ? -dot(off, across) / line.slant : 0;
  const Vec3 closest = off + line.t_least * across;
  line.square = dot(closest, closest);
  line.one_half = std::abs(dot(direction, facing)) > parallel;
  return line;
}

/// Measures y less that of the line where it is as far from the axis, over the half of the hyperbola that goes out from
/// its point nearest to the axis, forwards or backwards. It serves lines steep to the axis.
struct SteepHalf {
  LineAboutAxis line;
  double sign;

  double t(double r) const { return line.t_least + sign * std::sqrt(std::max(r * r - line.square, 0.0) / line.slant); }
  /// Is positive where x is not nearer to the axis than the line is anywhere.
  double inside(const Vec2& x) const {
    constexpr double rounding = 1e-14;
    const double r = line.radius + x[1];
    return r * r - line.square * (1 - rounding) + 1e-300;
  }
  double value(const Vec2& x) const { return x[0] - line.y(t(line.radius + x[1])); }
  double slope(const Vec2& x, const Vec2& d) const {
    const double r = line.radius + x[1], out = r * r - line.square;
    constexpr double steepest = 1e-24;  // bound of the slope, which is infinite where the halves meet
    const double rate = sign * r / std::sqrt(std::max(out, steepest * r * r) * line.slant);
    return d[0] - line.y1 * rate * d[1];
  }
  std::array<double, 2> range(const ProfileBox& box) const {
    const double a = line.y(t(std::max(line.radius + box.low[1], 0.0))), b = line.y(t(line.radius + box.high[1]));
    return {box.low[0] - std::max(a, b), box.high[0] - std::min(a, b)};
  }
};

/// Measures the radius less that of the line at the same y. It serves lines nearly along the axis.
struct FlatLine {
  LineAboutAxis line;

  double t(double y) const { return (y - line.y0) / line.y1; }
  double radius(double y) const {
    const double off = t(y) - line.t_least;
    return std::sqrt(line.square + line.slant * off * off);
  }
  double inside(const Vec2&) const { return 1; }
  double value(const Vec2& x) const { return line.radius + x[1] - radius(x[0]); }
  double slope(const Vec2& x, const Vec2& d) const {
    const double r = radius(x[0]);
    return d[1] - (r > 0 ? line.slant * (t(x[0]) - line.t_least) / (r * line.y1) * d[0] : 0);
  }
  std::array<double, 2> range(const ProfileBox& box) const {
    const double a = radius(box.low[0]), b = radius(box.high[0]);
    const double middle = std::clamp(line.y(line.t_least), box.low[0], box.high[0]);
    return {line.radius + box.low[1] - std::max(a, b), line.radius + box.high[1] - radius(middle)};
  }
};

/// Finds the root of the function next to a hint by Newton's method, on the hint's piece or those near it; finds none
/// where the first step is longer than a piece and a fiftieth of the curve, or the others do not shrink to half.
template <class Function>
std::optional<ProfilePoint> crossing_near(const ProfileCurve& curve, const Function& f, SurfaceHint& hint) {
  const std::vector<ProfilePiece>& pieces = curve.pieces();
  constexpr int most = 8;
  constexpr double rounding = 1e-15;
  std::size_t piece = hint.piece;
  double u = hint.parameter, length = pieces[piece].length, last = 2 * std::max(length, curve.length() / 50);
  // Goes on from where a step led to. Returns false beyond the ends of the curve.
  const auto stay = [&] {
    while (u > length && piece + 1 < pieces.size()) {
      u -= length;
      length = pieces[++piece].length;
    }
    while (u < 0 && piece > 0) {
      length = pieces[--piece].length;
      u += length;
    }
    return u >= 0 && u <= length;
  };
  for (int i = 0; i < most; ++i) {
    const ProfilePoint p = curve.at(piece, u);
    if (!(f.inside(p.x) > 0)) return std::nullopt;
    const double step = -f.value(p.x) / f.slope(p.x, p.d1);
    if (!(std::abs(step) <= 0.5 * last)) return std::nullopt;
    // Newton's next step is about the square of this one; on another piece it begins anew.
    const bool done = std::abs(step) <= rounding * length || step * step <= rounding * length * last;
    last = std::abs(step);
    u += step;
    const std::size_t before = piece;
    if (!stay()) return std::nullopt;
    if (!done || piece != before) continue;
    // One step from the nearest of many fixed places makes the last digits independent of the hint.
    const double grid = length / (1 << 26);
    u = std::round(u / grid) * grid;
    const ProfilePoint q = curve.at(piece, u);
    u = std::clamp(u - f.value(q.x) / f.slope(q.x, q.d1), 0.0, length);
    hint.piece = piece;
    hint.parameter = u;
    return curve.at(piece, u);
  }
  return std::nullopt;
}

Vec2 normal_of(const ProfilePoint& p) {
  const Vec2 t = p.tangent();
  return {-t[1], t[0]};
}

Vec3 towards(const Vec3& facing, const Vec3& n) {
  return dot(n, facing) < 0 ? -1.0 * n : n;
}

}  // namespace

std::optional<ExtrudedProfile::Hit> ExtrudedProfile::meet(const Vec3& from, const Vec3& direction) const {
  const Vec3 r = from - origin_;
  const StraightLine line{{dot(r, y_), dot(r, z_)}, {dot(direction, y_), dot(direction, z_)}};
  const double square = dot(line.direction, line.direction);
  std::optional<Hit> best;
  if (!(square > 0)) return best;
  for_each_crossing(*curve_, line, [&](const ProfilePoint& p, std::size_t piece, double u) {
    const double t = dot(p.x - line.from, line.direction) / square;
    if (!best || std::abs(t) < std::abs(best->t)) best = Hit{t, p, {0, piece, u}};
  });
  return best;
}

std::optional<double> ExtrudedProfile::distance_near(const Vec3& from, const Vec3& direction, const Vec3&,
                                                     SurfaceHint& hint) const {
  const Vec3 r = from - origin_;
  const StraightLine line{{dot(r, y_), dot(r, z_)}, {dot(direction, y_), dot(direction, z_)}};
  const auto near = [&]() -> std::optional<double> {
    if (hint.branch < 0) return std::nullopt;
    const auto p = crossing_near(*curve_, line, hint);
    if (!p) return std::nullopt;
    return dot(p->x - line.from, line.direction) / dot(line.direction, line.direction);
  };
  if (const auto t = near()) return t;
  const auto hit = meet(from, direction);
  hint = hit ? hit->at : SurfaceHint{};
  if (!hit) return std::nullopt;
  return near().value_or(hit->t);
}

std::optional<double> ExtrudedProfile::distance(const Vec3& from, const Vec3& direction, const Vec3&) const {
  const auto hit = meet(from, direction);
  if (!hit) return std::nullopt;
  return hit->t;
}

std::optional<Vec3> ExtrudedProfile::normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const auto hit = meet(from, direction);
  if (!hit) return std::nullopt;
  const Vec2 n = normal_of(hit->point);
  return towards(facing, n[0] * y_ + n[1] * z_);
}

Vec3 ExtrudedProfile::normal_met(const Vec3&, const Vec3&, const SurfaceHint& hint) const {
  const Vec2 n = normal_of(curve_->at(hint.piece, hint.parameter));
  return n[0] * y_ + n[1] * z_;
}

Vec3 ExtrudedProfile::nearest(const Vec3& point) const {
  const Vec3 r = point - origin_;
  const Vec2 x = curve_->nearest({dot(r, y_), dot(r, z_)}).x;
  return origin_ + x[0] * y_ + x[1] * z_ + dot(r, along_) * along_;
}

std::array<double, 2> ExtrudedProfile::extent(const Vec3& direction) const {
  constexpr double along = 1e-9;
  if (std::abs(dot(direction, along_)) > along) return Surface::extent(direction);
  const double a = dot(direction, y_), b = dot(direction, z_), from = dot(direction, origin_);
  std::array<double, 2> range{INFINITY, -INFINITY};
  for (const ProfileInterval& part : curve_->intervals())
    for (const double y : {part.box.low[0], part.box.high[0]})
      for (const double z : {part.box.low[1], part.box.high[1]})
        range = {std::min(range[0], from + a * y + b * z), std::max(range[1], from + a * y + b * z)};
  return range;
}

std::optional<RevolvedProfile::Hit> RevolvedProfile::meet(const Vec3& from, const Vec3& direction,
                                                          const Vec3& facing) const {
  const LineAboutAxis line = about_axis(from - origin_, direction, facing, axis_, radius_);
  std::optional<Hit> best;
  const auto take = [&](double t, const ProfilePoint& p, const SurfaceHint& at) {
    if (!best || std::abs(t) < std::abs(best->t)) best = Hit{t, p, at};
  };
  if (line.steep()) {
    for (const double sign : {-1.0, 1.0}) {
      if (!line.counts(sign)) continue;
      const SteepHalf half{line, sign};
      for_each_crossing(*curve_, half, [&](const ProfilePoint& p, std::size_t piece, double u) {
        take(half.t(radius_ + p.x[1]), p, {sign < 0 ? 0 : 1, piece, u});
      });
    }
    return best;
  }
  const FlatLine flat{line};
  for_each_crossing(*curve_, flat, [&](const ProfilePoint& p, std::size_t piece, double u) {
    take(flat.t(p.x[0]), p, {2, piece, u});
  });
  return best;
}

std::optional<double> RevolvedProfile::distance_near(const Vec3& from, const Vec3& direction, const Vec3& facing,
                                                     SurfaceHint& hint) const {
  const LineAboutAxis line = about_axis(from - origin_, direction, facing, axis_, radius_);
  const auto near = [&]() -> std::optional<double> {
    if (hint.branch == 2 && !line.steep()) {
      const FlatLine flat{line};
      if (const auto p = crossing_near(*curve_, flat, hint)) return flat.t(p->x[0]);
    } else if (hint.branch >= 0 && hint.branch < 2 && line.steep()) {
      const SteepHalf half{line, hint.branch == 0 ? -1.0 : 1.0};
      if (const auto p = crossing_near(*curve_, half, hint); p && line.counts(half.sign))
        return half.t(radius_ + p->x[1]);
    }
    return std::nullopt;
  };
  if (const auto t = near()) return t;
  const auto hit = meet(from, direction, facing);
  hint = hit ? hit->at : SurfaceHint{};
  if (!hit) return std::nullopt;
  return near().value_or(hit->t);
}

Vec3 RevolvedProfile::outward(const Vec3& point) const {
  const Vec3 r = point - origin_, off = r - dot(r, axis_) * axis_;
  if (const double away = length(off); away > 0) return (1 / away) * off;
  return normalized(cross(axis_, std::abs(axis_[0]) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
}

std::optional<double> RevolvedProfile::distance(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const auto hit = meet(from, direction, facing);
  if (!hit) return std::nullopt;
  return hit->t;
}

std::optional<Vec3> RevolvedProfile::normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const auto hit = meet(from, direction, facing);
  if (!hit) return std::nullopt;
  const Vec2 n = normal_of(hit->point);
  return towards(facing, n[0] * axis_ + n[1] * outward(from + hit->t * direction));
}

Vec3 RevolvedProfile::normal_met(const Vec3& met, const Vec3&, const SurfaceHint& hint) const {
  const Vec2 n = normal_of(curve_->at(hint.piece, hint.parameter));
  return n[0] * axis_ + n[1] * outward(met);
}

std::array<double, 2> RevolvedProfile::extent(const Vec3& direction) const {
  const double a = dot(direction, axis_), out = length(direction - a * axis_), from = dot(direction, origin_);
  std::array<double, 2> range{INFINITY, -INFINITY};
  for (const ProfileInterval& part : curve_->intervals()) {
    const double r = out * (radius_ + part.box.high[1]);
    for (const double y : {part.box.low[0], part.box.high[0]})
      range = {std::min(range[0], from + a * y - r), std::max(range[1], from + a * y + r)};
  }
  return range;
}

Vec3 RevolvedProfile::nearest(const Vec3& point) const {
  const Vec3 r = point - origin_;
  const double y = dot(r, axis_);
  const Vec2 x = curve_->nearest({y, length(r - y * axis_) - radius_}).x;
  return origin_ + x[0] * axis_ + (radius_ + x[1]) * outward(point);
}

}  // namespace rollcon
