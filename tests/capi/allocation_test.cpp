/// Setters of a time loop allocate nothing.

#include <cstdlib>
#include <new>

#include "fixture.hpp"

namespace {

thread_local std::int64_t allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size > 0 ? size : 1)) return p;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) {
  return ::operator new(size);
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete[](void* p) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}

using namespace capi_test;

class allocation : public Api {
 protected:
  void set_step(int step) {
    const double change = 1 + 0.01 * step;
    for (double& h : gap) h = change;
    for (double& c : slip) c = change;
    for (double& m : mu) m = 0.1 * change;
    failures += rollcon_contact_set_creep(contact, 1e-3 * change, 0, 1e-4 * step) != 0;
    failures += rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, change) != 0;
    failures += rollcon_contact_set_rolling(contact, change) != 0;
    failures += rollcon_contact_set_gap(contact, frame.nodes, gap.data()) != 0;
    failures += rollcon_contact_set_gap_quadratic(contact, change, change, 0) != 0;
    failures += rollcon_contact_set_creep_field(contact, frame.nodes, slip.data()) != 0;
    failures += rollcon_contact_set_friction(contact, "coulomb", 1, mu.data()) != 0;
    failures += rollcon_contact_set_friction_field(contact, frame.nodes, mu.data()) != 0;
    failures += rollcon_contact_set_real(contact, "tolerance", 1e-8 * change) != 0;
    failures += rollcon_contact_set_int(contact, "max_iterations", 50 + step) != 0;
    failures += rollcon_contact_set_creep_field(contact, 0, nullptr) != 0;
    failures += rollcon_contact_set_friction_field(contact, 0, nullptr) != 0;
  }

  std::vector<double> gap = std::vector<double>(static_cast<std::size_t>(frame.nodes));
  std::vector<double> slip = std::vector<double>(static_cast<std::size_t>(2 * frame.nodes));
  std::vector<double> mu = std::vector<double>(static_cast<std::size_t>(frame.nodes));
  int failures = 0;
};

TEST_F(allocation, setters_of_a_time_loop_allocate_nothing) {
  set_frame();
  set_step(0);
  ASSERT_GT(allocations, 0) << "the count works";
  allocations = 0;
  for (int step = 1; step <= 10; ++step) set_step(step);
  const std::int64_t counted = allocations;
  std::printf("allocations in 120 setters: %lld (bound 0)\n", static_cast<long long>(counted));
  EXPECT_EQ(counted, 0);
  EXPECT_EQ(failures, 0);
}
