/// Finds the pitch rate that belongs to a longitudinal force, and how far springs of the rail give way.

#include <algorithm>
#include <cmath>

#include "support/error.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

bool is_apart(Status status) {
  return status == Status::no_contact || status == Status::derailed || status == Status::cancelled;
}

}  // namespace

// Encloses the rate by growing steps from that of the velocity, and then takes secants (Illinois).
Status WheelRail::find_pitch_rate() {
  if (!in_.by_pull) return find_height();
  Status status = Status::ok;
  double most = 0;
  const auto off = [&](double rate) {
    in_.velocity.pitch = rate;
    status = find_height();
    const Totals now = totals(in_.position, z_, in_.deviation);
    most = 0;
    for (const Slot* slot : active_) most += slot->contact.overlap().share * length(slot->contact.force());
    return now.pull - in_.pull;
  };
  constexpr double first = 1e-4, grown = 2.5, farthest = 0.5, enough = 1e-6;
  constexpr int most_secants = 60;
  const double start = in_.velocity.pitch != 0 ? in_.velocity.pitch : -onward(in_) / radius_;
  double low = start, off_low = off(low), high = low, off_high = off_low;
  if (is_apart(status)) return status;
  // The wheel is pushed forward the more, the faster it turns forwards, which is a negative rate.
  double step = (off_low < 0 ? -first : first) * std::abs(start);
  while (off_low * off_high > 0 && std::abs(off_high) > enough * most) {
    if (std::abs(high - start) > farthest * std::abs(start))
      fail(Status::err_load,
           "no pitch rate from %g to %g has the longitudinal force %g: the wheel has %g there; check the force beside "
           "friction times the vertical force",
           std::min(start, high), std::max(start, high), in_.pull, off_high + in_.pull);
    low = high;
    off_low = off_high;
    off_high = off(high += step);
    if (is_apart(status)) return status;
    step *= grown;
  }
  for (int i = 0; std::abs(off_high) > enough * most; ++i) {
    if (i == most_secants || std::abs(high - low) <= 1e-14 * std::abs(high)) {
      context_->caveat(Status::not_converged,
                       "the longitudinal force is %.10g for %.10g; no pitch rate tried brought it nearer",
                       off_high + in_.pull, in_.pull);
      return Status::not_converged;
    }
    const double next = high - off_high * (high - low) / (off_high - off_low), off_next = off(next);
    if (is_apart(status)) return status;
    if (off_next * off_high < 0) {
      low = high;
      off_low = off_high;
    } else {
      off_low *= 0.5;
    }
    high = next;
    off_high = off_next;
  }
  return status;
}

// Meets stiffness times deflection = force of the wheel + force given by Broyden's method, from differences.
Status WheelRail::find_deflection() {
  const double ky = in_.stiffness[0], kz = in_.stiffness[1];
  if (ky == 0 && kz == 0) return find_pitch_rate();
  const RailDeviation given = in_.deviation;
  Status status = Status::ok;
  double most = 0;
  using Pair = std::array<double, 2>;
  const auto off = [&](const Pair& d) {
    in_.deviation.y = given.y + d[0];
    in_.deviation.z = given.z + d[1];
    status = find_pitch_rate();
    const Totals now = totals(in_.position, z_, in_.deviation);
    most = length(now.force) + std::abs(in_.rail_force[0]) + std::abs(in_.rail_force[1]);
    const Pair load{in_.rail_force[0] - now.force[1], in_.rail_force[1] - now.force[2]};
    return Pair{ky > 0 ? d[0] - load[0] / ky : 0, kz > 0 ? d[1] - load[1] / kz : 0};
  };
  const auto error = [&](const Pair& r) { return std::hypot(ky * r[0], kz * r[1]); };
  constexpr double enough = 1e-6;
  constexpr int most_steps = 40, most_halvings = 12;
  const double step = 1e-6 * radius_, farthest = 1e-3 * radius_;
  Pair d{0, kz > 0 && in_.by_force ? (in_.load + in_.rail_force[1]) / kz : 0}, r = off(d);
  Pair slope[2];  // columns by d
  for (std::size_t k = 0; k < 2; ++k) {
    slope[k] = {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0};
    if ((k == 0 ? ky : kz) == 0) continue;
    Pair near = d;
    near[k] += step;
    const Pair there = off(near);
    for (std::size_t i = 0; i < 2; ++i) slope[k][i] = (there[i] - r[i]) / step;
  }
  r = off(d);
  for (int i = 0; error(r) > enough * most; ++i) {
    if (status == Status::cancelled) return status;
    const double det = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
    if (i == most_steps || det == 0) {
      context_->caveat(Status::not_converged,
                       "the rail's springs are off by the force %.3g; no deflection tried was better", error(r));
      return Status::not_converged;
    }
    Pair go{-(slope[1][1] * r[0] - slope[1][0] * r[1]) / det, -(slope[0][0] * r[1] - slope[0][1] * r[0]) / det};
    const double far = std::hypot(go[0], go[1]);
    double part = far > farthest ? farthest / far : 1;
    const double before = error(r);
    Pair next = r;
    for (int k = 0; k < most_halvings; ++k, part *= 0.5) {
      next = off({d[0] + part * go[0], d[1] + part * go[1]});
      if (status == Status::cancelled || error(next) < before) break;
    }
    go = {part * go[0], part * go[1]};
    const double square = go[0] * go[0] + go[1] * go[1];
    for (std::size_t c = 0; c < 2 && square > 0; ++c) {
      const double miss = next[c] - r[c] - slope[0][c] * go[0] - slope[1][c] * go[1];
      for (std::size_t k = 0; k < 2; ++k) slope[k][c] += miss * go[k] / square;
    }
    d = {d[0] + go[0], d[1] + go[1]};
    r = next;
  }
  return status;
}

}  // namespace rollcon
