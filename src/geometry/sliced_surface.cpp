#include "geometry/sliced_surface.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon {
namespace {

/// Returns two unit vectors at right angles to a unit vector and each other.
std::array<Vec3, 2> across(const Vec3& direction) {
  const Vec3 other = std::abs(direction[0]) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 a = cross(direction, other), unit = (1 / length(a)) * a;
  return {unit, cross(direction, unit)};
}

}  // namespace

SlicedSurface::Point SlicedSurface::at(std::size_t sheet, double u, double v) const {
  const SlicePoint p = slices_->at(sheet, slices_->within(u), v);
  if (!place_.revolved) {
    const Vec3 y = cross(place_.e_z, place_.axis);
    const auto in_plane = [&](const Vec2& x) { return x[0] * y + x[1] * place_.e_z; };
    return {place_.origin + u * place_.axis + in_plane(p.x), place_.axis + in_plane(p.u), in_plane(p.v)};
  }
  const double c = std::cos(u), s = std::sin(u), r = place_.radius + p.x[1];
  const Vec3 out = c * place_.e_z + s * third_, round = c * third_ - s * place_.e_z;
  return {place_.origin + p.x[0] * place_.axis + r * out, p.u[0] * place_.axis + p.u[1] * out + r * round,
          p.v[0] * place_.axis + p.v[1] * out};
}

double SlicedSurface::place_of(const Vec3& point) const {
  const Vec3 r = point - place_.origin;
  return place_.revolved ? std::atan2(dot(r, third_), dot(r, place_.e_z)) : dot(r, place_.axis);
}

// Uses Newton's method for where the surface meets the line, in two directions across it.
std::optional<SlicedSurface::Hit> SlicedSurface::near(const Vec3& from, const Vec3& direction,
                                                      const SurfaceHint& start) const {
  const auto sheet = static_cast<std::size_t>(start.branch);
  const ProfileSlices::Sheet& s = slices_->sheets()[sheet];
  const std::array<Vec3, 2> e = across(direction);
  constexpr int most = 12;
  constexpr double rounding = 1e-14, square = 1e-7, edge = 1e-9;
  double u = start.place, v = start.parameter, last = INFINITY;
  int beyond = 0;
  for (int i = 0; i < most; ++i) {
    const Point p = at(sheet, u, v);
    const Vec3 off = p.x - from;
    const double f = dot(e[0], off), g = dot(e[1], off);
    const double a = dot(e[0], p.u), b = dot(e[0], p.v), c = dot(e[1], p.u), d = dot(e[1], p.v), det = a * d - b * c;
    const double du = (b * g - d * f) / det, dv = (c * f - a * g) / det;
    const double way = length(du * p.u + dv * p.v), size = length(p.v);
    if (!std::isfinite(way)) return std::nullopt;
    u += du;
    v += dv;
    if (!(v >= -edge && v <= s.last() + edge) && ++beyond > 2) return std::nullopt;
    v = std::clamp(v, 0.0, s.last());
    // The next step is about the square of this one.
    if (way <= rounding * place_.radius || way <= square * size) {
      if (!s.has(slices_->within(u))) return std::nullopt;
      const Point q = at(sheet, u, v);
      const Vec3 miss = q.x - from;
      const double t = dot(direction, miss);
      if (length(miss - t * direction) > 1e-3 * size) return std::nullopt;
      Hit hit{t, start};
      hit.at.place = u;
      hit.at.parameter = v;
      return hit;
    }
    if (way > 2 * last) return std::nullopt;
    last = way;
  }
  return std::nullopt;
}

// Looks at the section where the line begins for columns between which it passes.
std::optional<SlicedSurface::Hit> SlicedSurface::meet(const Vec3& from, const Vec3& direction) const {
  const double u = place_of(from), here = slices_->within(u);
  const Vec3 forward = place_.revolved ? std::cos(u) * third_ - std::sin(u) * place_.e_z : place_.axis;
  const Vec3 side = cross(forward, direction);
  std::optional<Hit> best;
  if (!(dot(side, side) > 0)) return best;
  for (std::size_t k = 0; k < slices_->sheets().size(); ++k) {
    const ProfileSlices::Sheet& s = slices_->sheets()[k];
    if (!s.has(here)) continue;
    double before = 0;
    for (std::size_t j = 0; j < s.columns; ++j) {
      const double now = dot(side, at(k, u, static_cast<double>(j)).x - from);
      if (j > 0 && (now < 0) != (before < 0)) {
        SurfaceHint start{static_cast<int>(k), 0, static_cast<double>(j) - now / (now - before)};
        start.place = u;
        if (const auto hit = near(from, direction, start); hit && (!best || std::abs(hit->t) < std::abs(best->t)))
          best = hit;
      }
      before = now;
    }
  }
  return best;
}

std::optional<double> SlicedSurface::distance(const Vec3& from, const Vec3& direction, const Vec3&) const {
  const auto hit = meet(from, direction);
  if (!hit) return std::nullopt;
  return hit->t;
}

std::optional<double> SlicedSurface::distance_near(const Vec3& from, const Vec3& direction, const Vec3&,
                                                   SurfaceHint& hint) const {
  auto hit = hint.branch < 0 ? std::nullopt : near(from, direction, hint);
  if (!hit) hit = meet(from, direction);
  hint = hit ? hit->at : SurfaceHint{};
  if (!hit) return std::nullopt;
  return hit->t;
}

Vec3 SlicedSurface::normal_at(const SurfaceHint& hint) const {
  const Point p = at(static_cast<std::size_t>(hint.branch), hint.place, hint.parameter);
  const Vec3 n = cross(p.u, p.v);
  return (1 / length(n)) * n;
}

std::optional<Vec3> SlicedSurface::normal(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const auto hit = meet(from, direction);
  if (!hit) return std::nullopt;
  const Vec3 n = normal_at(hit->at);
  return dot(n, facing) < 0 ? -1.0 * n : n;
}

Vec3 SlicedSurface::normal_met(const Vec3&, const Vec3&, const SurfaceHint& hint) const {
  return normal_at(hint);
}

// Descends from the nearest column of the point's own section.
Vec3 SlicedSurface::nearest(const Vec3& point) const {
  const double u = place_of(point), here = slices_->within(u);
  Vec3 best = point;
  double least = INFINITY;
  for (std::size_t k = 0; k < slices_->sheets().size(); ++k) {
    const ProfileSlices::Sheet& s = slices_->sheets()[k];
    if (!s.has(here)) continue;
    std::size_t nearest = 0;
    double near_by = INFINITY;
    for (std::size_t j = 0; j < s.columns; ++j)
      if (const double off = length(at(k, u, static_cast<double>(j)).x - point); off < near_by) {
        near_by = off;
        nearest = j;
      }
    double at_u = u, v = static_cast<double>(nearest);
    constexpr int steps = 8;
    for (int i = 0; i < steps; ++i) {
      const Point p = at(k, at_u, v);
      const Vec3 off = point - p.x;
      const double a = dot(p.u, p.u), b = dot(p.u, p.v), d = dot(p.v, p.v), f = dot(p.u, off), g = dot(p.v, off);
      const double det = a * d - b * b;
      if (!(det > 0)) break;
      at_u += (d * f - b * g) / det;
      v = std::clamp(v + (a * g - b * f) / det, 0.0, s.last());
    }
    const Vec3 x = at(k, at_u, v).x;
    if (const double off = length(x - point); off < least) {
      least = off;
      best = x;
    }
  }
  return best;
}

std::array<double, 2> SlicedSurface::extent(const Vec3& direction) const {
  constexpr double along = 1e-9, margin = 0.05;
  const double a = dot(direction, place_.axis);
  if (!place_.revolved && std::abs(a) > along) return Surface::extent(direction);
  const Vec3 y_axis = cross(place_.e_z, place_.axis);
  const double from = dot(direction, place_.origin), y = dot(direction, y_axis), z = dot(direction, place_.e_z);
  const double out = length(direction - a * place_.axis), wave = slices_->most_wave();
  std::array<double, 2> range{INFINITY, -INFINITY};
  const auto take = [&](double low, double high) { range = {std::min(range[0], low), std::max(range[1], high)}; };
  for (const ProfileSlices::Sheet& s : slices_->sheets())
    for (const ProfileSlices::Node& n : s.node) {
      const double r = out * (place_.radius + n.x[1] + wave), middle = from + a * n.x[0];
      const double height = from + y * n.x[0] + z * n.x[1], shift = std::abs(z) * wave;
      place_.revolved ? take(middle - r, middle + r) : take(height - shift, height + shift);
    }
  const double more = margin * (range[1] - range[0]);  // splines may pass slices by a little
  return {range[0] - more, range[1] + more};
}

Vec2 section_of(const ProfileSlices& slices, double u, double share) {
  const auto& sheet = slices.sheets();
  const double here = slices.within(u);
  double columns = 0;
  for (const ProfileSlices::Sheet& s : sheet) columns += s.has(here) ? s.last() : 0;
  double v = share * columns;
  std::size_t last = 0;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    if (!sheet[i].has(here)) continue;
    if (v <= sheet[i].last()) return slices.at(i, here, v).x;
    v -= sheet[i].last();
    last = i;
  }
  return slices.at(last, here, sheet[last].last()).x;
}

}  // namespace rollcon
