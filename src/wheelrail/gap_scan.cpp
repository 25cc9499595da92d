#include "wheelrail/gap_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollcon {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// visit(cell, a, b) with the rough gaps at both ends of each cell.
template <class Visit>
void for_each_cell(ProfileGap& gap, Visit visit) {
  constexpr double smooth = 1e-9;
  double slope = infinite;
  RoughGap a, b;
  for (const VisibleCell& cell : gap.wheel().cells()) {
    a = std::abs(cell.slope[0] - slope) < smooth ? b : gap.rough(cell, 0);
    b = gap.rough(cell, 1);
    slope = cell.slope[1];
    if (a.known || b.known) visit(cell, a, b);
  }
}

/// Below what the gap does not fall between the ends of a cell.
double bound(const RoughGap& a, const RoughGap& b, const VisibleCell& cell) {
  const double steepest = std::max(std::abs(a.rise), std::abs(b.rise));
  if (a.known && b.known)
    return std::min(a.gap, b.gap) - a.slack - b.slack - (a.rise < 0 && b.rise > 0 ? steepest * (b.y - a.y) : 0);
  const RoughGap& in = a.known ? a : b;
  return in.gap - in.slack - 2 * steepest * (cell.s[1] - cell.s[0]);
}

/// The cell's part in which there is a gap, in pieces over which it rises or falls: visit(a, b).
template <class Visit>
void for_each_slope(const ProfileGap& gap, const VisibleCell& cell, bool from_known, bool to_known, Visit visit) {
  auto a = gap.at(cell, cell.s[0]), b = gap.at(cell, cell.s[1]);
  if (!a && !b) return;
  if (!a || !from_known) a = gap.edge(cell, cell.s[1], cell.s[0]);
  if (!b || !to_known) b = gap.edge(cell, cell.s[0], cell.s[1]);
  if (!(a->rise * b->rise < 0)) {
    visit(*a, *b);
    return;
  }
  const GapPoint e = gap.extreme(cell, *a, *b);
  visit(*a, e);
  visit(e, *b);
}

class OverlapScan {
 public:
  OverlapScan(ProfileGap& gap, std::vector<Overlap>& found) : gap_(gap), found_(found) {}

  void find() {
    found_.clear();
    for_each_cell(gap_, [&](const VisibleCell& cell, const RoughGap& a, const RoughGap& b) {
      if (passed_by(cell, a, b)) return;
      if (inside_ && !a.known) close(last_, true);
      starts_ = !a.known || cell.s[0] == 0;
      for_each_slope(gap_, cell, a.known, b.known, [&](const GapPoint& p, const GapPoint& q) { step(cell, p, q); });
      if (inside_ && !b.known) close(last_, true);
    });
    if (inside_) end_at_last_cell();
  }

 private:
  bool passed_by(const VisibleCell& cell, const RoughGap& a, const RoughGap& b) {
    if (!inside_) return bound(a, b, cell) > 0;
    const bool kink = a.rise >= 0 && rise_ < 0;
    rise_ = b.rise;
    return a.known && b.known && a.gap < -a.slack && b.gap < -b.slack && !kink && a.rise * b.rise > 0;
  }
  void step(const VisibleCell& cell, const GapPoint& a, const GapPoint& b) {
    if (inside_ && a.gap > 0) close(a, false);
    if (!inside_ && a.gap <= 0) open(a, starts_);
    starts_ = false;
    if (inside_) deepen(a);
    if (inside_ && b.gap > 0)
      close(gap_.zero(cell, a, b), false);
    else if (!inside_ && b.gap <= 0)
      open(gap_.zero(cell, a, b), false);
    if (inside_) deepen(b);
    last_ = b;
    rise_ = b.rise;
  }
  void open(const GapPoint& p, bool cut) {
    inside_ = true;
    now_ = Overlap{};
    now_.from = now_.deepest = p;
    now_.cut = cut;
  }
  void deepen(const GapPoint& p) {
    if (p.depth() > now_.deepest.depth()) now_.deepest = p;
  }
  void close(const GapPoint& p, bool cut) {
    inside_ = false;
    now_.to = p;
    now_.cut = now_.cut || cut;
    if (now_.to.s > now_.from.s) found_.push_back(now_);
  }
  void end_at_last_cell() {
    const VisibleCell& cell = gap_.wheel().cells().back();
    const auto p = gap_.at(cell, cell.s[1]);
    if (p) deepen(*p);
    close(p.value_or(last_), true);
  }

  ProfileGap& gap_;
  std::vector<Overlap>& found_;
  bool inside_ = false, starts_ = false;
  double rise_ = 0;
  GapPoint last_{};
  Overlap now_;
};

}  // namespace

double least_gap(ProfileGap gap) {
  double rough = infinite, least = infinite;
  for_each_cell(gap, [&](const VisibleCell&, const RoughGap& a, const RoughGap& b) {
    if (a.known) rough = std::min(rough, a.gap + a.slack);
    if (b.known) rough = std::min(rough, b.gap + b.slack);
  });
  for_each_cell(gap, [&](const VisibleCell& cell, const RoughGap& a, const RoughGap& b) {
    if (bound(a, b, cell) > std::min(rough, least)) return;
    for_each_slope(gap, cell, a.known, b.known, [&](const GapPoint& p, const GapPoint& q) {
      least = std::min({least, p.gap, q.gap});
    });
  });
  return least;
}

void find_overlaps(ProfileGap gap, std::vector<Overlap>& overlap) {
  OverlapScan(gap, overlap).find();
}

}  // namespace rollcon
