#include "mesh/section_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollcon {
namespace {

double arc_over_chord(double turned) {
  const double half = 0.5 * turned;
  return std::abs(half) < 1e-4 ? 1 + half * half / 6 : half / std::sin(half);
}

}  // namespace

SectionLine::SectionLine(std::vector<Place> place) : place_(std::move(place)), arc_(place_.size(), 0.0) {
  for (std::size_t i = 1; i < place_.size(); ++i) {
    const Place &a = place_[i - 1], &b = place_[i];
    arc_[i] = arc_[i - 1] + std::hypot(b.y - a.y, b.height - a.height) * arc_over_chord(b.angle - a.angle);
  }
}

// Returns the length from place i to y before place i + 1, and the angle there. The sine is linear in y on an arc.
double SectionLine::arc_from(std::size_t i, double y, double& angle) const {
  const Place &a = place_[i], &b = place_[i + 1];
  const double sine = std::sin(a.angle), rise = (std::sin(b.angle) - sine) / (b.y - a.y), along = y - a.y;
  angle = std::asin(std::clamp(sine + rise * along, -1.0, 1.0));
  const auto length = [&](double to_y, double to_angle) {
    return (to_y - a.y) / std::cos(0.5 * (to_angle + a.angle)) * arc_over_chord(to_angle - a.angle);
  };
  return length(y, angle) / length(b.y, b.angle) * (arc_[i + 1] - arc_[i]);
}

SectionLine::Point SectionLine::at(double y) const {
  const Place &first = place_.front(), &last = place_.back();
  if (!(y > first.y)) return {(y - first.y) / std::cos(first.angle), first.angle};
  if (!(y < last.y)) return {arc_.back() + (y - last.y) / std::cos(last.angle), last.angle};
  const auto after =
      std::upper_bound(place_.begin(), place_.end(), y, [](double v, const Place& p) { return v < p.y; });
  const auto i = static_cast<std::size_t>(after - place_.begin()) - 1;
  Point point;
  point.arc = arc_[i] + arc_from(i, y, point.angle);
  return point;
}

}  // namespace rollcon
