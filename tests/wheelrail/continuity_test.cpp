/// Through flange contact in small steps: nothing jumps. A jump stays what it is when steps get smaller; all else
/// shrinks with them.

#include "manchester.hpp"

using namespace rollcon;
using namespace rollcon::manchester;

namespace {

struct Motion {
  double sunk;  ///< beyond first touch; 0: the wheelset moves at a constant height
  double from, to;
};

Pose pose_at(const ContactSearch& search, const Motion& m, double y) {
  constexpr double yaw_by_y = 2.4e-3, roll_by_y = -2e-4, height = 0.17;
  Pose pose = placed(y, roll_by_y * y, yaw_by_y * y, height);
  if (m.sunk > 0) pose.translation[2] += search.first_touch(pose) + m.sunk;
  return pose;
}

/// What forces go with: sums over patches by shares, and of them times place, angle and sizes.
using Sums = std::array<double, 8>;
constexpr const char* names[] = {"load", "y", "z", "x", "angle", "width", "length", "rolling radius"};

Sums sums_of(const std::vector<OverlapPatch>& patch) {
  Sums sum{};
  for (const OverlapPatch& p : patch) {
    const double load = p.share * p.overlap * std::sqrt(p.overlap);
    const double of[] = {1,       p.reference[1] - 700, p.reference[2],   p.reference[0],
                         p.angle, p.high - p.low,       p.front - p.back, p.rolling_radius - radius};
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += load * of[i];
  }
  return sum;
}

/// Greatest changes from step to step, over the range of the values.
Sums greatest_steps(ContactSearch& search, const Motion& m, int steps) {
  std::vector<OverlapPatch> patch;
  Sums before{}, most{}, low, high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  for (int i = 0; i <= steps; ++i) {
    search.find(pose_at(search, m, m.from + (m.to - m.from) * i / steps), patch);
    const Sums now = sums_of(patch);
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (i > 0) most[k] = std::max(most[k], std::abs(now[k] - before[k]));
      low[k] = std::min(low[k], now[k]);
      high[k] = std::max(high[k], now[k]);
    }
    before = now;
  }
  for (std::size_t k = 0; k < most.size(); ++k) most[k] /= high[k] - low[k];
  return most;
}

}  // namespace

TEST(contact_search_continuity, sums_over_patches_do_not_jump) {
  ContactSearch search(wheel(), rail());
  for (const Motion& m : {Motion{0.03, -3, 7}, Motion{0.1, -3, 7}, Motion{0, -3, 7}}) {
    const Sums coarse = greatest_steps(search, m, 2000), fine = greatest_steps(search, m, 32000);
    for (std::size_t k = 0; k < coarse.size(); ++k) {
      const std::string what = std::string(names[k]) + ", sunk by " + std::to_string(m.sunk);
      report(what + ": greatest step of 5 um over the range", coarse[k]);
      expect_error(what + ": the same of 0.3 um", fine[k], 0.2 * coarse[k]);
    }
  }
}

/// Each patch goes on from one of the step before, unless it has only begun to overlap or to share.
TEST(contact_search_continuity, patches_move_on_or_begin_with_nothing) {
  ContactSearch search(wheel(), rail());
  const Motion m{0.03, -3, 7};
  constexpr int steps = 32000;
  std::vector<OverlapPatch> before, now;
  double moved = 0, turned = 0, deeper = 0, wider = 0, born = 0;
  int births = 0;
  for (int i = 0; i <= steps; ++i) {
    search.find(pose_at(search, m, m.from + (m.to - m.from) * i / steps), now);
    for (const OverlapPatch& p : now) {
      const OverlapPatch* same = nullptr;
      double least = INFINITY;
      for (const OverlapPatch& q : before) {
        const double off = std::abs(p.reference[1] + p.low - q.reference[1] - q.low) +
                           std::abs(p.reference[1] + p.high - q.reference[1] - q.high);
        if (off < least) {
          least = off;
          same = &q;
        }
      }
      if (i == 0) continue;
      constexpr double near = 1;
      if (!same || least > near) {
        ++births;
        born = std::max(born, p.share * p.overlap / m.sunk);
        continue;
      }
      moved = std::max(moved, length(p.reference - same->reference));
      turned = std::max(turned, std::abs(p.angle - same->angle));
      deeper = std::max(deeper, std::abs(p.overlap - same->overlap));
      wider = std::max(wider, least);
    }
    before = now;
  }
  std::printf("%d patches began\n", births);
  EXPECT_GE(births, 2);
  expect_error("a patch's first overlap times share, over the depth", born, 0.05);
  report("greatest step of a reference, mm", moved);
  report("greatest step of an angle", turned);
  report("greatest step of an overlap, mm", deeper);
  report("greatest step of both ends, mm", wider);
}
