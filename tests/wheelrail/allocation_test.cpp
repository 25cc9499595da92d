/// A search that has seen as many patches allocates nothing.

#include <cstdlib>
#include <new>

#include "manchester.hpp"

namespace {

thread_local std::int64_t allocations = 0;

}  // namespace

// Not inlined: compilers that see the inside of one of a pair only take them for mismatched.
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

TEST(allocation, warm_searches_allocate_nothing) {
  ContactSearch search(wheel(), rail());
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
