#include "geometry/profile_curve.hpp"

#include <algorithm>
#include <limits>

#include "geometry/profile_crossings.hpp"

namespace rollcon {
namespace {

bool is_arc(const ProfilePiece& p) {
  return p.square == Vec2{0, 0} && p.cube == Vec2{0, 0};
}

ProfilePoint point_of(const ProfilePiece& p, double u) {
  if (!is_arc(p))
    return {p.start + u * (p.along + u * (p.square + u * p.cube)), p.along + u * (2.0 * p.square + 3 * u * p.cube),
            2.0 * p.square + 6 * u * p.cube};
  const double half = p.curvature * u / 2, c = std::cos(half), s = std::sin(half);
  const double chord = half == 0 ? u : u * (s / half);
  const Vec2 side{-p.along[1], p.along[0]};
  const Vec2 tangent = (1 - 2 * s * s) * p.along + (2 * s * c) * side;
  return {p.start + chord * (c * p.along + s * side), tangent, p.curvature * Vec2{-tangent[1], tangent[0]}};
}

/// Returns the length of a cubic up to u, by Gauss's rule with 5 points.
double length_to(const ProfilePiece& p, double u) {
  if (is_arc(p)) return u;
  constexpr std::array<double, 3> x{0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> w{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (const double sign : {-1.0, 1.0}) {
      if (i == 0 && sign > 0) continue;
      sum += w[i] * rollcon::length(point_of(p, u * (1 + sign * x[i]) / 2).d1);
    }
  return sum * u / 2;
}

/// Returns the parameter at which a cubic has that length.
double parameter_at(const ProfilePiece& p, double s) {
  if (is_arc(p)) return s;
  double u = s;
  for (int i = 0; i < 20; ++i) {
    const double step = (s - length_to(p, u)) / rollcon::length(point_of(p, u).d1);
    u = std::clamp(u + step, 0.0, p.length);
    if (std::abs(step) <= 1e-15 * p.length) break;
  }
  return u;
}

ProfileBox box_of(std::initializer_list<Vec2> points, double more) {
  constexpr double far = std::numeric_limits<double>::infinity();
  ProfileBox box{{far, far}, {-far, -far}};
  for (const Vec2& x : points)
    for (std::size_t c = 0; c < 2; ++c) {
      box.low[c] = std::min(box.low[c], x[c] - more);
      box.high[c] = std::max(box.high[c], x[c] + more);
    }
  return box;
}

/// Bounds a cubic by its control points, an arc by its chord and height.
ProfileBox box_of(const ProfilePiece& p, double from, double to) {
  const ProfilePoint a = point_of(p, from), b = point_of(p, to);
  if (is_arc(p)) {
    const double half = p.curvature * (to - from) / 2;
    return box_of({a.x, b.x}, p.curvature == 0 ? 0 : 2 * std::abs((1 - std::cos(half)) / p.curvature));
  }
  const double third = (to - from) / 3;
  return box_of({a.x, b.x, a.x + third * a.d1, b.x - third * b.d1}, 0);
}

/// Vanishes on the line of constant y.
struct UprightLine {
  double y;
  double inside(const Vec2&) const { return 1; }
  double value(const Vec2& x) const { return x[0] - y; }
  double slope(const Vec2&, const Vec2& d) const { return d[0]; }
  std::array<double, 2> range(const ProfileBox& box) const { return {box.low[0] - y, box.high[0] - y}; }
};

}  // namespace

ProfileCurve::ProfileCurve(std::vector<ProfilePiece> piece) : piece_(std::move(piece)) {
  constexpr double most_turned = 0.1;
  start_.push_back(0);
  for (std::size_t i = 0; i < piece_.size(); ++i) {
    const ProfilePiece& p = piece_[i];
    start_.push_back(start_.back() + length_to(p, p.length));
    const double parts = is_arc(p) ? std::max(1.0, std::ceil(std::abs(p.curvature) * p.length / most_turned)) : 1;
    for (double k = 0; k < parts; ++k) {
      const double from = p.length * k / parts, to = p.length * (k + 1) / parts;
      interval_.push_back({i, from, to, box_of(p, from, to)});
    }
  }
  for (std::size_t i = 0; i < interval_.size(); ++i) {
    const ProfileBox& box = interval_[i].box;
    if (i % block == 0)
      block_.push_back(box);
    else
      block_.back() = box_of({block_.back().low, block_.back().high, box.low, box.high}, 0);
  }
}

ProfilePoint ProfileCurve::at(std::size_t piece, double u) const {
  return point_of(piece_[piece], u);
}

ProfilePoint ProfileCurve::at(double s) const {
  const auto after = std::upper_bound(start_.begin() + 1, start_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - start_.begin()) - 1;
  return point_of(piece_[i], parameter_at(piece_[i], s - start_[i]));
}

std::vector<double> ProfileCurve::at_y(double y) const {
  std::vector<double> found;
  for_each_crossing(*this, UprightLine{y}, [&](const ProfilePoint&, std::size_t i, double u) {
    const double s = start_[i] + length_to(piece_[i], u);
    if (found.empty() || s - found.back() > 1e-12 * length()) found.push_back(s);
  });
  return found;
}

ProfilePoint ProfileCurve::nearest(const Vec2& x) const {
  ProfilePoint best = point_of(piece_.front(), 0);
  double least = rollcon::length(best.x - x);
  const auto take = [&](const ProfilePoint& p) {
    const double distance = rollcon::length(p.x - x);
    if (distance >= least) return;
    least = distance;
    best = p;
  };
  const auto ahead = [&](const ProfilePoint& p) { return dot(x - p.x, p.d1); };
  for (const ProfileInterval& part : interval_) {
    const Vec2 inside{std::clamp(x[0], part.box.low[0], part.box.high[0]),
                      std::clamp(x[1], part.box.low[1], part.box.high[1])};
    if (rollcon::length(inside - x) >= least) continue;
    double from = part.from, to = part.to;
    take(at(part.piece, from));
    take(at(part.piece, to));
    if (!(ahead(at(part.piece, from)) > 0 && ahead(at(part.piece, to)) < 0)) continue;
    for (int i = 0; i < 200 && to - from > 1e-16 * part.to; ++i) {
      const double middle = (from + to) / 2;
      (ahead(at(part.piece, middle)) > 0 ? from : to) = middle;
    }
    take(at(part.piece, from));
  }
  return best;
}

std::vector<Vec2> ProfileCurve::points() const {
  constexpr double turned = 0.01;
  constexpr double least_parts = 16;
  std::vector<Vec2> found;
  for (const ProfilePiece& p : piece_) {
    const double parts = is_arc(p) ? std::max(least_parts, std::ceil(std::abs(p.curvature) * p.length / turned)) : 1;
    for (double k = 0; k < parts; ++k) found.push_back(point_of(p, p.length * k / parts).x);
  }
  found.push_back(point_of(piece_.back(), piece_.back().length).x);
  return found;
}

ProfileCurve turned_over(const ProfileCurve& curve) {
  std::vector<ProfilePiece> piece = curve.pieces();
  for (ProfilePiece& p : piece) {
    for (Vec2* v : {&p.start, &p.along, &p.square, &p.cube}) (*v)[1] = 0 - (*v)[1];
    p.curvature = 0 - p.curvature;
  }
  return ProfileCurve(std::move(piece));
}

}  // namespace rollcon
