/// Tests that searches and solves that have seen as many patches and nodes allocate nothing.

#include <cstdlib>
#include <new>
#include <numbers>

#include "tables/force_table.hpp"
#include "wheel_rail_fixture.hpp"

namespace {

thread_local std::int64_t allocations = 0;

}  // namespace

// The operator is not inlined, because compilers that see the inside of one of a pair only take them for mismatched.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size > 0 ? size : 1)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

using namespace rollcon;
using namespace rollcon::manchester;

using allocation = wheels;

TEST_F(allocation, warm_searches_allocate_nothing) {
  ContactSearch search(manchester::wheel(), manchester::rail());
  std::vector<OverlapPatch> patch;
  const auto run = [&] {
    std::size_t most = 0;
    for (int i = 0; i < 200; ++i) {
      Pose pose = placed(0.05 * i - 3, 0, 1e-4 * i, 0);
      pose.translation[2] += search.first_touch(pose) + 0.05;
      search.find(pose, patch);
      most = std::max(most, patch.size());
    }
    return most;
  };
  EXPECT_GE(run(), 2U);
  const std::int64_t before = allocations;
  run();
  expect_error("allocations of 200 warm searches", static_cast<double>(allocations - before), 0);
  EXPECT_GT(before, 0);
}

// The wheel goes from the tread to two patches and back, by frames and by a table.
TEST_F(allocation, warm_steps_allocate_nothing) {
  context->set_threads(1);
  for (const bool by_table : {false, true}) {
    const auto w = make();
    w->set_real("accuracy", by_table ? 0.01 : 0.02);
    w->prescribe_vertical(static_cast<std::int32_t>(How::by_force), 10000);
    if (by_table) w->set_table(ForceTable::standard(context));
    std::int64_t most = 0;
    const auto run = [&] {
      for (int i = 0; i < 100; ++i) {
        place(*w, 3.5 + 2 * std::sin(0.02 * std::numbers::pi * i));
        EXPECT_EQ(w->solve(), Status::ok);
        most = std::max(most, w->patches());
      }
    };
    run();
    run();
    EXPECT_GE(most, 2);
    const std::int64_t before = allocations;
    run();
    expect_error(by_table ? "allocations of 100 warm steps, by table" : "allocations of 100 warm steps, on frames",
                 static_cast<double>(allocations - before), 0);
    EXPECT_GT(before, 0);
  }
}
