// Memory of many solves and calls.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "interface.hpp"

namespace {

using cntc_test::Element;

long resident_pages() {
  long size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident;
}

void solve_often(int solves, int wheels) {
  Element e(1, 3, 1), w(3, 1, -1);
  cntc_test::set_wheel(w);
  long before = 0;
  for (int k = 0; k < solves; ++k) {
    cntc_test::set_small(e, 1e-6 * (k % 997));
    ASSERT_GE(e.calculate(), 0);
    if (k % (solves / wheels) == 0) {
      w.set(cntc_setwheelsetposition, 1, {0, 2 + .01 * (k % 89), 0, 0, 0, 0});
      ASSERT_EQ(w.calculate(), 0);
    }
    if (k == solves / 4) before = resident_pages();
  }
  const double grown = double(resident_pages() - before) * double(sysconf(_SC_PAGESIZE)) / 1e6;
  std::printf("  %d solves, %d of wheels: %.2f MB more\n", solves, wheels, grown);
  EXPECT_LT(grown, 8);
}

TEST(memory, a_thousand_solves_do_not_grow) {
  solve_often(1000, 10);
}
TEST(memory_long, ten_thousand_solves_do_not_grow) {
  solve_often(10000, 40);
}
TEST(memory_nightly, a_million_solves_do_not_grow) {
  solve_often(1000000, 4000);
}

TEST(memory, a_million_getters_and_setters) {
  Element e(1, 3, 1);
  cntc_test::set_small(e, 1e-3);
  EXPECT_GE(e.calculate(), 0);
  const long before = resident_pages();
  for (int k = 0; k < 500000; ++k) {
    e.creepages(1e-3, 1e-9 * k, 0);
    double pen = 0;
    cntc_getpenetration(e.ire(), e.icp(), &pen);
    ASSERT_GT(pen, 0);
  }
  EXPECT_LT(double(resident_pages() - before) * double(sysconf(_SC_PAGESIZE)), 1e6);
}

}  // namespace
