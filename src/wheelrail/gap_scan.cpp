#include "wheelrail/gap_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollcon {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Calls visit(span, a, b) with the rough gaps at both ends of each span.
template <class Visit>
void for_each_span(ProfileGap& gap, Visit visit) {
  constexpr double smooth = 1e-9;
  double slope = infinite;
  RoughGap a, b;
  for (const VisibleSpan& span : gap.wheel().spans()) {
    a = std::abs(span.slope[0] - slope) < smooth ? b : gap.rough(span, 0);
    b = gap.rough(span, 1);
    slope = span.slope[1];
    if (a.known || b.known) visit(span, a, b);
  }
}

/// Returns a bound below which the gap does not fall between the ends of a span.
double bound(const RoughGap& a, const RoughGap& b, const VisibleSpan& span) {
  const double steepest = std::max(std::abs(a.rise), std::abs(b.rise));
  if (a.known && b.known)
    return std::min(a.gap, b.gap) - a.slack - b.slack - (a.rise < 0 && b.rise > 0 ? steepest * (b.y - a.y) : 0);
  const RoughGap& in = a.known ? a : b;
  return in.gap - in.slack - 2 * steepest * (span.s[1] - span.s[0]);
}

/// Calls visit(a, b) for pieces of the span's part in which there is a gap, over which it rises or falls.
template <class Visit>
void for_each_slope(const ProfileGap& gap, const VisibleSpan& span, Visit visit) {
  auto a = gap.at(span, span.s[0]), b = gap.at(span, span.s[1]);
  if (!a && !b) return;
  if (!a) a = gap.edge(span, span.s[1], span.s[0]);
  if (!b) b = gap.edge(span, span.s[0], span.s[1]);
  if (!(a->rise * b->rise < 0)) {
    visit(*a, *b);
    return;
  }
  const GapPoint e = gap.extreme(span, *a, *b);
  visit(*a, e);
  visit(e, *b);
}

class OverlapScan {
 public:
  OverlapScan(ProfileGap& gap, std::vector<Overlap>& found) : gap_(gap), found_(found) {}

  void find() {
    found_.clear();
    for_each_span(gap_, [&](const VisibleSpan& span, const RoughGap& a, const RoughGap& b) {
      if (passed_by(span, a, b)) return;
      if (inside_ && !a.known) close(last_, true);
      starts_ = !a.known || span.s[0] == 0;
      for_each_slope(gap_, span, [&](const GapPoint& p, const GapPoint& q) { step(span, p, q); });
      if (inside_ && !b.known) close(last_, true);
    });
    if (inside_) end_at_last_cell();
  }

 private:
  bool passed_by(const VisibleSpan& span, const RoughGap& a, const RoughGap& b) {
    if (!inside_) return bound(a, b, span) > 0;
    const bool kink = falls_ != (a.rise < 0);
    if (!a.known || !b.known || a.gap > -a.slack || b.gap > -b.slack || kink || a.rise * b.rise <= 0) return false;
    return true;
  }
  /// Takes a step from a to b, between which the gap rises or falls.
  void step(const VisibleSpan& span, const GapPoint& a, const GapPoint& b) {
    const bool falls = a.rise + b.rise < 0;
    // Pieces of published profiles meet but for steps of their rounding.
    if (inside_ && a.gap > 0) {
      deepen(last_);
      close(a, false);
    }
    if (!inside_ && a.gap <= 0) {
      open(a, starts_);
      deepest_known_ = true;
    } else if (inside_ && falls_ && !falls) {
      deepen(a);
    } else if (inside_ && !falls_ && falls) {
      close(a, false);
      open(a, false);
      now_.grown = true;
    }
    if (inside_ && b.gap > 0)
      close(gap_.zero(span, a, b), false);
    else if (!inside_ && b.gap <= 0)
      open(gap_.zero(span, a, b), false);
    starts_ = false;
    falls_ = falls;
    last_ = b;
  }
  void open(const GapPoint& p, bool cut) {
    inside_ = true;
    now_ = Overlap{};
    now_.from = now_.deepest = p;
    now_.cut = deepest_known_ = cut;
  }
  void deepen(const GapPoint& p) {
    if (!deepest_known_ || p.depth() > now_.deepest.depth()) now_.deepest = p;
    deepest_known_ = true;
  }
  void close(const GapPoint& p, bool cut) {
    inside_ = false;
    if (cut || !deepest_known_) deepen(p);
    now_.to = p;
    now_.cut = now_.cut || cut;
    if (now_.to.s > now_.from.s && now_.deepest.gap < 0) found_.push_back(now_);
  }
  void end_at_last_cell() {
    const VisibleSpan& span = gap_.wheel().spans().back();
    const auto p = gap_.at(span, span.s[1]);
    close(p.value_or(last_), true);
  }

  ProfileGap& gap_;
  std::vector<Overlap>& found_;
  bool inside_ = false, starts_ = false, deepest_known_ = false;
  bool falls_ = false;  ///< the gap falls up to here
  GapPoint last_{};
  Overlap now_;
};

}  // namespace

std::optional<GapPoint> least_gap(ProfileGap gap) {
  double rough = infinite;
  std::optional<GapPoint> least;
  for_each_span(gap, [&](const VisibleSpan&, const RoughGap& a, const RoughGap& b) {
    if (a.known) rough = std::min(rough, a.gap + a.slack);
    if (b.known) rough = std::min(rough, b.gap + b.slack);
  });
  for_each_span(gap, [&](const VisibleSpan& span, const RoughGap& a, const RoughGap& b) {
    if (bound(a, b, span) > (least ? std::min(rough, least->gap) : rough)) return;
    for_each_slope(gap, span, [&](const GapPoint& p, const GapPoint& q) {
      const GapPoint& nearer = q.gap < p.gap ? q : p;
      if (!least || nearer.gap < least->gap) least = nearer;
    });
  });
  return least;
}

void find_overlaps(ProfileGap gap, std::vector<Overlap>& overlap) {
  OverlapScan(gap, overlap).find();
}

}  // namespace rollcon
