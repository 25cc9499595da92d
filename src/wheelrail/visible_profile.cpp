#include "wheelrail/visible_profile.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/profile_crossings.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr double most_turned = 0.02;     ///< greatest turn in a cell
constexpr double parts_of_length = 400;  ///< least number of cells
constexpr double least_cosine = 0.01;    ///< cosine of the steepest parts
constexpr double corner_turn = 1e-6;     ///< turn of a kink that counts

double between(double from, double to, double share) {
  return from + share * (to - from);
}

}  // namespace

double VisiblePoint::curvature() const {
  if (dy == 0) return 0;
  const double square = 1 + slope * slope;
  return dslope / (dy * square * std::sqrt(square));
}

VisibleProfile::VisibleProfile(std::shared_ptr<const ProfileCurve> curve, const ProfilePlane& map, Seen seen)
    : curve_(std::move(curve)), map_(map), seen_(seen), forward_(map.e_y[0] < 0 ? -1 : 1) {
  const std::size_t pieces = curve_->pieces().size();
  const double longest = curve_->length() / parts_of_length;
  for (std::size_t i = 0; i < pieces; ++i) add_piece(forward_ > 0 ? i : pieces - 1 - i, longest);
  if (cell_.empty())
    fail(Status::err_argument, "nothing of a profile of length %g can be seen along z; its y must rise somewhere",
         curve_->length());
  number();
  gather_spans(longest);
}

VisiblePoint VisibleProfile::on_curve(std::size_t piece, double u) const {
  const ProfilePoint p = curve_->at(piece, u);
  const auto turned = [&](const Vec2& v) { return v[0] * map_.e_y + v[1] * map_.e_z; };
  const Vec2 x = map_.origin + turned(p.x), d1 = forward_ * turned(p.d1), d2 = turned(p.d2);
  return {x[0], x[1], d1[1] / d1[0], d1[0], d1[1], cross(d1, d2) / (d1[0] * d1[0])};
}

VisiblePoint VisibleProfile::at(const VisibleCell& cell, double s) const {
  const double share = (s - cell.s[0]) / (cell.s[1] - cell.s[0]);
  if (cell.kind == VisibleCell::Kind::curve)
    return on_curve(cell.piece, share == 1 ? cell.u[1] : between(cell.u[0], cell.u[1], share));
  const double length = cell.s[1] - cell.s[0];
  return {between(cell.y[0], cell.y[1], share),
          between(cell.z[0], cell.z[1], share),
          between(cell.slope[0], cell.slope[1], share),
          (cell.y[1] - cell.y[0]) / length,
          (cell.z[1] - cell.z[0]) / length,
          (cell.slope[1] - cell.slope[0]) / length};
}

VisiblePoint VisibleProfile::at_among(std::size_t first, std::size_t last, double s) const {
  const auto begin = cell_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto after = std::upper_bound(begin + 1, cell_.begin() + static_cast<std::ptrdiff_t>(last) + 1, s,
                                      [](double value, const VisibleCell& cell) { return value < cell.s[0]; });
  return at(*(after - 1), s);
}

std::size_t VisibleProfile::cell_at_y(double y, std::size_t near) const {
  constexpr int steps = 4;
  for (int k = 0; k < steps; ++k) {
    if (y < cell_[near].y[0] && near > 0)
      --near;
    else if (y > cell_[near].y[1] && near + 1 < cell_.size())
      ++near;
    else
      return near;
  }
  const auto after = std::upper_bound(cell_.begin() + 1, cell_.end(), y,
                                      [](double value, const VisibleCell& cell) { return value < cell.y[0]; });
  return static_cast<std::size_t>(after - cell_.begin()) - 1;
}

VisiblePoint VisibleProfile::at_y(const VisibleCell& cell, double y, double& u) const {
  // The inverse's cubic through both ends is within a millionth of the cell already where it is not steep.
  const double width = cell.y[1] - cell.y[0], t = (y - cell.y[0]) / width, chord = cell.u[1] - cell.u[0];
  const auto off = [&](double slope) { return forward_ * width * std::sqrt(1 + slope * slope) - chord; };
  u = cell.u[0] + t * (chord + (1 - t) * ((1 - t) * off(cell.slope[0]) - t * off(cell.slope[1])));
  const double low = std::min(cell.u[0], cell.u[1]), high = std::max(cell.u[0], cell.u[1]);
  constexpr double square_is_rounding = 1e-6;
  VisiblePoint p{};
  for (int i = 0; i < 30; ++i) {
    u = std::clamp(u, low, high);
    p = on_curve(cell.piece, u);
    const double step = (y - p.y) / p.dy;
    u += forward_ * step;
    if (std::abs(step) <= square_is_rounding * (high - low)) {
      p.z += step * p.dy * (p.slope + step * p.dslope / 2);
      p.slope += step * p.dslope;
      p.y = y;
      break;
    }
  }
  u = std::clamp(u, low, high);
  return p;
}

double VisibleProfile::u_at_y(const VisibleCell& cell, double y) const {
  double u = 0;
  at_y(cell, y, u);
  return u;
}

VisiblePoint VisibleProfile::at_y(double y, std::size_t near) const {
  const VisibleCell& cell = cell_[cell_at_y(y, near)];
  double u = 0;
  if (cell.kind == VisibleCell::Kind::curve) return at_y(cell, y, u);
  return at(cell, between(cell.s[0], cell.s[1], (y - cell.y[0]) / (cell.y[1] - cell.y[0])));
}

void VisibleProfile::end_at(VisibleCell& cell, int end, double u) const {
  const VisiblePoint p = on_curve(cell.piece, u);
  const auto e = static_cast<std::size_t>(end);
  cell.u[e] = u;
  cell.y[e] = p.y;
  cell.z[e] = p.z;
  cell.slope[e] = p.slope;
}

void VisibleProfile::add_piece(std::size_t piece, double longest) {
  const ProfilePiece& p = curve_->pieces()[piece];
  const ProfilePoint a = curve_->at(piece, 0), b = curve_->at(piece, p.length);
  const double turn =
      p.curvature != 0 ? std::abs(p.curvature) * p.length : std::abs(std::atan2(cross(a.d1, b.d1), dot(a.d1, b.d1)));
  const double parts = std::max({1.0, std::ceil(turn / most_turned), std::ceil(p.length / longest)});
  for (double k = 0; k < parts; ++k) {
    const double from = p.length * k / parts, to = k + 1 == parts ? p.length : p.length * (k + 1) / parts;
    VisibleCell cell;
    cell.piece = piece;
    end_at(cell, 0, forward_ > 0 ? from : p.length - from);
    end_at(cell, 1, forward_ > 0 ? to : p.length - to);
    if (keep_steep_out(cell)) add(cell);
  }
}

bool VisibleProfile::keep_steep_out(VisibleCell& cell) const {
  const auto flat = [&](double u) {
    const VisiblePoint p = on_curve(cell.piece, u);
    return p.dy > least_cosine * std::hypot(p.dy, p.dz);
  };
  const bool first = flat(cell.u[0]), last = flat(cell.u[1]);
  if (first && last) return true;
  if (!first && !last) return false;
  double in = first ? cell.u[0] : cell.u[1], out = first ? cell.u[1] : cell.u[0];
  for (int i = 0; i < 60; ++i) (flat((in + out) / 2) ? in : out) = (in + out) / 2;
  end_at(cell, first ? 1 : 0, in);
  return cell.u[0] != cell.u[1];
}

void VisibleProfile::add(VisibleCell cell) {
  if (!(cell.y[1] > cell.y[0])) return;
  if (!cell_.empty()) {
    const double rounding = 1e-12 * curve_->length();
    if (cell.y[0] < high() - rounding) {
      const double behind = cell.y[0] < low() ? 0 : at_y(cell.y[0]).z - cell.z[0];
      if (seen_ == Seen::from_greater_z ? behind < 0 : behind > 0) {
        cut_back(cell.y[0]);
      } else {
        if (cell.y[1] <= high()) return;
        end_at(cell, 0, u_at_y(cell, high()));
      }
    }
  }
  if (!cell_.empty()) bridge_to(cell);
  cell.s = {0, std::abs(cell.u[1] - cell.u[0])};
  cell_.push_back(cell);
}

void VisibleProfile::cut_back(double y) {
  while (!cell_.empty() && cell_.back().y[0] >= y) cell_.pop_back();
  if (cell_.empty() || cell_.back().y[1] <= y) return;
  VisibleCell& last = cell_.back();
  if (last.kind == VisibleCell::Kind::curve) {
    end_at(last, 1, u_at_y(last, y));
    last.s = {0, std::abs(last.u[1] - last.u[0])};
  } else {
    cell_.pop_back();
  }
}

void VisibleProfile::bridge_to(const VisibleCell& cell) {
  const VisibleCell& last = cell_.back();
  const double rounding = 1e-9 * curve_->length(), gap = cell.y[0] - last.y[1];
  VisibleCell joint;
  joint.y = {last.y[1], cell.y[0]};
  joint.z = {last.z[1], cell.z[0]};
  if (gap > rounding) {
    joint.kind = VisibleCell::Kind::line;
    joint.slope = {(joint.z[1] - joint.z[0]) / gap, (joint.z[1] - joint.z[0]) / gap};
    joint.s = {0, std::hypot(gap, joint.z[1] - joint.z[0])};
    cell_.push_back(joint);
    return;
  }
  const double turn = std::atan(last.slope[1]) - std::atan(cell.slope[0]);
  if (seen_ != Seen::from_greater_z || turn < corner_turn || std::abs(joint.z[1] - joint.z[0]) > rounding) return;
  constexpr double length_of_turn = 1e-3;
  joint.kind = VisibleCell::Kind::corner;
  joint.slope = {last.slope[1], cell.slope[0]};
  joint.s = {0, length_of_turn * curve_->length() * turn};
  cell_.push_back(joint);
}

void VisibleProfile::number() {
  double s = 0;
  for (VisibleCell& cell : cell_) {
    cell.s = {s, s + cell.s[1]};
    s = cell.s[1];
  }
}

void VisibleProfile::gather_spans(double longest) {
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    const VisibleCell& cell = cell_[i];
    if (!span_.empty()) {
      VisibleSpan& span = span_.back();
      const double kink = std::abs(std::atan(cell.slope[0]) - std::atan(span.slope[1]));
      const double turn = std::abs(std::atan(cell.slope[1]) - std::atan(span.slope[0]));
      if (cell.kind == VisibleCell::Kind::curve && cell_[i - 1].kind == cell.kind && kink < corner_turn &&
          turn <= most_turned && cell.s[1] - span.s[0] <= longest) {
        span.last = i;
        span.s[1] = cell.s[1];
        span.y[1] = cell.y[1];
        span.z[1] = cell.z[1];
        span.slope[1] = cell.slope[1];
        continue;
      }
    }
    span_.push_back({i, i, cell.s, cell.y, cell.z, cell.slope});
  }
}

}  // namespace rollcon
