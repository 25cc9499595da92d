#include "framing/strips/strip_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "framing/strips/strip_find.hpp"

namespace rollcon::strips {
namespace {

constexpr int samples = 64;
// Jumps of curvature over the mean one that the overlap tells, between which rows begin to move and have moved.
constexpr double least_jump = 40, large_jump = 150;
// Parts of half the overlap that bodies part by beyond the corner: a contact that has just
// reached a corner has no peak there.
constexpr double least_part = 0.05, large_part = 0.6;
constexpr double least_reach = 1e-3;
constexpr double chords_of_reach = 4;  // half chords over which pressures change at a corner far from the end

double rise(double x, double low, double high) {
  const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

/// Takes values and slopes of the gap across the middles of one part's chords.
class Middle {
 public:
  Middle(const StripScene& scene, const StripState& state)
      : gap_(*scene.gap), layout_(state.layout), g_(state.geometry.data()) {}

  double width() const { return g_[layout_.width_of(0)]; }
  /// Returns the row before a place and the part of the way to the next one; outer rows go on beyond.
  std::pair<int, double> between(double u) const {
    const double* const row = layout_.across.data() + 1;
    const int rows = layout_.rows_each;
    const double inside = std::clamp(u, row[0], row[rows - 1]);
    const auto k = static_cast<int>(std::upper_bound(row + 1, row + rows - 1, inside) - row);
    return {k - 1, (inside - row[k - 1]) / (row[k] - row[k - 1])};
  }
  double gap(double u, double* slope = nullptr) const {
    const auto [row, t] = between(u);
    const Vec2 point{(1 - t) * g_[row] + t * g_[row + 1], g_[layout_.centre_of(0)] + u * width()};
    double value = 0;
    Vec2 slopes;
    gap_.at({&point, 1}, &value, &slopes);
    if (slope) *slope = slopes[1] * width();
    return value;
  }
  /// Returns where the gap is as large as a level, between the middle and twice the width.
  double end_below(double u, double level, int halvings) const {
    double inside = 0, outside = 2 * u;
    if (gap(u) < level)
      inside = u;
    else
      outside = u;
    for (int i = 0; i < halvings; ++i) {
      const double between = (inside + outside) / 2;
      (gap(between) < level ? inside : outside) = between;
    }
    return outside;
  }
  double slope(double u) const {
    double slope = 0;
    gap(u, &slope);
    return slope;
  }

 private:
  const PlaneField& gap_;
  const StripLayout& layout_;
  const double* g_;
};

/// Moves to where curvature jumps, by straight lines through slopes on both sides at ever smaller distances. Returns
/// the jump; 0 where there is none.
double jump_near(const Middle& middle, double distance, double& place) {
  constexpr int rounds = 5;
  constexpr double found = 0.05;  // part of the last distance by which a jump moves at most: kinks move on
  double jump = 0;
  for (int round = 0; round < rounds; ++round, distance /= 4) {
    const double before = middle.slope(place - distance), behind = middle.slope(place + distance);
    const double rise_before = (before - middle.slope(place - 2 * distance)) / distance,
                 rise_behind = (middle.slope(place + 2 * distance) - behind) / distance;
    const double now = rise_behind - rise_before;
    if (!(std::abs(now) > std::abs(jump) / 2)) return 0;
    const double by = (before + rise_before * distance - behind + rise_behind * distance) / now;
    if (!(std::abs(by) <= (round + 1 < rounds ? 2 : found) * distance)) return 0;
    place += by;
    jump = now;
  }
  return std::abs(jump);
}

/// Makes a start for the chords of moved rows from those of a solution, whose squares are in proportion to how far the
/// gap is below the line between the ends of the width.
void shape_chords(const StripScene& scene, const StripState& from, StripState& to) {
  const Middle middle(scene, from);
  const double end[2] = {middle.gap(-1), middle.gap(1)};
  const auto depth = [&](double u) { return (end[0] * (1 - u) + end[1] * (1 + u)) / 2 - middle.gap(u); };
  constexpr double least_part = 1e-3;
  const StripLayout& l = from.layout;
  double deepest = 0;
  for (int k = 0; k < l.rows_each; ++k) deepest = std::max(deepest, depth(l.across[k + 1]));
  if (!(deepest > 0)) return;
  const auto floored = [&](double u) { return std::max(depth(u), least_part * deepest); };
  const auto ratio = [&](int row) {
    const double half = from.geometry[l.half_of(row)];
    return half * half / floored(l.across[row + 1]);
  };
  for (int k = 0; k < to.layout.rows_each; ++k) {
    const double u = to.layout.across[k + 1];
    const auto [row, t] = middle.between(u);
    to.geometry[to.layout.half_of(k)] = std::sqrt(((1 - t) * ratio(row) + t * ratio(row + 1)) * floored(u));
  }
}

}  // namespace

bool is_laid(const StripLayout& layout) {
  return layout.parts == 1 && layout.across[1] != usual_row(2.0 / layout.counts.across - 1);
}

// Places are found to rounding, and strengths change smoothly. Corners are looked for wherever the undeformed bodies
// overlap, which reaches a little beyond the contact.
void CornerRows::find(const StripScene& scene, const StripState& state) {
  corner_.clear();
  if (state.layout.parts != 1) return;
  const Middle middle(scene, state);
  constexpr int rough = 12, exact = 50;
  const double from = middle.end_below(-1, state.approach, rough), to = middle.end_below(1, state.approach, rough);
  std::array<double, samples + 1> place, slope;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= samples; ++i) {
    const double t = std::sin(std::numbers::pi * (static_cast<double>(i) / samples - 0.5));
    place[i] = ((1 - t) * from + (1 + t) * to) / 2;
    least = std::min(least, middle.gap(place[i], &slope[i]));
  }
  const double overlap = state.approach - least;
  const double* half = state.geometry.data() + state.layout.half_of(0);
  const double chord = *std::max_element(half, half + state.layout.rows_each) / middle.width();
  for (std::size_t i = 1; i + 2 <= samples; ++i) {
    const double spacing = place[i + 1] - place[i], before = (slope[i] - slope[i - 1]) / (place[i] - place[i - 1]),
                 behind = (slope[i + 2] - slope[i + 1]) / (place[i + 2] - place[i + 1]);
    double at = place[i] + (slope[i + 1] - slope[i] - behind * spacing) / (before - behind);
    if (!(std::abs(behind - before) > least_jump * overlap) || !(std::abs(at - place[i]) <= 2 * spacing)) continue;
    const double jump = jump_near(middle, spacing / 2, at), side = at > 0 ? 1 : -1;
    if (!(jump > least_jump * overlap)) continue;
    const auto same = [at](const Corner& c) { return std::abs(c.at - at) < 1e-4; };
    if (std::any_of(corner_.begin(), corner_.end(), same)) continue;
    Corner corner;
    corner.at = at;
    corner.place = std::clamp(at, -1.0, 1.0);
    corner.reach = 1 / (1 / std::hypot(1 - std::abs(at), least_reach) + 1 / (chords_of_reach * chord));
    // Where half of the overlap is left the contact ends nearly, however rough its strips are.
    const double beyond = std::max(side * (middle.end_below(side, state.approach - overlap / 2, exact) - at), 0.0);
    corner.strength = rise(std::log(jump / overlap), std::log(least_jump), std::log(large_jump)) *
                      rise(jump / overlap * beyond * beyond, least_part, large_part);
    if (corner.strength > 0) corner_.push_back(corner);
  }
}

// Places rows at equal steps of the usual parameter plus an area hyperbolic sine for each corner, whose steps grow in
// proportion to the distance from a place between the corner and the contact's end; over lengths of at least `least` of
// half the width.
void CornerRows::place(StripCounts counts, double least) {
  constexpr double amount = 0.8, beyond = 0.4, width = 0.3;
  constexpr int halvings = 52;
  double of_usual = 1;
  const auto measure = [&](double t) {
    double sum = of_usual * t;
    for (const Corner& c : corner_)
      sum += amount * c.strength *
             std::asinh((usual_row(t) - c.place - std::copysign(beyond * c.reach, c.place)) /
                        std::max(width * c.reach, least));
    return sum;
  };
  // An end without a corner needs its rows, too.
  double strongest[2] = {0, 0};
  for (const Corner& c : corner_) strongest[c.place > 0 ? 1 : 0] = std::max(strongest[c.place > 0 ? 1 : 0], c.strength);
  of_usual = 1 + ((measure(1) - measure(-1)) / 2 - 1) * (1 - std::min(strongest[0], strongest[1]));
  const double first = measure(-1), last = measure(1);
  across_.assign(static_cast<std::size_t>(counts.across) + 1, -1);
  across_.back() = 1;
  for (int i = 1; i < counts.across; ++i) {
    const double wanted = first + (last - first) * i / counts.across, usual = 2.0 * i / counts.across - 1;
    double low = -1, high = 1;
    for (int k = 0; k < halvings && !corner_.empty(); ++k) {
      const double t = (low + high) / 2;
      (measure(t) < wanted ? low : high) = t;
    }
    across_[static_cast<std::size_t>(i)] = usual_row(corner_.empty() ? usual : (low + high) / 2);
  }
}

// Finds strips of the counts in moved_, from others, with rows at the places that corners and `least` ask for.
bool CornerRows::move(const StripScene& scene, const StripState& from, StripCounts counts, double least) {
  place(counts, least);
  moved_.layout = StripLayout(counts, 1, across_);
  refine(from, moved_);
  const auto inside = [](const Corner& c) { return std::abs(c.at) < 1; };
  if (std::any_of(corner_.begin(), corner_.end(), inside)) shape_chords(scene, from, moved_);
  return solver_.press(scene, moved_, StripStart::geometry).status == StripStatus::solved;
}

// Moves rows until their places and the contact agree. Returns false where they do not.
bool CornerRows::settle(const StripScene& scene, StripState& state) {
  constexpr int most_rounds = 20;
  constexpr double same = 1e-8;
  for (int round = 0; round < most_rounds; ++round) {
    find(scene, state);
    if (!move(scene, state, state.layout.counts, 0)) return false;
    std::swap(state, moved_);
    double moved = 0;
    for (std::size_t i = 0; i < across_.size(); ++i)
      moved = std::max(moved, std::abs(across_[i] - moved_.layout.across[i]));
    if (moved < same) return true;
  }
  return false;
}

// Finds the contact on a few strips whose rows come closer and closer to corners.
bool CornerRows::guide(const StripScene& scene, const StripState& solved) {
  constexpr StripCounts counts{6, 20};
  constexpr double first = 0.3, closer = 0.4, last = 1e-3, near_one = 0.9;
  // A probe often has corners in place already.
  find(scene, solved);
  if (move(scene, solved, counts, 0)) {
    std::swap(guide_, moved_);
    if (settle(scene, guide_)) return true;
  }
  const StripState* from = &solved;
  corner_.clear();
  if (move(scene, solved, counts, 0)) {
    std::swap(guide_, moved_);
    from = &guide_;
  }
  for (double least = first / closer, step = closer; least > last;) {
    find(scene, *from);
    if (move(scene, *from, counts, least * step)) {
      std::swap(guide_, moved_);
      from = &guide_;
      least *= step;
      step = closer;
    } else {
      step = std::sqrt(step);
      if (step > near_one) return false;
    }
  }
  return settle(scene, guide_);
}

void CornerRows::widen(const StripScene& scene, StripState& state) {
  const StripLayout& l = state.layout;
  const Middle middle(scene, state);
  constexpr int rough = 12;
  const double depth = state.approach - middle.gap(0), level = state.approach - depth / 2;
  const double low = std::min(middle.end_below(-1, level, rough), -1.0),
               high = std::max(middle.end_below(1, level, rough), 1.0);
  const double width = middle.width();
  state.geometry[l.centre_of(0)] += (low + high) / 2 * width;
  state.geometry[l.width_of(0)] *= (high - low) / 2;
}

bool CornerRows::cornered(const StripScene& scene, const StripState& solved) {
  find(scene, solved);
  return !corner_.empty() || is_laid(solved.layout);
}

bool CornerRows::lay(const StripScene& scene, const StripState& solved, StripCounts counts, StripState& laid) {
  if (solved.layout.counts == counts && is_laid(solved.layout)) {
    laid = solved;
  } else {
    constexpr StripCounts between{10, 30};
    if (!guide(scene, solved)) return false;
    find(scene, guide_);
    bool found = move(scene, guide_, counts, 0);
    if (!found && move(scene, guide_, between, 0)) {
      std::swap(guide_, moved_);
      found = move(scene, guide_, counts, 0);
    }
    if (!found) return false;
    std::swap(laid, moved_);
  }
  if (!settle(scene, laid)) return false;
  // Tractions over pressures go on from those on the rows before.
  moved_.layout = laid.layout;
  refine(solved, moved_);
  laid.traction.swap(moved_.traction);
  return true;
}

}  // namespace rollcon::strips
