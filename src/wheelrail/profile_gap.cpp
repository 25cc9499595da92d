#include "wheelrail/profile_gap.hpp"

#include <cmath>

#include "geometry/profile_crossings.hpp"

namespace rollcon {

std::optional<GapPoint> ProfileGap::at(const VisiblePoint& p, double s) const {
  const auto point = locus_.at(p);
  if (!point) return std::nullopt;
  const double y = point->x[1];
  if (!(y >= rail_.low() && y <= rail_.high())) return std::nullopt;
  near_ = rail_.cell_at_y(y, near_);
  const VisiblePoint r = rail_.at_y(y, near_);
  return GapPoint{s, point->x, r.z - point->x[2], r.slope - point->slope, r.slope, point->forward_y};
}

RoughGap ProfileGap::rough(const VisibleCell& cell, std::size_t end) {
  RoughGap g;
  g.s = cell.s[end];
  const auto point = locus_.at({cell.y[end], cell.z[end], cell.slope[end], 1, cell.slope[end], 0});
  if (!point) return g;
  g.y = point->x[1];
  if (!(g.y >= rail_.low() && g.y <= rail_.high())) return g;
  g.known = true;
  near_ = rail_.cell_at_y(g.y, near_);
  const VisibleCell& r = rail_.cells()[near_];
  const double width = r.y[1] - r.y[0], t = (g.y - r.y[0]) / width, chord = (r.z[1] - r.z[0]) / width;
  const double from = r.slope[0] - chord, to = r.slope[1] - chord;
  const double z = r.z[0] + width * t * (chord + (1 - t) * ((1 - t) * from - t * to));
  g.gap = z - point->x[2];
  g.rise = r.slope[0] + t * (r.slope[1] - r.slope[0]) - point->slope;
  constexpr double share = 0.1;  // of the height of an arc over its chord
  g.slack = share * width * (std::abs(from) + std::abs(to));
  return g;
}

GapPoint ProfileGap::zero(const VisibleCell& cell, const GapPoint& a, const GapPoint& b) const {
  if (a.gap * b.gap >= 0) return std::abs(a.gap) <= std::abs(b.gap) ? a : b;
  GapPoint last = a;
  const double s = bracketed_root(
      a.s, b.s, a.gap,
      [&](double u) {
        last = at(cell, u).value_or(last);
        return last.gap;
      },
      [&](double) { return last.rise * last.forward_y; });
  return at(cell, s).value_or(last);
}

GapPoint ProfileGap::extreme(const VisibleCell& cell, const GapPoint& a, const GapPoint& b) const {
  if (a.rise * b.rise >= 0) return std::abs(a.rise) <= std::abs(b.rise) ? a : b;
  GapPoint last = a;
  const double chord = (b.rise - a.rise) / (b.s - a.s);
  const double s = bracketed_root(
      a.s, b.s, a.rise,
      [&](double u) {
        last = at(cell, u).value_or(last);
        return last.rise;
      },
      [&](double) { return chord; });
  return at(cell, s).value_or(last);
}

GapPoint ProfileGap::edge(const VisibleCell& cell, double in, double out) const {
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (in + out) / 2;
    (at(cell, middle) ? in : out) = middle;
  }
  return *at(cell, in);
}

}  // namespace rollcon
