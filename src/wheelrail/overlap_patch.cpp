#include "wheelrail/overlap_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadrature/rules.hpp"
#include "wheelrail/depth_along.hpp"
#include "wheelrail/false_position.hpp"

namespace rollcon {
namespace {

/// Rises from 0 below the first value to 1 above the second.
double smooth_step(double value, double from, double to) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Says how far two neighbours are one patch, from 0 (apart) to 1: by their distance over the sum of the radii of
/// contact, and by the angle between their normals, which have to be one in a planar patch. The bulge of a half-space
/// around a contact of radius c lessens the approach of an equal one that it nearly touches, 2 c from centre to centre,
/// by a quarter, at 4 c (radii apart) by an eighth, at 10 c by 4 percent.
double joined(const ProfileGap& gap, const Overlap& a, const Overlap& b, const MergeRule& rule) {
  constexpr double part_together = 0.3, part_same = 0.35 / 0.55;
  const double apart = rule.distance, together = part_together * apart;
  const double other_plane = rule.angle, same_plane = part_same * other_plane;
  const double turned = std::abs(std::atan(a.deepest.rail_slope) - std::atan(b.deepest.rail_slope));
  const double one_plane = rule.planar ? smooth_step(-turned, -other_plane, -same_plane) : 1;
  if (b.grown) {
    // Patches that are hardly divided are one, whatever their planes.
    constexpr double divided = 0.3;
    const double saddle = b.from.depth() / std::min(a.deepest.depth(), b.deepest.depth());
    return std::max(one_plane, 1 - smooth_step(1 - saddle, 0, divided));
  }
  if (one_plane == 0) return 0;
  const VisiblePoint from = gap.rail_at(a.to.wheel[1], a.to.wheel[0]),
                     to = gap.rail_at(b.from.wheel[1], b.from.wheel[0]);
  const double distance = length(Vec3{b.from.wheel[0] - a.to.wheel[0], to.y - from.y, to.z - from.z});
  const double near = one_plane * smooth_step(-distance, -apart * (a.size + b.size), -together * (a.size + b.size));
  if (near == 0) return 0;
  // A patch that only begins to overlap is nothing yet, unless it is about to grow together with its neighbour.
  constexpr double shallow = 0.15;
  constexpr int parts = 8;
  double saddle = 0;
  for (int i = 1; i < parts; ++i)
    if (const auto p = gap.at(a.to.s + (b.from.s - a.to.s) * i / parts)) saddle = std::max(saddle, -p->depth());
  const double depth = std::min(a.deepest.depth(), b.deepest.depth());
  return near * smooth_step(depth, 0, shallow * (depth + saddle));
}

/// Returns the s of some overlaps at which the locus has this y.
double s_at_y(const ProfileGap& gap, const GapPoint& first, const GapPoint& last, double y) {
  const double a = first.wheel[1] - y, b = last.wheel[1] - y;
  if (a >= 0) return first.s;
  if (b <= 0) return last.s;
  double off = a;
  const auto value = [&](double s) {
    if (const auto found = gap.locus_at(gap.wheel().at(s))) off = found->x[1] - y;
    return off;
  };
  const double rounding = gap.locus().rounding();
  return false_position(first.s, a, last.s, b, value, [&](double f) { return std::abs(f) <= rounding; });
}

/// Finds the lateral spread about the common centre.
void describe_moments(const Overlap* first, const Overlap* last, OverlapPatch& patch) {
  const Vec3 pole = first->deepest.wheel;
  DepthMoments all;
  double deepest = 0;
  for (const Overlap* o = first; o <= last; ++o) {
    all.add(o->moments, o->deepest.wheel[1] - pole[1], o->deepest.wheel[2] - pole[2]);
    deepest = std::max(deepest, -o->deepest.gap);
  }
  const double half = 0.5 * (patch.high - patch.low);
  patch.spread = half * half / 8;
  patch.fullness = 1;
  if (!(all.weight > 0)) return;
  const double y = patch.lateral[1], z = patch.lateral[2];
  const double mean = (y * all.first[0] + z * all.first[1]) / all.weight;
  const auto [yy, yz, zz] = all.second;
  const double spread = (y * y * yy + 2 * y * z * yz + z * z * zz) / all.weight - mean * mean;
  if (!(spread > 0)) return;
  patch.spread = spread;
  // The integral of (1 - t^2)^2.5 is 5 pi / 16; weights are by y, and depths along z.
  const double wide = std::sqrt(8 * spread) * std::cos(patch.angle);
  const double power = std::pow(all.weight / (5 * std::numbers::pi / 16 * wide), 0.4);
  if (power > 0) patch.fullness = power / deepest;
}

void describe_reference(const ProfileGap& gap, double s, double side, double radius, OverlapPatch& patch) {
  const VisiblePoint wheel = gap.wheel().at(s), rail = gap.rail_at(patch.reference[1], patch.reference[0]);
  patch.reference[2] = rail.z;
  if (const auto there = gap.locus_at(wheel)) patch.wheel = there->x;
  patch.wheel_y = side * wheel.y;
  patch.rolling_radius = radius + wheel.z;
  patch.curvature = gap.locus().curvature(wheel);
  patch.curvature.across += rail.curvature();
  if (gap.varying()) patch.curvature.along = gap.varying()->curvature_along(gap.locus(), wheel);
}

OverlapPatch patch_of(const ProfileGap& gap, const Overlap* first, const Overlap* last, double side, double radius) {
  OverlapPatch patch;
  double weight = 0, y = 0, x = 0, angle = 0, ahead = 0;
  for (const Overlap* o = first; o <= last; ++o) {
    weight += o->weight;
    y += o->y;
    x += o->x;
    angle += o->angle;
    ahead += o->ahead;
    patch.cut = patch.cut || o->cut;
    patch.parted = patch.parted || o->parted;
  }
  // An overlap that is too shallow has a weight of 0.
  const GapPoint& deep = first->deepest;
  patch.reference = weight > 0 ? Vec3{x / weight, y / weight, 0} : deep.wheel;
  patch.angle = weight > 0 ? angle / weight : std::atan(deep.rail_slope);
  const double one_end = first->from.wheel[1], other = last->to.wheel[1];
  patch.reference[1] = std::clamp(patch.reference[1], std::min(one_end, other), std::max(one_end, other));
  describe_reference(gap, s_at_y(gap, first->from, last->to, patch.reference[1]), side, radius, patch);
  const double c = std::cos(patch.angle), s = std::sin(patch.angle);
  patch.normal = {0, s, -c};
  patch.lateral = {0, c, s};
  ahead = weight > 0 ? ahead / weight : deep.rail_ahead;
  if (ahead != 0) {
    // A normal with this slope along x stays in the plane of the angle across it.
    const double turned = std::atan(ahead * c);
    patch.along = {std::cos(turned), -s * std::sin(turned), c * std::sin(turned)};
    patch.normal = cross(patch.lateral, patch.along);
  }
  patch.back = patch.front = first->deepest.wheel[0] - patch.reference[0];
  patch.low = patch.high = dot(patch.lateral, first->deepest.wheel - patch.reference);
  double deepest = 0;
  for (const Overlap* o = first; o <= last; ++o) {
    patch.back = std::min(patch.back, o->back - patch.reference[0]);
    patch.front = std::max(patch.front, o->front - patch.reference[0]);
    for (const GapPoint* p : {&o->from, &o->to}) {
      const double off = dot(patch.lateral, p->wheel - patch.reference);
      patch.low = std::min(patch.low, off);
      patch.high = std::max(patch.high, off);
    }
    deepest = std::max(deepest, o->deepest.depth());
  }
  // Overlaps that are less than half as deep cannot be the deepest along the normal.
  constexpr double share = 0.5;
  for (const Overlap* o = first; o <= last; ++o)
    if (o->deepest.depth() >= share * deepest)
      patch.overlap = std::max(patch.overlap, greatest_depth_along(gap, *o, patch.angle));
  // Where the rail ends beside the overlap there is none along the normal.
  if (!(patch.overlap > 0)) patch.overlap = deepest;
  describe_moments(first, last, patch);
  return patch;
}

/// Returns how far along x the circle through a point overlaps, behind and ahead. Along it the gap is gap + b l + a
/// l^2, with b by how much it runs sideways; a is measured, as curvatures jump where arcs meet.
VaryingPair::Reach reach(const ProfileGap& gap, const VisiblePoint& p, const GapPoint& g) {
  const double depth = g.depth();
  if (!(depth > 0)) return {};
  if (gap.varying()) return gap.varying()->reach(gap.locus(), p);
  const double step = std::sqrt(2 * depth / gap.locus().bend(p)), sideways = g.rise * gap.locus().sideways(p);
  const std::array<Vec3, 2> beside = gap.locus().beside(p, step);
  std::array<double, 2> found{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3& x = beside[i];
    const double b = i == 0 ? -sideways : sideways;
    double a = -g.gap / (step * step);
    if (x[1] >= gap.rail().low() && x[1] <= gap.rail().high())
      a = (gap.rail_z(x[1]) - x[2] - g.gap - b * step) / (step * step);
    constexpr double flattest = 1.0 / 16;
    a = std::max(a, flattest * -g.gap / (step * step));
    const double root = std::sqrt(b * b - 4 * a * g.gap);
    const double length = b > 0 ? -2 * g.gap / (b + root) : (root - b) / (2 * a);
    found[i] = length / step * std::abs(x[0] - g.wheel[0]);
  }
  return {found[0], found[1]};
}

struct LocusPlace {
  double s;
  VisiblePoint wheel;
  std::optional<LocusPoint> locus;
};

/// Finds where the locus has this y, from a start between two ends.
LocusPlace place_at_y(const ProfileGap& gap, double y, double s, double from, double to, double close_enough) {
  constexpr int most = 8;
  LocusPlace place{};
  for (int i = 0; i <= most; ++i) {
    place.s = s;
    place.wheel = gap.wheel().at(s);
    place.locus = gap.locus_at(place.wheel);
    if (!place.locus || std::abs(y - place.locus->x[1]) <= close_enough) break;
    s = std::clamp(s + (y - place.locus->x[1]) / place.locus->forward_y, from, to);
  }
  return place;
}

/// Integrates over y, in which the gap's slope is continuous; by s it is not where the wheel's curvature jumps. Calls
/// visit(point of the wheel, gap) wherever the gap is taken.
template <class Visit>
void integrate(const ProfileGap& gap, const GapPoint& from, const GapPoint& to, Overlap& o, Visit visit) {
  constexpr std::size_t points = 16, parts = 3;
  const auto& rule = quadrature::line_rule(static_cast<int>(points));
  const double half = (to.wheel[1] - from.wheel[1]) / (2 * parts);
  const double close_enough = 1e-9 * half;
  GapPoint last = from;
  for (std::size_t k = 0; k < parts * points; ++k) {
    const std::size_t part = k / points, i = k % points;
    const double y = from.wheel[1] + half * (static_cast<double>(2 * part + 1) + rule.x[i]);
    const double start = std::clamp(last.s + (y - last.wheel[1]) / last.forward_y, last.s, to.s);
    const LocusPlace place = place_at_y(gap, y, start, from.s, to.s, close_enough);
    const auto g = place.locus ? gap.at(*place.locus, place.s) : std::nullopt;
    if (!g || !(g->gap < 0)) continue;
    last = *g;
    visit(place.wheel, *g);
    const double w = rule.w[i] * half * g->gap * g->gap * std::sqrt(-g->gap);
    o.weight += w;
    o.y += w * g->wheel[1];
    o.x += w * g->wheel[0];
    o.angle += w * std::atan(g->rail_slope);
    o.ahead += w * g->rail_ahead;
    o.moments.add(w, g->wheel[1] - o.deepest.wheel[1], g->wheel[2] - o.deepest.wheel[2]);
  }
}

}  // namespace

void DepthMoments::add(double w, double y, double z) {
  weight += w;
  first[0] += w * y;
  first[1] += w * z;
  second[0] += w * y * y;
  second[1] += w * y * z;
  second[2] += w * z * z;
}

void DepthMoments::add(const DepthMoments& other, double y, double z) {
  const auto [fy, fz] = other.first;
  second[0] += other.second[0] + 2 * y * fy;
  second[1] += other.second[1] + y * fz + z * fy;
  second[2] += other.second[2] + 2 * z * fz;
  first[0] += fy;
  first[1] += fz;
  add(other.weight, y, z);
}

void measure(const ProfileGap& gap, Overlap& o) {
  o.back = std::min({o.from.wheel[0], o.to.wheel[0], o.deepest.wheel[0]});
  o.front = std::max({o.from.wheel[0], o.to.wheel[0], o.deepest.wheel[0]});
  const auto take = [&](const VisiblePoint& p, const GapPoint& g) {
    const auto [behind, ahead, parted] = reach(gap, p, g);
    o.parted = o.parted || parted;
    o.back = std::min(o.back, g.wheel[0] - behind);
    o.front = std::max(o.front, g.wheel[0] + ahead);
    return (ahead + behind) / 2;
  };
  for (const auto& [from, to] : {std::array{o.from, o.deepest}, std::array{o.deepest, o.to}})
    integrate(gap, from, to, o, take);
  const double along = take(gap.wheel().at(o.deepest.s), o.deepest);
  const Vec3 across = o.to.wheel - o.from.wheel;
  o.size = std::sqrt(along * std::hypot(across[1], across[2]) / 4);
}

void gather(const ProfileGap& gap, const std::vector<Overlap>& overlap, const MergeRule& rule, double side,
            double radius, std::vector<OverlapPatch>& patch) {
  patch.clear();
  const std::size_t n = overlap.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i > 0 ? joined(gap, overlap[i - 1], overlap[i], rule) : 0;
    double inner = 1;
    for (std::size_t j = i; j < n && inner > before; ++j) {
      const double after = j + 1 < n ? joined(gap, overlap[j], overlap[j + 1], rule) : 0;
      const double share = inner - std::max(before, after);
      if (share > 0) {
        patch.push_back(patch_of(gap, &overlap[i], &overlap[j], side, radius));
        patch.back().apart = inner - share;
        patch.back().share = share;
      }
      inner = std::min(inner, after);
    }
  }
}

}  // namespace rollcon
