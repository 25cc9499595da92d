#include "wheelrail/varying_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollcon {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Contact is looked for within this angle before and behind the lowest point; rails that rise by 1 : 4 are met there.
constexpr double farthest = 0.25, closest_station = 0.005, farthest_station = 0.02;

}  // namespace

VaryingPair::VaryingPair(const SliceHeights* wheel, const SliceHeights* rail, const VisibleProfile& rail_profile,
                         std::optional<double> roller, double along, double turned, double radius)
    : wheel_(wheel),
      rail_(rail),
      rail_profile_(rail_profile),
      roller_(roller),
      along_(along),
      turned_(turned),
      station_(farthest_station) {
  constexpr double of_wave = 0.125;
  if (wheel_) station_ = closest_station;
  for (const SliceHeights* one : {wheel_, rail_})
    for (std::size_t i = 0; one && i < one->slices().waves().size(); ++i)
      station_ = std::min(station_, of_wave * one->slices().waves()[i].length / (one == wheel_ ? 1 : radius));
  stations_ = std::min(static_cast<int>(farthest / station_), most_stations);
  for (int i = -stations_; i <= stations_; ++i)
    turn_[static_cast<std::size_t>(i + stations_)] = {std::cos(i * station_), std::sin(i * station_)};
}

std::optional<SliceHeight> VaryingPair::rail(double x, double y) const {
  if (rail_) return rail_->at(along_ + x, y);
  if (!(y >= rail_profile_.low() && y <= rail_profile_.high())) return std::nullopt;
  near_ = rail_profile_.cell_at_y(y, near_);
  const VisiblePoint p = rail_profile_.at_y(y, near_);
  SliceHeight h;
  h.z = p.z;
  h.y = p.slope;
  h.yy = p.dslope / p.dy;
  return roller_ ? revolved(h, along_ + x) : h;
}

// Turns the section about the roller's axis.
std::optional<SliceHeight> VaryingPair::revolved(const SliceHeight& h, double u) const {
  const double r = *roller_ - h.z, square = r * r - u * u;
  if (!(r > 0 && square > 0)) return std::nullopt;
  const double c = std::sqrt(square), cube = square * c;
  SliceHeight turned;
  turned.z = h.z + u * u / (r + c);
  turned.u = u / c;
  turned.y = r * h.y / c;
  turned.uu = r * r / cube;
  turned.uy = u * r * h.y / cube;
  turned.yy = (r * h.yy - h.y * h.y) / c + r * r * h.y * h.y / cube;
  return turned;
}

VisiblePoint VaryingPair::rail_section(double x, double y) const {
  const auto h = rail(x, y).value_or(SliceHeight{});
  return {y, h.z, h.y, 1, h.y, h.yy};
}

std::optional<VaryingPair::At> VaryingPair::at(const WheelLocus& locus, const VisiblePoint& p, double angle) const {
  SliceHeight w;
  if (wheel_) {
    const auto found = wheel_->at(angle - turned_, p.y);
    if (!found) return std::nullopt;
    w = *found;
  } else {
    w.z = p.z;
    w.y = p.slope;
    w.yy = p.dslope / p.dy;
  }
  const WheelAxes& a = locus.axes();
  const double c = std::cos(angle), s = std::sin(angle), r = a.radius + w.z;
  const Vec3 out = c * a.down + s * a.ahead, round = c * a.ahead - s * a.down;
  At at;
  at.x = a.centre + p.y * a.axis + r * out;
  const auto h = rail(at.x[0], at.x[1]);
  if (!h) return std::nullopt;
  at.t = w.u * out + r * round;
  at.y = a.axis + w.y * out;
  at.tt = (w.uu - r) * out + 2 * w.u * round;
  at.ty = w.uy * out + w.y * round;
  at.yy = w.yy * out;
  const auto slope = [&](const Vec3& v) { return h->u * v[0] + h->y * v[1] - v[2]; };
  const auto bend = [&](const Vec3& v, const Vec3& q) {
    return h->uu * v[0] * q[0] + h->uy * (v[0] * q[1] + v[1] * q[0]) + h->yy * v[1] * q[1];
  };
  at.gap = h->z - at.x[2];
  at.gap_t = slope(at.t);
  at.gap_y = slope(at.y);
  at.gap_tt = slope(at.tt) + bend(at.t, at.t);
  at.gap_ty = slope(at.ty) + bend(at.t, at.y);
  at.gap_yy = slope(at.yy) + bend(at.y, at.y);
  return at;
}

double VaryingPair::rough_gap(const WheelLocus& locus, double y, double z, double c, double s, double angle,
                              double& at_y) const {
  const WheelAxes& a = locus.axes();
  const double r = a.radius + (wheel_ ? wheel_->rough(angle - turned_, y) : z);
  if (!std::isfinite(r)) return infinite;
  const Vec3 x = a.centre + y * a.axis + r * c * a.down + r * s * a.ahead;
  at_y = x[1];
  if (rail_) return rail_->rough(along_ + x[0], x[1]) - x[2];
  if (!(x[1] >= rail_profile_.low() && x[1] <= rail_profile_.high())) return infinite;
  near_ = rail_profile_.cell_at_y(x[1], near_);
  const double section = rail_profile_.cells()[near_].cubic_z(x[1]);
  if (!roller_) return section - x[2];
  const double away = *roller_ - section, u = along_ + x[0], square = away * away - u * u;
  return square > 0 ? section + u * u / (away + std::sqrt(square)) - x[2] : infinite;
}

std::optional<int> VaryingPair::best_station(const WheelLocus& locus, double y, double z, double& lowest,
                                             double& at_y) const {
  std::optional<int> best;
  lowest = infinite;
  double there = 0;
  const auto gap_at = [&](int i, double c, double s) {
    const double g = rough_gap(locus, y, z, c, s, i * station_, there);
    if (g < lowest) {
      lowest = g;
      at_y = there;
      best = i;
    }
    return g;
  };
  for (int i = -stations_; i <= stations_; ++i) {
    const auto k = static_cast<std::size_t>(i + stations_);
    station_gap_[k] = gap_at(i, turn_[k][0], turn_[k][1]);
  }
  // Steeper rails, and flanges of wheels that yaw, are met farther away.
  const int way = best == stations_ ? 1 : best == -stations_ ? -1 : 0;
  for (int i = way * (stations_ + 1); way != 0 && std::abs(i) * station_ < 1; i += way)
    if (gap_at(i, std::cos(i * station_), std::sin(i * station_)) > lowest) break;
  return best;
}

// Between stations a circle sinks by an eighth of their distance squared over the radius; a roller bends away, too.
double VaryingPair::slack(const WheelLocus& locus) const {
  const double radius = locus.axes().radius;
  // The ends of a rail's profile are lowest.
  const double deepest = std::max(rail_profile_.cells().front().z[0], rail_profile_.cells().back().z[1]);
  const double bent = roller_ ? radius * (1 + radius / (*roller_ - deepest)) : radius;
  return 0.2 * farthest_station * farthest_station * bent + (wheel_ ? wheel_->slack() : 0) +
         (rail_ ? rail_->slack() : 0);
}

VaryingPair::Rough VaryingPair::rough(const WheelLocus& locus, double y, double z) const {
  Rough found{infinite, 0, slack(locus)};
  best_station(locus, y, z, found.gap, found.y);
  return found;
}

// Finds the least gap between the stations beside one.
std::optional<VaryingPair::At> VaryingPair::least_near(const WheelLocus& locus, const VisiblePoint& p, int station,
                                                       double& angle) const {
  double low = (station - 1) * station_, high = (station + 1) * station_;
  angle = station * station_;
  constexpr int most = 40;
  constexpr double rounding = 1e-15, square = 1e-8;
  std::optional<At> found;
  for (int i = 0; i < most; ++i) {
    found = at(locus, p, angle);
    if (!found) return found;
    const double lean = found->lean() / found->y[1];
    (lean > 0 ? high : low) = angle;
    double next = angle - found->lean() / found->lean_t();
    if (found->lean_t() > 0 && std::abs(next - angle) <= rounding) break;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - angle);
    if (step <= rounding) break;
    angle = next;
    if (step > square) continue;
    found = at(locus, p, angle);
    break;
  }
  return found;
}

// Tries stations. A place that is nearly as near at its station may be nearer between stations.
const std::optional<VaryingPair::At>& VaryingPair::least(const WheelLocus& locus, const VisiblePoint& p) const {
  if (tried_ && found_y_ == p.y && found_slope_ == p.slope) return found_;
  tried_ = true;
  found_y_ = p.y;
  found_slope_ = p.slope;
  found_.reset();
  double lowest = 0, there = 0;
  const auto best = best_station(locus, p.y, p.z, lowest, there);
  if (!best) return found_;
  found_ = least_near(locus, p, *best, angle_);
  const double highest = lowest + slack(locus);
  for (int i = -stations_; i <= stations_; ++i) {
    const auto k = static_cast<std::size_t>(i + stations_);
    const double gap = station_gap_[k];
    const bool nearest =
        (i == -stations_ || gap <= station_gap_[k - 1]) && (i == stations_ || gap <= station_gap_[k + 1]);
    if (!nearest || gap > highest || std::abs(i - *best) < 2) continue;
    double angle = 0;
    const auto other = least_near(locus, p, i, angle);
    if (!other || (found_ && found_->gap <= other->gap)) continue;
    found_ = other;
    angle_ = angle;
  }
  return found_;
}

std::optional<LocusPoint> VaryingPair::nearest(const WheelLocus& locus, const VisiblePoint& p) const {
  const auto& f = least(locus, p);
  if (!f) return std::nullopt;
  const auto h = rail(f->x[0], f->x[1]);
  if (!h || !(f->y[1] > 0)) return std::nullopt;
  // Where the least gap jumps from one place along x to another, y goes on as if it did not.
  const double forward = f->y[1] - f->lean_y() / f->lean_t() * f->t[1];
  constexpr double least_forward = 1e-3;
  const bool goes = std::isfinite(forward) && std::abs(forward) > least_forward;
  return LocusPoint{f->x, h->y - f->gap_y / f->y[1], p.dy * (goes ? forward : 1)};
}

double VaryingPair::curvature_along(const WheelLocus& locus, const VisiblePoint& p) const {
  const auto& f = least(locus, p);
  if (!f) return locus.bend(p);
  const double steep = std::sqrt(1 + p.slope * p.slope);
  return std::max(f->gap_tt / (dot(f->t, f->t) * steep), 0.1 * locus.bend(p));
}

// Goes on from the least gap by steps until the circle leaves the rail, and over to other overlaps that stations show.
VaryingPair::Reach VaryingPair::reach(const WheelLocus& locus, const VisiblePoint& p) const {
  const auto& f = least(locus, p);
  Reach reach;
  if (!f || !(f->gap < 0)) return reach;
  const double middle = angle_, bend = std::max(f->gap_tt, 0.1 * length(f->t) * length(f->t) * locus.bend(p));
  for (std::size_t side = 0; side < 2; ++side) {
    const double sign = side == 0 ? -1 : 1;
    double far = std::sqrt(-2 * f->gap / bend), x = f->x[0] + sign * far * length(f->t);
    constexpr int most = 6;
    for (int i = 0; i < most; ++i) {
      const auto g = at(locus, p, middle + sign * far);
      if (!g) break;
      x = g->x[0];
      const double slope = sign * g->gap_t, step = slope > 0 ? -g->gap / slope : far;
      far += std::clamp(step, -0.5 * far, far);
      if (std::abs(step) <= 1e-6 * far) break;
    }
    double there = 0;
    for (double angle = far + station_; angle <= farthest; angle += station_)
      if (const double turn = middle + sign * angle;
          rough_gap(locus, p.y, p.z, std::cos(turn), std::sin(turn), turn, there) < 0)
        if (const auto g = at(locus, p, middle + sign * angle); g && g->gap < 0) {
          x = g->x[0];
          reach.parted = true;
        }
    (side == 0 ? reach.behind : reach.ahead) = std::abs(x - f->x[0]);
  }
  return reach;
}

}  // namespace rollcon
