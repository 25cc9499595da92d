/// Tests that nothing jumps through flange contact in 2000 steps of 5 um. A step that is halved again and again, always
/// into the half with the greater change, ends at the jump it has, or with none.

#include "manchester.hpp"

using namespace rollcon;
using namespace rollcon::manchester;

namespace {

struct Motion {
  double sunk;  ///< depth beyond first touch; 0: the wheelset moves at a constant height
  double from, to;
};

Pose pose_at(const ContactSearch& search, const Motion& m, double y) {
  constexpr double yaw_by_y = 2.4e-3, roll_by_y = -2e-4, height = 0.17;
  Pose pose = placed(y, roll_by_y * y, yaw_by_y * y, height);
  if (m.sunk > 0) pose.translation[2] += search.first_touch(pose) + m.sunk;
  return pose;
}

/// Holds what forces go with: sums over patches by weights, and those times place, angle and sizes.
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

Sums sums_at(ContactSearch& search, const Motion& m, double y) {
  thread_local std::vector<OverlapPatch> patch;
  search.find(pose_at(search, m, y), patch);
  return sums_of(patch);
}

/// Returns what is left of the change of sum k between two positions after halvings.
double jump_between(ContactSearch& search, const Motion& m, std::size_t k, double a, double b) {
  constexpr int halvings = 34;
  double at_a = sums_at(search, m, a)[k], at_b = sums_at(search, m, b)[k];
  for (int i = 0; i < halvings; ++i) {
    const double middle = (a + b) / 2, between = sums_at(search, m, middle)[k];
    const bool first = std::abs(between - at_a) > std::abs(at_b - between);
    (first ? b : a) = middle;
    (first ? at_b : at_a) = between;
  }
  return std::abs(at_b - at_a);
}

}  // namespace

TEST(contact_search_continuity_long, sums_over_patches_do_not_jump) {
  constexpr int steps = 2000;
  constexpr std::size_t greatest = 50;
  ContactSearch search(wheel(), rail());
  for (const Motion& m : {Motion{0.03, -3, 7}, Motion{0.1, -3, 7}, Motion{0, -3, 7}}) {
    const auto y = [&](std::size_t i) { return m.from + (m.to - m.from) * static_cast<double>(i) / steps; };
    std::vector<Sums> sum;
    for (std::size_t i = 0; i <= steps; ++i) sum.push_back(sums_at(search, m, y(i)));
    for (std::size_t k = 0; k < sum[0].size(); ++k) {
      const auto change = [&](std::size_t i) { return std::abs(sum[i + 1][k] - sum[i][k]); };
      std::vector<std::size_t> step(steps);
      std::iota(step.begin(), step.end(), std::size_t{0});
      std::sort(step.begin(), step.end(), [&](std::size_t a, std::size_t b) { return change(a) > change(b); });
      double range = 0, jump = 0;
      for (const Sums& s : sum) range = std::max(range, std::abs(s[k] - sum[0][k]));
      for (std::size_t i = 0; i < greatest; ++i)
        jump = std::max(jump, jump_between(search, m, k, y(step[i]), y(step[i] + 1)));
      const std::string what = std::string(names[k]) + ", sunk by " + std::to_string(m.sunk);
      report(what + ": greatest step of 5 um over the range", change(step[0]) / range);
      // The rule of the mean is divided anew where a deepest point begins beside another, in an overlap of several
      // millimetres, with errors of 1e-4 mm of a reference. A sliver of overlap that is shorter than a span of the
      // scan, 0.4 mm, may be overlooked at an end.
      const double bound = names[k] == std::string("width") ? 2e-3 : 1e-4;
      expect_error(what + ": greatest jump over the range", jump / range, bound);
    }
  }
}

/// Each patch goes on from one of the step before, unless it has only begun to overlap, or to share a region with
/// another.
TEST(contact_search_continuity_long, patches_move_on_or_begin_with_nothing) {
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

// Patches that are about to merge count at levels: at each level every overlap belongs to one patch.
TEST(contact_search_continuity, each_level_has_every_overlap_once) {
  constexpr int levels = 50;
  ContactSearch search(wheel(), rail());
  std::vector<OverlapPatch> patch;
  int merging = 0, wrong = 0, together = 0;
  for (int i = 0; i <= 400; ++i) {
    Pose pose = placed(6.2 + 0.002 * i, 0, 0.0132, 0);
    pose.translation[2] += search.first_touch(pose) + 0.12;
    search.find(pose, patch);
    for (const OverlapPatch& single : patch) {
      merging += single.share < 1;
      if (single.apart + single.share < 1 - 1e-12) continue;
      for (int k = 0; k < levels; ++k) {
        const double level = (k + 0.5) / levels;
        int holds = 0;
        for (const OverlapPatch& p : patch) {
          const double at = dot(single.reference - p.reference, p.lateral);
          const bool here = p.low <= at && at <= p.high;
          holds += here && p.apart <= level && level < p.apart + p.share;
          together += here && &p != &single && p.beside(single) > 1e-14;
        }
        wrong += holds != 1;
      }
    }
  }
  EXPECT_GT(merging, 20);
  EXPECT_EQ(wrong, 0) << "levels at which an overlap is in no patch or in several";
  EXPECT_EQ(together, 0) << "pairs of patches in one place that count together";
}
