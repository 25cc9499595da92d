#include "framing/strips/strip_find.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "framing/hertz.hpp"
#include "framing/strips/field_sum.hpp"

namespace rollcon::strips {
namespace {

// Lattices of the probe, one after the other until strips are found from one.
constexpr ProbeCells probes[] = {{8, 12}, {12, 20}, {16, 32}};
constexpr StripCounts rough{6, 10};
constexpr int most_without_rough = 120;             // intervals along times across; finer strips begin with rough ones
constexpr int looks_along = 4, looks_across = 120;  // intervals of the box that is searched for further parts

/// Gives a gap that loads elsewhere widen.
struct GapBeside : PlaneField {
  const PlaneField* gap = nullptr;
  double cn = 0;
  std::vector<std::array<double, 3>> load;
  void at(std::span<const Vec2> point, double* value, Vec2* slope) const override {
    gap->at(point, value, slope);
    for (std::size_t i = 0; i < point.size(); ++i)
      for (const auto& [x, y, f] : load) value[i] += cn * f / std::hypot(point[i][0] - x, point[i][1] - y);
  }
};

// Returns the value at a place of the curve through values at `from` (ascending): a cubic through the four nearest.
double cubic(std::span<const double> from, const double* value, int stride, double at) {
  const int n = static_cast<int>(from.size());
  int first = static_cast<int>(std::upper_bound(from.begin(), from.end(), at) - from.begin()) - 2;
  first = std::clamp(first, 0, std::max(0, n - 4));
  double sum = 0;
  for (int i = first; i < std::min(first + 4, n); ++i) {
    double w = 1;
    for (int j = first; j < std::min(first + 4, n); ++j)
      if (j != i) w *= (at - from[j]) / (from[i] - from[j]);
    sum += w * value[i * stride];
  }
  return sum;
}

}  // namespace

bool fit_ellipse(const StripScene& scene, const Vec2& at, double size, double depth, double load, const StripLayout& l,
                 int part, double* geometry) {
  // Second derivatives from slopes on both sides.
  const Vec2 point[4] = {{at[0] - size, at[1]}, {at[0] + size, at[1]}, {at[0], at[1] - size}, {at[0], at[1] + size}};
  double value[4];
  Vec2 slope[4];
  scene.gap->at(point, value, slope);
  const QuadraticGap gap{(slope[1][0] - slope[0][0]) / (4 * size), (slope[3][1] - slope[2][1]) / (4 * size),
                         (slope[1][1] - slope[0][1] + slope[3][0] - slope[2][0]) / (4 * size)};
  if (!has_ellipse(gap)) return false;
  const double modulus = 1 / (std::numbers::pi * scene.bodies.cn);
  const HertzContact h = load > 0 ? hertz_by_load(gap, modulus, load) : hertz_by_approach(gap, modulus, depth);
  const double c = std::cos(h.angle), s = std::sin(h.angle), a2 = 1 / (h.larger * h.larger),
               b2 = 1 / (h.smaller * h.smaller);
  const double xx = c * c * a2 + s * s * b2, xy = c * s * (a2 - b2), yy = s * s * a2 + c * c * b2;
  const double width = std::sqrt(xx / (xx * yy - xy * xy));
  geometry[l.centre_of(part)] = at[1];
  geometry[l.width_of(part)] = width;
  for (int k = 0; k < l.rows_each; ++k) {
    const double u = l.across[k + 1];
    geometry[part * l.rows_each + k] = at[0] - xy / xx * u * width;
    geometry[l.half_of(part * l.rows_each + k)] = std::sqrt((1 - u * u) / xx);
  }
  return true;
}

void refine(const StripState& coarse, StripState& fine) {
  const StripLayout &c = coarse.layout, &f = fine.layout;
  fine.geometry.assign(f.geometry, 0);
  fine.traction.assign(2 * static_cast<std::size_t>(f.nodes), 0);
  fine.approach = coarse.approach;
  fine.motion = coarse.motion;
  const std::span<const double> from(c.across.data() + 1, c.rows_each);
  std::vector<double> shape(c.rows_each);
  for (int part = 0; part < f.parts; ++part) {
    fine.geometry[f.centre_of(part)] = coarse.geometry[c.centre_of(part)];
    fine.geometry[f.width_of(part)] = coarse.geometry[c.width_of(part)];
    for (int k = 0; k < c.rows_each; ++k) {
      const double u = from[k], half = coarse.geometry[c.half_of(part * c.rows_each + k)];
      shape[k] = half * half / (1 - u * u);
    }
    for (int k = 0; k < f.rows_each; ++k) {
      const double u = f.across[k + 1];
      const int row = part * f.rows_each + k;
      fine.geometry[row] = cubic(from, coarse.geometry.data() + part * c.rows_each, 1, u);
      const double square = cubic(from, shape.data(), 1, u);
      const auto [least, most] = std::minmax_element(shape.begin(), shape.end());
      fine.geometry[f.half_of(row)] = std::sqrt(std::clamp(square, *least, *most) * (1 - u * u));
      // Tractions over pressures, linear between nodes and constant beyond the last ones.
      const int below = std::clamp(static_cast<int>(std::upper_bound(from.begin(), from.end(), u) - from.begin()) - 1,
                                   0, std::max(0, c.rows_each - 2));
      const double t = std::clamp((u - from[below]) / (from[below + 1] - from[below]), 0.0, 1.0);
      for (int i = 0; i < f.nodes_each; ++i) {
        const double v = f.along[i + 1];
        const double* begin = c.along.data() + 1;
        const int left = std::clamp(static_cast<int>(std::upper_bound(begin, begin + c.nodes_each, v) - begin) - 1, 0,
                                    c.nodes_each - 2);
        const double q = std::clamp((v - begin[left]) / (begin[left + 1] - begin[left]), 0.0, 1.0);
        for (int d = 0; d < 2; ++d) {
          double sum = 0;
          for (int m = 0; m < 4; ++m) {
            const int node = (part * c.rows_each + below + m / 2) * c.nodes_each + left + m % 2;
            const double w = (m / 2 ? t : 1 - t) * (m % 2 ? q : 1 - q);
            if (coarse.pressure[node] > 0) sum += w * coarse.traction[d * c.nodes + node] / coarse.pressure[node];
          }
          fine.traction[d * f.nodes + row * f.nodes_each + i] = sum;
        }
      }
    }
  }
}

// Each of several parts gets a lattice of its own, under the loads of the others.
void StripFinder::look_closer(const StripScene& scene, StripCounts counts, ProbeCells cells, StripState& state) {
  GapBeside gap;
  gap.gap = scene.gap;
  gap.cn = scene.bodies.cn;
  StripScene alone = scene;
  alone.gap = &gap;
  alone.by_load = false;
  alone.value = state.approach;
  const StripLayout& l = state.layout;
  for (int part = 0; part < l.parts; ++part) {
    const Rectangle box = probe_.loads_beside(part, gap.load);
    if (part_probe_.start(alone, box, counts, part_, cells) != StripStatus::solved || part_.layout.parts != 1) continue;
    const StripLayout& o = part_.layout;
    for (int k = 0; k < o.rows; ++k) {
      state.geometry[part * l.rows_each + k] = part_.geometry[k];
      state.geometry[l.half_of(part * l.rows_each + k)] = part_.geometry[o.half_of(k)];
    }
    state.geometry[l.centre_of(part)] = part_.geometry[o.centre_of(0)];
    state.geometry[l.width_of(part)] = part_.geometry[o.width_of(0)];
  }
}

bool StripFinder::start(const StripScene& scene, const Rectangle& box, StripCounts counts, int cells, bool joined,
                        StripState& state) {
  const bool finer = counts.along * counts.across > most_without_rough;
  StripState& first = finer ? coarse_ : state;
  if (joined) {
    probe_.join(scene, first);
  } else {
    status_ = probe_.start(scene, box, finer ? rough : counts, first, probes[cells]);
    parts_seen_ = status_ == StripStatus::solved ? first.layout.parts : 0;
    if (parts_seen_ > 1) look_closer(scene, first.layout.counts, probes[cells], first);
  }
  if (status_ != StripStatus::solved) return false;
  probed_ = first;
  probed_.pressure.assign(static_cast<std::size_t>(first.layout.nodes), 0);
  probed_.traction.assign(2 * static_cast<std::size_t>(first.layout.nodes), 0);
  if (first.layout.parts == 1) CornerRows::widen(scene, probed_);
  if (!finer) return true;
  if (solver_.solve(scene, coarse_, StripStart::geometry).status != StripStatus::solved) return false;
  probed_ = coarse_;
  if (!(state.layout.counts == counts) || state.layout.parts != coarse_.layout.parts)
    state.layout = StripLayout(counts, coarse_.layout.parts);
  refine(coarse_, state);
  return true;
}

double StripFinder::deformed_gap(const StripScene& scene, const StripState& state, const Vec2& at, bool near) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  double gap = 0;
  scene.gap->at({&at, 1}, &gap, nullptr);
  gap -= state.approach;
  if (near) {
    const double across = (at[1] - g[l.centre_of(0)]) / g[l.width_of(0)];
    const StripPoint p{0, 0, 0, 1, 0, (at[0] - g[0]) / g[l.half_of(0)], across};
    return gap + integrals_.displacement(integrals_.observe(Displacement::normal, false, p, 0), 0, 0);
  }
  for (int i = 0; i < l.nodes; ++i) {
    const double w = l.unit_weight[i] * l.cell(l.node[i], g);
    const double dx = at[0] - l.x(l.node[i], g), dy = at[1] - l.y(l.node[i], g);
    gap += scene.bodies.cn * w * state.pressure[i] / std::sqrt(dx * dx + dy * dy);
  }
  return gap;
}

bool StripFinder::inside(const StripState& state, const Vec2& at, double reach) const {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  for (int part = 0; part < l.parts; ++part) {
    const double u = (at[1] - g[l.centre_of(part)]) / g[l.width_of(part)];
    if (std::abs(u) > reach) continue;
    // Chords are straight between rows.
    const int above =
        std::clamp(static_cast<int>(std::lower_bound(l.across.begin(), l.across.end(), u) - l.across.begin()) - 1, 1,
                   l.rows_each - 1);
    const double t = std::clamp((u - l.across[above]) / (l.across[above + 1] - l.across[above]), 0.0, 1.0);
    const int k = part * l.rows_each + above;
    const double middle = (1 - t) * g[k - 1] + t * g[k], half = (1 - t) * g[l.half_of(k - 1)] + t * g[l.half_of(k)];
    if (std::abs(at[0] - middle) < reach * half + (reach - 1) * g[l.width_of(part)]) return true;
  }
  return false;
}

// Looks where the undeformed bodies overlap outside of the strips for a place that the deformed ones overlap at, too,
// and adds a part there.
bool StripFinder::more_parts(const StripScene& scene, const Rectangle& box, StripState& state) {
  constexpr double reach = 1.1;
  const double hx = (box.x_greatest - box.x_least) / looks_along, hy = (box.y_greatest - box.y_least) / looks_across;
  point_.clear();
  for (int j = 0; j <= looks_across; ++j)
    for (int i = 1; i < looks_along; ++i)
      if (const Vec2 at{box.x_least + i * hx, box.y_least + j * hy}; !inside(state, at, reach)) point_.push_back(at);
  gap_.resize(point_.size());
  scene.gap->at(point_, gap_.data(), nullptr);
  std::size_t best = point_.size();
  double least = 0;
  integrals_.lay(state.layout, scene.bodies, state.geometry.data());
  integrals_.set_field(0, state.pressure.data());
  for (std::size_t i = 0; i < point_.size(); ++i) {
    if (!(gap_[i] < state.approach)) continue;
    const double gap = deformed_gap(scene, state, point_[i], false);
    if (best == point_.size() || gap < least) {
      best = i;
      least = gap;
    }
  }
  if (best == point_.size()) return false;
  // Moves to the least deformed gap beside it, by parabolas along both axes.
  Vec2 at = point_[best];
  Vec2 step{hx / 2, hy / 2};
  double value = deformed_gap(scene, state, at, true);
  for (int round = 0; round < 12; ++round)
    for (int d = 0; d < 2; ++d) {
      Vec2 before = at, after = at;
      before[d] -= step[d];
      after[d] += step[d];
      const double a = deformed_gap(scene, state, before, true), b = deformed_gap(scene, state, after, true);
      const double curve = a + b - 2 * value;
      const double by = curve > 0 ? std::clamp((a - b) / (2 * curve), -1.0, 1.0) : a < b ? -1 : 1;
      Vec2 to = at;
      to[d] += by * step[d];
      const double there = deformed_gap(scene, state, to, true);
      if (there < value) {
        at = to;
        value = there;
      }
      step[d] = std::max(step[d] / 2, 1e-4 * (d == 0 ? hx : hy));
      // The least gap lies in the contact that is known.
      if (inside(state, at, reach)) return false;
    }
  if (!(value < 0) || inside(state, at, reach)) return false;
  StripState more;
  more.layout = StripLayout(state.layout.counts, state.layout.parts + 1);
  const StripLayout &o = state.layout, &l = more.layout;
  more.geometry.assign(l.geometry, 0);
  for (int part = 0; part < o.parts; ++part) {
    for (int k = part * o.rows_each; k < (part + 1) * o.rows_each; ++k) {
      more.geometry[k] = state.geometry[k];
      more.geometry[l.half_of(k)] = state.geometry[o.half_of(k)];
    }
    more.geometry[l.centre_of(part)] = state.geometry[o.centre_of(part)];
    more.geometry[l.width_of(part)] = state.geometry[o.width_of(part)];
  }
  more.approach = state.approach;
  if (!fit_ellipse(scene, at, 1e-3 * hy, -value, 0, l, o.parts, more.geometry.data())) return false;
  state = std::move(more);
  return true;
}

// Lays rows near corners, from a solution on strips of any counts. Returns false where there are no corners or strips
// are not found near them; the state is then what it was.
bool StripFinder::solve_at_corners(const StripScene& scene, const StripState& solved, StripCounts counts,
                                   StripState& state) {
  missed_corners_ = rows_.cornered(scene, solved);
  if (!missed_corners_) return false;
  if (!rows_.lay(scene, solved, counts, laid_)) return false;
  if (solver_.solve(scene, laid_, StripStart::shares).status != StripStatus::solved) return false;
  std::swap(state, laid_);
  missed_corners_ = false;
  return true;
}

StripReport StripFinder::find(const StripScene& scene, const Rectangle& box, StripCounts counts, StripState& state,
                              bool warm, bool patient) {
  StripReport report;
  report.status = StripStatus::unfit;
  missed_corners_ = false;
  parts_seen_ = 0;
  const int attempts = patient ? static_cast<int>(std::size(probes)) : 1;
  warm = warm && state.layout.counts == counts && !state.pressure.empty();
  const bool refined = counts.along * counts.across > most_without_rough;
  for (int attempt = warm ? -1 : 0; attempt < attempts; ++attempt)
    // A waist may look like two parts to the probe.
    for (const bool joined : {false, true}) {
      if (joined && (attempt < 0 || parts_seen_ != 2)) break;
      const bool started = attempt < 0 || start(scene, box, counts, attempt, joined, state);
      if (status_ == StripStatus::no_contact && !started) return {status_};
      // Strips are often not found until their rows are near corners.
      const auto at_corners = [&](const StripState& from) { return solve_at_corners(scene, from, counts, state); };
      const bool from_probe = attempt >= 0 && status_ == StripStatus::solved && (refined || !started);
      if (from_probe && at_corners(probed_)) return {};
      if (!started) continue;
      report = solver_.solve(scene, state,
                             attempt < 0 ? StripStart::solution
                             : refined   ? StripStart::shares
                                         : StripStart::geometry);
      while (report.status == StripStatus::solved && more_parts(scene, box, state))
        report = solver_.solve(scene, state, StripStart::geometry);
      // Rows that corners have left are found from nothing.
      if (report.status == StripStatus::solved && !from_probe && !at_corners(state) && is_laid(state.layout))
        report.status = StripStatus::unfit;
      if (report.status == StripStatus::not_converged && !from_probe && attempt >= 0 && at_corners(probed_)) return {};
      if (report.status == StripStatus::solved || report.status == StripStatus::beyond_friction) return report;
      if (scattered()) return report;
    }
  return report;
}

bool StripFinder::rates(const StripScene& scene, const StripState& state, std::span<const StripParameter> parameter,
                        std::span<StripTotals> rate, std::span<double> share_rate) {
  if (!solver_.rates(scene, state, parameter, rate, share_rate)) return false;
  if (!is_laid(state.layout)) return true;
  const StripTotals now = StripSolver::totals(state);
  for (std::size_t i = 0; i < parameter.size(); ++i) {
    const StripParameter& p = parameter[i];
    double moved = 0;
    const auto count = [&moved](double by, double of) {
      if (of != 0) moved = std::max(moved, std::abs(by / of));
    };
    count(rate[i].load, now.load);
    count(rate[i].approach, now.approach);
    for (int d = 0; d < 3; ++d) {
      count(rate[i].force[d], now.force[d]);
      count(rate[i].motion[d], now.motion[d]);
    }
    if ((p.value == 0 && !p.gap && scene.bodies.ck == 0) || !(moved > 0)) continue;
    constexpr double little = 1e-4;
    StripTotals side[2];
    for (const int k : {0, 1}) {
      const double step = (k == 0 ? -little : little) / moved;
      StripScene there = scene;
      FieldSum gap, friction, slip[2];
      const auto shift = [&](FieldSum& to, const PlaneField*& field, const PlaneField* by) {
        to.field[0] = field;
        to.field[1] = by;
        to.factor[1] = step;
        if (by) field = &to;
      };
      shift(gap, there.gap, p.gap);
      shift(friction, there.friction, p.friction);
      for (int d = 0; d < 2; ++d) shift(slip[d], there.slip[d], p.slip[d]);
      there.value += step * p.value;
      there.mu += step * p.mu;
      for (int d = 0; d < 3; ++d) there.motion[d] += step * p.motion[d];
      beside_ = state;
      if (solver_.solve(there, beside_, StripStart::solution).status != StripStatus::solved ||
          !solve_at_corners(there, beside_, state.layout.counts, beside_))
        return true;
      side[k] = StripSolver::totals(beside_);
    }
    const double over = moved / (2 * little);
    rate[i].load = over * (side[1].load - side[0].load);
    rate[i].approach = over * (side[1].approach - side[0].approach);
    rate[i].pressed = over * (side[1].pressed - side[0].pressed);
    for (int d = 0; d < 3; ++d) {
      rate[i].force[d] = over * (side[1].force[d] - side[0].force[d]);
      rate[i].motion[d] = over * (side[1].motion[d] - side[0].motion[d]);
    }
  }
  return true;
}

}  // namespace rollcon::strips
