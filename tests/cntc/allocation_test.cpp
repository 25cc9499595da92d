// Memory of many solves and calls.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <functional>

#include "interface.hpp"

namespace {

using cntc_test::Element;

/// Returns the memory that this process has.
double megabytes() {
  long size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

void solve_often(int solves, int wheels) {
  Element e(1, 3, 1), w(3, 1, -1);
  cntc_test::set_wheel(w);
  double before = 0;
  for (int k = 0; k < solves; ++k) {
    cntc_test::set_small(e, 1e-6 * (k % 997));
    ASSERT_GE(e.calculate(), 0);
    if (k % (solves / wheels) == 0) {
      w.set(cntc_setwheelsetposition, 1, {0, 2 + .01 * (k % 89), 0, 0, 0, 0});
      ASSERT_EQ(w.calculate(), 0);
    }
    if (k == solves / 4) before = megabytes();
  }
  const double grown = megabytes() - before;
  std::printf("  %d solves, %d of wheels: %.2f MB more\n", solves, wheels, grown);
  EXPECT_LT(grown, 8);
}

TEST(memory, a_thousand_solves_do_not_grow) {
  solve_often(1000, 10);
}
TEST(memory_long, ten_thousand_solves_do_not_grow) {
  solve_often(10000, 40);
}

// Setters and getters of many kinds, and in every 200 calls a solve of 5 x 5 elements.
TEST(memory_long, a_million_calls_do_not_grow) {
  Element e(1, 3, 1);
  cntc_test::set_small(e, 0);
  const int pn = CNTC_fld_pn, size = 25, ten = 10, block = 1, lists = 9;
  const double place = .1;
  double values[25] = {};
  const std::function<void(double)> calls[] = {
      [&](double x) { e.creepages(x, 0, x / 10); },
      [&](double x) { e.normal_force(1e4 + 1e6 * x); },
      [&](double x) {
        e.set(cntc_setfrictionmethod, 0, {.3 + x, .3});
      },
      [&](double) {
        e.set(cntc_sethertzcontact, -1, {5, 5, 1e-3, 2e-3, 1.2});
      },
      [&](double) {
        e.set(cntc_setmaterialparameters, 0, {.28, .28, 82000, 82000});
      },
      [&](double) {
        e.flags({{CNTC_ic_iestim, 3}, {CNTC_ic_pvtime, 2}});
      },
      [&](double) { subs_addblock(e.ire(), e.icp(), &block, &lists, &block, &block, &block, &place, &place, &place); },
      [&](double) { cntc_getfielddata(e.ire(), e.icp(), &pn, &size, values); },
      [&](double) { cntc_gethertzcontact(e.ire(), e.icp(), &ten, values); },
      [&](double) { EXPECT_EQ(e.flag(CNTC_ic_tang), 3); }};
  constexpr int all = 1000000;
  double used[3] = {};
  for (int k = 1; k <= all; ++k) {
    if (k % 4000 == 0) {
      int error = 1;
      subs_calculate(e.ire(), e.icp(), &error);
      ASSERT_EQ(error, 0);
    } else if (k % 200 == 0) {
      ASSERT_GE(e.calculate(), 0);
    } else {
      calls[k % 10](1e-6 * (k % 997));
    }
    if (k == all / 10 || k == all / 2 || k == all) used[k / (all / 2)] = megabytes();
  }
  std::printf("  %.2f MB at a tenth, %.2f at half, %.2f in the end\n", used[0], used[1], used[2]);
  EXPECT_LT(used[1] - used[0], 1);
  EXPECT_LT(used[2] - used[1], 1);
}

}  // namespace
