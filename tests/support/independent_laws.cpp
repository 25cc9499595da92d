#include "support/independent_laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/independent_layer.hpp"
#include "support/independent_results.hpp"

namespace rollcon::laws {
namespace {

/// Returns how far upstream each node's material comes from, in the projection.
std::vector<double> ways(const Given& given, std::size_t nodes, double distance) {
  std::vector<double> way(nodes, distance);
  for (std::size_t k = 0; k < given.triad.size(); ++k) way[k] *= given.triad[k][0][0];
  return way;
}

class Checker {
 public:
  Checker(const rollcon_contact* contact, const Given& given, std::size_t most_nodes)
      : contact_(contact),
        given_(given),
        result_(contact),
        at_(project(given)),
        nodes_(given.frame.node.size()),
        used_(nodes_, 0) {
    for (const std::int32_t k : given.frame.connectivity) used_[static_cast<std::size_t>(k)] = 1;
    if (given.in_time) {
      upstream_ = ways(given, nodes_, given.in_time->distance);
    } else if (given.scheme == Scheme::characteristic) {
      upstream_ = steps(given.frame, at_, given.step, given.regular);
    } else {
      rows_ = given.scheme == Scheme::godunov ? godunov_rows(given.frame, at_) : least_squares_rows(given.frame, at_);
    }
    choose_nodes(most_nodes);
    find_displacements();
  }

  Laws run() {
    laws_.finite = result_.finite();
    laws_.checked = static_cast<std::int64_t>(looked_at_.size());
    normal_laws();
    friction_laws();
    loads();
    return laws_;
  }

 private:
  double pressure(std::size_t k) const { return -result_.traction[3 * k + 2]; }
  bool in_contact(std::size_t k) const { return used_[k] && pressure(k) > 0; }
  double rounding() const { return given_.rounding * std::numeric_limits<double>::epsilon(); }
  double mu(std::size_t k) const {
    if (upstream_.empty() && rows_[k].empty()) return 0;
    return given_.friction.size() == 1 ? given_.friction[0] : given_.friction[k];
  }
  double closing(std::size_t k) const { return given_.triad.empty() ? 1 : given_.triad[k][2][2]; }
  bool gap_given() const { return given_.quadratic || !given_.gap.empty(); }

  double undeformed_gap(std::size_t k) const {
    if (!given_.gap.empty()) return given_.gap[k];
    const auto& q = *given_.quadratic;
    const double x = at_.x[k], y = at_.y[k];
    return q[0] * x * x + q[1] * y * y + q[2] * x * y;
  }

  void choose_nodes(std::size_t most) {
    std::vector<std::size_t> touching, open;
    for (std::size_t k = 0; k < nodes_; ++k)
      if (used_[k]) (in_contact(k) ? touching : open).push_back(k);
    if (touching.size() + open.size() > most) {
      // The nodes looked at are those nearest to touching, and every so many of those in contact.
      const auto rigid = [&](std::size_t k) { return gap_given() ? undeformed_gap(k) : result_.gap[k]; };
      std::sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) { return rigid(a) < rigid(b); });
      open.resize(std::min(open.size(), most / 3));
      const std::size_t keep = most - open.size(), every = 1 + touching.size() / keep;
      std::vector<std::size_t> some;
      for (std::size_t k = 0; k < touching.size(); k += every) some.push_back(touching[k]);
      touching = some;
    }
    looked_at_ = touching;
    looked_at_.insert(looked_at_.end(), open.begin(), open.end());
  }

  /// Finds u1 - u2 at the nodes looked at, and where their schemes need it.
  void find_displacements() {
    std::vector<double> xy;
    place_.assign(nodes_, -1);
    ahead_.assign(nodes_, -1);
    const auto want = [&](std::size_t k) {
      if (place_[k] >= 0) return;
      place_[k] = static_cast<std::int64_t>(xy.size() / 2);
      xy.insert(xy.end(), {at_.x[k], at_.y[k]});
    };
    for (const std::size_t k : looked_at_) {
      want(k);
      if (!in_contact(k) || given_.in_time) continue;
      if (!upstream_.empty()) {
        ahead_[k] = static_cast<std::int64_t>(xy.size() / 2);
        xy.insert(xy.end(), {at_.x[k] + upstream_[k], at_.y[k]});
      } else {
        for (const Difference& d : rows_[k]) want(static_cast<std::size_t>(d.node));
      }
    }
    const auto points = static_cast<std::int64_t>(xy.size() / 2);
    u_.resize(static_cast<std::size_t>(3 * points));
    std::vector<double> u2(u_.size());
    must(rollcon_contact_get_displacements_at(contact_, 1, points, xy.data(), u_.data()), "get_displacements_at");
    must(rollcon_contact_get_displacements_at(contact_, 2, points, xy.data(), u2.data()), "get_displacements_at");
    for (std::size_t k = 0; k < u_.size(); ++k) {
      laws_.finite = laws_.finite && std::isfinite(u_[k]) && std::isfinite(u2[k]);
      largest_u_ = std::max({largest_u_, std::abs(u_[k]), std::abs(u2[k])});
      u_[k] -= u2[k];
    }
    if (given_.layer > 0) add_layer(xy);
  }

  void add_layer(const std::vector<double>& xy) {
    const TractionsBetween between(given_.frame, at_);
    for (std::size_t p = 0; 2 * p < xy.size(); ++p) {
      const auto q = between(result_.traction, xy[2 * p], xy[2 * p + 1]);
      for (std::size_t c = 0; c < 2; ++c) {
        u_[3 * p + c] += given_.layer * q[c];
        largest_u_ = std::max(largest_u_, given_.layer * std::abs(q[c]));
      }
    }
  }

  /// Returns what turns slip into a velocity: slip is over V, or a shift.
  double velocity() const { return given_.in_time ? 1 / given_.in_time->dt : given_.speed; }
  double u(std::int64_t place, std::size_t c) const { return u_[3 * static_cast<std::size_t>(place) + c]; }

  void normal_laws() {
    double p0 = 0, u0 = 0, overlap = 0, room = 0;
    for (std::size_t k = 0; k < nodes_; ++k) p0 = std::max(p0, pressure(k));
    for (const std::size_t k : looked_at_) {
      u0 = std::max(u0, std::abs(u(place_[k], 2)));
      if (!gap_given()) continue;
      overlap = std::max(overlap, result_.approach * closing(k) - undeformed_gap(k));
      room = std::max(room, std::abs(result_.approach * closing(k) - undeformed_gap(k)));
    }
    u0 = std::max(u0, overlap);
    if (!(u0 > 0)) u0 = room;
    p0_ = p0;
    u0_ = u0;
    for (std::size_t k = 0; k < nodes_; ++k) {
      if (used_[k] && p0 > 0) laws_.tension = std::max(laws_.tension, -pressure(k) / p0);
      if (!used_[k] && pressure(k) != 0) laws_.tension = 1;
      laws_.contact += in_contact(k);
      if (in_contact(k)) laws_.turn = std::max(laws_.turn, std::acos(std::min(1.0, closing(k))));
    }
    if (!(u0 > 0)) return;
    for (const std::size_t k : looked_at_) {
      const double rigid = gap_given() ? undeformed_gap(k) : result_.gap[k] + u(place_[k], 2);
      const double moved = gap_given() ? result_.approach * closing(k) : 0;
      const double gap = rigid - moved - u(place_[k], 2);
      laws_.gap_field = std::max(laws_.gap_field, std::abs(gap - result_.gap[k]) / u0);
      const double rest = std::max(0.0, std::abs(gap) - rounding() * (std::abs(rigid) + std::abs(moved) + largest_u_));
      if (gap < 0) laws_.penetration = std::max(laws_.penetration, rest / u0);
      if (gap > 0 && in_contact(k))
        laws_.separation = std::max(laws_.separation, std::min(pressure(k) / p0, rest / u0));
    }
  }

  /// Holds the slip velocity over V, and what rounding may do to it.
  struct Slip {
    std::array<double, 2> rigid{}, elastic{};
    double uncertain = 0;
  };

  Slip slip(std::size_t k) const {
    Slip s;
    const double x = at_.x[k] + (upstream_.empty() ? 0 : 0.5 * upstream_[k]), y = at_.y[k];
    const double turning = result_.creep[2];
    s.rigid = {result_.creep[0] - turning * y, result_.creep[1] + turning * x};
    double cosine = 1;
    if (!given_.triad.empty()) {
      const auto& t = given_.triad[k];
      s.rigid = {t[0][0] * s.rigid[0] + t[0][1] * s.rigid[1], t[1][0] * s.rigid[0] + t[1][1] * s.rigid[1]};
      cosine = t[0][0];
    }
    double size = 0;
    if (given_.in_time) {
      const TimeStep& t = *given_.in_time;
      for (double& r : s.rigid) r *= t.distance > 0 ? t.distance : 1;
      for (std::size_t c = 0; c < 2; ++c) s.elastic[c] = u(place_[k], c) - (t.before.empty() ? 0 : t.before[3 * k + c]);
      size = 1;
    } else if (!upstream_.empty()) {
      const double path = upstream_[k] / cosine;
      for (std::size_t c = 0; c < 2; ++c) s.elastic[c] = (u(place_[k], c) - u(ahead_[k], c)) / path;
      size = 1 / path;
    } else {
      for (const Difference& d : rows_[k]) {
        const std::int64_t j = place_[static_cast<std::size_t>(d.node)];
        for (std::size_t c = 0; c < 2; ++c) s.elastic[c] += cosine * d.c * (u(j, c) - u(place_[k], c));
        size += std::abs(d.c);
      }
    }
    s.uncertain = rounding() * (size * largest_u_ + std::hypot(s.rigid[0], s.rigid[1]));
    if (!given_.creep_field.empty()) add_creep_field(k, s);
    return s;
  }

  /// Leaves out what a particle that touches within a shift slipped before: along its traction, by its gap at the
  /// beginning times traction over pressure, and a ratio of tangential to normal compliance, which is 1 to 1.5
  /// for half-spaces; at corners of meshed blocks 2.7 was found.
  void count_from_touch(std::size_t k, Slip& s) {
    if (!given_.in_time || given_.in_time->distance > 0 || given_.in_time->gap.empty()) return;
    constexpr double least_ratio = 0.25, most_ratio = 4, certain = 1e-6;
    const double gap = given_.in_time->gap[k], q1 = result_.traction[3 * k], q2 = result_.traction[3 * k + 1];
    const double square = q1 * q1 + q2 * q2;
    if (!(gap > 0) || !(square > 0)) return;
    const double d1 = result_.slip[2 * k] / velocity() - s.rigid[0] - s.elastic[0];
    const double d2 = result_.slip[2 * k + 1] / velocity() - s.rigid[1] - s.elastic[1];
    const double part = (d1 * q1 + d2 * q2) / square, per = gap / pressure(k);
    // The ratio shows where that slip is well above rounding of all slip.
    const double all = std::hypot(s.rigid[0] + s.elastic[0], s.rigid[1] + s.elastic[1]);
    if (gap > certain * u0_ && per * std::sqrt(square) > certain * all &&
        (part < least_ratio * per || part > most_ratio * per))
      laws_.stick = 1;
    s.elastic[0] += part * q1;
    s.elastic[1] += part * q2;
  }

  /// Adds the creepage field, which is given at nodes; where slip is taken half a step upstream it is carried there.
  void add_creep_field(std::size_t k, Slip& s) const {
    if (!upstream_.empty() && field_rows_.empty()) field_rows_ = least_squares_rows(given_.frame, at_);
    for (std::size_t c = 0; c < 2; ++c) {
      double value = given_.creep_field[2 * k + c], derivative = 0;
      if (!upstream_.empty())
        for (const Difference& d : field_rows_[k])
          derivative += d.c * (given_.creep_field[2 * static_cast<std::size_t>(d.node) + c] - value);
      if (!upstream_.empty()) value -= 0.5 * upstream_[k] * derivative;
      s.rigid[c] += value / velocity();
    }
  }

  /// Returns the slip over V that tractions of the size found cause: u0 / p0 per traction, over the radius of a circle
  /// of the contact's area. Where all sticks, elastic slip itself is the creepage's or none.
  double elastic_slip() const {
    double q = 0, area = 0;
    for (std::size_t k = 0; k < nodes_; ++k) {
      if (!in_contact(k)) continue;
      q = std::max(q, std::hypot(result_.traction[3 * k], result_.traction[3 * k + 1]));
      area += std::abs(result_.weight[k]);
    }
    const double radius = std::sqrt(area / 3.14);
    if (!(area > 0)) return 0;
    if (!given_.in_time) return u0_ / p0_ * q / radius;
    const double distance = given_.in_time->distance;
    return u0_ / p0_ * q * (distance > 0 ? std::min(1.0, distance / radius) : 1);
  }

  void friction_laws() {
    std::vector<std::size_t> touching;
    for (const std::size_t k : looked_at_)
      if (in_contact(k)) touching.push_back(k);
    double q0 = 0, s0 = elastic_slip();
    for (std::size_t k = 0; k < nodes_; ++k)
      if (in_contact(k)) q0 = std::max(q0, mu(k) * pressure(k));
    std::vector<Slip> slips;
    for (const std::size_t k : touching) {
      slips.push_back(slip(k));
      Slip& s = slips.back();
      s0 = std::max({s0, std::hypot(s.rigid[0], s.rigid[1]), std::hypot(s.elastic[0], s.elastic[1])});
      count_from_touch(k, s);
    }
    for (std::size_t k = 0; k < nodes_; ++k) {
      const double q = given_.law.measure(result_.traction[3 * k], result_.traction[3 * k + 1]);
      const double fast = std::hypot(result_.slip[2 * k], result_.slip[2 * k + 1]);
      const double limit = in_contact(k) ? mu(k) * given_.law.coefficient(fast) * pressure(k) : 0;
      const double excess = result_.state[k] == ROLLCON_SLIP ? std::abs(q - limit) : q - limit;
      if (q0 > 0)
        laws_.bound = std::max(laws_.bound, excess / q0);
      else if (q > 0)
        laws_.bound = 1;
      laws_.sticking += result_.state[k] == ROLLCON_STICK;
    }
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const std::size_t k = touching[i];
      const Slip& s = slips[i];
      const double s1 = s.rigid[0] + s.elastic[0], s2 = s.rigid[1] + s.elastic[1];
      if (s0 > 0)
        laws_.slip_field =
            std::max(laws_.slip_field,
                     (std::hypot(velocity() * s1 - result_.slip[2 * k], velocity() * s2 - result_.slip[2 * k + 1])) /
                         (velocity() * s0));
      if (!(mu(k) > 0) || !(s0 > 0)) continue;
      const double q1 = result_.traction[3 * k], q2 = result_.traction[3 * k + 1];
      const double q = std::hypot(q1, q2), speed = std::hypot(s1, s2);
      // A node is off the law by what slip would have to change, or what traction would: the lesser counts.
      const double limit = mu(k) * given_.law.coefficient(given_.speed * speed) * pressure(k);
      std::array<double, 2> slides{};
      if (speed > 0) slides = given_.law.sliding(s1, s2);
      const double by_traction = speed > 0 ? std::hypot(q1 - limit * slides[0], q2 - limit * slides[1]) / q0 : 0;
      const auto relative = [&](double part) { return std::min(by_traction, std::max(0.0, part - s.uncertain) / s0); };
      if (result_.state[k] == ROLLCON_STICK)
        laws_.stick = std::max(laws_.stick, relative(speed));
      else if (result_.state[k] != ROLLCON_SLIP)
        laws_.stick = 1;  // a node in contact that is said to be open
      else if (q > 0) {
        const auto [n1, n2] = given_.law.against(q1, q2);
        laws_.direction =
            std::max({laws_.direction, relative(std::abs(s1 * n2 - s2 * n1)), relative(s1 * n1 + s2 * n2)});
      } else
        laws_.direction = std::max(laws_.direction, relative(speed));
    }
  }

  void loads() {
    const bool flat = given_.triad.empty();
    const auto integral = flat ? shape_integrals(given_.frame, at_)
                               : surface_integrals(given_.frame, given_.origin, axes_of(given_.rolling, given_.normal));
    double sum[4] = {}, size[4] = {};
    for (std::size_t k = 0; k < nodes_; ++k) {
      const double* t = &result_.traction[3 * k];
      std::array<double, 3> force{t[0], t[1], t[2]};
      if (!flat)
        for (std::size_t j = 0; j < 3; ++j)
          force[j] = t[0] * given_.triad[k][0][j] + t[1] * given_.triad[k][1][j] + t[2] * given_.triad[k][2][j];
      const double w = integral[k][0];
      // The terms count with the node's cell, because shape functions and arms may cancel.
      const double cell = std::max(result_.area[k], std::abs(w));
      for (std::size_t j = 0; j < 3; ++j) {
        sum[j] += w * force[j];
        size[j] += cell * std::abs(force[j]);
      }
      sum[3] += integral[k][1] * force[1] - integral[k][2] * force[0];
      const double arm = std::abs(at_.x[k]) + std::abs(at_.y[k]) + std::sqrt(cell);
      size[3] += cell * arm * std::hypot(force[0], force[1]);
    }
    const double found[4] = {result_.force[0], result_.force[1], result_.force[2], result_.moment[2]};
    const double motion[4] = {result_.creep[0], result_.creep[1], result_.approach, result_.creep[2]};
    for (std::size_t d = 0; d < 4; ++d) {
      const double value = given_.value[d];
      const auto compare = [&](double a, double b) {
        const double scale = std::max({size[d], std::abs(a), std::abs(b)});
        if (scale > 0) laws_.equilibrium = std::max(laws_.equilibrium, std::abs(a - b) / scale);
      };
      compare(sum[d], found[d]);
      if (!given_.by_force[d]) {
        if (motion[d] != value) laws_.motion = std::max(laws_.motion, std::abs(motion[d] - value) / std::abs(value));
      } else if (p0_ > 0) {  // nothing can be carried without contact
        compare(d == 2 ? -sum[d] : sum[d], value);
      }
    }
  }

  const rollcon_contact* contact_;
  const Given& given_;
  Results result_;
  Plane at_;
  std::size_t nodes_;
  std::vector<std::uint8_t> used_;
  std::vector<double> upstream_;
  Rows rows_;
  mutable Rows field_rows_;
  std::vector<std::size_t> looked_at_;
  std::vector<std::int64_t> place_, ahead_;  ///< places in u_ of a node and of its upstream point
  std::vector<double> u_;
  double largest_u_ = 0, p0_ = 0, u0_ = 0;
  Laws laws_;
};

}  // namespace

double Laws::worst() const {
  if (!finite) return INFINITY;
  return std::max({tension, penetration, separation, bound, stick, direction, equilibrium, motion});
}

const char* Laws::worst_name() const {
  const double w = worst();
  if (!finite) return "not finite";
  if (w == tension) return "tension";
  if (w == penetration) return "penetration";
  if (w == separation) return "separation";
  if (w == bound) return "bound";
  if (w == stick) return "stick";
  if (w == direction) return "direction";
  return w == equilibrium ? "equilibrium" : "motion";
}

std::vector<double> displacements_before(const rollcon_contact* contact, const Given& given, double distance) {
  const Plane at = project(given);
  const std::size_t n = at.x.size();
  const std::vector<double> way = ways(given, n, distance);
  std::vector<double> xy, u(3 * n), u2(3 * n);
  for (std::size_t k = 0; k < n; ++k) xy.insert(xy.end(), {at.x[k] + way[k], at.y[k]});
  const auto points = static_cast<std::int64_t>(n);
  must(rollcon_contact_get_displacements_at(contact, 1, points, xy.data(), u.data()), "get_displacements_at");
  must(rollcon_contact_get_displacements_at(contact, 2, points, xy.data(), u2.data()), "get_displacements_at");
  for (std::size_t k = 0; k < u.size(); ++k) u[k] -= u2[k];
  return u;
}

Laws check(const rollcon_contact* contact, const Given& given, std::size_t most_nodes) {
  return Checker(contact, given, most_nodes).run();
}

}  // namespace rollcon::laws
