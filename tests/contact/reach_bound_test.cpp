// Which nodes without rows are doubted does not depend on where the frame lies, and a load that is spread parts the
// surfaces less than one in its middle would.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;
using Gap = std::function<double(double, double)>;

constexpr double depth = 0.02;

struct Counts {
  double rows = 0, returned = 0;
  std::vector<double> traction;
};

/// 19 x 19 nodes of half-width 2.25 about a centre; the gap is given from there.
Counts solve(double cx, double cy, const Gap& gap, bool reach) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  const auto x = frames::uniform_lines(cx - 2.25, cx + 2.25, 18), y = frames::uniform_lines(cy - 2.25, cy + 2.25, 18);
  pair.frame(frames::rectangle(ElementType::quad4, x, y));
  Scene& s = pair.contact->scene;
  std::vector<double> h;
  for (const Vec3& node : s.mesh().node) h.push_back(gap(node[0] - cx, node[1] - cy));
  s.set_gap(pair.contact->nodes(), h.data());
  pair.friction(0.3);
  s.prescribe(3, 1, depth);
  s.set_creep(-2e-3, 5e-4, 0);
  s.options.set_text("operators", "dense");
  s.options.set_int("reach", reach);
  const Status status = pair.contact->solve();
  EXPECT_TRUE(status == Status::ok || status == Status::coarse) << "summits are a few nodes each";
  return {pair.contact->stat("rows_assembled"), pair.contact->stat("nodes_returned"), pair.tractions()};
}

double sphere(double x, double y) {
  return 0.01 * (x * x + y * y);
}

/// Two summits apart along x, and two lower ones further apart across: the guess leaves those out, and they touch.
double summits(double x, double y) {
  const auto summit = [&](double a, double b, double height) {
    return height + 0.08 * ((x - a) * (x - a) + (y - b) * (y - b));
  };
  return std::min({summit(-1.25, 0, 0), summit(1.25, 0, 0), summit(0, -2, 0.83 * depth), summit(0, 2, 0.83 * depth)});
}

struct Named {
  const char* name;
  Gap gap;
};
const Named gaps[] = {{"a sphere", sphere}, {"summits", summits}};

// Coordinates are multiples of powers of two: nothing is rounded when the frame moves.
TEST(reach_bound, does_not_depend_on_where_the_frame_lies) {
  for (const Named& scene : gaps) {
    const Counts here = solve(0, 0, scene.gap, true);
    EXPECT_LT(here.rows, 361);
    for (const auto& [cx, cy] : {std::pair{32.0, 0.0}, {0.0, -32.0}, {-8.0, 16.0}}) {
      const Counts there = solve(cx, cy, scene.gap, true);
      const double off = largest_difference(there.traction, here.traction);
      std::printf("%s at (%g, %g): %g of 361 rows, %g came back; at 0: %g, %g; tractions differ by %.1e (bound 1e-8)\n",
                  scene.name, cx, cy, there.rows, there.returned, here.rows, here.returned, off);
      EXPECT_EQ(there.rows, here.rows);
      EXPECT_EQ(there.returned, here.returned);
      EXPECT_LT(off, 1e-8);
    }
  }
}

// Pressed in two places, surfaces part less in between and beside them than under one force.
TEST(reach_bound, lower_summits_beside_two_higher_ones_are_found) {
  const Counts some = solve(0, 0, summits, true), all = solve(0, 0, summits, false);
  double low = 0;
  for (std::size_t k = 0; k < 361; ++k)
    if (std::abs(static_cast<double>(k / 19) - 9) > 6 || std::abs(static_cast<double>(k % 19) - 9) > 6)
      low = std::max(low, -all.traction[3 * k + 2]);
  const double off = largest_difference(some.traction, all.traction);
  std::printf("%g of 361 rows, %g came back; pressure on the rim's side %.3g; tractions differ by %.1e (bound 1e-8)\n",
              some.rows, some.returned, low, off);
  EXPECT_LT(some.rows, 0.25 * all.rows) << "of what lies out of reach";
  EXPECT_GT(some.returned, 0);
  EXPECT_GT(low, 0) << "the lower summits carry nothing";
  EXPECT_LT(off, 1e-8);
}

}  // namespace
}  // namespace rollcon
