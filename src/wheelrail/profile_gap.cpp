#include "wheelrail/profile_gap.hpp"

#include <cmath>

#include "wheelrail/false_position.hpp"

namespace rollcon {

std::optional<GapPoint> ProfileGap::at(const VisiblePoint& p, double s) const {
  const auto point = locus_at(p);
  return point ? at(*point, s) : std::nullopt;
}

std::optional<GapPoint> ProfileGap::at(const LocusPoint& point, double s) const {
  const double y = point.x[1];
  if (varying_) {
    const auto r = varying_->rail(point.x[0], y);
    if (!r) return std::nullopt;
    return GapPoint{s, point.x, r->z - point.x[2], r->y - point.slope, r->y, point.forward_y, r->u};
  }
  if (!(y >= rail_.low() && y <= rail_.high())) return std::nullopt;
  const VisiblePoint r = rail_at(y, point.x[0]);
  return GapPoint{s, point.x, r.z - point.x[2], r.slope - point.slope, r.slope, point.forward_y};
}

VisiblePoint ProfileGap::rail_at(double y, double x) const {
  if (varying_) return varying_->rail_section(x, y);
  near_ = rail_.cell_at_y(y, near_);
  return rail_.at_y(y, near_);
}

double ProfileGap::rail_z(double y) const {
  near_ = rail_.cell_at_y(y, near_);
  return rail_.cells()[near_].cubic_z(y);
}

RoughGap ProfileGap::rough(const VisibleSpan& span, std::size_t end) const {
  RoughGap g;
  g.s = span.s[end];
  if (varying_) {
    const VaryingPair::Rough rough = varying_->rough(locus_, span.y[end], span.z[end]);
    if (std::isfinite(rough.gap)) g = {true, g.s, rough.y, rough.gap, 0, rough.slack};
    return g;
  }
  std::array<double, 3> outline{};
  if (!locus_.outline(span.y[end], span.z[end], span.slope[end], outline)) return g;
  g.y = outline[0];
  if (!(g.y >= rail_.low() && g.y <= rail_.high())) return g;
  g.known = true;
  near_ = rail_.cell_at_y(g.y, near_);
  const VisibleCell& r = rail_.cells()[near_];
  const double width = r.y[1] - r.y[0], t = (g.y - r.y[0]) / width, chord = r.chord();
  const double from = r.slope[0] - chord, to = r.slope[1] - chord;
  g.gap = r.cubic_z(g.y) - outline[1];
  g.rise = r.slope[0] + t * (r.slope[1] - r.slope[0]) - outline[2];
  constexpr double share = 0.4;  // fraction of the height of an arc over its chord
  g.slack = share * width * (std::abs(from) + std::abs(to));
  return g;
}

GapPoint ProfileGap::zero(const VisibleSpan& span, const GapPoint& a, const GapPoint& b) const {
  if (a.gap * b.gap >= 0) return std::abs(a.gap) <= std::abs(b.gap) ? a : b;
  GapPoint last = a;
  const auto value = [&](double s) {
    last = at(span, s).value_or(last);
    return last.gap;
  };
  const double rounding = locus_.rounding();
  false_position(a.s, a.gap, b.s, b.gap, value, [&](double f) { return std::abs(f) <= rounding; });
  return last;
}

GapPoint ProfileGap::extreme(const VisibleSpan& span, const GapPoint& a, const GapPoint& b) const {
  if (a.rise * b.rise >= 0) return std::abs(a.rise) <= std::abs(b.rise) ? a : b;
  GapPoint last = a;
  const auto value = [&](double s) {
    last = at(span, s).value_or(last);
    return last.rise;
  };
  // A smooth gap lacks half of rise^2 / curvature to its least value; and more, as s is used too.
  constexpr double share = 1e-4;
  const double square = share * locus_.rounding() * std::abs((b.rise - a.rise) / (b.s - a.s));
  false_position(a.s, a.rise, b.s, b.rise, value, [&](double f) { return f * f <= square; });
  return last;
}

GapPoint ProfileGap::edge(const VisibleSpan& span, double in, double out) const {
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (in + out) / 2;
    (at(span, middle) ? in : out) = middle;
  }
  return *at(span, in);
}

}  // namespace rollcon
